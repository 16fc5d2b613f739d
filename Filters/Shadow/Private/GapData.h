// The gap between a mesh and its silhouette as vtkPolyData.
#ifndef GapData_h
#define GapData_h

#include "SilhouetteGap.h"

class vtkPolyData;

// The normals of a silhouette's points. False if there are none.
bool readNormals(vtkPolyData* silhouette, std::vector<shadow::Vec3>& normals);

// Writes points, normals and triangles, as vtkSilhouetteGap documents.
void writeGap(const shadow::SilhouetteGap& gap, vtkPolyData* output);

#endif
