#include "vtkSmoothLightSilhouette.h"

#include "CasterCache.h"
#include "PolyDataBridge.h"
#include "SMPRangeLoop.h"
#include "SilhouetteData.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkSmoothLightSilhouette);

vtkSmoothLightSilhouette::vtkSmoothLightSilhouette()
  : Cache(std::make_unique<CasterCache>())
{
}

vtkSmoothLightSilhouette::~vtkSmoothLightSilhouette() = default;

int vtkSmoothLightSilhouette::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  SilhouetteSettings settings;
  settings.kind = static_cast<shadow::SilhouetteKind>(this->Kind);
  settings.caster = { this->MergePoints, this->FeatureAngle };
  std::copy_n(this->LightPosition, 4, settings.lightPosition.begin());
  if (!readLight(this->LightPosition, settings.light))
  {
    vtkErrorMacro(<< describeBadLight(this->LightPosition));
    return 0;
  }
  if (!std::isfinite(this->Tolerance) || !std::isfinite(this->FeatureAngle))
  {
    vtkErrorMacro("Tolerance " << this->Tolerance << " and FeatureAngle " << this->FeatureAngle
                               << " must be finite.");
    return 0;
  }
  if (isTooLarge(input))
  {
    vtkErrorMacro(<< describeTooLarge(input));
    return 0;
  }

  PreparedCaster& prepared = this->Cache->get(input, settings.caster);
  const double unit =
    this->ToleranceMode == RELATIVE ? 2.0 * prepared.caster.radius() : 1.0;
  const auto chain = prepared.caster.silhouette(settings.light, settings.kind,
    static_cast<shadow::SearchMethod>(this->Search), smpRangeLoop);
  const shadow::SilhouetteLoops loops = shadow::traceLoops(chain->pieces);
  if (!loops.balanced)
  {
    vtkErrorMacro("The silhouette of " << input->GetNumberOfCells()
                                       << " cells is not closed; please report this mesh.");
    return 0;
  }
  const shadow::LoopPolylines lines = shadow::makePolylines(
    prepared.caster, *chain, loops, this->Tolerance * unit, smpRangeLoop);
  writeSilhouette(prepared, *chain, loops, lines, settings, output);
  return 1;
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
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "ToleranceMode: " << this->ToleranceMode << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "MergePoints: " << this->MergePoints << "\n";
  os << indent << "KeptMemorySize: " << this->GetKeptMemorySize() << "\n";
}
