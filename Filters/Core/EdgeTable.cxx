#include "EdgeTable.h"

#include <algorithm>

namespace shadow
{
namespace
{
struct HalfEdge
{
  Index upper; ///< the larger of the two ends
  Side side;

  bool operator<(const HalfEdge& o) const
  {
    return this->upper != o.upper ? this->upper < o.upper : this->side < o.side;
  }
};

/// The half edges at each vertex that is their lower end, sorted, and where they begin.
struct SortedHalfEdges
{
  std::vector<Index> start;
  std::vector<HalfEdge> halfEdges;

  explicit SortedHalfEdges(const TriangleMesh& mesh)
    : start(mesh.points.size() + 1, 0)
    , halfEdges(3 * mesh.triangles.size())
  {
    for (const Triangle& t : mesh.triangles)
    {
      for (unsigned k = 0; k < 3; ++k)
      {
        ++this->start[std::min(t[k], t[next(k)]) + 1];
      }
    }
    for (std::size_t v = 1; v < this->start.size(); ++v)
    {
      this->start[v] += this->start[v - 1];
    }
    std::vector<Index> fill(this->start.begin(), this->start.end() - 1);
    for (std::size_t side = 0; side < this->halfEdges.size(); ++side)
    {
      const Triangle& t = mesh.triangles[side / 3];
      const Index from = t[side % 3];
      const Index to = t[next(static_cast<unsigned>(side % 3))];
      this->halfEdges[fill[std::min(from, to)]++] = { std::max(from, to),
        static_cast<Side>(side) };
    }
    for (std::size_t v = 0; v + 1 < this->start.size(); ++v)
    {
      // A handful at most vertices.
      std::sort(this->halfEdges.begin() + this->start[v],
        this->halfEdges.begin() + this->start[v + 1]);
    }
  }
};
}

EdgeDefect edgeDefect(const TriangleMesh& mesh, const EdgeTable& table, Index edge)
{
  const Index sides = table.sideCount(edge);
  return sides == 1               ? EdgeDefect::Border
    : sides > 2                   ? EdgeDefect::NonManifold
    : signSum(mesh, table, edge) != 0 ? EdgeDefect::Inconsistent
                                      : EdgeDefect::None;
}

EdgeTable buildEdgeTable(const TriangleMesh& mesh)
{
  const SortedHalfEdges sorted(mesh);
  const std::vector<HalfEdge>& halfEdges = sorted.halfEdges;
  EdgeTable table;
  table.edges.reserve(halfEdges.size() / 2 + 16);
  table.sides.reserve(halfEdges.size());
  table.triangleEdges.resize(mesh.triangles.size());
  std::vector<Edge> others;
  std::vector<Side> otherSides;
  const auto addEdge = [&](Index lower, Index begin, Index end)
  {
    const Edge edge{ lower, halfEdges[begin].upper };
    const auto runsUp = [&](Index i)
    { return mesh.triangles[halfEdges[i].side / 3][halfEdges[i].side % 3] == lower; };
    if (end - begin == 2 && runsUp(begin) != runsUp(begin + 1))
    {
      const bool first = runsUp(begin);
      table.edges.push_back(edge);
      table.sides.push_back(halfEdges[first ? begin : begin + 1].side);
      table.sides.push_back(halfEdges[first ? begin + 1 : begin].side);
      return;
    }
    others.push_back(edge);
    table.firstOther.push_back(static_cast<Index>(otherSides.size()));
    for (Index i = begin; i < end; ++i)
    {
      otherSides.push_back(halfEdges[i].side);
    }
  };
  for (std::size_t v = 0; v + 1 < sorted.start.size(); ++v)
  {
    for (Index begin = sorted.start[v], end = begin; begin < sorted.start[v + 1]; begin = end)
    {
      while (end < sorted.start[v + 1] && halfEdges[end].upper == halfEdges[begin].upper)
      {
        ++end;
      }
      addEdge(static_cast<Index>(v), begin, end);
    }
  }

  table.regular = table.edges.size();
  for (Index& first : table.firstOther)
  {
    first += static_cast<Index>(2 * table.regular);
  }
  table.edges.insert(table.edges.end(), others.begin(), others.end());
  table.sides.insert(table.sides.end(), otherSides.begin(), otherSides.end());
  table.firstOther.push_back(static_cast<Index>(table.sides.size()));
  for (std::size_t e = 0; e < table.edges.size(); ++e)
  {
    const Index edge = static_cast<Index>(e);
    for (Index i = table.firstSide(edge); i < table.firstSide(edge + 1); ++i)
    {
      table.triangleEdges[table.sides[i] / 3][table.sides[i] % 3] = edge;
    }
  }
  table.edges.shrink_to_fit();
  return table;
}

void reorderRegularEdges(EdgeTable& table, const std::vector<Index>& order)
{
  std::vector<Edge> edges(table.edges.size());
  std::vector<Side> sides(2 * order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    edges[i] = table.edges[order[i]];
    for (std::size_t k = 0; k < 2; ++k)
    {
      const Side side = table.sides[2 * order[i] + k];
      sides[2 * i + k] = side;
      table.triangleEdges[side / 3][side % 3] = static_cast<Index>(i);
    }
  }
  std::copy(table.edges.begin() + static_cast<std::ptrdiff_t>(order.size()), table.edges.end(),
    edges.begin() + static_cast<std::ptrdiff_t>(order.size()));
  std::copy(sides.begin(), sides.end(), table.sides.begin());
  table.edges = std::move(edges);
}
}
