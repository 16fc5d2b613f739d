/// The smooth contour's segments: one cubic each, and its subdivision within a tolerance.
#pragma once

#include "CubicCurve.h"

namespace shadow
{
/// The contour's piece inside a triangle, between two points of the surface with unit normals:
/// tangent to the surface at its ends, with the tangents' length that makes it keep a circle's arc
/// (after Mattausch et al. 2012, section 4.2).
CubicCurve contourSegment(
  const Vec3& p0, const Vec3& n0, const Vec3& p1, const Vec3& n1);

/// How far a curve is from its chord, at most.
struct Deviation
{
  double world = 0.0; ///< in space
  double seen = 0.0;  ///< where it is measured: in space, or on receivers of the shadow

  void include(const Deviation& o)
  {
    this->world = std::max(this->world, o.world);
    this->seen = std::max(this->seen, o.seen);
  }
};

/// When a curve need not be split.
struct SubdivisionLimit
{
  double tolerance; ///< of what is seen
  double rounding;  ///< in space: what is less is noise of the coordinates
};

/// Splits at the middle until each part's deviation is within the limit, and calls emit(s) for each
/// inner breakpoint's parameter, ascending. deviationOf(curve) is the bound on a part's deviation.
/// Gives the largest that is left: above the limit only if the curve was split 2^maximumDepth
/// times.
template <class DeviationOf, class Emit>
Deviation subdivide(const CubicCurve& curve, const SubdivisionLimit& limit,
  const DeviationOf& deviationOf, const Emit& emit, double from = 0.0, double to = 1.0,
  int depth = 0)
{
  constexpr int maximumDepth = 16;
  Deviation bound = deviationOf(curve);
  if (!(bound.seen > limit.tolerance && bound.world > limit.rounding) || depth == maximumDepth)
  {
    return bound;
  }
  const auto [first, second] = curve.split(0.5);
  const double middle = 0.5 * (from + to);
  bound = subdivide(first, limit, deviationOf, emit, from, middle, depth + 1);
  emit(middle);
  bound.include(subdivide(second, limit, deviationOf, emit, middle, to, depth + 1));
  return bound;
}
}
