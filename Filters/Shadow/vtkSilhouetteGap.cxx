#include "vtkSilhouetteGap.h"

#include "GapData.h"
#include "PolyDataBridge.h"
#include "SMPRangeLoop.h"
#include "SilhouetteData.h"

#include "vtkAlgorithmOutput.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkSilhouetteGap);

vtkSilhouetteGap::vtkSilhouetteGap()
  : Cache(std::make_unique<CasterCache>())
{
  this->SetNumberOfInputPorts(2);
}

vtkSilhouetteGap::~vtkSilhouetteGap() = default;

void vtkSilhouetteGap::SetSilhouetteConnection(vtkAlgorithmOutput* silhouette)
{
  this->SetInputConnection(1, silhouette);
}

int vtkSilhouetteGap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* given = vtkPolyData::GetData(inputVector[1]);
  SilhouetteSettings settings;
  if (!readSettings(given, settings))
  {
    vtkErrorMacro(<< describeUnreadableSilhouette());
    return 0;
  }
  if (isTooLarge(input))
  {
    vtkErrorMacro(<< describeTooLarge(input));
    return 0;
  }
  shadow::Caster& caster = this->Cache->get(input, settings.caster).caster;
  const auto chain =
    caster.silhouette(settings.light, settings.kind, {}, this->Cache->lastTracked(), smpRangeLoop);
  shadow::SilhouetteInput silhouette;
  std::vector<shadow::Vec3> normals;
  if (matchSilhouette(given, settings, caster, *chain, silhouette) == shadow::Match::None ||
    !readNormals(given, normals))
  {
    vtkErrorMacro(<< describeForeignSilhouette(input));
    return 0;
  }
  const shadow::NearEnd nearEnd =
    shadow::makeNearEnd(caster, *chain, silhouette, shadow::Caps::None);
  writeGap(
    shadow::makeSilhouetteGap(nearEnd, silhouette, normals), vtkPolyData::GetData(outputVector));
  return 1;
}

void vtkSilhouetteGap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
