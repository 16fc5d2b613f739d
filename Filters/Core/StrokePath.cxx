#include "StrokePath.h"

#include <cassert>

namespace shadow
{
namespace
{
/// Parts of a line between two random offsets: so many that their curve looks smooth.
constexpr double partsOfWobble = 8.0;
constexpr double mostWobbles = 4096.0;

/// Steele, Lea & Flood 2014: neighbouring numbers become unrelated ones.
std::uint64_t mixed(std::uint64_t value)
{
  value += 0x9E3779B97F4A7C15u;
  value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9u;
  value = (value ^ (value >> 27)) * 0x94D049BB133111EBu;
  return value ^ (value >> 31);
}

/// A smooth random curve over the length of a line, from -1 to 1.
class Unsteadiness
{
public:
  Unsteadiness(const StrokeLine& line, std::uint64_t seed, double length, double step)
    : Key(mixed(mixed(seed) ^ line.number))
  {
    this->Closed = line.closed;
    this->StepLength = std::max(step, length / mostWobbles);
    this->Steps = length / this->StepLength;
    if (this->Closed)
    {
      // A whole number of them, so that its end continues its start.
      this->Steps = std::max(1.0, std::round(this->Steps));
      this->StepLength = length / this->Steps;
    }
  }

  double stepLength() const { return this->StepLength; }

  double at(double length) const
  {
    const double place = length / this->StepLength;
    const double before = std::floor(place);
    const double share = place - before;
    // Between two of them, so never beyond.
    return glm::mix(
      this->number(before), this->number(before + 1.0), share * share * (3.0 - 2.0 * share));
  }

private:
  double number(double index) const
  {
    const double wrapped = this->Closed && index >= this->Steps ? index - this->Steps : index;
    const std::uint64_t bits = mixed(this->Key ^ static_cast<std::uint64_t>(wrapped));
    return static_cast<double>(bits >> 11) * 0x1.0p-52 - 1.0;
  }

  std::uint64_t Key;
  bool Closed;
  double Steps;
  double StepLength;
};

std::vector<PathPoint> lifted(
  const StrokeLine& line, const StrokeSettings& settings, const StrokeView& view)
{
  std::vector<PathPoint> path;
  for (std::size_t i = 0; i < line.points.size(); ++i)
  {
    Vec3 at = line.points[i];
    const double by = settings.lift * settings.width * view.unit(at);
    if (line.normals.empty())
    {
      at += by * unitOrZero(view.eye.toward(at));
    }
    else
    {
      at += by * line.normals[i];
    }
    if (!line.directions.empty())
    {
      at += by * line.directions[i];
    }
    // Not into the eye or behind it.
    at = view.unit(at) > 0.0 ? at : line.points[i];
    path.push_back({ at, 0.0, static_cast<Index>(i), static_cast<Index>(i), 0.0 });
  }
  return path;
}

void overshoot(std::vector<PathPoint>& path, const StrokeSettings& settings, const StrokeView& view)
{
  const auto drawOut = [&](PathPoint& end, const Vec3& before) {
    const double by = settings.overshoot * settings.width * view.unit(end.at);
    const Vec3 at = end.at + by * unitOrZero(end.at - before);
    if (view.unit(at) > 0.0)
    {
      end.at = at;
    }
  };
  const Vec3 start = path.front().at;
  drawOut(path.front(), path[1].at);
  drawOut(path.back(), path.size() == 2 ? start : path[path.size() - 2].at);
}

/// Lengths in widths from the start to each point, and all around if it is closed.
std::vector<double> lengthsTo(const std::vector<PathPoint>& path, bool closed,
  const StrokeSettings& settings, const StrokeView& view)
{
  std::vector<double> lengths{ 0.0 };
  const std::size_t segments = closed ? path.size() : path.size() - 1;
  for (std::size_t i = 0; i < segments; ++i)
  {
    const Vec3& from = path[i].at;
    const Vec3& to = path[(i + 1) % path.size()].at;
    const double unit = 0.5 * settings.width * (view.unit(from) + view.unit(to));
    lengths.push_back(lengths.back() + glm::length(to - from) / unit);
  }
  return lengths;
}

/// Lengths at which the path needs a point of its own, ascending.
std::vector<double> cuts(
  double length, bool closed, const StrokeSettings& settings, const Unsteadiness& unsteadiness)
{
  std::vector<double> at;
  if (settings.wobble > 0.0)
  {
    const double step = unsteadiness.stepLength() / partsOfWobble;
    for (double place = step; place < length; place = step * static_cast<double>(at.size() + 1))
    {
      at.push_back(place);
    }
  }
  if (settings.taper > 0.0 && !closed)
  {
    at.push_back(settings.taper * length);
    at.push_back((1.0 - settings.taper) * length);
    std::sort(at.begin(), at.end());
  }
  return at;
}

/// The path with points at the cuts; `lengths` becomes that of its points, and all around.
std::vector<PathPoint> cutAt(
  const std::vector<double>& cuts, const std::vector<PathPoint>& path, std::vector<double>& lengths)
{
  std::vector<PathPoint> points;
  std::vector<double> places;
  std::size_t cut = 0;
  for (std::size_t i = 0; i + 1 < lengths.size(); ++i)
  {
    const PathPoint& from = path[i];
    const PathPoint& to = path[(i + 1) % path.size()];
    points.push_back(from);
    places.push_back(lengths[i]);
    for (; cut < cuts.size() && cuts[cut] < lengths[i + 1]; ++cut)
    {
      const double share = (cuts[cut] - lengths[i]) / (lengths[i + 1] - lengths[i]);
      const Vec3 at = glm::mix(from.at, to.at, share);
      // By rounding it may be a point that is there.
      if (cuts[cut] > places.back() && at != points.back().at && at != to.at)
      {
        points.push_back({ at, 0.0, from.from, to.from, share });
        places.push_back(cuts[cut]);
      }
    }
  }
  if (path.size() == lengths.size())
  {
    points.push_back(path.back());
  }
  places.push_back(lengths.back());
  lengths = places;
  return points;
}

void makeUnsteady(std::vector<PathPoint>& path, const std::vector<double>& lengths, bool closed,
  const StrokeSettings& settings, const StrokeView& view, const Unsteadiness& unsteadiness)
{
  const std::vector<Vec3> left = leftOfSegments(path, closed, view);
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    const Vec3& after = left[std::min(i, left.size() - 1)];
    const Vec3& before = i > 0 ? left[i - 1] : closed ? left.back() : after;
    const double by = settings.wobble * settings.width * view.unit(path[i].at);
    path[i].at += by * unsteadiness.at(lengths[i]) * unitOr(before + after, after);
  }
}
}

std::vector<Vec3> leftOfSegments(
  const std::vector<PathPoint>& path, bool closed, const StrokeView& view)
{
  const std::size_t segments = closed ? path.size() : path.size() - 1;
  std::vector<Vec3> left(segments);
  for (std::size_t i = 0; i < segments; ++i)
  {
    left[i] = view.left(path[i].at, path[(i + 1) % path.size()].at - path[i].at);
  }
  const auto known =
    std::find_if(left.begin(), left.end(), [](const Vec3& side) { return side != Vec3(0.0); });
  Vec3 last(0.0);
  if (known != left.end())
  {
    last = *known;
  }
  else
  {
    // A line of sight: nothing of it is seen, and any side does.
    const Vec3 sight = view.facing(path[0].at);
    const Vec3 axis = std::fabs(sight.x) < 0.5 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
    last = unitOr(glm::cross(axis, sight), Vec3(0.0, 0.0, 1.0));
  }
  for (Vec3& side : left)
  {
    side = side != Vec3(0.0) ? side : last;
    last = side;
  }
  return left;
}

std::vector<PathPoint> strokePath(
  const StrokeLine& line, const StrokeSettings& settings, const StrokeView& view)
{
  assert(line.points.size() >= 2);
  std::vector<PathPoint> path = lifted(line, settings, view);
  if (!line.closed && settings.overshoot > 0.0)
  {
    overshoot(path, settings, view);
  }
  std::vector<double> lengths = lengthsTo(path, line.closed, settings, view);
  const double length = lengths.back();
  // What is lifted to one place or is beyond all widths has nothing that could be measured.
  const bool isMeasured = length > 0.0 && std::isfinite(length);
  if (isMeasured)
  {
    const Unsteadiness unsteadiness(line, settings.seed, length, settings.wobbleLength);
    path = cutAt(cuts(length, line.closed, settings, unsteadiness), path, lengths);
    if (settings.wobble > 0.0)
    {
      makeUnsteady(path, lengths, line.closed, settings, view, unsteadiness);
    }
  }
  const double widening = isMeasured && !line.closed ? settings.taper * length : 0.0;
  for (std::size_t i = 0; i < path.size(); ++i)
  {
    const double toEnd = std::min(lengths[i], length - lengths[i]);
    const double share = toEnd < widening ? toEnd / widening : 1.0;
    path[i].halfWidth = 0.5 * settings.width * view.unit(path[i].at) * share;
  }
  return path;
}
}
