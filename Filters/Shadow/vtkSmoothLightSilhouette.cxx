#include "vtkSmoothLightSilhouette.h"

#include "CasterCache.h"
#include "PolyDataBridge.h"
#include "SMPRangeLoop.h"
#include "SilhouetteData.h"

#include "vtkAlgorithmOutput.h"
#include "vtkBoundingBox.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace
{
/// Of all inputs of a port. Not valid where there are none with points, or where they have no end.
vtkBoundingBox boundsOf(vtkInformationVector* inputs)
{
  vtkBoundingBox bounds;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    if (vtkDataSet* receiver = vtkDataSet::GetData(inputs, i))
    {
      bounds.AddBounds(receiver->GetBounds());
    }
  }
  const bool ends = std::isfinite(bounds.GetDiagonalLength());
  return ends ? bounds : vtkBoundingBox();
}

shadow::ShadowReceiver receiverOf(const shadow::Light& light, const vtkBoundingBox& bounds)
{
  const double* low = bounds.GetMinPoint();
  const double* high = bounds.GetMaxPoint();
  return { light, shadow::Vec3(low[0], low[1], low[2]), shadow::Vec3(high[0], high[1], high[2]) };
}
}

vtkStandardNewMacro(vtkSmoothLightSilhouette);

vtkSmoothLightSilhouette::vtkSmoothLightSilhouette()
  : Cache(std::make_unique<CasterCache>())
{
  this->SetNumberOfInputPorts(2);
}

vtkSmoothLightSilhouette::~vtkSmoothLightSilhouette() = default;

void vtkSmoothLightSilhouette::SetReceiverConnection(vtkAlgorithmOutput* receivers)
{
  this->SetInputConnection(1, receivers);
}

void vtkSmoothLightSilhouette::AddReceiverConnection(vtkAlgorithmOutput* receivers)
{
  this->AddInputConnection(1, receivers);
}

int vtkSmoothLightSilhouette::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

bool vtkSmoothLightSilhouette::ReadSettings(vtkPolyData* input, SilhouetteSettings& settings)
{
  settings.kind = static_cast<shadow::SilhouetteKind>(this->Kind);
  settings.caster = { this->MergePoints, this->FeatureAngle };
  std::copy_n(this->LightPosition, 4, settings.lightPosition.begin());
  if (!readLight(this->LightPosition, settings.light))
  {
    vtkErrorMacro(<< describeBadLight(this->LightPosition));
    return false;
  }
  if (!std::isfinite(this->Tolerance) || !std::isfinite(this->FeatureAngle))
  {
    vtkErrorMacro("Tolerance " << this->Tolerance << " and FeatureAngle " << this->FeatureAngle
                               << " must be finite.");
    return false;
  }
  if (isTooLarge(input))
  {
    vtkErrorMacro(<< describeTooLarge(input));
    return false;
  }
  return true;
}

int vtkSmoothLightSilhouette::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  SilhouetteSettings settings;
  if (!this->ReadSettings(input, settings))
  {
    return 0;
  }
  const bool onReceivers = this->ToleranceMode == RECEIVER;
  const vtkBoundingBox receivers = onReceivers ? boundsOf(inputVector[1]) : vtkBoundingBox();
  if (onReceivers && !receivers.IsValid())
  {
    vtkErrorMacro(
      "ToleranceMode RECEIVER needs receivers with finite points on port 1: connect some, "
      "or take WORLD or RELATIVE.");
    return 0;
  }

  PreparedCaster& prepared = this->Cache->get(input, settings.caster);
  const auto chain = prepared.caster.silhouette(settings.light, settings.kind,
    { static_cast<shadow::SearchMethod>(this->Search), this->SampleFraction,
      static_cast<std::uint32_t>(this->Seed) },
    this->Cache->lastTracked(), smpRangeLoop);
  settings.complete = chain->complete;
  const shadow::SilhouetteLoops loops =
    shadow::traceLoops(chain->pieces, prepared.caster.mesh().points.size());
  if (!loops.balanced)
  {
    vtkErrorMacro("The silhouette of " << input->GetNumberOfCells()
                                       << " cells is not closed; please report this mesh.");
    return 0;
  }
  const double unit = this->ToleranceMode == RELATIVE ? 2.0 * prepared.caster.radius() : 1.0;
  std::optional<shadow::ShadowReceiver> receiver;
  if (onReceivers)
  {
    receiver = receiverOf(chain->light, receivers);
  }
  writeSilhouette(prepared, *chain, loops,
    { this->Tolerance * unit, onReceivers ? &*receiver : nullptr }, settings, output);
  return 1;
}

double vtkSmoothLightSilhouette::ComputeMeshDeviation()
{
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return 0.0;
  }
  this->GetInputAlgorithm()->Update();
  vtkPolyData* input = vtkPolyData::SafeDownCast(this->GetInputDataObject(0, 0));
  if (!input || isTooLarge(input) || !std::isfinite(this->FeatureAngle))
  {
    return 0.0;
  }
  PreparedCaster& prepared = this->Cache->get(input, { this->MergePoints, this->FeatureAngle });
  return prepared.caster.edgeDeviation(smpRangeLoop);
}

unsigned long vtkSmoothLightSilhouette::GetKeptMemorySize() const
{
  return static_cast<unsigned long>((this->Cache->memory() + 1023) / 1024);
}

void vtkSmoothLightSilhouette::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LightPosition: (" << this->LightPosition[0] << ", " << this->LightPosition[1]
     << ", " << this->LightPosition[2] << ", " << this->LightPosition[3] << ")\n";
  os << indent << "Kind: " << this->Kind << "\n";
  os << indent << "Search: " << this->Search << "\n";
  os << indent << "SampleFraction: " << this->SampleFraction << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "ToleranceMode: " << this->ToleranceMode << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MergePoints: " << this->MergePoints << "\n";
  os << indent << "KeptMemorySize: " << this->GetKeptMemorySize() << "\n";
}
