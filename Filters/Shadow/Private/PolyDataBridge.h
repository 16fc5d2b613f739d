// vtkPolyData to the core's mesh and light, with a diagnosis of what was left out.
#ifndef PolyDataBridge_h
#define PolyDataBridge_h

#include "Geometry.h"
#include "Occurrences.h"

#include "vtkType.h"

#include <string>

class vtkPolyData;

// What was found when a mesh was read. Cells occur at their first point that is finite.
struct ReadingDefects
{
  shadow::Occurrences degenerateCells; // triangles with two equal corners: they cast nothing
  shadow::Occurrences nonFiniteCells;  // left out, as are cells with points that do not exist
  shadow::Occurrences crossedPolygons; // ear cutting gave up: they became fans
  shadow::Occurrences repeatedPoints;  // that are welded with an earlier one, their normals too
  shadow::Occurrences unusableNormals; // given, but zero or not finite
};

// A mesh as it was read. Its normals are empty where the input has none.
struct BridgedMesh
{
  shadow::TriangleMesh mesh;
  ReadingDefects defects;
  std::vector<vtkIdType> cells; // of each triangle: the input's cell that it is of
};

// Polygons are triangulated by ear cutting, strips are taken apart. Points that no triangle uses
// are left out.
BridgedMesh readMesh(vtkPolyData* input, bool mergePoints);

// Whether there are more points (2^30) or corners of triangles (2^31) than the core's 32-bit
// numbers can take.
bool isTooLarge(vtkPolyData* input);

// What to say of a mesh that is.
std::string describeTooLarge(vtkPolyData* input);

// False if the position has a component that is not finite, or nothing but zeros. Points come out
// with w = 1, directions at about unit length.
bool readLight(const double position[4], shadow::Light& light);

// What to say of a position that readLight refused.
std::string describeBadLight(const double position[4]);

#endif
