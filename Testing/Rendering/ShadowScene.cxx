#include "ShadowScene.h"

#include "ImageChecks.h"
#include "MaskComparison.h"

#include "vtkOffscreenWindows.h"

#include <vtkCamera.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkWindowToImageFilter.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>

namespace shadowtest
{
vtkSmartPointer<vtkRenderWindow> MakeWindow(int width, int height)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::Take(
    vtkOffscreenWindows::NewWindow(std::getenv("SMOOTHSHADOW_WINDOW")));
  if (!window)
  {
    throw std::runtime_error(vtkOffscreenWindows::GetLastReason());
  }
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  return window;
}

Image Grab(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->ReadFrontBufferOff();
  filter->ShouldRerenderOff();
  filter->Update();
  return filter->GetOutput();
}

unsigned char Byte(vtkImageData* image, int x, int y, int component)
{
  return static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0))[component];
}

long Differences(vtkImageData* a, vtkImageData* b)
{
  return compareImages(a, b).Pixels;
}

vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkLight> MakeLight(const RayLight& position, double intensity)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPositional(position[3] != 0.0);
  light->SetConeAngle(180.0);
  light->SetPosition(position[0], position[1], position[2]);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(intensity);
  return light;
}

Mesh FloatingBox()
{
  return moved(box(0.5, 0.4, 0.3), 1.0, { 0.0, 0.0, 1.0 }, 7);
}

//------------------------------------------------------------------------------------------------
Scene::Scene()
{
  this->Renderer->SetBackground(0.1, 0.2, 0.4);
  this->Renderer->AutomaticLightCreationOff();
  this->Renderer->SetPass(this->Pass);
  this->Pass->SetKindToDiscrete();
  this->Ground = this->Add(this->GroundMesh);
  this->Look(-3.0, -6.0, 5.0);
}

vtkSmartPointer<vtkActor> Scene::Add(vtkPolyData* mesh)
{
  vtkSmartPointer<vtkActor> actor = MakeActor(mesh);
  actor->GetProperty()->SetColor(Red, Green, Blue);
  actor->GetProperty()->SetAmbient(Ambient);
  actor->GetProperty()->SetDiffuse(Diffuse);
  this->Renderer->AddActor(actor);
  return actor;
}

vtkSmartPointer<vtkLight> Scene::AddLight(const RayLight& position, double intensity)
{
  vtkSmartPointer<vtkLight> light = MakeLight(position, intensity);
  this->Renderer->AddLight(light);
  return light;
}

vtkSmartPointer<vtkLight> Scene::AddHeadlight(double intensity)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToHeadlight();
  light->SetIntensity(intensity);
  this->Renderer->AddLight(light);
  return light;
}

void Scene::Look(double x, double y, double z)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(x, y, z);
  camera->SetFocalPoint(0.0, 0.0, 0.5);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetClippingRange(0.5, 40.0);
}

Image Scene::Mask(vtkLight* light)
{
  return Image::Take(this->Pass->GetMask(light));
}

//------------------------------------------------------------------------------------------------
RayView ViewOf(vtkRenderer* renderer, vtkImageData* image)
{
  return RayView::fromCamera(
    renderer->GetActiveCamera(), image->GetDimensions()[0], image->GetDimensions()[1]);
}

void ExpectMask(Scene& scene, vtkLight* light, const RayLight& position,
  const std::vector<RayObject>& objects, const char* what)
{
  const Image mask = scene.Mask(light);
  ASSERT_TRUE(mask) << what;
  const MaskComparison comparison =
    compareMask(RayScene(objects), ViewOf(scene.Renderer, mask), position, mask);
  EXPECT_EQ(comparison.total().WrongBeyond, 0) << what << "\n" << comparison.describe();
  EXPECT_GT(comparison.total().Shadowed, 200) << what << "\n" << comparison.describe();
}
}
