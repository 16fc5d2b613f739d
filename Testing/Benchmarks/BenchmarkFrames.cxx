// Frame times at 768 x 768 without shadows, with vtkShadowMapPass and with vtkStencilShadowPass,
// the light moving, nothing moving and the camera moving; the pixels of either's shadows that
// differ from a ray cast; the stencil pass's time by step; and for scale one thread of Embree.
//
// BenchmarkFrames [n ...]: the bunny subdivided n times after Loop, each time into four; 0 and 2
// without arguments.

#include "BenchmarkWindow.h"
#include "MaskComparison.h"
#include "Measure.h"
#include "PacketCaster.h"
#include "RayCast.h"
#include "RealMeshes.h"
#include "StepTimes.h"
#include "SubdividedBunny.h"
#include "TestMeshes.h"

#include <vtkActor.h>
#include <vtkCameraPass.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderPassCollection.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>
#include <vtkStencilShadowPass.h>

#include <embree3/rtcore_config.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace shadowtest;

constexpr int Size = 768;
/// That the light or the camera moves through, so that each frame has a new one.
constexpr int Places = 7;

enum Mode
{
  LIGHT_MOVES,
  AT_REST,
  CAMERA_MOVES,
  NumberOfModes
};

constexpr const char* ModeNames[] = { "light moves", "at rest", "camera moves" };

/// A direction, which both passes can cast: vtkShadowMapPass needs a spot for anything else.
void placeLight(vtkLight* light, int step)
{
  const double angle = 0.6 + 0.02 * step;
  light->SetPosition(2.0 * std::cos(angle), 2.0 * std::sin(angle), 4.0);
}

RayLight rayLight(vtkLight* light)
{
  double position[3];
  light->GetPosition(position);
  return { position[0], position[1], position[2], 0.0 };
}

struct Scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkLight> Light;
  vtkSmartPointer<vtkRenderWindow> Window;

  void add(vtkPolyData* mesh)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    // White, diffuse only: a pixel is black exactly if it gets no light.
    actor->GetProperty()->SetAmbient(0.0);
    this->Renderer->AddActor(actor);
  }

  explicit Scene(const std::vector<RayObject>& objects)
  {
    for (const RayObject& object : objects)
    {
      this->add(object.Surface);
    }
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetBackground(0.5, 0.5, 0.5);
    this->Light->SetPositional(false);
    this->Light->SetFocalPoint(0.0, 0.0, 0.0);
    this->Renderer->AddLight(this->Light);
    this->reset();
    this->Window = benchmarks::openWindow(Size, this->Renderer);
  }

  void reset()
  {
    placeLight(this->Light, 0);
    benchmarks::lookAtTheGround(this->Renderer);
  }

  void draw(Mode mode, int i)
  {
    if (mode == LIGHT_MOVES)
    {
      placeLight(this->Light, i % Places);
    }
    if (mode == CAMERA_MOVES)
    {
      this->Renderer->GetActiveCamera()->Azimuth(i % Places == 0 ? 1.0 - Places : 1.0);
    }
    benchmarks::drawFrame(this->Window);
  }

  /// One channel: 0 where no light comes.
  vtkSmartPointer<vtkImageData> lightMask()
  {
    this->reset();
    benchmarks::drawFrame(this->Window);
    const auto picture = benchmarks::grab(this->Window);
    auto mask = vtkSmartPointer<vtkImageData>::New();
    mask->SetDimensions(Size, Size, 1);
    mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    for (int y = 0; y < Size; ++y)
    {
      for (int x = 0; x < Size; ++x)
      {
        const double value = picture->GetScalarComponentAsDouble(x, y, 0, 0);
        mask->SetScalarComponentFromDouble(x, y, 0, 0, value > 0.0 ? 255.0 : 0.0);
      }
    }
    return mask;
  }
};

vtkSmartPointer<vtkRenderPass> shadowMapPass()
{
  vtkNew<vtkShadowMapPass> shadows;
  shadows->GetShadowMapBakerPass()->SetResolution(2048);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(shadows->GetShadowMapBakerPass());
  passes->AddItem(shadows);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(sequence);
  return camera;
}

void printWrong(Scene& scene, const RayScene& rays)
{
  const auto picture = scene.lightMask();
  const RayView view = RayView::fromCamera(scene.Renderer->GetActiveCamera(), Size, Size);
  const MaskComparison wrong = compareMask(rays, view, rayLight(scene.Light), picture);
  std::printf(" %6ld %6ld %6ld %6ld", wrong.Objects[0].Wrong, wrong.Objects[0].WrongBeyond,
    wrong.Objects[1].Wrong, wrong.Objects[1].WrongBeyond);
}

/// Pixels whose light by packets is not that of the ray cast in double.
long differingPixels(const std::vector<unsigned char>& mask, const RayScene& rays,
  const RayView& view, vtkLight* light)
{
  const RayPicture exact = rays.render(view, rayLight(light));
  long differing = 0;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    const Visibility seen = exact.Samples[i].Light;
    differing += (mask[i] != 0) != (seen == Visibility::Lit || seen == Visibility::Background);
  }
  return differing;
}

struct Rival
{
  std::string Name;
  std::unique_ptr<Scene> Picture;
  vtkSmartPointer<vtkStencilShadowPass> Pass; ///< null if it has another
};

constexpr std::size_t NoShadows = 0;
constexpr std::size_t ShadowMap = 1;

std::vector<Rival> makeRivals(const std::vector<RayObject>& objects)
{
  std::vector<Rival> rivals;
  rivals.push_back({ "no shadows", std::make_unique<Scene>(objects), nullptr });
  rivals.push_back({ "vtkShadowMapPass 2048", std::make_unique<Scene>(objects), nullptr });
  rivals.back().Picture->Renderer->SetPass(shadowMapPass());
  const std::pair<int, const char*> kinds[] = { { vtkStencilShadowPass::DISCRETE, "discrete" },
    { vtkStencilShadowPass::ACCURATE, "accurate" }, { vtkStencilShadowPass::SMOOTH, "smooth" },
    { vtkStencilShadowPass::AUTOMATIC, "automatic" } };
  for (const auto& [kind, name] : kinds)
  {
    rivals.push_back({ std::string("stencil, ") + name, std::make_unique<Scene>(objects),
      vtkSmartPointer<vtkStencilShadowPass>::New() });
    rivals.back().Pass->SetKind(kind);
    rivals.back().Picture->Renderer->SetPass(rivals.back().Pass);
  }
  return rivals;
}

void resetAll(std::vector<Rival>& rivals)
{
  for (Rival& rival : rivals)
  {
    rival.Picture->reset();
  }
}

void printFrames(std::vector<Rival>& rivals, const RayScene& rays, int rounds)
{
  const bool onProcessor = benchmarks::drawsOnProcessor(rivals.front().Picture->Window);
  std::vector<benchmarks::Turns> turns;
  for (const Mode mode : { LIGHT_MOVES, AT_REST, CAMERA_MOVES })
  {
    resetAll(rivals);
    turns.push_back(benchmarks::measureInTurns(
      rivals.size(),
      [&](std::size_t rival, int round) { rivals[rival].Picture->draw(mode, round); }, rounds));
  }
  std::printf("%-22s", "");
  for (const char* mode : ModeNames)
  {
    std::printf(" %21s", mode);
  }
  std::printf(" %13s %13s\n", "ground", "caster");
  for (std::size_t rival = 0; rival < rivals.size(); ++rival)
  {
    std::printf("%-22s", rivals[rival].Name.c_str());
    for (const benchmarks::Turns& mode : turns)
    {
      std::printf(" %9.1f %5.2f %5.2f", mode.median(rival),
        mode.ratio(rival, NoShadows, onProcessor), mode.ratio(rival, ShadowMap, onProcessor));
    }
    if (rival != NoShadows)
    {
      printWrong(*rivals[rival].Picture, rays);
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

void printSteps(std::vector<Rival>& rivals, int rounds)
{
  std::vector<Rival*> timed;
  std::vector<vtkStencilShadowPass*> passes;
  for (Rival& rival : rivals)
  {
    if (rival.Pass)
    {
      timed.push_back(&rival);
      passes.push_back(rival.Pass);
    }
  }
  for (const Mode mode : { LIGHT_MOVES, CAMERA_MOVES })
  {
    resetAll(rivals);
    const auto steps = benchmarks::measureSteps(
      passes, [&](std::size_t i, int round) { timed[i]->Picture->draw(mode, round); }, rounds);
    std::printf("%-22s", (std::string("steps, ") + ModeNames[mode]).c_str());
    for (const char* name : benchmarks::StepNames)
    {
      std::printf(" %15s", name);
    }
    std::printf("\n");
    for (std::size_t i = 0; i < timed.size(); ++i)
    {
      std::printf("%-22s", timed[i]->Name.c_str());
      for (const double time : steps[i])
      {
        std::printf(" %15.1f", time);
      }
      std::printf("\n");
    }
  }
}

/// In turns with frames without shadows.
void printPackets(
  const std::vector<RayObject>& objects, const RayScene& rays, Scene& plain, int rounds)
{
  const benchmarks::PacketCaster packets(objects);
  plain.reset();
  const RayView view = RayView::fromCamera(plain.Renderer->GetActiveCamera(), Size, Size);
  std::vector<unsigned char> mask;
  std::vector<double> primary;
  std::vector<double> shadow;
  const benchmarks::Turns turns = benchmarks::measureInTurns(
    2,
    [&](std::size_t rival, int round) {
      if (rival == 0)
      {
        plain.draw(LIGHT_MOVES, round);
        return;
      }
      primary.push_back(0.0);
      shadow.push_back(0.0);
      mask = packets.render(view, rayLight(plain.Light), primary.back(), shadow.back());
    },
    rounds);
  std::printf("Embree %s, one thread, packets of 8 (%s), rays set up and traced, no shading: "
              "%.1f ms a picture, %.2f of no shadows;\nrays from the eye %.1f, to the light %.1f; "
              "hierarchy built in %.0f; %ld pixels are not as by the ray cast in double\n",
    RTC_VERSION_STRING, packets.isNative() ? "native" : "emulated", turns.median(1),
    turns.ratio(1, 0, benchmarks::drawsOnProcessor(plain.Window)), benchmarks::medianOf(primary),
    benchmarks::medianOf(shadow), packets.getBuildTime(),
    differingPixels(mask, rays, view, plain.Light));
}

void report(int subdivisions)
{
  const Mesh mesh = standing(benchmarks::subdividedBunny(subdivisions), 1);
  const int rounds = subdivisions > 1 ? 9 : 15;
  double bounds[6];
  mesh->GetBounds(bounds);
  const std::vector<RayObject> objects = { { ground(bounds[4], 4.0, 8) }, { mesh } };
  const RayScene rays(objects);
  std::vector<Rival> rivals = makeRivals(objects);
  Scene& plain = *rivals[NoShadows].Picture;
  benchmarks::drawFrame(plain.Window);
  std::printf(
    "bunny, %lld triangles, over a plane; %d x %d; milliseconds, medians of %d frames in "
    "turns, and medians of the ratios to no\nshadows and to the shadow map; wrong pixels "
    "against a ray cast of the triangles, in all and beyond one pixel of an\nedge; no colour "
    "of the caster's lit side is told from shadow below 1/255\n%s\n",
    static_cast<long long>(mesh->GetNumberOfCells()), Size, Size, rounds,
    benchmarks::conditions(plain.Window).c_str());
  printFrames(rivals, rays, rounds);
  printSteps(rivals, rounds);
  printPackets(objects, rays, plain, rounds);
}
}

int main(int argc, char* argv[])
{
  std::vector<int> levels;
  for (int i = 1; i < argc; ++i)
  {
    levels.push_back(std::atoi(argv[i]));
  }
  if (levels.empty())
  {
    levels = { 0, 2 };
  }
  for (const int level : levels)
  {
    report(level);
    std::printf("\n");
  }
  return 0;
}
