/// A silhouette that comes back as polylines, and whether it is a chain's.
#pragma once

#include "Caster.h"

namespace shadow
{
/// A silhouette as polylines: what a silhouette filter gave.
struct SilhouetteInput
{
  std::vector<Vec3> points;
  std::vector<Vec3> meshPoints;
  std::vector<Index> nodes;       ///< node of each point, None between nodes
  std::vector<Index> loopPoints;  ///< points of the loops, loop after loop, the first not repeated
  std::vector<std::size_t> first; ///< where each loop begins, and the end
  std::vector<int> multiplicity;  ///< of each loop
};

/// A number for a node that is the same however the silhouette was searched for: a vertex's own,
/// and behind these for a crossing that of the first side that crosses there.
Index nodeNumber(const Caster& caster, const SilhouetteChain& chain, Index node);

/// The chain's node of that number, or None.
Index nodeOfNumber(const Caster& caster, const SilhouetteChain& chain, Index number);

/// How much of a chain polylines are.
enum class Match
{
  None, ///< they are another mesh's, or another light's
  Part, ///< some pieces are missing, as an incomplete search may leave them out
  Whole
};

/// Whether the polylines are the silhouette that the chain describes: nodes of it at the same
/// places on the mesh, joined by its pieces.
Match match(const SilhouetteInput& silhouette, const Caster& caster, const SilhouetteChain& chain);

/// A stretch of a loop between two nodes, as places in loopPoints; `end` is the second node's
/// place, which for a loop's last stretch is the loop's first place.
struct Stretch
{
  std::size_t begin;
  std::size_t innerEnd; ///< end of the points between, from begin + 1
  std::size_t end;
};

template <class Visit>
void forEachStretch(const SilhouetteInput& s, std::size_t loop, const Visit& visit)
{
  const std::size_t begin = s.first[loop];
  const std::size_t end = s.first[loop + 1];
  for (std::size_t at = begin; at < end;)
  {
    std::size_t to = at + 1;
    while (to < end && s.nodes[s.loopPoints[to]] == None)
    {
      ++to;
    }
    visit(Stretch{ at, to, to < end ? to : begin });
    at = to;
  }
}
}
