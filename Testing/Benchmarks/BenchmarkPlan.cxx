// What each rule of the pass is worth: 200 parts on a plane of which the eye sees 75, three
// lights, and each rule off. Pixels that differ then are few and on edges, but for other
// silhouettes.

#include "BenchmarkWindow.h"
#include "ImageChecks.h"
#include "Measure.h"
#include "PartsScene.h"
#include "StepTimes.h"

#include <vtkStencilShadowPass.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace
{
using benchmarks::PartsScene;

constexpr int Size = 768;
constexpr int Rounds = 9;

struct Rule
{
  const char* Name;
  std::function<void(vtkStencilShadowPass*)> TurnOff;
};

const Rule Rules[] = {
  { "all rules", [](vtkStencilShadowPass*) {} },
  { "Counting z-fail", [](vtkStencilShadowPass* pass) { pass->SetCountingToZFail(); } },
  { "SkipUnseenCasters off", [](vtkStencilShadowPass* pass) { pass->SkipUnseenCastersOff(); } },
  { "SkipCastersOutsideCones off",
    [](vtkStencilShadowPass* pass) { pass->SkipCastersOutsideConesOff(); } },
  { "SkipCastersWithoutReceivers off",
    [](vtkStencilShadowPass* pass) { pass->SkipCastersWithoutReceiversOff(); } },
  { "FiniteVolumes off", [](vtkStencilShadowPass* pass) { pass->FiniteVolumesOff(); } },
  { "Scissor off", [](vtkStencilShadowPass* pass) { pass->ScissorOff(); } },
  { "DepthBounds off", [](vtkStencilShadowPass* pass) { pass->DepthBoundsOff(); } },
  { "ReuseUnchanged off", [](vtkStencilShadowPass* pass) { pass->ReuseUnchangedOff(); } },
  { "Kind discrete", [](vtkStencilShadowPass* pass) { pass->SetKindToDiscrete(); } },
  { "Kind smooth", [](vtkStencilShadowPass* pass) { pass->SetKindToSmooth(); } },
  // A second time: how far ratios may be off.
  { "all rules", [](vtkStencilShadowPass*) {} },
  { "all of it off",
    [](vtkStencilShadowPass* pass) {
      pass->SetCountingToZFail();
      pass->SkipUnseenCastersOff();
      pass->SkipCastersOutsideConesOff();
      pass->SkipCastersWithoutReceiversOff();
      pass->FiniteVolumesOff();
      pass->ScissorOff();
      pass->DepthBoundsOff();
      pass->ReuseUnchangedOff();
    } },
};

const char* const ModeNames[] = { "lights moving", "camera moving", "at rest" };

/// How many pairs of a light and a caster were decided upon in a way, and for a reason.
std::map<std::string, int> decisions(vtkStencilShadowPass* pass)
{
  std::map<std::string, int> counts;
  const auto plan = vtkSmartPointer<vtkTable>::Take(pass->GetPlan());
  for (vtkIdType row = 0; row < plan->GetNumberOfRows(); ++row)
  {
    if (plan->GetValueByName(row, "Caster").ToInt() >= 0)
    {
      ++counts[plan->GetValueByName(row, "Decision").ToString() + ": " +
        plan->GetValueByName(row, "Reason").ToString()];
    }
  }
  return counts;
}

bool hasDepthBounds(vtkRenderWindow* window)
{
  return std::string(window->ReportCapabilities()).find("GL_EXT_depth_bounds_test") !=
    std::string::npos;
}
}

int main()
{
  // Without shadows, all rules, and the rest.
  constexpr std::size_t none = 0;
  constexpr std::size_t all = 1;
  const benchmarks::PartMeshes meshes;
  std::vector<std::string> names = { "no shadows" };
  std::vector<std::unique_ptr<PartsScene>> scenes;
  scenes.push_back(std::make_unique<PartsScene>(meshes, Size));
  scenes.back()->Renderer->SetPass(nullptr);
  for (const Rule& rule : Rules)
  {
    scenes.push_back(std::make_unique<PartsScene>(meshes, Size));
    rule.TurnOff(scenes.back()->Pass);
    names.emplace_back(rule.Name);
  }
  PartsScene& usual = *scenes[all];
  benchmarks::drawFrame(usual.Window);
  const std::map<std::string, int> made = decisions(usual.Pass);
  std::printf(
    "%d parts of %lld triangles in all, %d of them in view, and a plane; a direction, a lamp "
    "and a spot; %d x %d;\nmilliseconds, medians of %d frames in turns, and medians of the "
    "ratios to all rules\n%s\nGL_EXT_depth_bounds_test: %s\n",
    PartsScene::NumberOfParts, static_cast<long long>(usual.NumberOfTriangles),
    usual.countPartsInView(), Size, Size, Rounds, benchmarks::conditions(usual.Window).c_str(),
    hasDepthBounds(usual.Window) ? "the driver has it"
                                 : "the driver lacks it: the rule does nothing");

  std::vector<benchmarks::Turns> modes;
  for (int mode = 0; mode < PartsScene::NumberOfModes; ++mode)
  {
    for (const auto& scene : scenes)
    {
      scene->reset();
    }
    modes.push_back(benchmarks::measureInTurns(
      scenes.size(),
      [&](std::size_t rival, int round) {
        scenes[rival]->move(static_cast<PartsScene::Mode>(mode), round);
        benchmarks::drawFrame(scenes[rival]->Window);
      },
      Rounds));
  }

  std::printf("\n%-32s", "");
  for (const char* mode : ModeNames)
  {
    std::printf(" %15s", mode);
  }
  std::printf(" %10s\n", "differing");
  const auto picture = usual.picture();
  const bool onProcessor = benchmarks::drawsOnProcessor(usual.Window);
  for (std::size_t i = 0; i < scenes.size(); ++i)
  {
    std::printf("%-32s", names[i].c_str());
    for (const benchmarks::Turns& turns : modes)
    {
      std::printf(" %8.1f %6.2f", turns.median(i), turns.ratio(i, all, onProcessor));
    }
    if (i != none)
    {
      std::printf(" %10ld", shadowtest::compareImages(picture, scenes[i]->picture()).Pixels);
    }
    std::printf("\n");
  }

  std::printf("\n%-32s", "all rules, by step, waited for");
  for (const char* name : benchmarks::StepNames)
  {
    std::printf(" %15s", name);
  }
  std::printf("\n");
  for (int mode = 0; mode < PartsScene::NumberOfModes; ++mode)
  {
    usual.reset();
    const auto steps = benchmarks::measureSteps(
      { usual.Pass },
      [&](std::size_t, int round) {
        usual.move(static_cast<PartsScene::Mode>(mode), round);
        benchmarks::drawFrame(usual.Window);
      },
      Rounds);
    std::printf("%-32s", ModeNames[mode]);
    for (const double time : steps.front())
    {
      std::printf(" %15.1f", time);
    }
    std::printf("\n");
  }

  std::printf(
    "\npairs of a light and a caster by what was decided with all rules, in a first frame:\n");
  for (const auto& [decision, count] : made)
  {
    std::printf("%6d  %s\n", count, decision.c_str());
  }
  return 0;
}
