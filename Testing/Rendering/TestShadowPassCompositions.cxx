// The pass together with what else draws in VTK: the final picture must be lit and dark where a ray
// cast says so, without a word from VTK or OpenGL. Leaves its pictures in the folder
// SMOOTHSHADOW_PICTURES, to look at.

#include "ImageChecks.h"
#include "OpenGLWatch.h"
#include "PictureOracle.h"
#include "ShadowScene.h"
#include "StateProbe.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include "vtkOffscreenWindows.h"
#include "vtkStencilShadowPass.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkDepthPeelingPass.h>
#include <vtkDualDepthPeelingPass.h>
#include <vtkHiddenLineRemovalPass.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOutlineGlowPass.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSSAAPass.h>
#include <vtkSSAOPass.h>
#include <vtkSmartPointer.h>
#include <vtkToneMappingPass.h>
#include <vtkTranslucentPass.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace
{
using namespace shadowtest;

constexpr int Width = 200;
constexpr int Height = 150;

/// Draws, and keeps the picture if that is asked for.
Image Draw(vtkRenderWindow* window, const std::string& name)
{
  window->Render();
  const Image picture = Grab(window);
  if (const char* folder = std::getenv("SMOOTHSHADOW_PICTURES"))
  {
    writePng(picture,
      std::string(folder) + "/" + vtkOffscreenWindows::GetDefaultName() + "-composed-" + name +
        ".png");
  }
  return picture;
}

/// A box over the ground, and one light.
struct BoxScene : Scene
{
  Mesh Box = FloatingBox();
  vtkSmartPointer<vtkActor> Caster;
  RayLight Position;
  vtkSmartPointer<vtkLight> Light;

  explicit BoxScene(const RayLight& position = PointLight, double intensity = 1.0)
    : Position(position)
  {
    this->Caster = this->Add(this->Box);
    this->Light = this->AddLight(position, intensity);
  }

  std::vector<RayObject> Objects() const { return { { this->GroundMesh }, { this->Box } }; }

  PictureOracle Oracle(int width = Width, int height = Height) const
  {
    return PictureOracle(
      *this, this->Position, this->Objects(), width, height, this->Light->GetIntensity());
  }

  /// The mask and the picture against the ray cast. The mask is as large as the picture.
  void Expect(vtkImageData* picture, const char* what)
  {
    ExpectMask(*this, this->Light, this->Position, this->Objects(), what);
    const Image mask = this->Mask(this->Light);
    ASSERT_TRUE(mask) << what;
    PictureExpectation expectation;
    expectation.What = what;
    ExpectPicture(
      this->Oracle(mask->GetDimensions()[0], mask->GetDimensions()[1]), picture, expectation);
  }

  void Release(vtkRenderWindow* window, vtkRenderPass* pass)
  {
    pass->ReleaseGraphicsResources(window);
    this->Renderer->SetPass(nullptr);
  }
};

/// The picture of a chain of passes that has no shadows, with the light as it is or off.
Image DrawReference(BoxScene& scene, vtkRenderWindow* window, bool lit, const std::string& name)
{
  const double intensity = scene.Light->GetIntensity();
  scene.Light->SetIntensity(lit ? intensity : 0.0);
  const Image picture = Draw(window, name + (lit ? "-lit" : "-unlit"));
  scene.Light->SetIntensity(intensity);
  return picture;
}

/// Expects a pass to leave the state that another one has left in the same place. A texture unit
/// that passes within leave active may be another one, as the masks hold a unit meanwhile.
void ExpectSameState(const OpenGLValues& state, OpenGLValues expected, bool activatesTextures)
{
  EXPECT_GT(expected.size(), 30u);
  if (activatesTextures)
  {
    expected.erase("active texture");
  }
  for (const auto& value : expected)
  {
    EXPECT_EQ(state.at(value.first), value.second) << value.first;
  }
}
}

//------------------------------------------------------------------------------------------------
// Passes around and within.

TEST(ShadowPassCompositions, WithinSupersampling)
{
  for (const std::string camera : { "none", "within", "around" })
  {
    SCOPED_TRACE("camera pass: " + camera);
    BoxScene scene;
    auto window = MakeWindow(Width, Height);
    window->AddRenderer(scene.Renderer);
    const OpenGLWatch watch(window);
    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkCameraPass> cameraPass;
    vtkNew<ProbePass> probe;
    vtkNew<vtkSSAAPass> supersampling;
    vtkRenderPass* outermost = supersampling;
    supersampling->SetDelegatePass(probe);
    if (camera == "within")
    {
      cameraPass->SetDelegatePass(probe);
      supersampling->SetDelegatePass(cameraPass);
    }
    if (camera == "around")
    {
      cameraPass->SetDelegatePass(supersampling);
      outermost = cameraPass;
    }
    scene.Renderer->SetPass(outermost);

    probe->Delegate = steps;
    Draw(window, "ssaa-none");
    Draw(window, "ssaa-none");
    const OpenGLValues state = probe->After;

    probe->Delegate = scene.Pass;
    for (int frame = 0; frame < 2; ++frame)
    {
      const Image picture = Draw(window, "ssaa-camera-" + camera);
      PictureExpectation expectation;
      expectation.Margin = 3; // it filters over five pixels
      ExpectPicture(scene.Oracle(), picture, expectation);
      ExpectMask(scene, scene.Light, scene.Position, scene.Objects(), "supersampled");
      EXPECT_GT(scene.Mask(scene.Light)->GetDimensions()[0], Width);
      ExpectSameState(probe->After, state, false);
    }
    scene.Release(window, outermost);
    ExpectQuiet(watch);
  }
}

TEST(ShadowPassCompositions, AroundSupersampling)
{
  BoxScene scene;
  auto window = MakeWindow(Width, Height);
  window->AddRenderer(scene.Renderer);
  const OpenGLWatch watch(window);
  vtkNew<vtkSSAAPass> supersampling;
  supersampling->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
  scene.Pass->SetDelegatePass(supersampling);
  for (int frame = 0; frame < 2; ++frame)
  {
    const Image picture = Draw(window, "around-ssaa");
    PictureExpectation expectation;
    expectation.Margin = 3;
    ExpectPicture(scene.Oracle(), picture, expectation);
    ExpectMask(scene, scene.Light, scene.Position, scene.Objects(), "around supersampling");
    EXPECT_EQ(scene.Mask(scene.Light)->GetDimensions()[0], Width);
  }
  scene.Release(window, scene.Pass);
  ExpectQuiet(watch);
}

TEST(ShadowPassCompositions, WithinAndAroundAmbientOcclusion)
{
  BoxScene scene;
  // Standing on the ground, so that there is something to occlude.
  scene.Box = moved(box(0.5, 0.4, 0.5), 1.0, { 0.0, 0.0, 0.5 });
  scene.Renderer->RemoveActor(scene.Caster);
  scene.Add(scene.Box);
  auto window = MakeWindow(Width, Height);
  window->AddRenderer(scene.Renderer);
  const OpenGLWatch watch(window);
  vtkNew<vtkRenderStepsPass> steps;

  window->Render();
  const Image open = Draw(window, "ssao-none");
  for (const bool within : { true, false })
  {
    SCOPED_TRACE(within ? "the shadows within" : "the shadows around");
    vtkNew<ProbePass> probe;
    vtkNew<vtkSSAOPass> occlusion;
    occlusion->SetRadius(0.5);
    occlusion->SetDelegatePass(within ? static_cast<vtkRenderPass*>(probe) : steps);
    probe->Delegate = within ? static_cast<vtkRenderPass*>(steps) : occlusion;
    scene.Renderer->SetPass(within ? static_cast<vtkRenderPass*>(occlusion) : probe);
    const Image lit = DrawReference(scene, window, true, "ssao");
    const Image unlit = DrawReference(scene, window, false, "ssao");
    const OpenGLValues state = probe->After;

    scene.Pass->SetDelegatePass(within ? nullptr : occlusion.Get());
    probe->Delegate = scene.Pass;
    for (int frame = 0; frame < 2; ++frame)
    {
      const Image picture = Draw(window, within ? "ssao" : "around-ssao");
      ExpectMask(scene, scene.Light, scene.Position, scene.Objects(), "occluded");
      ExpectComposed(scene.Oracle(), picture, lit, unlit);
      EXPECT_GT(Differences(picture, open), 1000);
      ExpectSameState(probe->After, state, !within);
    }
    scene.Pass->SetDelegatePass(nullptr);
    occlusion->ReleaseGraphicsResources(window);
    scene.Release(window, scene.Pass);
  }
  ExpectQuiet(watch);
}

TEST(ShadowPassCompositions, WithinAndAroundToneMapping)
{
  // Brighter than a picture can hold.
  BoxScene scene(PointLight, 3.0);
  auto window = MakeWindow(Width, Height);
  window->AddRenderer(scene.Renderer);
  const OpenGLWatch watch(window);
  vtkNew<vtkRenderStepsPass> steps;
  scene.Renderer->SetPass(steps);
  const Image clamped = DrawReference(scene, window, true, "tone-none");
  for (const int type : { static_cast<int>(vtkToneMappingPass::Reinhard),
         static_cast<int>(vtkToneMappingPass::Exponential),
         static_cast<int>(vtkToneMappingPass::GenericFilmic) })
  {
    for (const bool within : { true, false })
    {
      SCOPED_TRACE("type " + std::to_string(type) + (within ? ", within" : ", around"));
      vtkNew<ProbePass> probe;
      vtkNew<vtkToneMappingPass> toning;
      toning->SetToneMappingType(type);
      toning->SetDelegatePass(within ? static_cast<vtkRenderPass*>(probe) : steps);
      probe->Delegate = within ? static_cast<vtkRenderPass*>(steps) : toning;
      scene.Renderer->SetPass(within ? static_cast<vtkRenderPass*>(toning) : probe);
      const std::string name = "tone-" + std::to_string(type);
      const Image lit = DrawReference(scene, window, true, name);
      const Image unlit = DrawReference(scene, window, false, name);
      const OpenGLValues state = probe->After;
      EXPECT_GT(Differences(lit, clamped), 10000);

      scene.Pass->SetDelegatePass(within ? nullptr : toning.Get());
      probe->Delegate = scene.Pass;
      for (int frame = 0; frame < 2; ++frame)
      {
        const Image picture = Draw(window, name + (within ? "" : "-around"));
        ExpectMask(scene, scene.Light, scene.Position, scene.Objects(), "toned");
        ExpectComposed(scene.Oracle(), picture, lit, unlit);
        ExpectSameState(probe->After, state, !within);
      }
      scene.Pass->SetDelegatePass(nullptr);
      toning->ReleaseGraphicsResources(window);
      scene.Release(window, scene.Pass);
    }
  }
  ExpectQuiet(watch);
}

TEST(ShadowPassCompositions, OptionsOfTheRenderer)
{
  for (const bool occlusion : { true, false })
  {
    SCOPED_TRACE(occlusion ? "ambient occlusion" : "FXAA");
    BoxScene scene;
    auto window = MakeWindow(Width, Height);
    window->AddRenderer(scene.Renderer);
    const OpenGLWatch watch(window);
    scene.Renderer->SetPass(nullptr);
    const Image plain = DrawReference(scene, window, true, "option-none");
    scene.Renderer->SetUseSSAO(occlusion);
    scene.Renderer->SetUseFXAA(!occlusion);
    scene.Renderer->SetSSAORadius(0.5);
    const std::string name = occlusion ? "option-ssao" : "option-fxaa";
    const Image lit = DrawReference(scene, window, true, name);
    const Image unlit = DrawReference(scene, window, false, name);
    EXPECT_GT(Differences(lit, plain), 100);

    scene.Renderer->SetPass(scene.Pass);
    for (int frame = 0; frame < 2; ++frame)
    {
      const Image picture = Draw(window, name);
      ExpectMask(scene, scene.Light, scene.Position, scene.Objects(), name.c_str());
      PictureExpectation expectation;
      expectation.Margin = occlusion ? 1 : 8; // FXAA blends along edges
      ExpectComposed(scene.Oracle(), picture, lit, unlit, expectation);
    }
    scene.Release(window, scene.Pass);
    ExpectQuiet(watch);
  }
}

//------------------------------------------------------------------------------------------------
// Translucent and wireframe actors.

namespace
{
/**
 * A translucent sheet as an oracle of its own.
 */
struct Pane
{
  Mesh Sheet;
  Color Paint;
  double Opacity;
  PictureOracle Oracle;

  Pane(Scene& scene, const RayLight& light, const Mesh& sheet, const Color& paint, double opacity)
    : Sheet(sheet)
    , Paint(paint)
    , Opacity(opacity)
    , Oracle(scene, light, { { sheet } }, Width, Height)
  {
    vtkSmartPointer<vtkActor> actor = scene.Add(sheet);
    actor->GetProperty()->SetColor(paint[0], paint[1], paint[2]);
    actor->GetProperty()->SetOpacity(opacity);
  }

  /// Lit as if nothing else was there.
  Color GetColor(int x, int y) const
  {
    const double shade = this->Oracle.GetColor(x, y)[0] / Scene::Red;
    return { shade * this->Paint[0], shade * this->Paint[1], shade * this->Paint[2] };
  }
};

double Distance(const Vec3& a, const Vec3& b)
{
  const Vec3 way = b - a;
  return std::hypot(way[0], way[1], way[2]);
}

/// What lies over the pixel's opaque surface, the farthest first.
std::vector<int> PanesOver(
  const std::vector<Pane>& panes, const PictureOracle& opaque, const Vec3& eye, int x, int y)
{
  std::vector<std::pair<double, int>> over;
  const bool background = opaque.GetKind(x, y) == PictureOracle::Background;
  const double limit = background ? 1e300 : Distance(eye, opaque.GetSample(x, y).Point);
  for (std::size_t pane = 0; pane < panes.size(); ++pane)
  {
    if (panes[pane].Oracle.GetKind(x, y) != PictureOracle::Background)
    {
      const double distance = Distance(eye, panes[pane].Oracle.GetSample(x, y).Point);
      if (distance < limit)
      {
        over.emplace_back(-distance, static_cast<int>(pane));
      }
    }
  }
  std::sort(over.begin(), over.end());
  std::vector<int> order;
  for (const auto& entry : over)
  {
    order.push_back(entry.second);
  }
  return order;
}

/**
 * Expects the opaque picture with the panes blended over it, each lit in full: not one of them
 * casts or is in shadow. Where panes lie over one another it is only compared if `layered`.
 */
void ExpectPanes(BoxScene& scene, vtkImageData* picture, const std::vector<Pane>& panes,
  bool layered, const char* what, int margin = 1)
{
  const PictureOracle opaque = scene.Oracle();
  Vec3 eye;
  scene.Renderer->GetActiveCamera()->GetPosition(eye.data());
  long overDark = 0;
  long inShadow = 0;
  long crossed = 0;
  PictureExpectation expectation;
  expectation.What = what;
  expectation.Margin = margin;
  expectation.Recolor = [&](const Color& color, int x, int y) -> std::optional<Color> {
    const std::vector<int> order = PanesOver(panes, opaque, eye, x, y);
    if (!layered && order.size() > 1)
    {
      return {};
    }
    for (int j = std::max(y - margin, 0); j <= std::min(y + margin, Height - 1); ++j)
    {
      for (int i = std::max(x - margin, 0); i <= std::min(x + margin, Width - 1); ++i)
      {
        if (PanesOver(panes, opaque, eye, i, j) != order)
        {
          return {};
        }
      }
    }
    Color blended = color;
    for (const int pane : order)
    {
      const Pane& over = panes[static_cast<std::size_t>(pane)];
      const Color shown = over.GetColor(x, y);
      for (std::size_t i = 0; i < 3; ++i)
      {
        blended[i] += over.Opacity * (shown[i] - blended[i]);
      }
    }
    overDark += order.size() == 1 && opaque.GetKind(x, y) == PictureOracle::Dark;
    crossed += order.size() == 2;
    return blended;
  };
  ExpectPicture(opaque, picture, expectation);
  EXPECT_GT(overDark, 200) << what;
  if (layered)
  {
    EXPECT_GT(crossed, 500) << what;
  }

  // That it would show if a pane were in shadow.
  std::vector<RayObject> sheets = scene.Objects();
  for (const Pane& pane : panes)
  {
    sheets.push_back({ pane.Sheet, nullptr, false });
  }
  const PictureOracle shadowed(scene, scene.Position, sheets, Width, Height);
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      inShadow +=
        shadowed.GetSample(x, y).Object > 1 && shadowed.GetSample(x, y).Light == Visibility::Shadow;
    }
  }
  EXPECT_GT(inShadow, 200) << what;
}

/// Expects pixels of a picture with panes to be as in one that VTK draws without shadows, where the
/// opaque surface is lit. Dual depth peeling loses panes with some drivers, with or without
/// shadows, so what lies behind the nearest pane is not compared with the oracle.
void ExpectPanesOf(BoxScene& scene, vtkImageData* picture, vtkImageData* shadowless)
{
  const PictureOracle opaque = scene.Oracle();
  long wrong = 0;
  long compared = 0;
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      if (opaque.GetKind(x, y) == PictureOracle::Lit && !opaque.IsNearEdge(x, y, 1))
      {
        ++compared;
        wrong +=
          std::abs(Byte(picture, x, y, 2) - Byte(shadowless, x, y, 2)) > tolerance::SameShade;
      }
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(compared, Width * Height / 2);
}

/// Two sheets about the box's shadow that overlap in the picture. The nearer one is drawn first.
std::vector<Pane> AddPanes(BoxScene& scene)
{
  std::vector<Pane> panes;
  panes.emplace_back(scene, scene.Position, moved(ground(0.0, 1.1), 1.0, { -0.7, -0.8, 0.6 }),
    Color{ 1.0, 0.25, 0.25 }, 0.5);
  panes.emplace_back(scene, scene.Position, moved(ground(0.0, 0.9), 1.0, { 0.2, -1.2, 0.3 }),
    Color{ 0.25, 0.5, 1.0 }, 0.25);
  return panes;
}
}

TEST(ShadowPassCompositions, TranslucentActors)
{
  for (const RayLight& position : { PointLight, DirectionalLight })
  {
    BoxScene scene(position);
    auto window = MakeWindow(Width, Height);
    window->AddRenderer(scene.Renderer);
    const OpenGLWatch watch(window);
    const std::vector<Pane> panes = AddPanes(scene);
    const Image picture = Draw(window, "translucent");
    ExpectMask(scene, scene.Light, scene.Position, scene.Objects(), "translucent");
    ExpectPanes(scene, picture, panes, false, "translucent");
    scene.Release(window, scene.Pass);
    ExpectQuiet(watch);
  }
}

TEST(ShadowPassCompositions, TranslucentActorsWithinSupersampling)
{
  BoxScene scene;
  auto window = MakeWindow(Width, Height);
  window->AddRenderer(scene.Renderer);
  const OpenGLWatch watch(window);
  const std::vector<Pane> panes = AddPanes(scene);
  vtkNew<vtkSSAAPass> supersampling;
  supersampling->SetDelegatePass(scene.Pass);
  scene.Renderer->SetPass(supersampling);
  const Image picture = Draw(window, "translucent-ssaa");
  ExpectMask(scene, scene.Light, scene.Position, scene.Objects(), "translucent");
  ExpectPanes(scene, picture, panes, false, "supersampled", 3);
  scene.Release(window, supersampling);
  ExpectQuiet(watch);
}

TEST(ShadowPassCompositions, DepthPeelingOfTheRenderer)
{
  BoxScene scene;
  auto window = MakeWindow(Width, Height);
  window->SetAlphaBitPlanes(1);
  window->AddRenderer(scene.Renderer);
  const OpenGLWatch watch(window);
  const std::vector<Pane> panes = AddPanes(scene);
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->SetMaximumNumberOfPeels(8);
  scene.Renderer->SetPass(nullptr);
  const Image shadowless = Draw(window, "peeling-none");
  scene.Renderer->SetPass(scene.Pass);
  for (int frame = 0; frame < 2; ++frame)
  {
    scene.Renderer->SetUseDepthPeeling(frame == 0);
    const Image picture = Draw(window, frame == 0 ? "peeling" : "blending");
    EXPECT_EQ(scene.Renderer->GetLastRenderingUsedDepthPeeling(), frame == 0);
    ExpectMask(scene, scene.Light, scene.Position, scene.Objects(), "peeling");
    ExpectPanes(scene, picture, panes, false, "peeling");
    if (frame == 0)
    {
      ExpectPanesOf(scene, picture, shadowless);
    }
  }
  scene.Release(window, scene.Pass);
  ExpectQuiet(watch);
}

TEST(ShadowPassCompositions, DepthPeelingPassesWithin)
{
  for (const bool dual : { true, false })
  {
    BoxScene scene;
    auto window = MakeWindow(Width, Height);
    window->SetAlphaBitPlanes(1);
    window->AddRenderer(scene.Renderer);
    const OpenGLWatch watch(window);
    const std::vector<Pane> panes = AddPanes(scene);
    vtkSmartPointer<vtkDepthPeelingPass> peeling;
    if (dual)
    {
      peeling = vtkSmartPointer<vtkDualDepthPeelingPass>::New();
    }
    else
    {
      peeling = vtkSmartPointer<vtkDepthPeelingPass>::New();
    }
    peeling->SetTranslucentPass(vtkNew<vtkTranslucentPass>());
    peeling->SetMaximumNumberOfPeels(8);
    vtkNew<vtkRenderStepsPass> steps;
    steps->SetTranslucentPass(peeling);
    const char* name = dual ? "dual-peeling" : "peeling-pass";
    scene.Renderer->SetPass(steps);
    const Image shadowless = Draw(window, std::string(name) + "-none");
    scene.Renderer->SetPass(scene.Pass);
    scene.Pass->SetDelegatePass(steps);
    for (int frame = 0; frame < 2; ++frame)
    {
      const Image picture = Draw(window, name);
      ExpectMask(scene, scene.Light, scene.Position, scene.Objects(), name);
      ExpectPanes(scene, picture, panes, !dual, name);
      ExpectPanesOf(scene, picture, shadowless);
    }
    scene.Release(window, scene.Pass);
    ExpectQuiet(watch);
  }
}

TEST(ShadowPassCompositions, HiddenLineRemoval)
{
  for (const bool ofRenderer : { true, false })
  {
    SCOPED_TRACE(ofRenderer ? "by the renderer" : "by a pass");
    BoxScene scene;
    auto window = MakeWindow(Width, Height);
    window->AddRenderer(scene.Renderer);
    const OpenGLWatch watch(window);
    const Mesh cage = moved(quadBox(0.7, 0.7, 0.6), 1.0, { -1.4, -1.0, 0.9 }, 11);
    vtkSmartPointer<vtkActor> lines = scene.Add(cage);
    scene.Renderer->SetPass(nullptr);
    lines->VisibilityOff();
    const Image without = DrawReference(scene, window, true, "lines-none");
    lines->VisibilityOn();
    lines->GetProperty()->SetRepresentationToWireframe();
    const Image all = DrawReference(scene, window, true, "lines-all");
    scene.Renderer->UseHiddenLineRemovalOn();
    const Image lit = DrawReference(scene, window, true, "lines");
    const Image unlit = DrawReference(scene, window, false, "lines");
    const long removed = Differences(all, without) - Differences(lit, without);
    EXPECT_GT(removed, 50);

    scene.Renderer->SetPass(scene.Pass);
    if (!ofRenderer)
    {
      vtkNew<vtkRenderStepsPass> steps;
      steps->SetOpaquePass(vtkNew<vtkHiddenLineRemovalPass>());
      scene.Pass->SetDelegatePass(steps);
    }
    for (int frame = 0; frame < 2; ++frame)
    {
      const Image picture = Draw(window, ofRenderer ? "lines" : "lines-pass");
      // Lines are where they are without shadows, lit or not.
      const PictureOracle oracle = scene.Oracle();
      long wrong[2] = { 0, 0 };
      long seen[2] = { 0, 0 };
      long dark = 0;
      for (int y = 0; y < Height; ++y)
      {
        for (int x = 0; x < Width; ++x)
        {
          const int shown = Byte(picture, x, y);
          const bool likeLit = std::abs(shown - Byte(lit, x, y)) <= tolerance::SameShade;
          const bool likeUnlit = std::abs(shown - Byte(unlit, x, y)) <= tolerance::SameShade;
          const bool line = Byte(lit, x, y) != Byte(without, x, y);
          if (!line && oracle.IsNearEdge(x, y, 1))
          {
            continue;
          }
          const bool inShadow = oracle.GetKind(x, y) == PictureOracle::Dark;
          ++seen[line];
          dark += !line && inShadow;
          wrong[line] += line ? !likeLit && !likeUnlit : inShadow ? !likeUnlit : !likeLit;
        }
      }
      EXPECT_EQ(wrong[0], 0);
      EXPECT_EQ(wrong[1], 0);
      EXPECT_GT(seen[0], Width * Height / 2);
      EXPECT_GT(seen[1], 100);
      EXPECT_GT(dark, 500);
    }
    scene.Release(window, scene.Pass);
    ExpectQuiet(watch);
  }
}

//------------------------------------------------------------------------------------------------
// Windows and renderers.

TEST(ShadowPassCompositions, OneAndSeveralViewports)
{
  // Two renderers of their own passes, and one that shares a pass, in viewports of three shapes.
  BoxScene first;
  BoxScene second(DirectionalLight);
  second.Look(4.0, -5.0, 4.0);
  BoxScene third;
  third.Look(-5.0, 3.0, 4.0);
  third.Renderer->SetPass(first.Pass);
  struct View
  {
    BoxScene* Scene;
    std::array<int, 4> Pixels; ///< left, bottom, width, height
  };
  const View views[3] = { { &first, { 0, 0, 160, 120 } }, { &second, { 160, 0, 240, 120 } },
    { &third, { 100, 120, 200, 180 } } };
  auto window = MakeWindow(400, 300);
  const OpenGLWatch watch(window);
  for (const View& view : views)
  {
    view.Scene->Renderer->SetViewport(view.Pixels[0] / 400.0, view.Pixels[1] / 300.0,
      (view.Pixels[0] + view.Pixels[2]) / 400.0, (view.Pixels[1] + view.Pixels[3]) / 300.0);
    window->AddRenderer(view.Scene->Renderer);
  }
  for (int frame = 0; frame < 3; ++frame)
  {
    const Image picture = Draw(window, "viewports");
    for (const View& view : views)
    {
      PictureExpectation expectation;
      expectation.Origin = { view.Pixels[0], view.Pixels[1] };
      ExpectPicture(view.Scene->Oracle(view.Pixels[2], view.Pixels[3]), picture, expectation);
    }
  }
  for (const View& view : views)
  {
    view.Scene->Release(window, view.Scene->Pass);
  }
  ExpectQuiet(watch);
}

TEST(ShadowPassCompositions, ShadowsInAnUpperLayer)
{
  BoxScene scene;
  scene.Renderer->SetLayer(1);
  vtkNew<vtkRenderer> below;
  below->SetBackground(0.6, 0.2, 0.3);
  auto window = MakeWindow(Width, Height);
  window->SetNumberOfLayers(2);
  window->AddRenderer(below);
  window->AddRenderer(scene.Renderer);
  const OpenGLWatch watch(window);
  const Image picture = Draw(window, "upper-layer");
  ExpectMask(scene, scene.Light, scene.Position, scene.Objects(), "upper layer");
  PictureExpectation expectation;
  const PictureOracle oracle = scene.Oracle();
  expectation.Recolor = [&oracle](const Color& color, int x, int y) -> std::optional<Color> {
    return oracle.GetKind(x, y) == PictureOracle::Background ? Color{ 0.6, 0.2, 0.3 } : color;
  };
  ExpectPicture(oracle, picture, expectation);
  scene.Release(window, scene.Pass);
  ExpectQuiet(watch);
}

TEST(ShadowPassCompositions, BesideOutlineGlow)
{
  // Below it in a layer, above it, and in a viewport beside it. The glow's viewport is that at the
  // window's origin, as vtkOutlineGlowPass draws there wherever its own is.
  for (const char* where : { "below", "above", "beside" })
  {
    SCOPED_TRACE(where);
    const bool below = std::string(where) == "below";
    const bool beside = std::string(where) == "beside";
    BoxScene scene;
    vtkNew<vtkRenderer> glowing;
    // Over the ground, or, to be seen behind the ground, over the background.
    const Vec3 place =
      std::string(where) == "above" ? Vec3{ 0.3, 7.3, -0.2 } : Vec3{ 1.3, -0.5, 0.6 };
    vtkSmartPointer<vtkActor> ball = MakeActor(moved(sphere(12, 24), 0.5, place));
    ball->GetProperty()->LightingOff();
    glowing->AddActor(ball);
    glowing->SetActiveCamera(scene.Renderer->GetActiveCamera());
    vtkNew<vtkOutlineGlowPass> glow;
    glow->SetDelegatePass(vtkNew<vtkRenderStepsPass>());
    glowing->SetPass(glow);
    auto window = MakeWindow(beside ? 2 * Width : Width, Height);
    window->SetNumberOfLayers(2);
    if (beside)
    {
      glowing->SetViewport(0.0, 0.0, 0.5, 1.0);
      scene.Renderer->SetViewport(0.5, 0.0, 1.0, 1.0);
    }
    else
    {
      (below ? glowing.Get() : scene.Renderer.Get())->SetLayer(1);
    }
    window->AddRenderer(scene.Renderer);
    window->AddRenderer(glowing);
    const OpenGLWatch watch(window);

    scene.Renderer->SetPass(nullptr);
    window->Render(); // the first glow is coarser than all others
    const Image lit = DrawReference(scene, window, true, std::string("glow-") + where);
    const Image unlit = DrawReference(scene, window, false, std::string("glow-") + where);
    ball->VisibilityOff();
    const Image plain = DrawReference(scene, window, true, std::string("glow-off-") + where);
    ball->VisibilityOn();
    EXPECT_GT(Differences(lit, plain), 150);

    scene.Renderer->SetPass(scene.Pass);
    for (int frame = 0; frame < 2; ++frame)
    {
      const Image picture = Draw(window, std::string("glow-") + where);
      ExpectMask(scene, scene.Light, scene.Position, scene.Objects(), where);
      PictureExpectation expectation;
      expectation.Origin[0] = beside ? Width : 0;
      ExpectComposed(scene.Oracle(), picture, lit, unlit, expectation);
      if (beside)
      {
        long changed = 0;
        for (int y = 0; y < Height; ++y)
        {
          for (int x = 0; x < Width; ++x)
          {
            changed += Byte(picture, x, y) != Byte(lit, x, y);
          }
        }
        EXPECT_EQ(changed, 0);
      }
    }
    glow->ReleaseGraphicsResources(window);
    glowing->SetPass(nullptr);
    scene.Release(window, scene.Pass);
    ExpectQuiet(watch);
  }
}

TEST(ShadowPassCompositions, MultisampledWindows)
{
  std::vector<int> tried;
  for (const int samples : { 2, 4, 8 })
  {
    BoxScene scene;
    auto window = MakeWindow(Width, Height);
    window->SetMultiSamples(samples);
    window->AddRenderer(scene.Renderer);
    const OpenGLWatch watch(window);
    vtkNew<ProbePass> probe;
    probe->Delegate = vtkSmartPointer<vtkRenderStepsPass>::New();
    scene.Renderer->SetPass(probe);
    Draw(window, "samples-none");
    Draw(window, "samples-none");
    const OpenGLValues state = probe->After;
    // More than the driver has are made fewer.
    const int given = window->GetMultiSamples();
    tried.push_back(given);
    probe->Delegate = scene.Pass;
    for (int frame = 0; frame < 2; ++frame)
    {
      const Image picture = Draw(window, "samples-" + std::to_string(given));
      scene.Expect(picture, "multisampled");
      ExpectSameState(probe->After, state, false);
    }
    scene.Release(window, scene.Pass);
    ExpectQuiet(watch);
  }
  EXPECT_GE(*std::max_element(tried.begin(), tried.end()), 4);
}

TEST(ShadowPassCompositions, WindowsOfAnyShapeAndResized)
{
  BoxScene scene;
  auto window = MakeWindow(Width, Height);
  window->AddRenderer(scene.Renderer);
  const OpenGLWatch watch(window);
  std::optional<GraphicsObjects> kept;
  for (const auto& size : std::vector<std::array<int, 2>>{
         { Width, Height }, { 301, 120 }, { 131, 260 }, { 180, 180 }, { Width, Height } })
  {
    window->SetSize(size[0], size[1]);
    const Image picture = Draw(window, "shape-" + std::to_string(size[0]));
    ASSERT_EQ(picture->GetDimensions()[0], size[0]);
    ASSERT_EQ(picture->GetDimensions()[1], size[1]);
    ASSERT_EQ(scene.Mask(scene.Light)->GetDimensions()[0], size[0]);
    ASSERT_EQ(scene.Mask(scene.Light)->GetDimensions()[1], size[1]);
    scene.Expect(picture, "resized");
    const GraphicsObjects objects = CountGraphicsObjects(window);
    EXPECT_EQ(objects, kept.value_or(objects));
    kept = objects;
  }
  scene.Release(window, scene.Pass);
  ExpectQuiet(watch);
}

TEST(ShadowPassCompositions, ToggledEveryFrame)
{
  BoxScene scene;
  auto window = MakeWindow(Width, Height);
  window->AddRenderer(scene.Renderer);
  const OpenGLWatch watch(window);
  const PictureOracle shadowless(scene, scene.Position, { { scene.GroundMesh } }, Width, Height);
  std::vector<GraphicsObjects> objects;
  for (int frame = 0; frame < 6; ++frame)
  {
    const bool shadows = frame % 2 == 0;
    scene.Renderer->SetPass(shadows ? scene.Pass.Get() : nullptr);
    const Image picture = Draw(window, shadows ? "toggled-on" : "toggled-off");
    if (shadows)
    {
      scene.Expect(picture, "toggled on");
    }
    else
    {
      long wrong = 0;
      long compared = 0;
      const PictureOracle oracle = scene.Oracle();
      for (int y = 0; y < Height; ++y)
      {
        for (int x = 0; x < Width; ++x)
        {
          if (oracle.GetSample(x, y).Object == 0 && !oracle.IsNearEdge(x, y, 1))
          {
            ++compared;
            wrong += std::abs(Byte(picture, x, y) - 255.0 * shadowless.GetColor(x, y)[0]) >
              tolerance::Shade;
          }
        }
      }
      EXPECT_EQ(wrong, 0);
      EXPECT_GT(compared, Width * Height / 4);
    }
    objects.push_back(CountGraphicsObjects(window));
  }
  EXPECT_EQ(objects[5], objects[1]);
  scene.Release(window, scene.Pass);
  ExpectQuiet(watch);
}

TEST(ShadowPassCompositions, TwoWindowsInTurn)
{
  // Two windows with a pass each, then one pass that goes from one to the other.
  auto first = MakeWindow(Width, Height);
  auto second = MakeWindow(180, 240);
  {
    BoxScene here;
    BoxScene there(DirectionalLight);
    first->AddRenderer(here.Renderer);
    second->AddRenderer(there.Renderer);
    for (int frame = 0; frame < 3; ++frame)
    {
      const OpenGLWatch watch(first);
      here.Expect(Draw(first, "first"), "first window");
      ExpectQuiet(watch);
      const OpenGLWatch other(second);
      there.Expect(Draw(second, "second"), "second window");
      ExpectQuiet(other);
    }
    here.Release(first, here.Pass);
    there.Release(second, there.Pass);
    first->RemoveRenderer(here.Renderer);
    second->RemoveRenderer(there.Renderer);
  }

  BoxScene scene;
  const GraphicsObjects none[2] = { CountGraphicsObjects(first), CountGraphicsObjects(second) };
  for (int frame = 0; frame < 6; ++frame)
  {
    SCOPED_TRACE(frame);
    vtkRenderWindow* window = frame % 2 == 0 ? first : second;
    vtkRenderWindow* other = frame % 2 == 0 ? second : first;
    window->AddRenderer(scene.Renderer);
    const OpenGLWatch watch(window);
    scene.Expect(Draw(window, "moved"), "moved to another window");
    ExpectQuiet(watch);
    EXPECT_NE(CountGraphicsObjects(window), none[frame % 2]);
    EXPECT_EQ(CountGraphicsObjects(other), none[1 - frame % 2]);
    window->RemoveRenderer(scene.Renderer);
  }
  scene.Renderer->SetPass(nullptr);
}

//------------------------------------------------------------------------------------------------
// What is left behind.

TEST(ShadowPassCompositions, ReadingAMaskLeavesStateAlone)
{
  BoxScene scene;
  auto window = MakeWindow(Width, Height);
  window->AddRenderer(scene.Renderer);
  const OpenGLWatch watch(window);
  window->Render();
  const OpenGLValues before = QueryState();
  ExpectMask(scene, scene.Light, scene.Position, scene.Objects(), "before");
  ExpectSameState(QueryState(), before, false);
  scene.Release(window, scene.Pass);
  ExpectQuiet(watch);
}

TEST(ShadowPassCompositions, RemovedPassLeavesNothing)
{
  for (const char* way : { "released", "destroyed", "released twice" })
  {
    SCOPED_TRACE(way);
    auto window = MakeWindow(Width, Height);
    BoxScene scene;
    window->AddRenderer(scene.Renderer);
    const OpenGLWatch watch(window);
    // More lights than a layer of masks has, and so many volumes around a point that they are
    // counted in floats.
    scene.AddHeadlight(0.1);
    for (int i = 0; i < 4; ++i)
    {
      scene.AddLight({ 1.0 * i - 2.0, 2.0, 4.0, i % 2 == 0 ? 1.0 : 0.0 }, 0.1);
    }
    for (int i = 0; i < 130; ++i)
    {
      scene.Add(scene.Box);
    }
    scene.Renderer->SetPass(nullptr);
    window->Render();
    window->Render();
    const Image plain = Draw(window, "removed-before");
    const GraphicsObjects before = CountGraphicsObjects(window);
    EXPECT_GT(before.Buffers, 0);

    auto pass = vtkSmartPointer<vtkStencilShadowPass>::New();
    pass->SetKindToDiscrete();
    for (int time = 0; time < 2; ++time)
    {
      scene.Renderer->SetPass(pass);
      window->Render();
      window->Render();
      EXPECT_GT(Differences(Grab(window), plain), 1000);
      const GraphicsObjects during = CountGraphicsObjects(window);
      EXPECT_GE(during.Textures, before.Textures + 2); // masks and counts
      EXPECT_GE(during.Renderbuffers, before.Renderbuffers + 1);
      EXPECT_GE(during.Framebuffers, before.Framebuffers + 3);
      EXPECT_GE(during.Buffers, before.Buffers + 10); // two of each volume
      EXPECT_GE(during.VertexArrays, before.VertexArrays + 6);

      scene.Renderer->SetPass(nullptr);
      if (std::string(way) == "destroyed")
      {
        // Mappers hold the passes that they were drawn with last.
        window->Render();
        EXPECT_EQ(pass->GetReferenceCount(), 1);
        pass = vtkSmartPointer<vtkStencilShadowPass>::New();
        pass->SetKindToDiscrete();
      }
      else
      {
        pass->ReleaseGraphicsResources(window);
        if (std::string(way) == "released twice")
        {
          pass->ReleaseGraphicsResources(window);
        }
      }
      EXPECT_EQ(CountGraphicsObjects(window), before);
      const Image after = Draw(window, "removed");
      EXPECT_EQ(Differences(after, plain), 0);
      EXPECT_EQ(CountGraphicsObjects(window), before);
    }
    ExpectQuiet(watch);
  }
}
