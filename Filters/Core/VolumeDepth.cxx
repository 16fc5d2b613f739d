#include "VolumeDepth.h"

#include <array>

namespace shadow
{
namespace
{
constexpr std::size_t sectorCount = 512;

/// The axis through the light and the caster's centre, and two directions across it.
struct MeridianFrame
{
  Vec3 axis;
  Vec3 x;
  Vec3 y;

  MeridianFrame(const Light& light, const Vec3& centre)
  {
    const Vec3 towardLight = unitOrZero(light.toward(centre));
    this->axis = towardLight == Vec3(0.0) ? Vec3(0.0, 0.0, 1.0) : towardLight;
    const Vec3 other = std::fabs(this->axis.x) < 0.6 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
    this->x = unitOrZero(glm::cross(this->axis, other));
    this->y = glm::cross(this->axis, this->x);
  }
};

/// Counts by sectors of the angle around the axis, as differences from one sector to the next.
class Sectors
{
public:
  /// From one sector on up to, not including, another one; around the end if that comes before.
  void add(std::size_t first, std::size_t end, int count)
  {
    this->Differences[first] += count;
    this->Differences[end] -= count;
    this->AtStart += first > end ? count : 0;
  }

  void addEverywhere(int count) { this->AtStart += count; }

  int greatest() const
  {
    int sum = this->AtStart;
    int most = 0;
    for (std::size_t i = 0; i < sectorCount; ++i)
    {
      sum += this->Differences[i];
      most = std::max(most, sum);
    }
    return most;
  }

private:
  std::array<int, sectorCount> Differences{};
  int AtStart = 0;
};

/// What grows with the angle of (x, y), from 0 to 4 in a turn, without a trigonometric function.
double turn(double x, double y)
{
  const double sum = std::fabs(x) + std::fabs(y);
  const double t = sum > 0.0 ? x / sum : 1.0;
  return y < 0.0 ? 3.0 + t : 1.0 - t;
}

std::size_t sector(double turned)
{
  // What is no number, of coordinates out of range, belongs somewhere, too.
  return turned >= 0.0
    ? std::min(static_cast<std::size_t>(turned * (sectorCount / 4.0)), sectorCount - 1)
    : 0;
}

enum class Sense
{
  Unknown, ///< too close to the axis to tell which way around it is the shorter one
  Forward,
  Backward
};

Sense sense(double from, double to)
{
  constexpr double wholeTurn = 4.0;
  constexpr double surelyShorter = 1.75;
  const double change = to - from;
  const double forward = change < 0.0 ? change + wholeTurn : change;
  return forward <= surelyShorter ? Sense::Forward
    : wholeTurn - forward <= surelyShorter ? Sense::Backward
                                           : Sense::Unknown;
}

/// What runs across the meridians in one and in the other sense.
class MeridianCounts
{
public:
  /// Adds a loop by the angles of its points. A sector in which one segment ends and the next goes
  /// on in the same sense counts once.
  void addLoop(const std::vector<double>& turns, int count)
  {
    Sense before = sense(turns.back(), turns.front());
    for (std::size_t i = 0; i < turns.size(); ++i)
    {
      const double from = turns[i];
      const double to = turns[i + 1 < turns.size() ? i + 1 : 0];
      const Sense now = sense(from, to);
      const bool goesOn = now == before;
      this->addSegment(sector(from), sector(to), now, goesOn, count);
      before = now;
    }
  }

  int greatest() const { return std::max(this->Forward.greatest(), this->Backward.greatest()); }

private:
  void addSegment(std::size_t from, std::size_t to, Sense sense, bool goesOn, int count)
  {
    const auto after = [](std::size_t i) { return i + 1 < sectorCount ? i + 1 : 0; };
    if (sense == Sense::Unknown)
    {
      this->Forward.addEverywhere(count);
      this->Backward.addEverywhere(count);
    }
    else if (sense == Sense::Forward && !(goesOn && from == to))
    {
      this->Forward.add(goesOn ? after(from) : from, after(to), count);
    }
    else if (sense == Sense::Backward && !(goesOn && from == to))
    {
      this->Backward.add(to, goesOn ? from : after(from), count);
    }
  }

  Sectors Forward;
  Sectors Backward;
};

/// Whether a triangle may be hit in a direction from the light; in doubt it is.
bool mayHit(const Vec3& direction, const std::array<Vec3, 3>& rays)
{
  bool anyPositive = false;
  bool anyNegative = false;
  bool anyAhead = false;
  for (unsigned k = 0; k < 3; ++k)
  {
    const double side = glm::dot(direction, glm::cross(rays[k], rays[next(k)]));
    anyPositive = anyPositive || side > 0.0;
    anyNegative = anyNegative || side < 0.0;
    anyAhead = anyAhead || glm::dot(direction, rays[k]) >= 0.0;
  }
  return anyAhead && !(anyPositive && anyNegative);
}

int depthOfCap(const NearEnd& end, const Vec3& direction)
{
  int depth = 0;
  const auto add = [&](const Triangle& t, int multiplicity)
  {
    std::array<Vec3, 3> rays;
    for (unsigned k = 0; k < 3; ++k)
    {
      rays[k] = -end.chain.light.toward(end.place(t[k]));
    }
    depth += mayHit(direction, rays) ? multiplicity : 0;
  };
  if (end.cap)
  {
    end.cap->forEach([&](const Triangle& t) { add(t, 1); });
  }
  for (const VolumeTriangle& t : end.triangles)
  {
    add(t.points, t.multiplicity);
  }
  return depth;
}
}

int greatestDepth(const NearEnd& end)
{
  const Vec3& centre = end.caster.centre();
  const MeridianFrame frame(end.chain.light, centre);
  MeridianCounts counts;
  std::vector<double> turns;
  for (const VolumeRim& rim : end.rims)
  {
    turns.clear();
    for (const Index point : rim.points)
    {
      const Vec3 from = end.place(point) - centre;
      turns.push_back(turn(glm::dot(from, frame.x), glm::dot(from, frame.y)));
    }
    counts.addLoop(turns, rim.multiplicity);
  }
  const int atPole = end.lightIsOutside ? 0 : depthOfCap(end, frame.axis);
  return atPole + counts.greatest();
}
}
