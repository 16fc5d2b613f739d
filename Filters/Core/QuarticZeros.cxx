#include "QuarticZeros.h"

namespace shadow
{
namespace
{
/// Newton's steps after which only the last digit may still change: what is left is about the
/// square.
constexpr double small = 1e-9;
}

/// Always three of Halley's steps, which are of third order, and one of Newton's: a branch costs
/// more than a step.
void QuarticZeros::refine()
{
  // Whole vectors; what is behind the last is computed for nothing.
  const std::size_t end = std::min(size, (this->Count + 3) / 4 * 4);
  for (std::size_t i = this->Count; i < end; ++i)
  {
    this->set(i, { { 0.0, 1.0, 0.0, 0.0, 0.0 } }, 0.0);
  }
  for (std::size_t i = 0; i < end; ++i)
  {
    const Quartic q{ { this->C[0][i], this->C[1][i], this->C[2][i], this->C[3][i],
      this->C[4][i] } };
    double s = this->S[i];
    for (int step = 0; step < 3; ++step)
    {
      const double value = q.value(s);
      const double slope = q.slope(s);
      s -= value * slope / (slope * slope - value * q.bend(s));
    }
    // Halley's steps vanish at an extremum, too, from where Newton's goes anywhere.
    const double last = q.value(s) / q.slope(s);
    this->Moved[i] = last;
    this->S[i] = s - last;
  }
}

/// Where the steps do not come to an end Newton's are taken within a bracket, which is halved where
/// they leave it.
double QuarticZeros::zero(std::size_t i, bool litAtZero) const
{
  double s = this->S[i];
  if (std::fabs(this->Moved[i]) < small && s >= 0.0 && s <= 1.0)
  {
    return s;
  }
  const Quartic q{ { this->C[0][i], this->C[1][i], this->C[2][i], this->C[3][i], this->C[4][i] } };
  double low = 0.0;
  double high = 1.0;
  s = 0.5;
  for (int step = 0; step < 60; ++step)
  {
    const double value = q.value(s);
    const double newton = s - value / q.slope(s);
    const double before = s;
    (isLit(value) == litAtZero ? low : high) = s;
    const bool inside = newton > low && newton < high;
    s = inside ? newton : 0.5 * (low + high);
    if (std::fabs(s - before) < (inside ? small : 1e-16))
    {
      break;
    }
  }
  return s;
}
}
