/// Which triangles are mixed, and which edges can bear a piece of the silhouette.
#pragma once

#include "ChainWeights.h"
#include "FacingHierarchy.h"

namespace shadow
{
enum class SearchMethod
{
  Automatic,  ///< the hierarchy, except on meshes so small that looking at everything is as fast
  BruteForce, ///< looks at everything
  Hierarchy,  ///< leaves out what a tree of boxes shows to be all lit or all dark
  Tracking,   ///< walks to the silhouette and follows it; may miss loops
  Randomized  ///< looks at a sample and follows what it finds; may miss loops
};

struct SearchSettings
{
  SearchMethod method = SearchMethod::Automatic;
  double sampleFraction = 0.01; ///< Randomized: share of the edges or triangles
  std::uint32_t seed = 1;       ///< Randomized: of the sample

  bool operator==(const SearchSettings& o) const
  {
    return method == o.method && sampleFraction == o.sampleFraction && seed == o.seed;
  }
};

/// What a search found.
struct SearchResult
{
  std::vector<Index> triangles; ///< of a corner field, those with lit and dark corners; ascending
  std::vector<std::uint8_t> litCorners; ///< of each of them, bit k: corner k is lit
  std::vector<Index>
    edges; ///< of a face field the silhouette, of a corner field the links; ascending
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

/// All that a kind of field can make a silhouette of: for faces the regular edges, for corners the
/// triangles and the creases whose pieces cancel unless they are mixed. What is none of that is
/// kept apart and looked at for every light.
struct SearchIndex
{
  FieldKind kind;
  FacingHierarchy items;    ///< regular edges, or triangles
  FacingHierarchy creases;  ///< of a corner field: creaseEdges
  std::vector<Index> creaseEdges; ///< ascending
  std::vector<Index> apart;       ///< edges, ascending

  std::size_t memory() const; ///< bytes
};

SearchIndex buildSearchIndex(
  const SearchedMesh& searched, FieldKind kind, const Ball& ball, const RangeLoop& loop);

/// All there is, with the tree or without; both find the same: every sign is that of the field in
/// double.
SearchResult search(const SearchedMesh& searched, const SearchIndex& index, const Light& light,
  bool useTree, const RangeLoop& loop);

/// The same with an index made for this one time.
inline SearchResult searchAll(
  const SearchedMesh& searched, const Light& light, FieldKind kind, const RangeLoop& loop)
{
  const Ball ball = searched.mesh.ball();
  return search(searched, buildSearchIndex(searched, kind, ball, loop), light, false, loop);
}

/// Whether a corner field's silhouette runs through a triangle. isLit(n) tells whether corner
/// normal n is lit.
template <class IsLit>
bool isMixed(const TriangleMesh& mesh, const IsLit& isLit, Index triangle)
{
  const Triangle& n = mesh.cornerNormals[triangle];
  const bool lit = isLit(n[0]);
  return lit != isLit(n[1]) || lit != isLit(n[2]);
}

/// The bits of a triangle's lit corners, as SearchResult has them.
inline std::uint8_t litCornersOf(const TriangleMesh& mesh, const LightField& field, Index triangle)
{
  const Triangle& n = mesh.cornerNormals[triangle];
  return static_cast<std::uint8_t>((field.lit(n[0]) ? 1 : 0) | (field.lit(n[1]) ? 2 : 0) |
    (field.lit(n[2]) ? 4 : 0));
}

/// How often an edge counts, from a to b, in the boundary of the chain of whole faces. isLit(t)
/// tells whether triangle t is lit.
template <class IsLit>
int faceMultiplicity(const SearchedMesh& searched, const IsLit& isLit, Index edge)
{
  int sum = 0;
  for (Index i = searched.edges.firstSide(edge); i < searched.edges.firstSide(edge + 1); ++i)
  {
    const Side side = searched.edges.sides[i];
    sum += sideSign(searched.mesh, searched.edges, edge, side) *
      searched.weights.face(side / 3).of(isLit(side / 3));
  }
  return sum;
}
}
