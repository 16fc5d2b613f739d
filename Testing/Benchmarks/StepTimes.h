// The time of a frame by step, from the pass's plan.
#ifndef StepTimes_h
#define StepTimes_h

#include "Measure.h"

#include <vtkSmartPointer.h>
#include <vtkStencilShadowPass.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace benchmarks
{
enum Step
{
  DEPTH,
  VOLUMES,
  COUNTING,
  SHADING,
  NumberOfSteps
};
constexpr const char* StepNames[] = { "depth", "volumes made", "counted, masks", "shading" };

using StepTimes = std::array<double, NumberOfSteps>;

/// The sums of the last frame, in milliseconds: true ones only with StepTiming on.
inline StepTimes stepTimes(vtkStencilShadowPass* pass)
{
  const auto plan = vtkSmartPointer<vtkTable>::Take(pass->GetPlan());
  StepTimes times{};
  for (vtkIdType row = 0; row < plan->GetNumberOfRows(); ++row)
  {
    const bool hasLight = plan->GetValueByName(row, "Light").ToInt() >= 0;
    const bool hasCaster = plan->GetValueByName(row, "Caster").ToInt() >= 0;
    const bool shades = plan->GetValueByName(row, "Decision").ToString() == "shading";
    times[hasCaster ? VOLUMES
        : hasLight  ? COUNTING
        : shades    ? SHADING
                    : DEPTH] += plan->GetValueByName(row, "Milliseconds").ToDouble();
  }
  return times;
}

/// Medians of frames of each pass, which draw(pass, round) draws in turn. Waits after steps, which
/// costs time itself.
template <class Draw>
std::vector<StepTimes> measureSteps(
  const std::vector<vtkStencilShadowPass*>& passes, const Draw& draw, int rounds = 15)
{
  std::vector<std::array<std::vector<double>, NumberOfSteps>> times(passes.size());
  for (vtkStencilShadowPass* pass : passes)
  {
    pass->StepTimingOn();
  }
  for (int round = 0; round <= rounds; ++round)
  {
    for (std::size_t i = 0; i < passes.size(); ++i)
    {
      draw(i, round);
      const StepTimes frame = stepTimes(passes[i]);
      for (std::size_t step = 0; step < NumberOfSteps && round > 0; ++step)
      {
        times[i][step].push_back(frame[step]);
      }
    }
  }
  std::vector<StepTimes> medians(passes.size());
  for (std::size_t i = 0; i < passes.size(); ++i)
  {
    passes[i]->StepTimingOff();
    for (std::size_t step = 0; step < NumberOfSteps; ++step)
    {
      medians[i][step] = medianOf(times[i][step]);
    }
  }
  return medians;
}
}

#endif
