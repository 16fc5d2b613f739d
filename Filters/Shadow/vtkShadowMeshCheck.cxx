#include "vtkShadowMeshCheck.h"

#include "CasterCache.h"
#include "DefectTable.h"
#include "MeshCheck.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <cmath>

vtkStandardNewMacro(vtkShadowMeshCheck);

vtkShadowMeshCheck::vtkShadowMeshCheck()
  : Cache(std::make_unique<CasterCache>())
{
  this->SetNumberOfInputPorts(1);
}

vtkShadowMeshCheck::~vtkShadowMeshCheck() = default;

int vtkShadowMeshCheck::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkShadowMeshCheck::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkTable* output = vtkTable::GetData(outputVector);
  if (!std::isfinite(this->FeatureAngle))
  {
    vtkErrorMacro("FeatureAngle " << this->FeatureAngle << " must be finite.");
    return 0;
  }
  if (isTooLarge(input))
  {
    vtkErrorMacro(<< describeTooLarge(input));
    return 0;
  }
  const PreparedCaster& prepared =
    this->Cache->get(input, { this->MergePoints, this->FeatureAngle });
  writeDefects(checkMesh(input, prepared, this->CheckIntersections), output);
  return 1;
}

void vtkShadowMeshCheck::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergePoints: " << this->MergePoints << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "CheckIntersections: " << this->CheckIntersections << "\n";
}
