/// The pieces of cast contours: where a silhouette's wall meets a receiver's triangle.
#pragma once

#include "ContourWalls.h"
#include "ReceiverView.h"

namespace shadow
{
/// What a piece ends at. Pieces join where they end at the same.
enum class ContourEndKind : std::uint8_t
{
  Edge,  ///< the wall crosses an edge of the receiver
  Start, ///< the ray through the segment's start meets the triangle
  End,   ///< that through its end
  Pierce ///< the segment itself pierces the triangle: beyond it there is no wall
};

struct ContourEnd
{
  ContourEndKind kind;
  std::uint8_t side; ///< of the triangle, where it is an edge
};

/// Of one segment on one triangle. Seen from the light the shadow is on the left.
struct ContourPiece
{
  Index segment;
  Index triangle;
  ContourEnd from;
  ContourEnd to;
};

/// All pieces of all segments on what faces the light, beyond the segments: ordered by blocks of
/// triangles, in the same order whatever the number of threads.
std::vector<ContourPiece> findPieces(const ContourWalls& walls, const ReceiverView& receiver,
  const RangeLoop& loop, TreeVisits& visits);
}
