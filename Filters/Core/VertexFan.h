/// The edges around a vertex that hang together there.
#pragma once

#include "EdgeTable.h"
#include "IndexSet.h"

namespace shadow
{
/// Around a vertex, a fan is what triangles join through edges at that vertex. An edge is in one
/// fan at either end, with all of its sides; a vertex may have several fans. Each triangle enters
/// and leaves its corner, so what is balanced at all vertices is balanced at each fan already.
class VertexFan
{
public:
  VertexFan(const TriangleMesh& mesh, const EdgeTable& edges)
    : Mesh(mesh)
    , Edges(edges)
  {
  }

  /// The edges of the fan that an edge is in at one of its ends, itself first and each once. Valid
  /// until the next call. O(sides of these edges).
  const std::vector<Index>& edgesAround(Index edge, Index vertex);

private:
  enum class End
  {
    Start,  ///< back at the edge where it began
    Border, ///< no further triangle
    Branch  ///< more than two sides
  };

  End turn(Index edge, Index vertex, Side through);
  void collect(Index edge, Index vertex);
  Index across(Index triangle, Index edge, Index vertex) const;

  const TriangleMesh& Mesh;
  const EdgeTable& Edges;
  std::vector<Index> Around;
  IndexSet Collected;
};
}
