// Windows of any shape, resized, with several renderers; the pass toggled, in two windows,
// released.

#include "ImageChecks.h"
#include "ShadowScene.h"
#include "TestMeshes.h"

#include "vtkStencilShadowPass.h"

#include <vtkLight.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

using namespace shadowtest;

TEST(StencilShadowPass, NotSquareWindows)
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
    window->Render();
    const Image mask = scene.Mask(light);
    ASSERT_TRUE(mask);
    EXPECT_EQ(mask->GetDimensions()[0], size[0]);
    EXPECT_EQ(mask->GetDimensions()[1], size[1]);
    ExpectMask(scene, light, PointLight, { { scene.GroundMesh }, { mesh } }, "window");
  }
}

TEST(StencilShadowPass, SeveralRenderersAsInWindowsOfTheirOwn)
{
  Scene left;
  left.Add(FloatingBox());
  left.AddLight(PointLight);
  Scene right;
  right.Add(moved(torus(20, 10), 0.6, { 0.0, 0.0, 1.2 }, 3));
  right.AddLight(DirectionalLight);
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
    window->Render();
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

TEST(StencilShadowPass, ResizedWindow)
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
    window->Render();
    const Image mask = scene.Mask(light);
    ASSERT_TRUE(mask);
    EXPECT_EQ(mask->GetDimensions()[0], size[0]);
    EXPECT_EQ(mask->GetDimensions()[1], size[1]);
    ExpectMask(scene, light, PointLight, { { scene.GroundMesh }, { mesh } }, "resized");
  }
}

TEST(StencilShadowPass, ToggledEveryFrame)
{
  Scene scene;
  scene.Add(FloatingBox());
  scene.AddLight(PointLight);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  std::vector<Image> pictures;
  for (int frame = 0; frame < 6; ++frame)
  {
    scene.Renderer->SetPass(frame % 2 == 0 ? scene.Pass.Get() : nullptr);
    window->Render();
    pictures.push_back(Grab(window));
  }
  EXPECT_GT(Differences(pictures[0], pictures[1]), 1000);
  for (std::size_t frame = 2; frame < pictures.size(); ++frame)
  {
    EXPECT_EQ(Differences(pictures[frame], pictures[frame - 2]), 0) << frame;
  }
}

TEST(StencilShadowPass, OnePassInTwoWindows)
{
  Scene scene;
  scene.Add(FloatingBox());
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto first = MakeWindow(200, 150);
  first->AddRenderer(scene.Renderer);
  first->Render();
  const Image picture = Grab(first);

  Scene other;
  other.Add(FloatingBox());
  other.AddLight(PointLight);
  other.Renderer->SetPass(scene.Pass);
  auto second = MakeWindow(200, 150);
  second->AddRenderer(other.Renderer);
  for (int frame = 0; frame < 3; ++frame)
  {
    second->Render();
    EXPECT_EQ(Differences(Grab(second), picture), 0);
    first->Render();
    EXPECT_EQ(Differences(Grab(first), picture), 0);
    EXPECT_GT(blackFraction(scene.Mask(light)), 0.05);
  }
}

TEST(StencilShadowPass, ReleasedAndDrawnElsewhere)
{
  Scene scene;
  scene.Add(FloatingBox());
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto first = MakeWindow(200, 150);
  first->AddRenderer(scene.Renderer);
  first->Render();
  const Image picture = Grab(first);
  EXPECT_TRUE(scene.Mask(light));

  scene.Pass->ReleaseGraphicsResources(first);
  EXPECT_EQ(scene.Pass->GetMask(light), nullptr);
  first->Render();
  EXPECT_EQ(Differences(Grab(first), picture), 0);

  first->RemoveRenderer(scene.Renderer);
  auto second = MakeWindow(200, 150);
  second->AddRenderer(scene.Renderer);
  second->Render();
  EXPECT_EQ(Differences(Grab(second), picture), 0);

  // The window goes while the pass is in no renderer.
  scene.Renderer->SetPass(nullptr);
  second->RemoveRenderer(scene.Renderer);
  second = nullptr;
  EXPECT_EQ(scene.Pass->GetMask(light), nullptr);
  first->AddRenderer(scene.Renderer);
  scene.Renderer->SetPass(scene.Pass);
  first->Render();
  EXPECT_EQ(Differences(Grab(first), picture), 0);
}
