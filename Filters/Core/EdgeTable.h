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

/// Unique edges with their incident sides, any number of them.
///
/// Regular edges are those with two sides that run against each other; the first one then runs from
/// a to b. They come first.
struct EdgeTable
{
  std::vector<Edge> edges;
  std::vector<Side> sides;             ///< edge after edge
  std::vector<Triangle> triangleEdges; ///< edge of each side
  std::size_t regular = 0;             ///< how many edges are regular
  std::vector<Index> firstOther;       ///< where each other edge's sides begin, and the end

  bool isRegular(Index edge) const { return edge < this->regular; }

  /// Where an edge's sides begin; those of the edge before end there.
  Index firstSide(Index edge) const
  {
    return edge <= this->regular ? 2 * edge : this->firstOther[edge - this->regular];
  }

  Index sideCount(Index edge) const { return this->firstSide(edge + 1) - this->firstSide(edge); }
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
  for (Index i = table.firstSide(edge); i < table.firstSide(edge + 1); ++i)
  {
    sum += sideSign(mesh, table, edge, table.sides[i]);
  }
  return sum;
}

/// What is wrong with an edge.
enum class EdgeDefect
{
  None,
  Border,      ///< one side
  NonManifold, ///< more than two sides
  Inconsistent ///< two sides that run in the same direction
};

EdgeDefect edgeDefect(const TriangleMesh& mesh, const EdgeTable& table, Index edge);

/// Regular and other edges each ascending by (a, b), the sides of the others ascending. Sorts by
/// counting: O(triangles + vertices), and a sort among the edges at one vertex.
EdgeTable buildEdgeTable(const TriangleMesh& mesh);

/// Puts the regular edges into another order: order[i] is the present number of the new edge i.
void reorderRegularEdges(EdgeTable& table, const std::vector<Index>& order);
}
