#include "vtkShadowedReceiver.h"

#include "RegionData.h"
#include "SMPRangeLoop.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkShadowedReceiver);

vtkShadowedReceiver::vtkShadowedReceiver() = default;
vtkShadowedReceiver::~vtkShadowedReceiver() = default;

int vtkShadowedReceiver::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  ContourInput input;
  if (!this->ReadScene(inputVector, true, input))
  {
    return 0;
  }
  if (input.scene.casters.empty() && input.scene.loops.count() > 0)
  {
    vtkErrorMacro("There are silhouettes on port 0 but no casters on port 2, without which nobody "
                  "can tell what they shadow: connect the meshes that the silhouettes are of.");
    return 0;
  }
  shadow::ContourReport report;
  const std::vector<shadow::LitRegions> regions = shadow::findLitRegions(
    input.scene, static_cast<shadow::TreeBuilder>(this->Builder), smpRangeLoop, report);
  if (!this->CheckLight(input, report.lightPoint))
  {
    return 0;
  }
  writeRegions(regions, input, vtkPolyData::GetData(outputVector));
  return 1;
}

void vtkShadowedReceiver::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
