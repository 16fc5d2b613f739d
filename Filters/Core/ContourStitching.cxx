#include "ContourStitching.h"

#include <numeric>

namespace shadow
{
namespace
{
/// An end of a piece.
struct Joint
{
  Index place; ///< the edge, or the triangle, that it is at
  Index piece;
  bool arrives; ///< the piece ends here, or else begins

  bool operator<(const Joint& o) const
  {
    return this->place != o.place ? this->place < o.place
      : this->arrives != o.arrives ? this->arrives
                                   : this->piece < o.piece; // those that arrive come first
  }
};

/// Ends in buckets: one for each segment, of the crossings with edges, and one for each point of
/// silhouettes, of the meetings of its ray with triangles.
class Buckets
{
public:
  Buckets(const std::vector<ContourPiece>& pieces, const ContourWalls& walls,
    const ReceiverView& receiver)
    : Start(2 * walls.pointCount() + 1, 0)
  {
    const auto forEachJoint = [&](const auto& visit)
    {
      for (std::size_t i = 0; i < pieces.size(); ++i)
      {
        const ContourPiece& piece = pieces[i];
        for (const bool arrives : { false, true })
        {
          const ContourEnd& end = arrives ? piece.to : piece.from;
          const bool isEdge = end.kind == ContourEndKind::Edge;
          if (end.kind == ContourEndKind::Pierce)
          {
            continue;
          }
          const std::size_t point =
            end.kind == ContourEndKind::End ? walls.next(piece.segment) : piece.segment;
          visit(isEdge ? point : walls.pointCount() + point,
            Joint{ isEdge ? receiver.edges().triangleEdges[piece.triangle][end.side]
                          : piece.triangle,
              static_cast<Index>(i), arrives });
        }
      }
    };
    forEachJoint([&](std::size_t bucket, const Joint&) { ++this->Start[bucket + 1]; });
    std::partial_sum(this->Start.begin(), this->Start.end(), this->Start.begin());
    this->Joints.resize(this->Start.back());
    std::vector<std::size_t> next = this->Start;
    forEachJoint([&](std::size_t bucket, const Joint& joint)
      { this->Joints[next[bucket]++] = joint; });
    for (std::size_t bucket = 0; bucket + 1 < this->Start.size(); ++bucket)
    {
      std::sort(this->at(this->Start[bucket]), this->at(this->Start[bucket + 1]));
    }
  }

  /// Calls visit(begin, end) for each group of ends at one place, arriving ones first.
  template <class Visit>
  void forEachGroup(const Visit& visit) const
  {
    for (std::size_t bucket = 0; bucket + 1 < this->Start.size(); ++bucket)
    {
      const std::size_t end = this->Start[bucket + 1];
      for (std::size_t i = this->Start[bucket]; i < end;)
      {
        std::size_t to = i + 1;
        while (to < end && this->Joints[to].place == this->Joints[i].place)
        {
          ++to;
        }
        visit(this->Joints.data() + i, this->Joints.data() + to);
        i = to;
      }
    }
  }

private:
  std::vector<Joint>::iterator at(std::size_t i)
  {
    return this->Joints.begin() + static_cast<std::ptrdiff_t>(i);
  }

  std::vector<std::size_t> Start;
  std::vector<Joint> Joints;
};

/// Whether another piece must join at an end.
bool mustJoin(const ContourPiece& piece, const ContourEnd& end, const ContourWalls& walls,
  const ReceiverView& receiver)
{
  if (end.kind == ContourEndKind::Edge)
  {
    const EdgeTable& table = receiver.edges();
    const Index edge = table.triangleEdges[piece.triangle][end.side];
    return table.isRegular(edge) && receiver.isLit(table.sides[table.firstSide(edge)] / 3) &&
      receiver.isLit(table.sides[table.firstSide(edge) + 1] / 3);
  }
  if (end.kind == ContourEndKind::End)
  {
    return walls.hasSegment(walls.next(piece.segment));
  }
  return end.kind == ContourEndKind::Start && walls.isEnd(piece.segment);
}
}

ContourChains joinPieces(const std::vector<ContourPiece>& pieces, const ContourWalls& walls,
  const ReceiverView& receiver)
{
  std::vector<Index> after(pieces.size(), None);
  std::vector<bool> hasBefore(pieces.size(), false);
  Buckets(pieces, walls, receiver)
    .forEachGroup(
      [&](const Joint* begin, const Joint* end)
      {
        const Joint* arriving = begin;
        const Joint* const lastArriving =
          std::find_if(begin, end, [](const Joint& joint) { return !joint.arrives; });
        for (const Joint* leaving = lastArriving; arriving != lastArriving && leaving != end;
             ++arriving, ++leaving)
        {
          after[arriving->piece] = leaving->piece;
          hasBefore[leaving->piece] = true;
        }
      });

  ContourChains chains;
  chains.pieces.reserve(pieces.size());
  std::vector<bool> taken(pieces.size(), false);
  const auto follow = [&](Index start)
  {
    Index piece = start;
    do
    {
      taken[piece] = true;
      chains.pieces.push_back(piece);
      piece = after[piece];
    } while (piece != None && piece != start);
    chains.first.push_back(chains.pieces.size());
    chains.closed.push_back(piece == start);
  };
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    chains.loose += after[i] == None && mustJoin(pieces[i], pieces[i].to, walls, receiver);
    chains.loose += !hasBefore[i] && mustJoin(pieces[i], pieces[i].from, walls, receiver);
    if (!hasBefore[i])
    {
      follow(static_cast<Index>(i));
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    if (!taken[i])
    {
      follow(static_cast<Index>(i));
    }
  }
  return chains;
}
}
