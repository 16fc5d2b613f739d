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

/// Splits at the middle until each part's deviation bound is within the tolerance, and calls
/// emit(s) for each inner breakpoint's parameter, ascending. Gives the largest bound that is left:
/// above the tolerance only if the curve was split 2^maximumDepth times.
template <class Emit>
double subdivide(
  const CubicCurve& curve, double tolerance, const Emit& emit, double from = 0.0, double to = 1.0,
  int depth = 0)
{
  constexpr int maximumDepth = 16;
  const double bound = curve.deviationBound();
  if (!(bound > tolerance) || depth == maximumDepth)
  {
    return bound;
  }
  const auto [first, second] = curve.split(0.5);
  const double middle = 0.5 * (from + to);
  const double firstBound = subdivide(first, tolerance, emit, from, middle, depth + 1);
  emit(middle);
  return std::fmax(firstBound, subdivide(second, tolerance, emit, middle, to, depth + 1));
}
}
