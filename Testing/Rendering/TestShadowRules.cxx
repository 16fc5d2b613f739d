// Each rule of the plan: it has something to decide in these scenes, and whether it is on or off the
// picture is the same.

#include "ImageChecks.h"
#include "ShadowScene.h"
#include "TestMeshes.h"

#include "vtkStencilShadowPass.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkLight.h>
#include <vtkTable.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <map>
#include <string>

namespace
{
using namespace shadowtest;

struct Rule
{
  const char* Name;
  std::function<void(vtkStencilShadowPass*)> TurnOff;
  std::string Trace; ///< of its use, in the plan
};

// Depth bounds leave none; whether the driver has them is for the test to find out.
const Rule Rules[] = {
  { "counting", [](vtkStencilShadowPass* pass) { pass->SetCountingToZFail(); },
    "nothing of it is between the light and the near plane" },
  { "unseen casters", [](vtkStencilShadowPass* pass) { pass->SkipUnseenCastersOff(); },
    "its shadow does not come into view" },
  { "cones", [](vtkStencilShadowPass* pass) { pass->SkipCastersOutsideConesOff(); },
    "it is outside of the light's cone" },
  { "receivers", [](vtkStencilShadowPass* pass) { pass->SkipCastersWithoutReceiversOff(); },
    "nothing behind it receives" },
  { "finite volumes", [](vtkStencilShadowPass* pass) { pass->FiniteVolumesOff(); },
    "ends behind the receivers" },
  { "scissor", [](vtkStencilShadowPass* pass) { pass->ScissorOff(); }, "" },
  { "depth bounds", [](vtkStencilShadowPass* pass) { pass->DepthBoundsOff(); }, "" },
  { "reuse", [](vtkStencilShadowPass* pass) { pass->ReuseUnchangedOff(); }, "nothing has changed" }
};

/**
 * Boxes of which one lies in the light, one outside of a spot's cone, one out of view, and one beside
 * the ground that shows no shadows itself.
 */
struct Stage : Scene
{
  vtkSmartPointer<vtkLight> Light;
  vtkSmartPointer<vtkRenderWindow> Window = MakeWindow(240, 180);

  Stage(const double eye[3], const double at[3], const RayLight& light)
  {
    this->Add(FloatingBox());
    this->Add(moved(box(), 0.3, { 2.5, 2.0, 0.5 }, 3));
    this->Add(moved(box(), 0.3, { 0.0, -60.0, 1.0 }, 5));
    const auto beside = this->Add(moved(box(), 0.3, { 8.0, 0.0, 1.0 }, 9));
    vtkNew<vtkInformation> keys;
    keys->Set(vtkStencilShadowPass::RECEIVES_SHADOW(), 0);
    beside->SetPropertyKeys(keys);
    this->Light = this->AddLight(light);
    if (light[3] != 0.0)
    {
      this->Light->SetConeAngle(25.0);
    }
    this->Look(eye[0], eye[1], eye[2]);
    this->Renderer->GetActiveCamera()->SetFocalPoint(at);
    this->Renderer->GetActiveCamera()->SetClippingRange(0.05, 40.0);
    this->Window->AddRenderer(this->Renderer);
  }

  /// The last of a few frames; `uses` counts rows of plans by the rules that left a trace there.
  Image Draw(std::map<std::string, int>& uses)
  {
    for (int frame = 0; frame < 3; ++frame)
    {
      this->Window->Render();
      const auto plan = vtkSmartPointer<vtkTable>::Take(this->Pass->GetPlan());
      for (vtkIdType row = 0; row < plan->GetNumberOfRows(); ++row)
      {
        const std::string text = plan->GetValueByName(row, "Decision").ToString() + "; " +
          plan->GetValueByName(row, "Reason").ToString();
        for (const Rule& rule : Rules)
        {
          uses[rule.Name] += !rule.Trace.empty() && text.find(rule.Trace) != std::string::npos;
        }
      }
    }
    return Grab(this->Window);
  }
};

struct View
{
  const char* Name;
  double Eye[3];
  double At[3];
  RayLight Light;
};

// Free of shadow, in the box's shadow, with the lamp close, and looking along the ground.
const View Views[] = { { "outside", { -3.0, -6.0, 5.0 }, { 0.0, 0.0, 0.5 }, PointLight },
  { "in shadow", { -0.25, -0.12, 0.5 }, { -0.1, 0.4, 0.0 }, DirectionalLight },
  { "under the lamp", { -2.0, -3.0, 3.0 }, { 0.0, 0.0, 0.5 }, { 0.2, 0.1, 1.9, 1.0 } },
  { "low", { -3.0, -4.0, 0.6 }, { -1.0, 0.0, 0.2 }, { 3.0, 2.0, 1.8, 0.0 } } };
}

TEST(ShadowRules, LeaveThePictureAsItIs)
{
  std::map<std::string, int> uses;
  std::map<std::string, int> usesWhenOff;
  for (const View& view : Views)
  {
    Stage all(view.Eye, view.At, view.Light);
    const Image picture = all.Draw(uses);
    EXPECT_GT(blackFraction(all.Mask(all.Light)), 0.005) << view.Name;
    for (const Rule& rule : Rules)
    {
      Stage stage(view.Eye, view.At, view.Light);
      rule.TurnOff(stage.Pass);
      std::map<std::string, int> traces;
      // Beside an edge a pixel may fall to the other side by rounding.
      EXPECT_LE(Differences(stage.Draw(traces), picture), 6) << view.Name << ", " << rule.Name;
      usesWhenOff[rule.Name] += traces[rule.Name];
    }
  }
  for (const Rule& rule : Rules)
  {
    EXPECT_EQ(usesWhenOff[rule.Name], 0) << rule.Name;
    EXPECT_EQ(uses[rule.Name] > 0, !rule.Trace.empty()) << rule.Name;
  }
}

/// Where it is there, volumes are drawn over fewer pixels: see to it that it is tried somewhere.
TEST(ShadowRules, SomeDriverHasDepthBounds)
{
  const char* wanted = std::getenv("SMOOTHSHADOW_EXPECTS_DEPTH_BOUNDS");
  if (!wanted)
  {
    GTEST_SKIP() << "only where the driver has them";
  }
  Stage stage(Views[0].Eye, Views[0].At, Views[0].Light);
  stage.Window->Render();
  const std::string capabilities = stage.Window->ReportCapabilities();
  EXPECT_NE(capabilities.find("GL_EXT_depth_bounds_test"), std::string::npos);
}

namespace
{
/**
 * A coarse ring over the ground; pictures of it by kind, and what the plan took.
 */
struct Ring : Scene
{
  vtkSmartPointer<vtkLight> Light;
  vtkSmartPointer<vtkRenderWindow> Window;

  Ring(int around, int along, int size)
    : Window(MakeWindow(size, size))
  {
    this->Add(moved(torus(around, along), 0.6, { 0.0, 0.0, 1.2 }, 3));
    this->Light = this->AddLight(DirectionalLight);
    this->Window->AddRenderer(this->Renderer);
  }

  Image MaskBy(int kind, double pixelTolerance)
  {
    this->Pass->SetKind(kind);
    this->Pass->SetPixelTolerance(pixelTolerance);
    this->Window->Render();
    return this->Mask(this->Light);
  }

  bool Takes(const char* kind)
  {
    const auto plan = vtkSmartPointer<vtkTable>::Take(this->Pass->GetPlan());
    for (vtkIdType row = 0; row < plan->GetNumberOfRows(); ++row)
    {
      // The ground is number 0.
      if (plan->GetValueByName(row, "Caster").ToInt() == 1)
      {
        return plan->GetValueByName(row, "Decision").ToString().find(kind) != std::string::npos;
      }
    }
    return false;
  }
};
}

/// Edges of the mesh are taken exactly while pixels do not tell, and what they give differs little.
TEST(ShadowRules, KindsByPixels)
{
  Ring coarse(24, 12, 240);
  const Image smooth = coarse.MaskBy(vtkStencilShadowPass::SMOOTH, 0.01);
  const Image byTolerance = coarse.MaskBy(vtkStencilShadowPass::AUTOMATIC, 0.5);
  EXPECT_TRUE(coarse.Takes("smooth"));
  const Image discrete = coarse.MaskBy(vtkStencilShadowPass::DISCRETE, 0.5);
  EXPECT_LE(Differences(byTolerance, smooth), Differences(discrete, smooth) / 4);
  EXPECT_GT(Differences(discrete, smooth), 200);
  coarse.MaskBy(vtkStencilShadowPass::AUTOMATIC, 1000.0);
  EXPECT_TRUE(coarse.Takes("discrete"));

  Ring fine(480, 240, 240);
  const Image chosen = fine.MaskBy(vtkStencilShadowPass::AUTOMATIC, 0.5);
  EXPECT_TRUE(fine.Takes("discrete"));
  const Image best = fine.MaskBy(vtkStencilShadowPass::SMOOTH, 0.01);
  EXPECT_LE(Differences(chosen, best), Differences(discrete, smooth) / 4);
  // Nearer by, the same mesh is coarse.
  fine.Look(-0.3, -0.6, 0.9);
  fine.MaskBy(vtkStencilShadowPass::AUTOMATIC, 0.05);
  EXPECT_TRUE(fine.Takes("smooth"));
}
