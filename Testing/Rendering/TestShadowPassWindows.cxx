// The pass in two windows, and released. Windows of any shape, resized, with several renderers are
// in Robustness/TestHardPictures.

#include "ImageChecks.h"
#include "ShadowScene.h"

#include "vtkStencilShadowPass.h"

#include <vtkLight.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

using namespace shadowtest;

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
