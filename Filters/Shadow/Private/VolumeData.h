// A shadow volume as vtkPolyData.
#ifndef VolumeData_h
#define VolumeData_h

#include "ShadowVolume.h"

class vtkPolyData;

// Writes triangles with all arrays that vtkShadowVolumeExtruder documents. Points at infinity are
// shown at the end's length from the point that they belong to, or from the centre.
void writeVolume(const shadow::ShadowVolume& volume, const shadow::Vec3& centre,
  const shadow::ShadowEnd& end, bool closed, vtkPolyData* output);

// Writes what vtkShadowVolumeExtruder documents for NEAR_END.
void writeNearEnd(const shadow::NearEnd& end, vtkPolyData* output);

#endif
