#include "vtkCastShadowAlgorithm.h"

#include "ContourData.h"
#include "PolyDataBridge.h"
#include "ReceiverCache.h"

#include "vtkAlgorithmOutput.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
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
}

vtkCastShadowAlgorithm::vtkCastShadowAlgorithm()
  : Receivers(std::make_unique<ReceiverCache>())
  , Casters(std::make_unique<ReceiverCache>())
{
  this->SetNumberOfInputPorts(3);
}

vtkCastShadowAlgorithm::~vtkCastShadowAlgorithm() = default;

void vtkCastShadowAlgorithm::SetSilhouetteConnection(vtkAlgorithmOutput* silhouette)
{
  this->SetInputConnection(0, silhouette);
}

void vtkCastShadowAlgorithm::AddSilhouetteConnection(vtkAlgorithmOutput* silhouette)
{
  this->AddInputConnection(0, silhouette);
}

void vtkCastShadowAlgorithm::SetReceiverConnection(vtkAlgorithmOutput* receiver)
{
  this->SetInputConnection(1, receiver);
}

void vtkCastShadowAlgorithm::AddReceiverConnection(vtkAlgorithmOutput* receiver)
{
  this->AddInputConnection(1, receiver);
}

void vtkCastShadowAlgorithm::SetCasterConnection(vtkAlgorithmOutput* caster)
{
  this->SetInputConnection(2, caster);
}

void vtkCastShadowAlgorithm::AddCasterConnection(vtkAlgorithmOutput* caster)
{
  this->AddInputConnection(2, caster);
}

int vtkCastShadowAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  if (port == 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

bool vtkCastShadowAlgorithm::ReadScene(
  vtkInformationVector** inputVector, bool withCasters, ContourInput& input)
{
  const std::vector<vtkPolyData*> silhouettes = inputsOf(inputVector[0]);
  const std::vector<vtkPolyData*> meshes = inputsOf(inputVector[1]);
  const std::vector<vtkPolyData*> casters =
    withCasters ? inputsOf(inputVector[2]) : std::vector<vtkPolyData*>();
  double* position = input.light;
  std::copy_n(this->LightPosition, 4, position);
  if (lightOf(silhouettes, position) == SilhouetteLight::Different)
  {
    vtkErrorMacro("The silhouettes on port 0 are of different lights, one of them (" << position[0]
      << ", " << position[1] << ", " << position[2] << ", " << position[3]
      << "), by their field data LightPosition: give each light a filter.");
    return false;
  }
  if (!readLight(position, input.scene.light))
  {
    vtkErrorMacro(<< describeBadLight(position));
    return false;
  }
  for (const auto* inputs : { &meshes, &casters })
  {
    const auto tooLarge = std::find_if(inputs->begin(), inputs->end(), isTooLarge);
    if (tooLarge != inputs->end())
    {
      vtkErrorMacro(<< describeTooLarge(*tooLarge));
      return false;
    }
  }
  for (std::size_t i = 0; i < silhouettes.size(); ++i)
  {
    addSilhouette(silhouettes[i], static_cast<int>(i), input);
  }
  input.meshes = meshes;
  input.receivers = this->Receivers->get(meshes);
  input.casters = this->Casters->get(casters);
  input.scene.receivers = meshesOf(input.receivers);
  input.scene.casters = meshesOf(input.casters);
  return true;
}

bool vtkCastShadowAlgorithm::CheckLight(const ContourInput& input, unsigned int lightPoint)
{
  if (lightPoint == shadow::None)
  {
    return true;
  }
  const shadow::Vec3& at = input.scene.loops.points[lightPoint];
  vtkErrorMacro("The light lies on a silhouette, at or beside (" << at.x << ", " << at.y << ", "
    << at.z << "), which then casts in all directions: move it off the caster.");
  return false;
}

void vtkCastShadowAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LightPosition: (" << this->LightPosition[0] << ", " << this->LightPosition[1]
     << ", " << this->LightPosition[2] << ", " << this->LightPosition[3] << ")\n";
  os << indent << "Builder: " << this->Builder << "\n";
}
