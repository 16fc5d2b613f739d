// Views and windows that break stencil shadows: each mask is held against the ray cast. Leaves its
// pictures in the folder SMOOTHSHADOW_PICTURES, to look at.

#include "ImageChecks.h"
#include "MaskComparison.h"
#include "RayCast.h"
#include "ShadowScene.h"
#include "TestMeshes.h"

#include "vtkOffscreenWindows.h"
#include "vtkStencilShadowPass.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{
using namespace shadowtest;

/// Draws, and keeps the picture if that is asked for.
void render(vtkRenderWindow* window, const std::string& name)
{
  window->Render();
  if (const char* folder = std::getenv("SMOOTHSHADOW_PICTURES"))
  {
    writePng(Grab(window),
      std::string(folder) + "/" + vtkOffscreenWindows::GetDefaultName() + "-hard-" + name + ".png");
  }
}
}

TEST(HardPictures, NearPlaneThroughAVolume)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  scene.Add(mesh);
  vtkSmartPointer<vtkLight> light = scene.AddLight(DirectionalLight);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  // Behind the caster and within reach of its shadow: the near plane cuts the walls.
  camera->SetPosition(-1.0, -0.3, 0.6);
  camera->SetFocalPoint(-0.4, 0.3, 0.0);
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  for (const double nearest : { 0.05, 0.3, 0.5, 0.6 })
  {
    camera->SetClippingRange(nearest, 12.0);
    render(window, "near-plane-" + std::to_string(nearest));
    // The oracle looks from the near plane on, so it does not see what that plane cuts away.
    ExpectMask(scene, light, DirectionalLight, { { scene.GroundMesh }, { mesh } }, "near plane");
  }
}

TEST(HardPictures, NearPlaneThroughTheCaster)
{
  // Its shadow on the ground is that of the whole. What is left of it is seen from inside, where
  // closed meshes are taken as solid and lit: that is not compared.
  Scene scene;
  const Mesh mesh = moved(torus(24, 12), 0.8, { 0.0, 0.0, 1.3 }, 3);
  scene.Add(mesh);
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  const double distance = camera->GetDistance();
  for (const double nearest : { distance - 0.8, distance - 0.3, distance + 0.5 })
  {
    camera->SetClippingRange(nearest, 40.0);
    render(window, "cut-caster-" + std::to_string(nearest));
    const Image mask = scene.Mask(light);
    ASSERT_TRUE(mask);
    const MaskComparison comparison = compareMask(
      RayScene({ { scene.GroundMesh }, { mesh } }), ViewOf(scene.Renderer, mask), PointLight, mask);
    EXPECT_EQ(comparison.Objects[0].WrongBeyond, 0) << comparison.describe();
    EXPECT_EQ(comparison.Background.WrongBeyond, 0) << comparison.describe();
    EXPECT_GT(comparison.Objects[0].Shadowed, 500) << comparison.describe();
  }
}

TEST(HardPictures, FarPlaneNear)
{
  // Just behind what is seen, so that it cuts all volumes, and through the scene.
  for (const RayLight& position : { PointLight, DirectionalLight })
  {
    Scene scene;
    const Mesh mesh = FloatingBox();
    scene.Add(mesh);
    vtkSmartPointer<vtkLight> light = scene.AddLight(position);
    auto window = MakeWindow(240, 180);
    window->AddRenderer(scene.Renderer);
    for (const double farthest : { 13.0, 9.5, 8.5 })
    {
      scene.Renderer->GetActiveCamera()->SetClippingRange(0.5, farthest);
      render(window, "far-plane-" + std::to_string(farthest));
      ExpectMask(scene, light, position, { { scene.GroundMesh }, { mesh } }, "far plane");
    }
  }
}

TEST(HardPictures, EyeInShadow)
{
  for (const RayLight& position : { PointLight, DirectionalLight })
  {
    Scene scene;
    const Mesh roof = moved(box(2.0, 2.0, 0.05), 1.0, { 0.0, 0.0, 1.5 });
    scene.Add(roof);
    vtkSmartPointer<vtkLight> light = scene.AddLight(position);
    scene.Look(0.3, 0.2, 0.9);
    scene.Renderer->GetActiveCamera()->SetFocalPoint(-2.0, -3.0, 0.0);
    scene.Renderer->GetActiveCamera()->SetClippingRange(0.01, 20.0);
    auto window = MakeWindow(240, 180);
    window->AddRenderer(scene.Renderer);
    render(window, "eye-in-shadow");
    ExpectMask(scene, light, position, { { scene.GroundMesh }, { roof } }, "under a roof");
    const double dark = blackFraction(scene.Mask(light));
    EXPECT_GT(dark, 0.1);
    EXPECT_LT(dark, 0.95);
  }
}

TEST(HardPictures, LightInView)
{
  Scene scene;
  const Mesh mesh = moved(box(), 0.4, { 1.6, 1.2, 3.2 }, 5);
  scene.Add(mesh);
  const RayLight position = { 2.6, 2.0, 5.0, 1.0 };
  vtkSmartPointer<vtkLight> light = scene.AddLight(position);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(-3.0, -2.0, 3.0);
  camera->SetFocalPoint(1.6, 1.2, 2.6);
  camera->SetViewAngle(80.0);
  scene.Renderer->SetWorldPoint(position.data());
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  scene.Renderer->WorldToView();
  EXPECT_LT(std::abs(scene.Renderer->GetViewPoint()[0]), 1.0);
  EXPECT_LT(std::abs(scene.Renderer->GetViewPoint()[1]), 1.0);
  render(window, "light-in-view");
  ExpectMask(scene, light, position, { { scene.GroundMesh }, { mesh } }, "light in view");
}

TEST(HardPictures, HugeGroundPlane)
{
  // The sun is low, so the shadow reaches far; the ground casts, too, a volume as huge.
  const RayLight sun = { 2.0, -3.0, 0.5, 0.0 };
  for (const double halfSize : { 100.0, 1e4 })
  {
    Scene scene;
    scene.Renderer->RemoveAllViewProps();
    const Mesh plane = ground(0.0, halfSize);
    const Mesh mesh = moved(box(0.5, 0.4, 0.7), 1.0, { 0.0, 0.0, 1.0 });
    scene.Add(plane);
    scene.Add(mesh);
    for (const RayLight& position : { sun, PointLight })
    {
      scene.Renderer->RemoveAllLights();
      vtkSmartPointer<vtkLight> light = scene.AddLight(position);
      scene.Look(5.0, -3.0, 1.5); // up to the horizon
      scene.Renderer->GetActiveCamera()->SetViewAngle(50.0);
      scene.Renderer->GetActiveCamera()->SetClippingRange(0.5, 3.0 * halfSize);
      auto window = MakeWindow(240, 180);
      window->AddRenderer(scene.Renderer);
      render(window,
        "huge-ground-" + std::to_string(halfSize) + (position[3] == 0.0 ? "-sun" : "-lamp"));
      ExpectMask(scene, light, position, { { plane }, { mesh } }, "huge ground");
      window->RemoveRenderer(scene.Renderer);
    }
  }
}

namespace
{
// The mask fills a picture of that size, and is right.
void expectMaskOfSize(Scene& scene, vtkLight* light, const Mesh& mesh,
  const std::array<int, 2>& size, const char* what)
{
  const Image mask = scene.Mask(light);
  ASSERT_TRUE(mask);
  EXPECT_EQ(mask->GetDimensions()[0], size[0]);
  EXPECT_EQ(mask->GetDimensions()[1], size[1]);
  ExpectMask(scene, light, PointLight, { { scene.GroundMesh }, { mesh } }, what);
}
}

TEST(HardPictures, NotSquareWindows)
{
  for (const auto& size :
    std::vector<std::array<int, 2>>{ { 240, 240 }, { 400, 150 }, { 130, 301 } })
  {
    Scene scene;
    const Mesh mesh = FloatingBox();
    scene.Add(mesh);
    vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
    auto window = MakeWindow(size[0], size[1]);
    window->AddRenderer(scene.Renderer);
    render(window, "window-" + std::to_string(size[0]));
    expectMaskOfSize(scene, light, mesh, size, "window");
  }
}

TEST(HardPictures, TwoViewportsAreAsWindowsOfTheirOwn)
{
  Scene left;
  const Mesh floating = FloatingBox();
  left.Add(floating);
  vtkSmartPointer<vtkLight> leftLight = left.AddLight(PointLight);
  Scene right;
  const Mesh ring = moved(torus(20, 10), 0.6, { 0.0, 0.0, 1.2 }, 3);
  right.Add(ring);
  vtkSmartPointer<vtkLight> rightLight = right.AddLight(DirectionalLight);
  right.Look(4.0, -5.0, 4.0);

  std::vector<Image> alone;
  for (Scene* scene : { &left, &right })
  {
    auto window = MakeWindow(150, 120);
    window->AddRenderer(scene->Renderer);
    window->Render();
    alone.push_back(Grab(window));
    window->RemoveRenderer(scene->Renderer);
  }

  auto window = MakeWindow(300, 200);
  left.Renderer->SetViewport(0.0, 0.0, 0.5, 0.6);
  right.Renderer->SetViewport(0.5, 0.4, 1.0, 1.0);
  window->AddRenderer(left.Renderer);
  window->AddRenderer(right.Renderer);
  for (int frame = 0; frame < 2; ++frame)
  {
    render(window, "viewports");
    ExpectMask(left, leftLight, PointLight, { { left.GroundMesh }, { floating } }, "left");
    ExpectMask(right, rightLight, DirectionalLight, { { right.GroundMesh }, { ring } }, "right");
    const Image both = Grab(window);
    long wrong = 0;
    for (int y = 0; y < 120; ++y)
    {
      for (int x = 0; x < 150; ++x)
      {
        // Interpolated colours may round otherwise in another viewport; a shadow would differ more.
        for (int i = 0; i < 3; ++i)
        {
          wrong += std::abs(Byte(both, x, y, i) - Byte(alone[0], x, y, i)) > 1;
          wrong += std::abs(Byte(both, 150 + x, 80 + y, i) - Byte(alone[1], x, y, i)) > 1;
        }
      }
    }
    EXPECT_EQ(wrong, 0);
  }
}

TEST(HardPictures, WindowResized)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  scene.Add(mesh);
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto window = MakeWindow(160, 160);
  window->AddRenderer(scene.Renderer);
  for (const auto& size :
    std::vector<std::array<int, 2>>{ { 160, 160 }, { 300, 180 }, { 120, 90 } })
  {
    window->SetSize(size[0], size[1]);
    render(window, "resized-" + std::to_string(size[0]));
    expectMaskOfSize(scene, light, mesh, size, "resized");
  }
}

TEST(HardPictures, PassToggledEveryFrame)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  scene.Add(mesh);
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  std::vector<Image> pictures;
  for (int frame = 0; frame < 6; ++frame)
  {
    const bool shadows = frame % 2 == 0;
    scene.Renderer->SetPass(shadows ? scene.Pass.Get() : nullptr);
    render(window, shadows ? "toggled-on" : "toggled-off");
    pictures.push_back(Grab(window));
    if (shadows)
    {
      ExpectMask(scene, light, PointLight, { { scene.GroundMesh }, { mesh } }, "toggled");
    }
  }
  EXPECT_GT(Differences(pictures[0], pictures[1]), 1000);
  for (std::size_t frame = 2; frame < pictures.size(); ++frame)
  {
    EXPECT_EQ(Differences(pictures[frame], pictures[frame - 2]), 0) << frame;
  }
}
