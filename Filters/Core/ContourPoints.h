/// Where the points of contours are.
#pragma once

#include "ContourPieces.h"

namespace shadow
{
/// A point of a contour, and the point of the silhouette that casts it.
struct ContourPoint
{
  Vec3 point;
  Vec3 caster;
};

/// Of one end of a piece, the same for all pieces that join there.
ContourPoint pointAt(const ContourPiece& piece, const ContourEnd& end, const ContourWalls& walls,
  const ContourLoops& loops, const ReceiverView& receiver);
}
