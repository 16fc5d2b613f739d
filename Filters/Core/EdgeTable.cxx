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
}

EdgeTable buildEdgeTable(const TriangleMesh& mesh)
{
  const std::size_t triangleCount = mesh.triangles.size();
  std::vector<Index> start(mesh.points.size() + 1, 0);
  for (const Triangle& t : mesh.triangles)
  {
    for (unsigned k = 0; k < 3; ++k)
    {
      ++start[std::min(t[k], t[next(k)]) + 1];
    }
  }
  for (std::size_t v = 1; v < start.size(); ++v)
  {
    start[v] += start[v - 1];
  }
  std::vector<HalfEdge> halfEdges(3 * triangleCount);
  std::vector<Index> fill(start.begin(), start.end() - 1);
  for (std::size_t t = 0; t < triangleCount; ++t)
  {
    for (unsigned k = 0; k < 3; ++k)
    {
      const Index from = mesh.triangles[t][k];
      const Index to = mesh.triangles[t][next(k)];
      halfEdges[fill[std::min(from, to)]++] = { std::max(from, to),
        static_cast<Side>(3 * t + k) };
    }
  }

  EdgeTable table;
  table.edges.reserve(triangleCount + triangleCount / 2 + 16);
  table.firstSide.reserve(table.edges.capacity() + 1);
  table.sides.reserve(halfEdges.size());
  table.triangleEdges.resize(triangleCount);
  for (std::size_t v = 0; v + 1 < start.size(); ++v)
  {
    std::sort(halfEdges.begin() + start[v], halfEdges.begin() + start[v + 1]);
    for (Index i = start[v]; i < start[v + 1]; ++i)
    {
      const HalfEdge& h = halfEdges[i];
      if (i == start[v] || h.upper != halfEdges[i - 1].upper)
      {
        table.firstSide.push_back(static_cast<Index>(table.sides.size()));
        table.edges.push_back({ static_cast<Index>(v), h.upper });
      }
      table.sides.push_back(h.side);
      table.triangleEdges[h.side / 3][h.side % 3] = static_cast<Index>(table.edges.size() - 1);
    }
  }
  table.firstSide.push_back(static_cast<Index>(table.sides.size()));
  return table;
}
}
