/// Pieces of contours joined where they end at the same.
#pragma once

#include "ContourPieces.h"

namespace shadow
{
/// Pieces in chains, each in the order and the direction in which its contour runs.
struct ContourChains
{
  std::vector<Index> pieces;
  std::vector<std::size_t> first{ 0 }; ///< where each chain begins, and the end
  std::vector<bool> closed;            ///< of each chain
  /// Ends of pieces that end where another one had to begin: always 0 on receivers whose
  /// triangles are all consistently wound.
  std::size_t loose = 0;

  std::size_t count() const { return this->closed.size(); }
};

/// At an edge of two triangles that face the light, and at a silhouette's point, one piece
/// arrives and one leaves. A chain that is not closed ends at other edges, where the silhouette
/// ends, or where it pierces the receiver. O(pieces).
ContourChains joinPieces(const std::vector<ContourPiece>& pieces, const ContourWalls& walls,
  const ReceiverView& receiver);
}
