/**
 * @brief Invariants of silhouettes and shadow volumes, checked without the code that made them.
 *
 * All read the public arrays of the filters' outputs: CellData `Multiplicity`, PointData
 * `Normals` and `Homogeneous`. An output without them counts as multiplicity 1 and w = 1.
 */
#ifndef shadowtest_ChainChecks_h
#define shadowtest_ChainChecks_h

#include <vtkType.h>

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

class vtkPolyData;

namespace shadowtest
{
/// The number of edges, by point id, whose directed traversals by polygons do not sum to zero with
/// the cells' multiplicities. 0 for a closed chain, which is not to be passed on trust: ask for
/// triangles, too.
vtkIdType openEdges(vtkPolyData* polygons);

/// The same with points that are equal in all (homogeneous) coordinates taken as one.
vtkIdType openEdgesByCoordinates(vtkPolyData* polygons);

struct LoopReport
{
  vtkIdType Loops = 0;
  vtkIdType Segments = 0;
  /// Polylines whose last point id is not their first.
  vtkIdType OpenLoops = 0;
  /// Polylines of less than two segments: they enclose nothing and cannot be closed.
  vtkIdType ShortLoops = 0;
  vtkIdType NonFinitePoints = 0;
  /// Points (by id) where more multiplicity arrives than leaves.
  vtkIdType UnbalancedPoints = 0;
  /// Multiplicity below 1, or an array of another length than the cells.
  vtkIdType BadMultiplicities = 0;
  /// Greatest | |n| - 1 | of the points' normals; 0 without normals, infinite if one is not finite.
  double NormalError = 0.0;
  bool HasNormals = false;

  /// All of the above as they must be; unit normals if there are normals.
  bool good() const;
};
std::ostream& operator<<(std::ostream& out, const LoopReport& report);

/// Looks at the lines of a silhouette.
LoopReport checkLoops(vtkPolyData* silhouette);

/// Numbers that are NaN or infinite, in the points and in all arrays of points, cells and fields.
vtkIdType nonFiniteNumbers(vtkPolyData* data);

/// How often the polygons of a volume wind around a point: solid angles over 4 pi. Points at
/// infinity are taken as such, not truncated. A whole number unless the volume is open or the
/// point lies on it. Good to tolerance::Winding within 1,000 sizes of the mesh; the error grows
/// with the square of the distance, as the solid angles shrink.
double windingNumber(vtkPolyData* volume, const double point[3]);

/// The same around many points of one volume, which is read once.
class VolumeWinding
{
public:
  explicit VolumeWinding(vtkPolyData* volume);
  double around(const double point[3]) const;

private:
  struct WeightedTriangle
  {
    std::array<std::size_t, 3> Corners;
    double Multiplicity;
  };
  std::vector<std::array<double, 4>> Points;
  std::vector<WeightedTriangle> Triangles;
};

/// Volume enclosed by the polygons, by the divergence theorem; points at infinity not allowed.
double enclosedVolume(vtkPolyData* polygons);

struct Blockers
{
  /// Triangles that the segment from the point to the light crosses.
  int Count = 0;
  /// Sum of their orientations: +1 where the light sees the face's front.
  int Signed = 0;
  /// How clear the decision was: the least |barycentric coordinate| or relative distance along the
  /// ray that decided it. Tests leave out points below tolerance::TooClose.
  double Margin = 1.0;
};

/// What stands between a point and the light (homogeneous), by a loop over all triangles.
Blockers blockersTowards(vtkPolyData* mesh, const double point[3], const double light[4]);
}

#endif
