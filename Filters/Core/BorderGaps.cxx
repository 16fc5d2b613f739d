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

/// No point of the box is nearer to the segment.
double leastDistance(const Box& box, const Vec3& a, const Vec3& b)
{
  const Vec3 centre = 0.5 * (box.low + box.high);
  return distance(centre, a, b) - 0.5 * glm::length(box.high - box.low);
}

class GapFinder
{
public:
  GapFinder(const TriangleMesh& mesh, const EdgeTable& edges, double reach)
    : Mesh(mesh)
    , Edges(edges)
    , LargestReach(reach)
    , Reach(mesh.points.size(), reach)
  {
    for (const Edge& edge : edges.edges)
    {
      const double near = nearShare * this->length(edge);
      this->Reach[edge.a] = std::min(this->Reach[edge.a], near);
      this->Reach[edge.b] = std::min(this->Reach[edge.b], near);
    }
    for (std::size_t e = edges.regular; e < edges.edges.size(); ++e)
    {
      if (edges.sideCount(static_cast<Index>(e)) == 1)
      {
        this->Borders.push_back(static_cast<Index>(e));
        this->Vertices.push_back(edges.edges[e].a);
        this->Vertices.push_back(edges.edges[e].b);
      }
    }
    std::sort(this->Vertices.begin(), this->Vertices.end());
    this->Vertices.erase(
      std::unique(this->Vertices.begin(), this->Vertices.end()), this->Vertices.end());
  }

  BorderGaps find(const RangeLoop& loop) const
  {
    std::vector<Box> boxes(this->Vertices.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      boxes[i].add(this->Mesh.points[this->Vertices[i]]);
    }
    const BoxTree tree(boxes);
    std::vector<std::uint8_t> isNear(boxes.size());
    loop(boxes.size(), heavyGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          isNear[i] = this->isNearAnother(tree, this->Vertices[i]);
        }
      });
    std::vector<std::vector<Index>> junctions(this->Borders.size());
    loop(junctions.size(), heavyGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          junctions[i] = this->junctionsAt(tree, this->Borders[i]);
        }
      });
    return this->collect(isNear, junctions);
  }

private:
  const Vec3& place(Index vertex) const { return this->Mesh.points[vertex]; }

  double length(const Edge& edge) const
  {
    return glm::length(this->place(edge.b) - this->place(edge.a));
  }

  bool isNearAnother(const BoxTree& tree, Index vertex) const
  {
    const Vec3& p = this->place(vertex);
    const double near = this->Reach[vertex];
    bool found = false;
    tree.search([&](const Box& box) { return leastDistance(box, p, p) <= near; },
      [&](Index i)
      {
        const Index other = this->Vertices[i];
        const double away = glm::length(this->place(other) - p);
        found = away > 0.0 && away <= std::min(near, this->Reach[other]);
        return !found;
      });
    return found;
  }

  /// As items of the tree.
  std::vector<Index> junctionsAt(const BoxTree& tree, Index border) const
  {
    const Edge& edge = this->Edges.edges[border];
    const Triangle& own =
      this->Mesh.triangles[this->Edges.sides[this->Edges.firstSide(border)] / 3];
    const Vec3& a = this->place(edge.a);
    const Vec3& b = this->place(edge.b);
    const double near = std::min(this->LargestReach, nearShare * this->length(edge));
    std::vector<Index> found;
    tree.search([&](const Box& box) { return leastDistance(box, a, b) <= near; },
      [&](Index i)
      {
        const Index vertex = this->Vertices[i];
        const Vec3& p = this->place(vertex);
        if (std::find(own.begin(), own.end(), vertex) == own.end() &&
          distance(p, a, b) <= std::min(near, this->Reach[vertex]) &&
          glm::length(p - a) > near && glm::length(p - b) > near)
        {
          found.push_back(i);
        }
        return true;
      });
    return found;
  }

  BorderGaps collect(const std::vector<std::uint8_t>& isNear,
    const std::vector<std::vector<Index>>& junctions) const
  {
    std::vector<std::uint8_t> isJunction(this->Vertices.size());
    for (const std::vector<Index>& atEdge : junctions)
    {
      for (const Index i : atEdge)
      {
        isJunction[i] = 1;
      }
    }
    BorderGaps gaps;
    for (std::size_t i = 0; i < this->Vertices.size(); ++i)
    {
      if (isNear[i] != 0)
      {
        gaps.nearSeams.add(this->place(this->Vertices[i]));
      }
      if (isJunction[i] != 0)
      {
        gaps.tJunctions.add(this->place(this->Vertices[i]));
      }
    }
    return gaps;
  }

  const TriangleMesh& Mesh;
  const EdgeTable& Edges;
  const double LargestReach;
  std::vector<double> Reach; ///< of each vertex of the mesh
  std::vector<Index> Borders;
  std::vector<Index> Vertices; ///< of borders, ascending
};
}

BorderGaps findBorderGaps(
  const TriangleMesh& mesh, const EdgeTable& edges, double reach, const RangeLoop& loop)
{
  return GapFinder(mesh, edges, reach).find(loop);
}
}
