// What a light reaches of receivers as vtkPolyData.
#ifndef RegionData_h
#define RegionData_h

#include "ContourData.h"
#include "LitRegions.h"

// All cells and arrays that vtkShadowedReceiver documents. Regions are those of the input's
// receivers, one by one.
void writeRegions(const std::vector<shadow::LitRegions>& regions, const ContourInput& input,
  vtkPolyData* output);

#endif
