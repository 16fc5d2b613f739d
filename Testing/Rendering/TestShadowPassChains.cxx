// The pass in chains of passes, around others and within them, and the state it leaves alone.

#include "ImageChecks.h"
#include "OpenGLWatch.h"
#include "ShadowScene.h"
#include "StateProbe.h"

#include "vtkStencilShadowPass.h"

#include <vtkCameraPass.h>
#include <vtkLight.h>
#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSSAAPass.h>
#include <vtkSSAOPass.h>
#include <vtkSequencePass.h>
#include <vtkTextureUnitManager.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using namespace shadowtest;

/**
 * Lights and opaque geometry, without a camera pass.
 */
vtkSmartPointer<vtkRenderPass> MakeSteps()
{
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(vtkNew<vtkLightsPass>());
  passes->AddItem(vtkNew<vtkOpaquePass>());
  auto sequence = vtkSmartPointer<vtkSequencePass>::New();
  sequence->SetPasses(passes);
  return sequence;
}

vtkSmartPointer<vtkCameraPass> MakeCamera(vtkRenderPass* delegate)
{
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(delegate);
  return camera;
}
}

namespace
{
void expectStateIsLeftAlone(vtkPolyData* caster)
{
  Scene scene;
  scene.Add(caster);
  scene.AddLight(PointLight);
  vtkNew<ProbePass> inner;
  inner->Delegate = MakeSteps();
  vtkNew<ProbePass> outer;
  outer->SetOddValues = true;
  scene.Pass->SetDelegatePass(inner);
  vtkSmartPointer<vtkCameraPass> camera = MakeCamera(outer);
  scene.Renderer->SetPass(camera);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);

  // Without the pass first: what the mappers themselves leave behind is not the pass's.
  outer->Delegate = inner;
  window->Render();
  window->Render();
  const auto before = outer->Before;
  const auto after = outer->After;
  EXPECT_EQ(outer->Error, 0u);
  ASSERT_EQ(before.at("viewport"), (std::vector<int>{ 0, 0, 200, 150 }));

  outer->Delegate = scene.Pass;
  for (int frame = 0; frame < 3; ++frame)
  {
    window->Render();
    EXPECT_EQ(outer->Error, 0u);
    EXPECT_FALSE(
      vtkOpenGLRenderWindow::SafeDownCast(window)->GetState()->GetTextureUnitManager()->IsAllocated(
        0));
    for (auto entry : before)
    {
      // While the delegate draws, the masks are bound to the unit that was free.
      if (entry.first == "array texture")
      {
        entry.second = inner->Before.at(entry.first);
      }
      EXPECT_EQ(inner->Before.at(entry.first), entry.second) << "shading: " << entry.first;
      EXPECT_EQ(outer->After.at(entry.first), after.at(entry.first)) << "after: " << entry.first;
    }
  }
  EXPECT_GT(before.size(), 30u);
}
}

TEST(StencilShadowPass, StateIsLeftAlone)
{
  expectStateIsLeftAlone(FloatingBox());
}

// More shadow volumes than a stencil counts: blending counts them.
TEST(StencilShadowPass, StateIsLeftAloneByCountsInFloats)
{
  const std::vector<Mesh> sheets(200, moved(ground(0.0, 0.4), 1.0, { 0.0, 0.0, 1.0 }));
  expectStateIsLeftAlone(merged(sheets));
}

TEST(StencilShadowPass, ChainsOfPasses)
{
  Scene scene;
  scene.Add(FloatingBox());
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  window->Render();
  const Image direct = Grab(window);

  // With a camera pass around, and with the delegate that the pass makes itself.
  vtkSmartPointer<vtkCameraPass> camera = MakeCamera(scene.Pass);
  scene.Renderer->SetPass(camera);
  window->Render();
  EXPECT_EQ(Differences(Grab(window), direct), 0);
  scene.Pass->SetDelegatePass(MakeSteps());
  window->Render();
  EXPECT_EQ(Differences(Grab(window), direct), 0);

  // Camera inside.
  scene.Pass->SetDelegatePass(MakeCamera(MakeSteps()));
  scene.Renderer->SetPass(scene.Pass);
  window->Render();
  EXPECT_EQ(Differences(Grab(window), direct), 0);

  // Supersampled, all three ways: the same picture but for edges. With the supersampling around
  // they become smooth; within, the mask keeps the window's size.
  for (const char* way : { "around", "around the camera", "within" })
  {
    SCOPED_TRACE(way);
    const bool within = std::string(way) == "within";
    vtkNew<vtkSSAAPass> supersampling;
    if (within)
    {
      supersampling->SetDelegatePass(MakeCamera(MakeSteps()));
      scene.Pass->SetDelegatePass(supersampling);
      scene.Renderer->SetPass(scene.Pass);
    }
    else
    {
      const bool bare = std::string(way) == "around";
      scene.Pass->SetDelegatePass(bare ? nullptr : MakeSteps().Get());
      supersampling->SetDelegatePass(
        bare ? static_cast<vtkRenderPass*>(scene.Pass) : static_cast<vtkRenderPass*>(camera));
      scene.Renderer->SetPass(supersampling);
    }
    window->Render();
    const Image smooth = Grab(window);
    const Image mask = scene.Mask(light);
    ASSERT_TRUE(mask);
    if (within)
    {
      EXPECT_EQ(mask->GetDimensions()[0], 200);
    }
    else
    {
      EXPECT_GT(mask->GetDimensions()[0], 300);
    }
    EXPECT_GT(blackFraction(mask), 0.05);
    long unlike = 0;
    long between = 0;
    for (int y = 2; y < 148; ++y)
    {
      for (int x = 2; x < 198; ++x)
      {
        int lowest = 255;
        int highest = 0;
        for (int i = 0; i < 25; ++i)
        {
          const int value = Byte(direct, x + i % 5 - 2, y + i / 5 - 2);
          lowest = std::min(lowest, value);
          highest = std::max(highest, value);
        }
        const int value = Byte(smooth, x, y);
        // vtkSSAAPass overshoots a little: its filter has negative weights.
        unlike += value < lowest - 10 || value > highest + 10;
        between += value > lowest + 20 && value < highest - 20;
      }
    }
    EXPECT_EQ(unlike, 0);
    EXPECT_GT(between, 200);
    scene.Renderer->SetPass(nullptr);
  }
}

TEST(StencilShadowPass, AmbientOcclusionAroundAndWithin)
{
  Scene scene;
  scene.Add(FloatingBox());
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  vtkNew<vtkSSAOPass> occlusion;
  occlusion->SetRadius(0.5);
  vtkNew<vtkRenderStepsPass> steps;
  occlusion->SetDelegatePass(steps);
  scene.Renderer->SetPass(occlusion);
  window->Render();
  const Image lit = Grab(window);
  const double intensity = light->GetIntensity();
  light->SetIntensity(0.0);
  window->Render();
  const Image unlit = Grab(window);
  light->SetIntensity(intensity);
  occlusion->ReleaseGraphicsResources(window);

  for (const bool within : { true, false })
  {
    SCOPED_TRACE(within ? "within" : "around");
    vtkNew<vtkSSAOPass> another;
    another->SetRadius(0.5);
    another->SetDelegatePass(within ? static_cast<vtkRenderPass*>(steps) : scene.Pass);
    scene.Pass->SetDelegatePass(within ? another.Get() : nullptr);
    scene.Renderer->SetPass(within ? static_cast<vtkRenderPass*>(scene.Pass) : another);
    const OpenGLWatch watch(window);
    window->Render();
    const int references[2] = { scene.Pass->GetReferenceCount(), another->GetReferenceCount() };
    window->Render();
    EXPECT_EQ(scene.Pass->GetReferenceCount(), references[0]);
    EXPECT_EQ(another->GetReferenceCount(), references[1]);
    ExpectQuiet(watch);
    const Image picture = Grab(window);
    const Image mask = scene.Mask(light);
    ASSERT_TRUE(mask);
    EXPECT_GT(blackFraction(mask), 0.05);
    long wrong = 0;
    for (int y = 0; y < 150; ++y)
    {
      for (int x = 0; x < 200; ++x)
      {
        wrong += std::abs(Byte(picture, x, y) -
                   Byte(Byte(mask, x, y) ? lit.Get() : unlit.Get(), x, y)) > 1;
      }
    }
    EXPECT_EQ(wrong, 0);
    // vtkSSAOPass does not free its textures by itself.
    another->ReleaseGraphicsResources(window);
    scene.Renderer->SetPass(nullptr);
  }
}
