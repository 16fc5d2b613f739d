/// A cubic in Bezier form.
#pragma once

#include "Geometry.h"

#include <utility>

namespace shadow
{
struct CubicCurve
{
  std::array<Vec3, 4> b;

  /// The straight line from p to q at constant speed.
  static CubicCurve line(const Vec3& p, const Vec3& q)
  {
    return { { p, p + (q - p) / 3.0, q - (q - p) / 3.0, q } };
  }

  /// The cubic with these ends and derivatives there.
  static CubicCurve hermite(const Vec3& p, const Vec3& dp, const Vec3& q, const Vec3& dq)
  {
    return { { p, p + dp / 3.0, q - dq / 3.0, q } };
  }

  Vec3 point(double s) const
  {
    const double r = 1.0 - s;
    return r * r * r * b[0] + 3.0 * r * r * s * b[1] + 3.0 * r * s * s * b[2] + s * s * s * b[3];
  }

  Vec3 derivative(double s) const
  {
    const double r = 1.0 - s;
    return 3.0 * (r * r * (b[1] - b[0]) + 2.0 * r * s * (b[2] - b[1]) + s * s * (b[3] - b[2]));
  }

  /// Both parts of a split at s, by de Casteljau.
  std::pair<CubicCurve, CubicCurve> split(double s) const
  {
    const auto mix = [s](const Vec3& p, const Vec3& q) { return p + s * (q - p); };
    const Vec3 b01 = mix(b[0], b[1]);
    const Vec3 b12 = mix(b[1], b[2]);
    const Vec3 b23 = mix(b[2], b[3]);
    const Vec3 b012 = mix(b01, b12);
    const Vec3 b123 = mix(b12, b23);
    const Vec3 middle = mix(b012, b123);
    return { { { b[0], b01, b012, middle } }, { { middle, b123, b23, b[3] } } };
  }

  /// Where the curve's chord in constant speed differs from it: no point of the curve is farther
  /// than this from the chord's point at the same parameter. The difference is
  /// 3 s (1-s)^2 d1 + 3 s^2 (1-s) d2, and its weights add up to at most 3/4.
  double deviationBound() const
  {
    const Vec3 d1 = b[1] - (2.0 * b[0] + b[3]) / 3.0;
    const Vec3 d2 = b[2] - (b[0] + 2.0 * b[3]) / 3.0;
    return 0.75 * std::sqrt(std::max(glm::dot(d1, d1), glm::dot(d2, d2)));
  }
};
}
