#include "BorderGaps.h"

#include "BoxTree.h"

#include <algorithm>

namespace shadow
{
namespace
{
/// The share of an edge from which on what is near to it is another part of the mesh, no gap.
constexpr double nearShare = 0.1;

/// From a segment.
double distance(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 along = b - a;
  const double squared = glm::dot(along, along);
  const double s = squared > 0.0 ? glm::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  return glm::length(p - (a + s * along));
}

bool isWithin(const Vec3& p, const Box& box, double distance)
{
  Box around;
  around.add(p - distance);
  around.add(p + distance);
  return box.meets(around);
}

/// Where border vertices are: any number of them that were not welded are one place.
struct Place
{
  Vec3 point;
  double reach; ///< the least of theirs
  std::size_t vertices;
};

struct BorderSide
{
  std::array<Vec3, 3> corners; ///< of its triangle, from the side's start on
  double reach;
};

class GapFinder
{
public:
  GapFinder(const TriangleMesh& mesh, const EdgeTable& edges, double reach)
  {
    const auto reachAt = [&](const Edge& edge)
    {
      const double length = glm::length(mesh.points[edge.b] - mesh.points[edge.a]);
      return std::min(reach, nearShare * length);
    };
    std::vector<double> vertexReach(mesh.points.size(), reach);
    for (const Edge& edge : edges.edges)
    {
      const double near = reachAt(edge);
      vertexReach[edge.a] = std::min(vertexReach[edge.a], near);
      vertexReach[edge.b] = std::min(vertexReach[edge.b], near);
    }
    std::vector<Index> vertices;
    for (std::size_t i = edges.regular; i < edges.edges.size(); ++i)
    {
      const Index e = static_cast<Index>(i);
      if (edges.sideCount(e) == 1)
      {
        const Side side = edges.sides[edges.firstSide(e)];
        const Triangle& t = mesh.triangles[side / 3];
        const unsigned start = side % 3;
        this->Borders.push_back({ { mesh.points[t[start]], mesh.points[t[next(start)]],
                                    mesh.points[t[next(next(start))]] },
          reachAt(edges.edges[e]) });
        vertices.push_back(edges.edges[e].a);
        vertices.push_back(edges.edges[e].b);
      }
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    std::sort(vertices.begin(), vertices.end(),
      [&](Index l, Index r)
      {
        const Vec3& p = mesh.points[l];
        const Vec3& q = mesh.points[r];
        return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
      });
    for (const Index v : vertices)
    {
      if (this->Places.empty() || this->Places.back().point != mesh.points[v])
      {
        this->Places.push_back({ mesh.points[v], reach, 0 });
      }
      Place& place = this->Places.back();
      place.reach = std::min(place.reach, vertexReach[v]);
      ++place.vertices;
    }
  }

  BorderGaps find(const RangeLoop& loop) const
  {
    std::vector<Box> boxes(this->Places.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      boxes[i].add(this->Places[i].point);
    }
    const BoxTree places(boxes);
    boxes.assign(this->Borders.size(), Box());
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      boxes[i].add(this->Borders[i].corners[0]);
      boxes[i].add(this->Borders[i].corners[1]);
    }
    const BoxTree borders(boxes);
    std::vector<std::uint8_t> isNear(this->Places.size());
    std::vector<std::uint8_t> isJunction(this->Places.size());
    loop(this->Places.size(), heavyGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          isNear[i] = this->isNearAnother(places, this->Places[i]);
          isJunction[i] = this->isJunction(borders, this->Places[i]);
        }
      });
    BorderGaps gaps;
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      const Place& place = this->Places[i];
      const Occurrences here{ place.vertices, place.point };
      gaps.nearSeams.add(isNear[i] != 0 ? here : Occurrences());
      gaps.tJunctions.add(isJunction[i] != 0 ? here : Occurrences());
    }
    return gaps;
  }

private:
  bool isNearAnother(const BoxTree& tree, const Place& place) const
  {
    bool found = false;
    tree.search([&](const Box& box) { return isWithin(place.point, box, place.reach); },
      [&](Index i)
      {
        const Place& other = this->Places[i];
        const double away = glm::length(other.point - place.point);
        found = away > 0.0 && away <= std::min(place.reach, other.reach);
        return !found;
      });
    return found;
  }

  bool isJunction(const BoxTree& tree, const Place& place) const
  {
    const Vec3& p = place.point;
    bool found = false;
    tree.search([&](const Box& box) { return isWithin(p, box, place.reach); },
      [&](Index i)
      {
        const BorderSide& border = this->Borders[i];
        const auto& [a, b, opposite] = border.corners;
        found = glm::length(p - a) > border.reach && glm::length(p - b) > border.reach &&
          p != opposite && distance(p, a, b) <= std::min(place.reach, border.reach);
        return !found;
      });
    return found;
  }

  std::vector<Place> Places;
  std::vector<BorderSide> Borders;
};
}

BorderGaps findBorderGaps(
  const TriangleMesh& mesh, const EdgeTable& edges, double reach, const RangeLoop& loop)
{
  return GapFinder(mesh, edges, reach).find(loop);
}
}
