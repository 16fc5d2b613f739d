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
  void add(std::size_t first, std::size_t last, int count)
  {
    this->Differences[first] += count;
    this->Differences[last + 1] -= count;
  }

  int greatest() const
  {
    int most = 0;
    int sum = 0;
    for (const int difference : this->Differences)
    {
      sum += difference;
      most = std::max(most, sum);
    }
    return most;
  }

private:
  std::array<int, sectorCount + 1> Differences{};
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
  return std::min(static_cast<std::size_t>(turned * (sectorCount / 4.0)), sectorCount - 1);
}

/// Adds a segment to the sectors that it passes, by the shorter way around the axis; one that
/// comes too close to the axis to tell the way goes to all, in both senses.
void addSegment(double from, double to, int count, Sectors& forward, Sectors& backward)
{
  constexpr double halfTurn = 2.0;
  constexpr double surelyShorter = 1.75;
  const double change = to - from;
  const bool acrossStart = std::fabs(change) > halfTurn;
  const double way = acrossStart ? 2.0 * halfTurn - std::fabs(change) : std::fabs(change);
  if (way > surelyShorter)
  {
    forward.add(0, sectorCount - 1, count);
    backward.add(0, sectorCount - 1, count);
    return;
  }
  Sectors& sectors = (change > 0.0) != acrossStart ? forward : backward;
  const std::size_t low = sector(std::min(from, to));
  const std::size_t high = sector(std::max(from, to));
  if (acrossStart)
  {
    sectors.add(0, low, count);
    sectors.add(high, sectorCount - 1, count);
  }
  else
  {
    sectors.add(low, high, count);
  }
}

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

int depthOfCap(const ShadowVolume& volume, const Light& light, const Vec3& direction)
{
  int depth = 0;
  for (const VolumeTriangle& t : volume.triangles)
  {
    if (t.part != VolumePart::Cap && t.part != VolumePart::Gap)
    {
      continue;
    }
    std::array<Vec3, 3> rays;
    for (unsigned k = 0; k < 3; ++k)
    {
      rays[k] = -light.toward(Vec3(volume.points[t.points[k]]));
    }
    depth += mayHit(direction, rays) ? t.multiplicity : 0;
  }
  return depth;
}
}

int greatestDepth(const SilhouetteInput& silhouette, const Light& light, const Vec3& centre,
  bool lightIsOutside, const ShadowVolume& volume)
{
  const MeridianFrame frame(light, centre);
  std::vector<double> turns(silhouette.points.size());
  for (std::size_t i = 0; i < turns.size(); ++i)
  {
    const Vec3 from = silhouette.points[i] - centre;
    turns[i] = turn(glm::dot(from, frame.x), glm::dot(from, frame.y));
  }
  Sectors forward;
  Sectors backward;
  for (std::size_t loop = 0; loop < silhouette.multiplicity.size(); ++loop)
  {
    const std::size_t begin = silhouette.first[loop];
    const std::size_t end = silhouette.first[loop + 1];
    for (std::size_t i = begin; i < end; ++i)
    {
      const Index p = silhouette.loopPoints[i];
      const Index q = silhouette.loopPoints[i + 1 < end ? i + 1 : begin];
      addSegment(turns[p], turns[q], silhouette.multiplicity[loop], forward, backward);
    }
  }
  const int atPole = lightIsOutside ? 0 : depthOfCap(volume, light, frame.axis);
  return atPole + std::max(forward.greatest(), backward.greatest());
}
}
