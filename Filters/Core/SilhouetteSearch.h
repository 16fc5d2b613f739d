/// Which triangles are mixed, and which edges can bear a piece of the silhouette.
#pragma once

#include "ChainWeights.h"
#include "FacingItems.h"
#include "RangeLoop.h"

namespace shadow
{
enum class SearchMethod
{
  Automatic,  ///< the hierarchy for large meshes whose light moves, else brute force
  BruteForce, ///< looks at everything
  Hierarchy   ///< leaves out what a tree of boxes shows to be all lit or all dark
};

/// What a search found: the same for every method, up to edges on which all pieces cancel.
struct SearchResult
{
  std::vector<Index> triangles; ///< of a corner field, those with lit and dark corners; ascending
  std::vector<Index> edges; ///< of a face field the silhouette, of a corner field the links; ascending
  std::vector<int> multiplicities; ///< of a face field, of each edge from a to b
  std::size_t tested = 0;   ///< triangles and edges that were looked at
};

/// The mesh that is searched, with what belongs to it.
struct SearchedMesh
{
  const TriangleMesh& mesh;
  const EdgeTable& edges;
  const ChainWeights& weights;
  const std::vector<Index>& linkEdges;
};

/// Looks at all triangles or edges. O(triangles).
SearchResult searchAll(
  const SearchedMesh& searched, const Light& light, FieldKind kind, const RangeLoop& loop);

/// A hierarchy over all that a kind of field can make a silhouette of, and what it does not hold.
struct SearchTree
{
  FacingHierarchy hierarchy;
  std::vector<Index> apart; ///< edges to look at for every light

  std::size_t memory() const
  {
    return this->hierarchy.memory() + this->apart.capacity() * sizeof(Index);
  }
};

SearchTree buildSearchTree(const SearchedMesh& searched, FieldKind kind, const Vec3& centre,
  double radius, const RangeLoop& loop);

/// Looks at what the tree cannot leave out, and decides that with the very values that searchAll
/// has. In proportion to the silhouette, and to the edges apart.
SearchResult searchTree(const SearchedMesh& searched, const SearchTree& tree, const Light& light,
  FieldKind kind, const RangeLoop& loop);

/// How often an edge counts, from a to b, in the boundary of the chain of whole faces. isLit(t)
/// tells whether triangle t is lit.
template <class IsLit>
int faceMultiplicity(const SearchedMesh& searched, const IsLit& isLit, Index edge)
{
  int sum = 0;
  for (Index i = searched.edges.firstSide[edge]; i < searched.edges.firstSide[edge + 1]; ++i)
  {
    const Side side = searched.edges.sides[i];
    sum += sideSign(searched.mesh, searched.edges, edge, side) *
      searched.weights.silhouette(FieldKind::Face, side / 3).of(isLit(side / 3));
  }
  return sum;
}
}
