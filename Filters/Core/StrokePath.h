/// The middle of a stroke: a polyline lifted, overshot, tapered and unsteady as if drawn by hand.
#pragma once

#include "StrokeView.h"

#include <cstdint>

namespace shadow
{
/// Widths are in the view's unit; lengths other than those in widths, so that a stroke looks the
/// same in either unit.
struct StrokeSettings
{
  double width = 1.0;
  double taper = 0.0;         ///< share of the length, at each open end, that widens from 0
  double overshoot = 0.0;     ///< widths by which open ends are drawn out
  double wobble = 0.0;        ///< widths: the most that the middle is to the left or right
  double wobbleLength = 40.0; ///< widths from one random offset to the next
  std::uint64_t seed = 1;
  double lift = 0.5; ///< widths
};

/// A polyline of at least two points, no two in a row at the same place, all finite. The first
/// point of a closed one is not repeated.
struct StrokeLine
{
  std::vector<Vec3> points;
  std::vector<Vec3> normals;    ///< of the receiver; or empty
  std::vector<Vec3> directions; ///< in the receiver, into the shadow; or empty
  bool closed = false;
  std::uint64_t number = 0; ///< different for different lines: what they are unsteady by
};

struct PathPoint
{
  Vec3 at;
  double halfWidth; ///< world units
  Index from;       ///< the line's point from which it is
  Index to;         ///< and the next one, towards which it is by this share of the way
  double share;
};

/// At each point moved by `lift` widths along the normal and as many along the direction into the
/// shadow; without normals towards the eye, which leaves its place in the picture.
///
/// Offsets to the left and right follow a smooth curve through random numbers of -1 to 1 that
/// depend on the seed and the line's number alone; a line has at most 4,096 of them.
std::vector<PathPoint> strokePath(
  const StrokeLine& line, const StrokeSettings& settings, const StrokeView& view);

/// The side that is left of each segment as it is seen. Segments along a line of sight have that of
/// another one beside them.
std::vector<Vec3> leftOfSegments(
  const std::vector<PathPoint>& path, bool closed, const StrokeView& view);
}
