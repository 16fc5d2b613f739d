// Visibility masks of real meshes against a CPU ray cast of the same triangles. Leaves its masks
// and pictures in the folder SMOOTHSHADOW_PICTURES, where TestWindowsAgree compares those of the
// windows.

#include "ImageChecks.h"
#include "MaskComparison.h"
#include "RayCast.h"
#include "RealMeshes.h"
#include "ShadowScene.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include "vtkOffscreenWindows.h"
#include "vtkStencilShadowPass.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <cstdlib>

namespace
{
using namespace shadowtest;

struct MaskScene
{
  std::string name;
  int width = 512;
  int height = 512;
  int kind = vtkStencilShadowPass::DISCRETE;
};

class ShadowMasks : public ::testing::Test
{
protected:
  void setUp(
    const MaskScene& scene, const std::vector<RayObject>& objects, const RayLight& position)
  {
    this->Renderer = vtkSmartPointer<vtkRenderer>::New();
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    for (const RayObject& object : objects)
    {
      this->Renderer->AddActor(MakeActor(object.Surface));
    }
    this->Light = MakeLight(position);
    this->Renderer->AddLight(this->Light);
    this->Pass->SetKind(scene.kind);
    this->Renderer->SetPass(this->Pass);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(2.5, -4.5, 3.0);
    camera->SetFocalPoint(0.0, 0.0, -0.2);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(32.0);
    this->Renderer->ResetCameraClippingRange();
    this->Window = MakeWindow(scene.width, scene.height);
    this->Window->AddRenderer(this->Renderer);
  }

  void keepPictures(const std::string& name, vtkImageData* mask)
  {
    const char* folder = std::getenv("SMOOTHSHADOW_PICTURES");
    if (!folder)
    {
      return;
    }
    const std::string start =
      std::string(folder) + "/" + vtkOffscreenWindows::GetDefaultName() + "-" + name;
    writePng(mask, start + "-mask.png");
    writePng(Grab(this->Window), start + ".png");
  }

  void check(const MaskScene& scene, vtkPolyData* mesh, const RayLight& position)
  {
    SCOPED_TRACE(scene.name);
    double bounds[6];
    mesh->GetBounds(bounds);
    const std::vector<RayObject> objects = { { ground(bounds[4], 4.0, 8) }, { mesh } };
    this->setUp(scene, objects, position);
    this->Window->Render();
    const Image mask = Image::Take(this->Pass->GetMask(this->Light));
    ASSERT_TRUE(mask);
    this->keepPictures(scene.name, mask);
    if (scene.kind != vtkStencilShadowPass::DISCRETE)
    {
      return; // a smooth surface's shadow is not that of its triangles
    }
    const RayScene rays(objects);
    const RayView view =
      RayView::fromCamera(this->Renderer->GetActiveCamera(), scene.width, scene.height);
    const MaskComparison comparison = compareMask(rays, view, position, mask);
    // One may be stray, see tolerance::StrayPixels; what is too faint for 8 bits is black anyway.
    const MaskCount count = comparison.total();
    EXPECT_LE(count.WrongBeyond - count.WrongFaint, 1) << comparison.describe();
    EXPECT_LE(static_cast<double>(count.WrongFaint),
      tolerance::FaintPixels * static_cast<double>(count.Compared))
      << comparison.describe();
    EXPECT_GT(comparison.Objects[0].Shadowed, 2000) << comparison.describe();
    EXPECT_GT(comparison.Objects[1].Shadowed, 50) << comparison.describe();
  }

  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkLight> Light;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkStencilShadowPass> Pass;
};

const RayLight Point = { 1.5, 1.5, 3.5, 1.0 };
const RayLight Direction = { -1.0, -0.6, 1.5, 0.0 };
}

TEST_F(ShadowMasks, BunnyByPointLight)
{
  this->check({ "bunny-point" }, standing(bunny(), 1), Point);
}

TEST_F(ShadowMasks, BunnyByDirectionalLight)
{
  this->check({ "bunny-direction" }, standing(bunny(), 1), Direction);
}

TEST_F(ShadowMasks, BunnyInAWideWindow)
{
  this->check({ "bunny-wide", 640, 400 }, standing(bunny(), 1), Point);
}

TEST_F(ShadowMasks, SmoothBunny)
{
  this->check(
    { "bunny-smooth", 512, 512, vtkStencilShadowPass::SMOOTH }, standing(bunny(), 1), Point);
}

TEST_F(ShadowMasks, ArmadilloByPointLight)
{
  this->check({ "armadillo-point" }, standing(cgalMesh("armadillo"), 1), Point);
}

TEST_F(ShadowMasks, ElephantByDirectionalLight)
{
  this->check({ "elephant-direction" }, standing(cgalMesh("refined_elephant"), 1), Direction);
}

TEST_F(ShadowMasks, Torus)
{
  this->check({ "torus-point" }, torus(48, 24), Point);
  this->check({ "torus-direction" }, torus(48, 24), Direction);
}
