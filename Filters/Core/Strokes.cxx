#include "Strokes.h"

namespace shadow
{
namespace
{
/// The longest mitre, in widths: what SVG calls stroke-miterlimit.
constexpr double miterLimit = 2.0;
/// Of what is round, in radians: an eighth of a straight angle is round enough at a stroke's size.
constexpr double roundStep = 0.3926990816987241;

struct Ribbon
{
  std::vector<StrokePoint> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// Points of a ribbon at one end of a segment.
struct Corners
{
  std::size_t left;
  std::size_t middle;
  std::size_t right;
};

class RibbonMaker
{
public:
  RibbonMaker(const std::vector<PathPoint>& path, bool closed, const StrokeView& view)
    : Path(path)
    , Closed(closed)
    , View(view)
    , Left(leftOfSegments(path, closed, view))
  {
  }

  Ribbon make()
  {
    const std::size_t segments = this->Left.size();
    std::vector<Corners> start(segments);
    std::vector<Corners> end(segments);
    for (std::size_t i = 0; i < this->Path.size(); ++i)
    {
      const bool first = i == 0 && !this->Closed;
      const bool last = i == segments;
      if (first || last)
      {
        Corners& corners = first ? start[0] : end[segments - 1];
        corners =
          this->straight(i, this->add(i, 0.0, Vec3(0.0)), this->Left[first ? 0 : segments - 1]);
        continue;
      }
      this->join(i, end[i > 0 ? i - 1 : segments - 1], start[i]);
    }
    for (std::size_t i = 0; i < segments; ++i)
    {
      this->addTriangle(start[i].right, end[i].right, end[i].middle);
      this->addTriangle(start[i].right, end[i].middle, start[i].middle);
      this->addTriangle(start[i].middle, end[i].middle, end[i].left);
      this->addTriangle(start[i].middle, end[i].left, start[i].left);
    }
    return std::move(this->Made);
  }

private:
  std::size_t add(std::size_t point, double across, const Vec3& left)
  {
    const PathPoint& middle = this->Path[point];
    this->Made.points.push_back({ middle.at + across * middle.halfWidth * left, across, middle.from,
      middle.to, middle.share });
    return this->Made.points.size() - 1;
  }

  // What tapers to nothing has fewer triangles at its end.
  void addTriangle(std::size_t a, std::size_t b, std::size_t c)
  {
    if (a != b && b != c && c != a)
    {
      this->Made.triangles.push_back({ a, b, c });
    }
  }

  Corners straight(std::size_t point, std::size_t middle, const Vec3& left)
  {
    if (this->Path[point].halfWidth == 0.0)
    {
      return { middle, middle, middle };
    }
    const std::size_t onLeft = this->add(point, 1.0, left);
    return { onLeft, middle, this->add(point, -1.0, left) };
  }

  // At the end of one segment and the start of the next.
  void join(std::size_t point, Corners& end, Corners& start)
  {
    const std::size_t count = this->Path.size();
    const Vec3& before = this->Left[point > 0 ? point - 1 : this->Left.size() - 1];
    const Vec3& after = this->Left[point];
    const Vec3& at = this->Path[point].at;
    const Vec3 facing = this->View.facing(at);
    const double cosine = glm::dot(before, after);
    const double sine = glm::dot(glm::cross(before, after), facing);
    const std::size_t middle = this->add(point, 0.0, Vec3(0.0));

    // The mitre is 1 / cos(turn / 2) long and takes tan(turn / 2) off the segments' inner sides.
    const double miterSquared = 2.0 / (1.0 + cosine);
    const double taken = this->Path[point].halfWidth * std::fabs(sine) / (1.0 + cosine);
    const double shorter =
      std::min(this->View.seenLength(at, this->Path[(point + count - 1) % count].at),
        this->View.seenLength(at, this->Path[(point + 1) % count].at));
    if (miterSquared <= miterLimit * miterLimit && taken <= 0.5 * shorter)
    {
      start = this->straight(point, middle, (before + after) / (1.0 + cosine));
      end = start;
      return;
    }
    end = this->straight(point, middle, before);
    start = this->straight(point, middle, after);
    if (this->Path[point].halfWidth == 0.0)
    {
      return;
    }
    const double turn = std::atan2(sine, cosine);
    const bool leftwards = turn > 0.0;
    std::size_t last = leftwards ? end.right : end.left;
    const std::size_t target = leftwards ? start.right : start.left;
    const double steps = std::max(1.0, std::ceil(std::fabs(turn) / roundStep));
    for (double step = 1.0; step <= steps; ++step)
    {
      const double angle = turn * step / steps;
      const Vec3 side = std::cos(angle) * before + std::sin(angle) * glm::cross(facing, before);
      const std::size_t next =
        step == steps ? target : this->add(point, leftwards ? -1.0 : 1.0, side);
      this->addTriangle(middle, leftwards ? last : next, leftwards ? next : last);
      last = next;
    }
  }

  const std::vector<PathPoint>& Path;
  const bool Closed;
  const StrokeView& View;
  const std::vector<Vec3> Left;
  Ribbon Made;
};
}

Strokes makeStrokes(const std::vector<StrokeLine>& lines, const StrokeSettings& settings,
  const StrokeView& view, const RangeLoop& loop)
{
  std::vector<Ribbon> ribbons(lines.size());
  loop(lines.size(), 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      const std::vector<PathPoint> path = strokePath(lines[i], settings, view);
      ribbons[i] = RibbonMaker(path, lines[i].closed, view).make();
    }
  });
  Strokes strokes;
  for (const Ribbon& ribbon : ribbons)
  {
    strokes.firstPoint.push_back(strokes.firstPoint.back() + ribbon.points.size());
    strokes.firstTriangle.push_back(strokes.firstTriangle.back() + ribbon.triangles.size());
  }
  strokes.points.resize(strokes.firstPoint.back());
  strokes.triangles.resize(strokes.firstTriangle.back());
  loop(lines.size(), 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      const std::size_t first = strokes.firstPoint[i];
      std::size_t point = first;
      for (const StrokePoint& from : ribbons[i].points)
      {
        strokes.points[point++] = from;
      }
      std::size_t next = strokes.firstTriangle[i];
      for (const auto& t : ribbons[i].triangles)
      {
        strokes.triangles[next++] = { first + t[0], first + t[1], first + t[2] };
      }
    }
  });
  return strokes;
}
}
