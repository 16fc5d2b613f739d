#include "PiercedTriangles.h"

#include "BoxTree.h"

#include <algorithm>

namespace shadow
{
namespace
{
/// Which side of the plane of a, b, c the point d is on: 1 if these turn counter-clockwise as seen
/// from it, -1 on the other side, 0 if rounding could have made up the answer. It is exactly 0
/// where d is one of the others.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  const Vec3 u = a - d;
  const Vec3 v = b - d;
  const Vec3 w = c - d;
  const double determinant = u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) +
    u.z * (v.x * w.y - v.y * w.x);
  const double permanent = std::fabs(u.x) * (std::fabs(v.y * w.z) + std::fabs(v.z * w.y)) +
    std::fabs(u.y) * (std::fabs(v.z * w.x) + std::fabs(v.x * w.z)) +
    std::fabs(u.z) * (std::fabs(v.x * w.y) + std::fabs(v.y * w.x));
  constexpr double halfEpsilon = 0.5 * std::numeric_limits<double>::epsilon();
  constexpr double relativeError = (7.0 + 56.0 * halfEpsilon) * halfEpsilon;
  const double error = relativeError * permanent;
  return determinant < -error ? 1 : determinant > error ? -1 : 0;
}

using Corners = std::array<Vec3, 3>;
using Sides = std::array<int, 3>;

/// The sides of a triangle's plane on which the corners of another one are.
Sides sidesOf(const Corners& plane, const Corners& other)
{
  Sides sides;
  for (std::size_t k = 0; k < 3; ++k)
  {
    sides[k] = orientation(plane[0], plane[1], plane[2], other[k]);
  }
  return sides;
}

bool areOnBothSides(const Sides& sides)
{
  return *std::min_element(sides.begin(), sides.end()) < 0 &&
    *std::max_element(sides.begin(), sides.end()) > 0;
}

/// Of corners on both sides, one that is alone on its own.
std::size_t aloneOf(const Sides& sides)
{
  const int side = std::count(sides.begin(), sides.end(), 1) == 1 ? 1 : -1;
  return static_cast<std::size_t>(std::find(sides.begin(), sides.end(), side) - sides.begin());
}

/// The corners from the given one on, in the same or the opposite sense.
Corners from(const Corners& corners, std::size_t first, bool turned)
{
  const Vec3& second = corners[(first + 1) % 3];
  const Vec3& third = corners[(first + 2) % 3];
  return { corners[first], turned ? third : second, turned ? second : third };
}

/// Whether the segments in which two planes' common line lies in two triangles overlap by some
/// length (Guigue & Devillers 2003). The first corner of each is alone on its side of the other's
/// plane, and each plane is turned to have the other's first corner on its positive side.
bool overlap(const Corners& s, const Corners& t)
{
  return orientation(t[0], s[0], t[1], s[1]) > 0 && orientation(t[0], s[2], t[2], s[0]) > 0;
}

/// The middle of that overlap.
Vec3 middleOfOverlap(const Corners& s, const Corners& t)
{
  const auto crossing = [](const Vec3& start, const Vec3& end, const Corners& plane)
  {
    const Vec3 normal = glm::cross(plane[1] - plane[0], plane[2] - plane[0]);
    const double before = glm::dot(normal, start - plane[0]);
    const double behind = glm::dot(normal, end - plane[0]);
    return start + glm::clamp(before / (before - behind), 0.0, 1.0) * (end - start);
  };
  // Two of the four ends are those of the overlap: in order along the line, the middle ones.
  std::array<Vec3, 4> ends{ crossing(s[0], s[1], t), crossing(s[0], s[2], t),
    crossing(t[0], t[1], s), crossing(t[0], t[2], s) };
  const Vec3 along =
    glm::cross(glm::cross(s[1] - s[0], s[2] - s[0]), glm::cross(t[1] - t[0], t[2] - t[0]));
  std::sort(ends.begin(), ends.end(),
    [&](const Vec3& l, const Vec3& r) { return glm::dot(along, l) < glm::dot(along, r); });
  return 0.5 * (ends[1] + ends[2]);
}

/// Whether two triangles pierce each other, and where.
bool pierce(const Corners& s, const Corners& t, Vec3& place)
{
  const Sides ofT = sidesOf(s, t);
  if (!areOnBothSides(ofT))
  {
    return false;
  }
  const Sides ofS = sidesOf(t, s);
  if (!areOnBothSides(ofS))
  {
    return false;
  }
  const std::size_t i = aloneOf(ofS);
  const std::size_t j = aloneOf(ofT);
  const Corners first = from(s, i, ofT[j] < 0);
  const Corners second = from(t, j, ofS[i] < 0);
  if (!overlap(first, second))
  {
    return false;
  }
  place = middleOfOverlap(first, second);
  return true;
}

Box boxAround(const Vec3& p, const Vec3& q)
{
  Box box;
  box.add(p);
  box.add(q);
  return box;
}

/// The triangles of a mesh, with boxes around them that rule out most pairs.
class Pairs
{
public:
  explicit Pairs(const TriangleMesh& mesh)
    : Mesh(mesh)
    , Boxes(mesh.triangles.size())
  {
    for (std::size_t i = 0; i < this->Boxes.size(); ++i)
    {
      for (const Vec3& p : this->corners(i))
      {
        this->Boxes[i].add(p);
      }
    }
  }

  const std::vector<Box>& boxes() const { return this->Boxes; }

  Corners corners(std::size_t i) const
  {
    const Triangle& t = this->Mesh.triangles[i];
    return { this->Mesh.points[t[0]], this->Mesh.points[t[1]], this->Mesh.points[t[2]] };
  }

  bool canPierce(std::size_t i, std::size_t j) const
  {
    if (i == j || !this->Boxes[i].meets(this->Boxes[j]))
    {
      return false;
    }
    const Triangle& s = this->Mesh.triangles[i];
    const Triangle& t = this->Mesh.triangles[j];
    unsigned shared = 0;
    unsigned ofS = 0;
    unsigned ofT = 0;
    for (unsigned k = 0; k < 9; ++k)
    {
      if (s[k / 3] == t[k % 3])
      {
        ++shared;
        ofS = k / 3;
        ofT = k % 3;
      }
    }
    // With a common side they can lie in one plane only, or do not meet elsewhere. What they have
    // in common from a common vertex on ends where it leaves one of them, at the opposite side.
    return shared == 0 ||
      (shared == 1 && (this->sideMeets(i, ofS, j) || this->sideMeets(j, ofT, i)));
  }

private:
  /// Whether the box around the side opposite of a corner meets the box around another triangle.
  bool sideMeets(std::size_t i, unsigned corner, std::size_t j) const
  {
    const Triangle& t = this->Mesh.triangles[i];
    return boxAround(this->Mesh.points[t[next(corner)]], this->Mesh.points[t[next(next(corner))]])
      .meets(this->Boxes[j]);
  }

  const TriangleMesh& Mesh;
  std::vector<Box> Boxes;
};
}

Occurrences findPiercedTriangles(const TriangleMesh& mesh, const RangeLoop& loop)
{
  const std::size_t count = mesh.triangles.size();
  const Pairs pairs(mesh);
  const BoxTree tree(pairs.boxes());
  std::vector<Occurrences> found(count);
  loop(count, heavyGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Box& own = pairs.boxes()[i];
        const Corners corners = pairs.corners(i);
        tree.search([&](const Box& box) { return box.meets(own); },
          [&](Index j)
          {
            Vec3 place;
            if (pairs.canPierce(i, j) && pierce(corners, pairs.corners(j), place))
            {
              found[i].add(place);
            }
            return found[i].count == 0;
          });
      }
    });
  Occurrences all;
  for (const Occurrences& one : found)
  {
    all.add(one);
  }
  return all;
}
}
