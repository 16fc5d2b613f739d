/// Chains of pieces as polylines.
#pragma once

#include "CastContour.h"
#include "ContourPoints.h"

namespace shadow
{
/// The hidden parts of pieces, each from one share of the piece's length to another one, ascending
/// and apart. Nothing is hidden where this is empty.
struct HiddenSpans
{
  std::vector<std::size_t> first; ///< where those of each piece begin, and the end
  std::vector<std::array<double, 2>> spans;
  /// Parts of lines that are hidden or visible for less than this length count as what is around
  /// them.
  double least = 0.0;

  std::size_t begin(std::size_t piece) const
  {
    return this->first.empty() ? 0 : this->first[piece];
  }
  std::size_t end(std::size_t piece) const
  {
    return this->first.empty() ? 0 : this->first[piece + 1];
  }
};

/// A piece as a straight line.
struct PieceLine
{
  ContourPoint from;
  ContourPoint to;
};

std::vector<PieceLine> pieceLines(const std::vector<ContourPiece>& pieces,
  const ContourWalls& walls, const ContourLoops& loops, const ReceiverView& receiver,
  const RangeLoop& loop);

/// Appends the chains to the lines, cut where they become hidden or visible; what is hidden is left
/// out unless it is kept.
void appendLines(const ContourChains& chains, const std::vector<ContourPiece>& pieces,
  const std::vector<PieceLine>& straight, const HiddenSpans& hidden, const ContourWalls& walls,
  const ReceiverView& receiver, Index receiverNumber, bool keepHidden,
  CastContours& lines);
}
