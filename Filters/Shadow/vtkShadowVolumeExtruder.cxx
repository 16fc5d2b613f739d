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
#include <sstream>

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

shadow::Vec3 toVector(const double v[3])
{
  return { v[0], v[1], v[2] };
}

std::string describeUnreached(std::size_t count, const shadow::ShadowEnd& end)
{
  std::ostringstream message;
  message << "The rays of " << count << " points do not come to the plane through ("
          << end.planeOrigin.x << ", " << end.planeOrigin.y << ", " << end.planeOrigin.z
          << ") with the normal (" << end.planeNormal.x << ", " << end.planeNormal.y << ", "
          << end.planeNormal.z << "): move it behind the mesh, or take Extent LENGTH or INFINITE.";
  return message.str();
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

bool vtkShadowVolumeExtruder::ReadSettings(
  vtkPolyData* input, vtkPolyData* given, SilhouetteSettings& settings)
{
  if (given && !readSettings(given, settings))
  {
    vtkErrorMacro(<< describeUnreadableSilhouette());
    return false;
  }
  if (!given && !readLight(this->LightPosition, settings.light))
  {
    vtkErrorMacro(<< describeBadLight(this->LightPosition));
    return false;
  }
  if (isTooLarge(input))
  {
    vtkErrorMacro(<< describeTooLarge(input));
    return false;
  }
  return true;
}

int vtkShadowVolumeExtruder::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* given = vtkPolyData::GetData(inputVector[1]);
  SilhouetteSettings settings;
  if (!this->ReadSettings(input, given, settings))
  {
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
    match = matchSilhouette(given, settings, caster, *chain, silhouette);
  }
  if (match == shadow::Match::None)
  {
    vtkErrorMacro(<< describeForeignSilhouette(input));
    return 0;
  }
  const shadow::NearEnd nearEnd =
    shadow::makeNearEnd(caster, *chain, silhouette, coreCaps(this->Caps));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (this->Extent == NEAR_END)
  {
    writeNearEnd(nearEnd, output);
    return 1;
  }
  const shadow::ShadowEnd end{ static_cast<shadow::Extent>(this->Extent),
    this->Length > 0.0 ? this->Length : 20.0 * caster.radius(), toVector(this->PlaneOrigin),
    toVector(this->PlaneNormal) };
  const shadow::ShadowVolume volume =
    shadow::extrude(nearEnd, { end, this->WallStrips });
  if (volume.unreached > 0)
  {
    vtkErrorMacro(<< describeUnreached(volume.unreached, end));
    return 0;
  }
  writeVolume(volume, caster.centre(), end,
    this->Caps != NONE && match == shadow::Match::Whole, output);
  return 1;
}

void vtkShadowVolumeExtruder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LightPosition: (" << this->LightPosition[0] << ", " << this->LightPosition[1]
     << ", " << this->LightPosition[2] << ", " << this->LightPosition[3] << ")\n";
  os << indent << "Caps: " << this->Caps << "\n";
  os << indent << "Extent: " << this->Extent << "\n";
  os << indent << "Length: " << this->Length << "\n";
  os << indent << "PlaneOrigin: (" << this->PlaneOrigin[0] << ", " << this->PlaneOrigin[1] << ", "
     << this->PlaneOrigin[2] << ")\n";
  os << indent << "PlaneNormal: (" << this->PlaneNormal[0] << ", " << this->PlaneNormal[1] << ", "
     << this->PlaneNormal[2] << ")\n";
  os << indent << "WallStrips: " << (this->WallStrips ? "on" : "off") << "\n";
}
