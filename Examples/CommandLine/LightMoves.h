/**
 * How long a filter takes for a light that moves, its mesh at rest.
 */
#ifndef LightMoves_h
#define LightMoves_h

#include "Numbers.h"
#include "Timing.h"

#include <cmath>

namespace CLI
{
class App;
}

/// Adds --repeat.
void AddRepeatOption(CLI::App& command, int& repeat);

/// The light after so many small steps; `size` is the mesh's, and not finite where its points are
/// not.
inline Homogeneous MovedLight(const Homogeneous& light, double size, int steps)
{
  const bool direction = light[3] == 0.0;
  const double reach =
    direction ? std::abs(light[0]) + std::abs(light[1]) + std::abs(light[2]) : size;
  const double move = 1e-3 * (std::isfinite(reach) ? reach : 1.0) * steps;
  return { light[0] + move, light[1] - 0.5 * move, light[2] + 0.25 * move, light[3] };
}

/// Median of `repeat` moves in milliseconds; the last one ends at the light itself.
template <class Update>
double MedianLightMove(const Homogeneous& light, double size, int repeat, const Update& update)
{
  std::vector<double> times;
  for (int step = repeat - 1; step >= 0; --step)
  {
    times.push_back(Milliseconds([&] { update(MovedLight(light, size, step)); }));
  }
  return Median(times);
}

#endif
