/// The edges of any triangle soup, each with the triangle sides that lie on it.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// One edge with its ends in ascending order.
struct Edge
{
  Index a;
  Index b;
};

/// A side of a triangle, numbered 3 * triangle + corner at which it starts.
using Side = Index;

/// Sorted unique edges with their incident sides, any number of them.
struct EdgeTable
{
  std::vector<Edge> edges;     ///< ascending by (a, b)
  std::vector<Index> firstSide; ///< edges + 1 entries: where an edge's sides begin
  std::vector<Side> sides;     ///< sides of each edge, ascending
  std::vector<Triangle> triangleEdges; ///< edge of each side

  Index sideCount(Index edge) const { return this->firstSide[edge + 1] - this->firstSide[edge]; }
};

/// +1 if the side runs along its edge from a to b, -1 if from b to a.
inline int sideSign(const TriangleMesh& mesh, const EdgeTable& table, Index edge, Side side)
{
  return mesh.triangles[side / 3][side % 3] == table.edges[edge].a ? 1 : -1;
}

/// Sum of the signs of an edge's sides: 0 where they run against each other in pairs.
inline int signSum(const TriangleMesh& mesh, const EdgeTable& table, Index edge)
{
  int sum = 0;
  for (Index i = table.firstSide[edge]; i < table.firstSide[edge + 1]; ++i)
  {
    sum += sideSign(mesh, table, edge, table.sides[i]);
  }
  return sum;
}

/// Sorts by counting: O(triangles + vertices), and a sort among the edges at one vertex.
EdgeTable buildEdgeTable(const TriangleMesh& mesh);
}
