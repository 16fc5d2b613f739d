#include "vtkShadowVolumeExtruder.h"

#include "PolyDataBridge.h"
#include "SMPRangeLoop.h"
#include "SilhouetteData.h"
#include "VolumeData.h"

#include "vtkAlgorithmOutput.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cassert>

namespace
{
shadow::Caps coreCaps(int caps)
{
  switch (caps)
  {
    case vtkShadowVolumeExtruder::NONE:
      return shadow::Caps::None;
    case vtkShadowVolumeExtruder::LIT:
      return shadow::Caps::Lit;
    default:
      return shadow::Caps::Dark;
  }
}

shadow::SilhouetteInput discreteSilhouette(
  const shadow::Caster& caster, const shadow::SilhouetteChain& chain)
{
  const shadow::SilhouetteLoops loops =
    shadow::traceLoops(chain.pieces, caster.mesh().points.size());
  assert(loops.balanced); // a boundary always is
  return toInput(caster, chain, loops);
}
}

vtkStandardNewMacro(vtkShadowVolumeExtruder);

vtkShadowVolumeExtruder::vtkShadowVolumeExtruder()
  : Cache(std::make_unique<CasterCache>())
{
  this->SetNumberOfInputPorts(2);
}

vtkShadowVolumeExtruder::~vtkShadowVolumeExtruder() = default;

void vtkShadowVolumeExtruder::SetSilhouetteConnection(vtkAlgorithmOutput* silhouette)
{
  this->SetInputConnection(1, silhouette);
}

int vtkShadowVolumeExtruder::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkShadowVolumeExtruder::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* given = vtkPolyData::GetData(inputVector[1]);
  SilhouetteSettings settings;
  if (given && !readSettings(given, settings))
  {
    vtkErrorMacro("The silhouette on port 1 lacks its field data or its light: give it the output "
                  "of vtkSmoothLightSilhouette.");
    return 0;
  }
  if (!given && !readLight(this->LightPosition, settings.light))
  {
    vtkErrorMacro(<< describeBadLight(this->LightPosition));
    return 0;
  }
  if (isTooLarge(input))
  {
    vtkErrorMacro(<< describeTooLarge(input));
    return 0;
  }

  shadow::Caster& caster = this->Cache->get(input, settings.caster).caster;
  const auto chain = caster.silhouette(
    settings.light, settings.kind, {}, this->Cache->lastTracked(), smpRangeLoop);
  shadow::SilhouetteInput silhouette;
  shadow::Match match = shadow::Match::Whole;
  if (!given)
  {
    silhouette = discreteSilhouette(caster, *chain);
  }
  else
  {
    match = readSilhouette(given, caster, *chain, silhouette)
      ? shadow::match(silhouette, caster, *chain)
      : shadow::Match::None;
  }
  // Only a search that says so may have left some of it out.
  if (match == shadow::Match::None || (match == shadow::Match::Part && settings.complete))
  {
    vtkErrorMacro("The silhouette on port 1 is not that of the mesh on port 0, which has "
      << input->GetNumberOfCells()
      << " cells: connect vtkSmoothLightSilhouette to the same mesh and leave its output as it "
         "is.");
    return 0;
  }
  const double length = this->Length > 0.0 ? this->Length : 20.0 * caster.radius();
  writeVolume(
    shadow::extrude(caster, *chain, silhouette, { coreCaps(this->Caps), this->WallStrips }),
    caster.centre(), length, this->Caps != NONE && match == shadow::Match::Whole,
    vtkPolyData::GetData(outputVector));
  return 1;
}

void vtkShadowVolumeExtruder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LightPosition: (" << this->LightPosition[0] << ", " << this->LightPosition[1]
     << ", " << this->LightPosition[2] << ", " << this->LightPosition[3] << ")\n";
  os << indent << "Caps: " << this->Caps << "\n";
  os << indent << "Length: " << this->Length << "\n";
  os << indent << "WallStrips: " << (this->WallStrips ? "on" : "off") << "\n";
}
