#include "vtkCastShadowContour.h"

#include "ContourData.h"
#include "SMPRangeLoop.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkCastShadowContour);

vtkCastShadowContour::vtkCastShadowContour() = default;
vtkCastShadowContour::~vtkCastShadowContour() = default;

int vtkCastShadowContour::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  ContourInput input;
  if (!this->ReadScene(inputVector, this->RemoveHidden, input))
  {
    return 0;
  }
  shadow::ContourReport report;
  shadow::CastContours contours = shadow::castContours(input.scene,
    { static_cast<shadow::TreeBuilder>(this->Builder), this->KeepHidden }, smpRangeLoop, report);
  if (!this->CheckLight(input, report.lightPoint))
  {
    return 0;
  }
  if (this->GridSpacing > 0.0)
  {
    contours = onGrid(contours, this->GridSpacing);
  }
  writeContours(contours, input, report, vtkPolyData::GetData(outputVector));
  return 1;
}

void vtkCastShadowContour::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RemoveHidden: " << (this->RemoveHidden ? "on" : "off") << "\n";
  os << indent << "KeepHidden: " << (this->KeepHidden ? "on" : "off") << "\n";
  os << indent << "GridSpacing: " << this->GridSpacing << "\n";
}
