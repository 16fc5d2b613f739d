// vtkPolyData to the core's mesh and light, with a diagnosis of what was left out.
#ifndef PolyDataBridge_h
#define PolyDataBridge_h

#include "Geometry.h"

#include "vtkType.h"

class vtkPolyData;

// A mesh as it was read. Its normals are empty where the input has none.
struct BridgedMesh
{
  shadow::TriangleMesh mesh;
  vtkIdType degenerateCells = 0; // fewer than three distinct points: they cast nothing
  vtkIdType nonFiniteCells = 0;  // left out
};

// Polygons are triangulated by ear cutting, strips are taken apart. Points that no triangle uses
// are left out.
BridgedMesh readMesh(vtkPolyData* input, bool mergePoints);

// False if the position has a component that is not finite, or nothing but zeros. The sign of w
// is made positive, which leaves the point the same.
bool readLight(const double position[4], shadow::Light& light);

#endif
