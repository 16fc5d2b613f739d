/**
 * What is between points and an eye or a light, and the parts of lines that this leaves.
 */
#ifndef LineOfSight_h
#define LineOfSight_h

#include "Polylines.h"

#include <vtkStaticCellLocator.h>

#include <functional>
#include <vector>

class LineOfSight
{
public:
  /// Of triangles or other polygons, with finite points.
  explicit LineOfSight(const std::vector<vtkPolyData*>& meshes);

  /// Whether nothing is between a point and an eye (homogeneous; w = 0 at infinity). The point may
  /// lie on a mesh itself: what is nearer to it than 1e-5 of the meshes' size does not block.
  bool IsFree(const Vector3& point, const Homogeneous& eye) const;

private:
  // One a mesh, as small meshes may lie among large ones.
  std::vector<vtkSmartPointer<vtkStaticCellLocator>> Locators;
  double Bounds[6];
  double Size = 0.0;
};

/// Whether a point is in; it is given by a line's segment and the share of the way along that.
using PartTest = std::function<bool(std::size_t segment, double share)>;

/// The parts of a line that are in. Looked at are both ends of each segment and `steps(segment)` -
/// 1 places between them; where it changes from one to the next is found by halving, 12 times. Each
/// part has the line's own points and those at which it changes.
std::vector<Polyline3> PartsOf(const Polyline3& line, const PartTest& isIn,
  const std::function<int(std::size_t segment)>& steps);

#endif
