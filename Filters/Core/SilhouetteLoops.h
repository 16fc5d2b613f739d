/// The silhouette's pieces joined into closed loops.
#pragma once

#include "SilhouetteChain.h"

namespace shadow
{
/// Loops that visit no node twice and together count each piece with its multiplicity.
struct SilhouetteLoops
{
  std::vector<Index> pieces;        ///< the loops' pieces, loop after loop
  std::vector<std::size_t> first;   ///< where each loop begins, and the end
  std::vector<int> multiplicity;    ///< of each loop
  bool balanced = true;             ///< as many pieces enter each node as leave it

  std::size_t count() const { return this->multiplicity.size(); }
};

/// Decomposes the chain, which as a boundary has none itself, so that every walk along it comes
/// back. The nodes below vertexCount are vertices, few of which are used; those from there on are
/// crossings, all of which are. O(n) on average in the number of pieces.
SilhouetteLoops traceLoops(const std::vector<Piece>& pieces, std::size_t vertexCount);
}
