#include "vtkCastShadowContour.h"

#include "ContourData.h"
#include "PolyDataBridge.h"
#include "ReceiverCache.h"
#include "SMPRangeLoop.h"

#include "vtkAlgorithmOutput.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace
{
std::vector<vtkPolyData*> inputsOf(vtkInformationVector* port)
{
  std::vector<vtkPolyData*> inputs;
  for (int i = 0; i < port->GetNumberOfInformationObjects(); ++i)
  {
    inputs.push_back(vtkPolyData::GetData(port, i));
  }
  return inputs;
}

std::vector<shadow::ContourReceiver> meshesOf(
  const std::vector<std::shared_ptr<const PreparedReceiver>>& prepared)
{
  std::vector<shadow::ContourReceiver> meshes;
  for (const auto& one : prepared)
  {
    meshes.push_back({ &one->mesh, &one->edges });
  }
  return meshes;
}

vtkPolyData* firstTooLarge(const std::vector<vtkPolyData*>& meshes)
{
  const auto found = std::find_if(meshes.begin(), meshes.end(), isTooLarge);
  return found != meshes.end() ? *found : nullptr;
}
}

vtkStandardNewMacro(vtkCastShadowContour);

vtkCastShadowContour::vtkCastShadowContour()
  : Receivers(std::make_unique<ReceiverCache>())
  , Casters(std::make_unique<ReceiverCache>())
{
  this->SetNumberOfInputPorts(3);
}

vtkCastShadowContour::~vtkCastShadowContour() = default;

void vtkCastShadowContour::SetSilhouetteConnection(vtkAlgorithmOutput* silhouette)
{
  this->SetInputConnection(0, silhouette);
}

void vtkCastShadowContour::AddSilhouetteConnection(vtkAlgorithmOutput* silhouette)
{
  this->AddInputConnection(0, silhouette);
}

void vtkCastShadowContour::SetReceiverConnection(vtkAlgorithmOutput* receiver)
{
  this->SetInputConnection(1, receiver);
}

void vtkCastShadowContour::AddReceiverConnection(vtkAlgorithmOutput* receiver)
{
  this->AddInputConnection(1, receiver);
}

void vtkCastShadowContour::SetCasterConnection(vtkAlgorithmOutput* caster)
{
  this->SetInputConnection(2, caster);
}

void vtkCastShadowContour::AddCasterConnection(vtkAlgorithmOutput* caster)
{
  this->AddInputConnection(2, caster);
}

int vtkCastShadowContour::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  if (port == 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

int vtkCastShadowContour::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const std::vector<vtkPolyData*> silhouettes = inputsOf(inputVector[0]);
  const std::vector<vtkPolyData*> meshes = inputsOf(inputVector[1]);
  const std::vector<vtkPolyData*> blockers =
    this->RemoveHidden ? inputsOf(inputVector[2]) : std::vector<vtkPolyData*>();
  double position[4];
  std::copy_n(this->LightPosition, 4, position);
  if (lightOf(silhouettes, position) == SilhouetteLight::Different)
  {
    vtkErrorMacro("The silhouettes on port 0 are of different lights, one of them (" << position[0]
      << ", " << position[1] << ", " << position[2] << ", " << position[3]
      << "), by their field data LightPosition: give each light a filter.");
    return 0;
  }
  shadow::Light light;
  if (!readLight(position, light))
  {
    vtkErrorMacro(<< describeBadLight(position));
    return 0;
  }
  for (const auto* inputs : { &meshes, &blockers })
  {
    if (vtkPolyData* mesh = firstTooLarge(*inputs))
    {
      vtkErrorMacro(<< describeTooLarge(mesh));
      return 0;
    }
  }

  ContourInput input;
  shadow::ContourScene& scene = input.scene;
  scene.light = light;
  for (std::size_t i = 0; i < silhouettes.size(); ++i)
  {
    addSilhouette(silhouettes[i], static_cast<int>(i), input);
  }
  const auto receivers = this->Receivers->get(meshes);
  const auto casters = this->Casters->get(blockers);
  scene.receivers = meshesOf(receivers);
  scene.casters = meshesOf(casters);
  shadow::ContourReport report;
  shadow::CastContours contours = shadow::castContours(scene,
    { static_cast<shadow::TreeBuilder>(this->Builder), this->KeepHidden }, smpRangeLoop, report);
  if (report.lightPoint != shadow::None)
  {
    const shadow::Vec3& at = scene.loops.points[report.lightPoint];
    vtkErrorMacro("The light lies on a silhouette, at or beside (" << at.x << ", " << at.y << ", "
      << at.z << "), which then casts in all directions: move it off the caster.");
    return 0;
  }
  if (this->GridSpacing > 0.0)
  {
    contours = onGrid(contours, this->GridSpacing);
  }
  writeContours(contours, input, report, position, vtkPolyData::GetData(outputVector));
  return 1;
}

void vtkCastShadowContour::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LightPosition: (" << this->LightPosition[0] << ", " << this->LightPosition[1]
     << ", " << this->LightPosition[2] << ", " << this->LightPosition[3] << ")\n";
  os << indent << "Builder: " << this->Builder << "\n";
  os << indent << "RemoveHidden: " << (this->RemoveHidden ? "on" : "off") << "\n";
  os << indent << "KeepHidden: " << (this->KeepHidden ? "on" : "off") << "\n";
  os << indent << "GridSpacing: " << this->GridSpacing << "\n";
}
