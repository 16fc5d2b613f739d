/// The contour where the surface is concave along the light's rays.
#pragma once

#include "Caster.h"

namespace shadow
{
/// A chord in whose triangle the surface bends towards the light, from lit in front of the contour
/// to dark behind it as seen along the ray.
struct ConcaveChord
{
  Index from;
  Index to;
  Index triangle;
  bool turnedAway; ///< the flat triangle faces away from the light, though its lit corners do not
};

/// The concave chords of a corner field's silhouette. In front of such a contour the surface lies
/// in its own shadow: no light passes there, so none of it is seen as a shadow's edge.
class ConcaveContour
{
public:
  /// In proportion to the chain.
  ConcaveContour(const Caster& caster, const SilhouetteChain& chain);

  /// The concave chord between two nodes, or null.
  const ConcaveChord* find(Index from, Index to) const;

  /// Whether a concave chord ends at the node.
  bool isEnd(Index node) const
  {
    return node >= this->VertexCount && this->Ends[node - this->VertexCount];
  }

private:
  std::size_t VertexCount;
  std::vector<ConcaveChord> Chords;
  std::vector<bool> Ends;   ///< whether a concave chord ends at each crossing
  std::vector<Index> First; ///< of each crossing, the first of the chords that leave it
  std::vector<Index> Next;  ///< of each chord, the next one that leaves the same crossing
};
}
