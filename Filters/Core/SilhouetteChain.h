/// The silhouette as the boundary of the lit chain: nodes, pieces between them, multiplicities.
#pragma once

#include "CasterEdges.h"
#include "CubicCurve.h"
#include "IndexSet.h"
#include "SilhouetteSearch.h"

namespace shadow
{
enum class SilhouetteKind
{
  Discrete, ///< edges between lit and dark faces
  Accurate, ///< zero set of the field that is linear on edges
  Smooth    ///< the accurate one, on the smooth surface
};

inline FieldKind fieldKind(SilhouetteKind kind)
{
  return kind == SilhouetteKind::Discrete ? FieldKind::Face : FieldKind::Corner;
}

/// Where the field of one side, or of several with the same normals, changes sign on an edge.
struct Crossing
{
  Index edge;
  Side side;        ///< the first of the sides that cross here
  double parameter; ///< along the edge from a to b
  Vec3 point;       ///< on the smooth surface; the mesh point for an accurate silhouette
  Vec3 normal;      ///< unit normal at point
};

/// Where a crossing is on the mesh itself.
inline Vec3 meshPoint(const TriangleMesh& mesh, const EdgeTable& edges, const Crossing& c)
{
  const Vec3& a = mesh.points[edges.edges[c.edge].a];
  const Vec3& b = mesh.points[edges.edges[c.edge].b];
  return a + c.parameter * (b - a);
}

/// A directed piece of the silhouette between two nodes. Nodes are numbered: first the vertices
/// of the mesh, then the crossings.
struct Piece
{
  Index from;
  Index to;
  Index source;     ///< the triangle that a chord crosses, or the edge of a link
  bool isChord;     ///< crosses a triangle; otherwise runs along an edge
  int multiplicity; ///< at least 1
};

class Caster;

/// Immutable once built; for as long as its caster is there.
struct SilhouetteChain
{
  Light light;
  SilhouetteKind kind = SilhouetteKind::Smooth;
  LightField field;                 ///< of the caster's mesh
  SearchSettings search;            ///< how it was found; never Automatic
  bool complete = true;             ///< known to be all of the silhouette
  std::size_t itemsTested = 0;      ///< triangles and edges that the search looked at
  IndexSet crossedEdges;
  std::vector<Index> firstCrossing; ///< of each crossed edge by its place there, and the end
  std::vector<Crossing> crossings;  ///< of each crossed edge in order of parameter
  std::vector<Piece> pieces;        ///< chords, then links
  std::vector<CubicCurve> curves;   ///< Smooth: the curve of each piece

  /// First and end of the crossings on an edge; empty if it has none.
  std::pair<Index, Index> crossingsOn(Index edge) const
  {
    const Index place = this->crossedEdges.find(edge);
    return place == None
      ? std::pair<Index, Index>{ 0, 0 }
      : std::pair<Index, Index>{ this->firstCrossing[place], this->firstCrossing[place + 1] };
  }

  /// The crossing on an edge that belongs to a side with these normals, or None.
  Index crossingOf(const Caster& caster, Index edge, const SideNormals& normals) const;
};

/// Builds the chain of what a search for the light found; in proportion to that. The same for every
/// loop.
SilhouetteChain buildSilhouetteChain(Caster& caster, const Light& light, SilhouetteKind kind,
  const SearchResult& found, const RangeLoop& loop);
}
