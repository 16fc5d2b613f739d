/// Zeros of quartics between 0 and 1, many side by side.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// c[0] + c[1] s + ... + c[4] s^4
struct Quartic
{
  std::array<double, 5> c;

  /// Sums in pairs, so that they need not wait for one another.
  double value(double s) const
  {
    const double q = s * s;
    return (this->c[0] + s * this->c[1]) + q * ((this->c[2] + s * this->c[3]) + q * this->c[4]);
  }

  double slope(double s) const
  {
    return (this->c[1] + s * 2.0 * this->c[2]) + s * s * (3.0 * this->c[3] + s * 4.0 * this->c[4]);
  }

  /// Half the second derivative.
  double bend(double s) const
  {
    return this->c[2] + s * (3.0 * this->c[3] + s * 6.0 * this->c[4]);
  }
};

/// Up to `size` quartics with a start each, not far from a zero. Their steps are taken together,
/// which takes a compiler's vectors and hides that each waits for its last.
class QuarticZeros
{
public:
  static constexpr std::size_t size = 32;

  /// They are numbered as they come.
  void add(const Quartic& quartic, double start)
  {
    this->set(this->Count++, quartic, start);
  }

  /// The steps of all.
  void refine();

  /// A zero in [0, 1], after refine. litAtZero: whether the quartic is lit at 0; at 1 it is not as
  /// at 0.
  double zero(std::size_t i, bool litAtZero) const;

private:
  void set(std::size_t i, const Quartic& quartic, double start)
  {
    for (std::size_t k = 0; k < 5; ++k)
    {
      this->C[k][i] = quartic.c[k];
    }
    this->S[i] = start;
  }

  std::size_t Count = 0;
  std::array<std::array<double, size>, 5> C;
  std::array<double, size> S;
  std::array<double, size> Moved; ///< by the last step
};
}
