/// Following the silhouette from one of its pieces to all that hang together with it.
#pragma once

#include "CasterEdges.h"
#include "SilhouetteSearch.h"
#include "VertexFan.h"

#include <array>

namespace shadow
{
/// What of a corner field's silhouette lies on an edge. The order of the crossings on it, which
/// depends on the kind of silhouette, is not asked for.
struct EdgePieces
{
  int atA = 0; ///< multiplicity of the interval that begins at the edge's first end, from a to b
  int atB = 0; ///< of the one that ends at its second end
  bool severalCrossings = false; ///< so that there are intervals between

  bool any() const { return this->atA != 0 || this->atB != 0 || this->severalCrossings; }
};

/// isLit(n) tells whether corner normal n is lit; crossed(t) is called for each triangle whose side
/// on the edge has a lit and a dark end.
template <class IsLit, class Crossed>
EdgePieces findEdgePieces(
  const SearchedMesh& searched, const IsLit& isLit, Index edge, const Crossed& crossed)
{
  const EdgeTable& edges = searched.edges;
  EdgePieces pieces;
  bool any = false;
  SideNormals crossing{ None, None };
  for (Index i = edges.firstSide(edge); i < edges.firstSide(edge + 1); ++i)
  {
    const Side side = edges.sides[i];
    const Index triangle = side / 3;
    const int sign = sideSign(searched.mesh, edges, edge, side);
    const SideNormals normals = sideNormals(searched.mesh, edges, edge, side);
    const bool litA = isLit(normals.a);
    const bool litB = isLit(normals.b);
    const ChainWeight weight = searched.weights.silhouette(FieldKind::Corner, triangle);
    pieces.atA += sign * weight.of(litA);
    pieces.atB += sign * weight.of(litB);
    if (litA != litB)
    {
      crossed(triangle);
      pieces.severalCrossings = pieces.severalCrossings || (any && !(normals == crossing));
      crossing = normals;
      any = true;
    }
  }
  return pieces;
}

/// Takes whole components of the silhouette's chain, so that all it has taken is closed, on any
/// mesh. Components are told apart at fans (VertexFan), finer than at vertices; all crossings on an
/// edge go together. O(1) on average for each piece, and each triangle around the vertices that
/// pieces along edges touch.
class SilhouetteFollower
{
public:
  SilhouetteFollower(const SearchedMesh& searched, const Light& light, FieldKind kind);

  /// Looks whether the silhouette runs through a triangle or along one of its edges, or along or
  /// across an edge; if so, takes all that hangs together with it.
  bool startAt(Index triangle);
  bool startOn(Index edge);

  /// All that was taken, and how many triangles and edges were looked at, some of them more than
  /// once; of a corner field's edges those that can bear pieces.
  SearchResult result() const;

private:
  struct TakenEdge
  {
    int multiplicity;         ///< of a face field
    bool bears;               ///< pieces, as far as is known without the order of crossings
    std::array<bool, 2> open; ///< ends at which the fan is still to be looked at
  };

  struct Sign
  {
    Index item;
    bool lit;
  };

  bool lit(Index item);
  bool isMixed(Index triangle);
  int multiplicityAt(Index edge, Index vertex);
  bool tryEdge(Index edge);
  Index takeEdge(Index edge);
  Index takeFaceEdge(Index edge, int multiplicity);
  void follow();
  void followChord(Index triangle);
  void followEnds(Index place);
  void followFan(Index edge, Index vertex);

  const SearchedMesh Searched;
  const LightField Field;
  const bool BearsLinks;   ///< whether there can be anything but chords
  std::vector<Sign> Signs; ///< the last ones, each at its item's number modulo the size
  VertexFan Fan;
  IndexSet Triangles;
  IndexSet Edges;
  std::vector<TakenEdge> Taken; ///< what is known of each of Edges
  std::size_t NextTriangle = 0; ///< the first that has not been followed
  std::size_t NextEdge = 0;
  std::size_t Tested = 0;
};
}
