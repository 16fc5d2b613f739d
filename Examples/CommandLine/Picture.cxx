#include "Picture.h"

#include "Failure.h"
#include "LightMoves.h"
#include "Messages.h"
#include "SilhouetteOptions.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkInformation.h>
#include <vtkOffscreenWindows.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <sstream>

namespace
{
constexpr std::array<Vector3, 4> MeshColours = { Vector3{ 0.91, 0.66, 0.42 },
  Vector3{ 0.45, 0.65, 0.82 }, Vector3{ 0.60, 0.74, 0.46 }, Vector3{ 0.80, 0.52, 0.60 } };
constexpr Vector3 GroundColour = { 0.92, 0.92, 0.90 };
constexpr Vector3 Background = { 0.80, 0.85, 0.90 };

// So much light comes from the lamps in all; the rest, which shadows leave, from the eye and from
// everywhere.
constexpr double KeyIntensity = 0.75;
constexpr double FillIntensity = 0.28;
constexpr double Ambient = 0.14;

vtkNew<vtkActor> MakeActor(const Vector3& colour)
{
  vtkNew<vtkActor> actor;
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->SetAmbient(Ambient);
  return actor;
}

void Place(vtkLight* light, const Homogeneous& position)
{
  light->SetPositional(position[3] != 0.0);
  light->SetPosition(position[0], position[1], position[2]);
  light->SetFocalPoint(0.0, 0.0, 0.0);
}
}

Picture::Picture(const std::string& window, const std::array<int, 2>& size)
  : WindowName(window)
  , Size(size)
{
  this->Window.TakeReference(vtkOffscreenWindows::NewWindow(window.c_str()));
  if (!this->Window)
  {
    throw Failure("no window (" + vtkOffscreenWindows::GetLastReason() + ")", "--window " + window,
      "choose another of egl, osmesa, native");
  }
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(size[0], size[1]);
  this->Renderer->SetBackground(Background[0], Background[1], Background[2]);
  this->Renderer->AutomaticLightCreationOff();
  this->Window->AddRenderer(this->Renderer);
}

void Picture::AddMeshes(const std::vector<vtkPolyData*>& meshes)
{
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(meshes[i]);
    mapper->ScalarVisibilityOff();
    const vtkNew<vtkActor> actor = MakeActor(MeshColours[i % MeshColours.size()]);
    actor->SetMapper(mapper);
    actor->GetProperty()->SetSpecular(0.25);
    actor->GetProperty()->SetSpecularPower(30.0);
    this->Renderer->AddActor(actor);
  }
}

void Picture::AddScene(const Scene& scene, bool ground)
{
  if (ground)
  {
    const Ground square = scene.GroundSquare();
    vtkNew<vtkPlaneSource> plane;
    plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    plane->SetOrigin(square.Origin[0], square.Origin[1], square.Origin[2]);
    plane->SetPoint1(square.Point1[0], square.Point1[1], square.Point1[2]);
    plane->SetPoint2(square.Point2[0], square.Point2[1], square.Point2[2]);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    const vtkNew<vtkActor> actor = MakeActor(GroundColour);
    actor->SetMapper(mapper);
    // Nothing lies under it that its shadow could meet.
    vtkNew<vtkInformation> keys;
    keys->Set(vtkStencilShadowPass::CASTS_SHADOW(), 0);
    actor->SetPropertyKeys(keys);
    this->Renderer->AddActor(actor);
  }

  const std::vector<Homogeneous>& positions = scene.Lights();
  for (const Homogeneous& position : positions)
  {
    const auto light = vtkSmartPointer<vtkLight>::New();
    light->SetLightTypeToSceneLight();
    light->SetConeAngle(180.0); // in all directions
    light->SetIntensity(KeyIntensity / static_cast<double>(positions.size()));
    Place(light, position);
    this->Renderer->AddLight(light);
    this->Lights.push_back(light);
  }
  this->AddFillLight();

  const Camera view = scene.View();
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(view.Eye.data());
  camera->SetFocalPoint(view.At.data());
  camera->SetViewUp(view.Up.data());
  camera->SetViewAngle(view.Angle);
  this->Renderer->ResetCameraClippingRange();
}

// From the eye, so that it throws no shadow that is seen, and what lies in shadow keeps its shape.
void Picture::AddFillLight()
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  light->SetIntensity(FillIntensity);
  this->Renderer->AddLight(light);
}

void Picture::CastShadows(const ShadowOptions& options)
{
  this->Pass = vtkSmartPointer<vtkStencilShadowPass>::New();
  this->Pass->SetKind(options.Kind == "auto" ? static_cast<int>(vtkStencilShadowPass::AUTOMATIC)
                                             : KindNumber(options.Kind));
  this->Pass->SetPixelTolerance(options.PixelTolerance);
  static const std::map<std::string, int> countings = { { "auto", vtkStencilShadowPass::AUTOMATIC },
    { "zpass", vtkStencilShadowPass::Z_PASS }, { "zfail", vtkStencilShadowPass::Z_FAIL } };
  this->Pass->SetCounting(countings.at(options.Counting));
  this->Pass->SetStepTiming(options.Plan);
  this->Pass->SetReuseUnchanged(!options.Plan);
  this->Renderer->SetPass(this->Pass);
}

double Picture::Draw()
{
  ClearMessages();
  const double time = Milliseconds([this] {
    this->Window->Render();
    this->Window->WaitForCompletion();
  });
  const std::string error = FirstError();
  if (!error.empty())
  {
    throw Failure(
      "drawing failed (" + error + ")", "--window " + this->WindowName, "try another window");
  }
  const std::string warning = FirstWarning();
  if (!warning.empty())
  {
    std::cerr << "smoothshadow: warning: " << warning << std::endl;
  }
  return time;
}

void Picture::MoveLights(const Scene& scene, double size, int step)
{
  for (std::size_t i = 0; i < this->Lights.size(); ++i)
  {
    Place(this->Lights[i], MovedLight(scene.Lights()[i], size, step));
  }
}

vtkSmartPointer<vtkImageData> Picture::Image()
{
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(this->Window);
  capture->SetInputBufferTypeToRGB();
  capture->ReadFrontBufferOff();
  capture->ShouldRerenderOff();
  capture->Update();
  return capture->GetOutput();
}

vtkSmartPointer<vtkTable> Picture::Plan()
{
  vtkSmartPointer<vtkTable> plan;
  if (this->Pass)
  {
    plan.TakeReference(this->Pass->GetPlan());
  }
  return plan;
}

vtkSmartPointer<vtkImageData> Picture::Mask(std::size_t light)
{
  vtkSmartPointer<vtkImageData> mask;
  if (this->Pass)
  {
    mask.TakeReference(this->Pass->GetMask(this->Lights.at(light)));
  }
  if (!mask)
  {
    // A light that casts nothing is visible everywhere.
    mask = vtkSmartPointer<vtkImageData>::New();
    mask->SetDimensions(this->Size[0], this->Size[1], 1);
    mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    auto* values = static_cast<unsigned char*>(mask->GetScalarPointer());
    std::fill_n(values, mask->GetNumberOfPoints(), static_cast<unsigned char>(255));
  }
  return mask;
}

std::string Picture::GraphicsName()
{
  const std::string wanted = "OpenGL renderer string:";
  const char* capabilities = this->Window->ReportCapabilities();
  std::istringstream lines(capabilities ? capabilities : "");
  for (std::string line; std::getline(lines, line);)
  {
    if (line.compare(0, wanted.size(), wanted) == 0)
    {
      const std::size_t begin = line.find_first_not_of(' ', wanted.size());
      return begin == std::string::npos ? "" : line.substr(begin);
    }
  }
  return "";
}
