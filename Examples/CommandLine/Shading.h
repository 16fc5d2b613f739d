/**
 * A mesh made ready to be drawn: what the mappers shade and what the shadow pass takes the
 * silhouette of is then the same surface, with the same normals.
 */
#ifndef Shading_h
#define Shading_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

struct ShadedMesh
{
  vtkSmartPointer<vtkPolyData> Data; // triangles, finite, with point normals
  vtkIdType NonFiniteTriangles;      // left out
  bool NormalsComputed;
};

/// Normals, where the mesh has none, are split at edges sharper than featureAngle (degrees).
ShadedMesh PrepareForShading(vtkPolyData* mesh, double featureAngle);

#endif
