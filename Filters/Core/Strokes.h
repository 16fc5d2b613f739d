/// Ribbons along polylines, facing an eye.
#pragma once

#include "RangeLoop.h"
#include "StrokePath.h"

namespace shadow
{
/// A point of a ribbon has the data of the line's point that it is from, mixed with those of the
/// next one.
struct StrokePoint
{
  Vec3 at;
  double across; ///< 1 on the left as it is seen, 0 in the middle, -1 on the right
  Index from;    ///< a number in the line
  Index to;
  double share;
};

/// Triangles that are counter-clockwise as seen from the eye.
struct Strokes
{
  std::vector<StrokePoint> points;
  std::vector<std::array<std::size_t, 3>> triangles; ///< numbers of points
  std::vector<std::size_t> firstPoint{ 0 };          ///< of each line, and the end
  std::vector<std::size_t> firstTriangle{ 0 };
};

/// One ribbon a line, with the line's own points in its middle: its edges are on both sides, half a
/// width away. Corners are mitred up to twice the width (turns of 120 degrees), beyond that and
/// between segments shorter than the mitre round, so that no triangle is turned over. Ribbons that
/// turn sharply or meet themselves overlap.
///
/// Points of lines are before the eye if the view is in pixels. Same bytes whatever the threads;
/// linear in the number of points.
Strokes makeStrokes(const std::vector<StrokeLine>& lines, const StrokeSettings& settings,
  const StrokeView& view, const RangeLoop& loop);
}
