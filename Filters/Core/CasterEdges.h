/// What an edge is to the silhouette: its normals, its kind, and whether pieces of it can remain.
#pragma once

#include "ChainWeights.h"

namespace shadow
{
/// Numbers of the corner normals that one side of an edge has at the edge's ends.
struct SideNormals
{
  Index a;
  Index b;

  bool operator==(const SideNormals& o) const { return this->a == o.a && this->b == o.b; }
};

inline SideNormals sideNormals(
  const TriangleMesh& mesh, const EdgeTable& edges, Index edge, Side side)
{
  const Triangle& normals = mesh.cornerNormals[side / 3];
  const SideNormals along{ normals[side % 3], normals[next(side % 3)] };
  return sideSign(mesh, edges, edge, side) > 0 ? along : SideNormals{ along.b, along.a };
}

/// The distinct normals of an edge's sides, in order of the sides.
std::vector<SideNormals> distinctNormals(
  const TriangleMesh& mesh, const EdgeTable& edges, Index edge);

enum class EdgeKind : std::uint8_t
{
  Plain,  ///< two sides that run against each other and share their normals
  Crease, ///< several sides with different normals
  Border  ///< one side, or sides that do not run against each other in pairs
};

EdgeKind edgeKind(const TriangleMesh& mesh, const EdgeTable& edges, Index edge);

/// The kind of each edge; empty if all are plain.
std::vector<EdgeKind> findEdgeKinds(const TriangleMesh& mesh, const EdgeTable& edges);

/// The weights of an edge's sides, each with its sign: how often, from a to b, the edge is in the
/// silhouette where all at it is lit, and where all is dark. On a plain edge both are 0.
ChainWeight sumOfSides(const TriangleMesh& mesh, const EdgeTable& edges,
  const ChainWeights& weights, FieldKind kind, Index edge);

/// Counts for the user of what the edges tell about the mesh.
struct EdgeDefects
{
  std::size_t boundary = 0;     ///< edges with one side
  std::size_t nonManifold = 0;  ///< edges with more than two sides
  std::size_t inconsistent = 0; ///< edges with two sides that run in the same direction
};

EdgeDefects countEdgeDefects(const TriangleMesh& mesh, const EdgeTable& edges);

/// The edges on which pieces of a corner field's silhouette can lie. On all others the pieces of
/// the two sides cancel for every light. Takes what findEdgeKinds gives.
std::vector<Index> findLinkEdges(const TriangleMesh& mesh, const EdgeTable& edges,
  const ChainWeights& weights, const std::vector<EdgeKind>& kinds);
}
