#include "ContourPieces.h"

#include "ExactSum.h"

#include <algorithm>
#include <cassert>
#include <optional>

namespace shadow
{
namespace
{
/// Triangles of a block, for which one search may do.
constexpr std::size_t blockSize = 16;
/// It does where the box around them is this small, compared with their own boxes together.
constexpr float blockShare = 0.75f;
/// Triangles that one thread takes at a time: whole blocks.
constexpr std::size_t chunkSize = 32 * blockSize;

double sumOfSizes(const Vec3& v)
{
  return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z);
}

/// The side of the plane through p, q and r on which s is: 1 on the one from which they turn
/// counter-clockwise, where the light is if it sees them so; 0 if rounding, that of the places
/// included, could have made up the answer.
int sideOfPlane(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, double placeError)
{
  const Vec3 u = p - s;
  const Vec3 v = q - s;
  const Vec3 w = r - s;
  const double value = glm::dot(u, glm::cross(v, w));
  const double sizes[3] = { sumOfSizes(u), sumOfSizes(v), sumOfSizes(w) };
  const double error = determinantError * sizes[0] * sizes[1] * sizes[2] +
    2.0 * placeError * (sizes[0] * sizes[1] + sizes[1] * sizes[2] + sizes[2] * sizes[0]);
  return value > error ? 1 : value < -error ? -1 : 0;
}

/// Where an edge and a segment cross in the light's view: their ends' sides.
struct Crossing
{
  ContourSide x;
  ContourSide y;
  ContourSide a;
  ContourSide b;
};

/// Tests segments against triangles.
class PairTest
{
public:
  PairTest(const ContourWalls& walls, const ReceiverView& receiver)
    : Walls(walls)
    , Receiver(receiver)
  {
  }

  std::optional<ContourPiece> operator()(Index segment, Index triangle) const
  {
    const WallPlane& wall = this->Walls.wall(segment);
    const Triangle& t = this->Receiver.mesh().triangles[triangle];
    if (wall.a == wall.b)
    {
      return this->pieceOfNoWidth(segment, triangle);
    }
    std::array<ContourSide, 3> sides;
    for (std::size_t k = 0; k < 3; ++k)
    {
      sides[k] = sideOfWall(wall, this->Receiver.view(t[k]));
    }
    if (sides[0].sign == sides[1].sign && sides[1].sign == sides[2].sign)
    {
      return std::nullopt;
    }
    Ends ends;
    const int turn = turnOf(
      this->Receiver.view(t[0]), this->Receiver.view(t[1]), this->Receiver.view(t[2]));
    bool holdsStart = turn != 0;
    bool holdsEnd = turn != 0;
    for (unsigned k = 0; k < 3; ++k)
    {
      const ContourSide& from = sides[k];
      const ContourSide& to = sides[next(k)];
      if (from.sign == to.sign)
      {
        continue;
      }
      const Edge edge = this->edge(triangle, k);
      const bool runsUp = t[k] == edge.a;
      const ContourSide& x = runsUp ? from : to;
      const Crossing crossing{ x, runsUp ? to : from, this->side(edge, wall.a),
        this->side(edge, wall.b) };
      const int inner = runsUp ? turn : -turn;
      holdsStart = holdsStart && crossing.a.sign == inner;
      holdsEnd = holdsEnd && crossing.b.sign == inner;
      if (crossing.a.sign == -x.sign && crossing.b.sign == x.sign)
      {
        ends.add({ ContourEndKind::Edge, static_cast<std::uint8_t>(k) }, from.sign > 0,
          this->isBeyond(edge, x.sign, segment));
      }
    }
    this->addVertices(segment, triangle, turn, holdsStart, holdsEnd, ends);
    return ends.piece(segment, triangle);
  }

private:
  /// What is found of a piece's two ends.
  class Ends
  {
  public:
    void add(ContourEnd end, bool isFirst, bool isBeyond)
    {
      const std::size_t place = isFirst ? 0 : 1;
      assert(!this->Found[place]); // the signs are those of an arrangement
      this->Found[place] = true;
      this->Ends_[place] = end;
      this->Beyond[place] = isBeyond;
    }

    std::optional<ContourPiece> piece(Index segment, Index triangle) const
    {
      assert(this->Found[0] == this->Found[1]);
      if (!this->Found[0] || !this->Found[1] || !(this->Beyond[0] || this->Beyond[1]))
      {
        return std::nullopt;
      }
      constexpr ContourEnd pierce{ ContourEndKind::Pierce, 0 };
      return ContourPiece{ segment, triangle, this->Beyond[0] ? this->Ends_[0] : pierce,
        this->Beyond[1] ? this->Ends_[1] : pierce };
    }

  private:
    std::array<bool, 2> Found{};
    std::array<bool, 2> Beyond{};
    std::array<ContourEnd, 2> Ends_{};
  };

  Edge edge(Index triangle, unsigned side) const
  {
    const EdgeTable& table = this->Receiver.edges();
    return table.edges[table.triangleEdges[triangle][side]];
  }

  ContourSide side(const Edge& edge, const Vec3& a) const
  {
    return sideOfEdge(this->Receiver.view(edge.a), this->Receiver.view(edge.b), a);
  }

  /// Of the point where an edge crosses a segment. With the edge's end that is on the wall's
  /// positive side the segment makes a triangle that faces the light; the edge is behind it where
  /// its other end is. A segment of almost no length makes none that can be told from a line:
  /// then all of the edge has to be behind all of the segment.
  bool isBeyond(const Edge& edge, int sideOfFirst, Index segment) const
  {
    const LightFrame& frame = this->Receiver.frame();
    const Vec3& a = this->Walls.place(segment);
    const Vec3& b = this->Walls.place(this->Walls.next(segment));
    const Vec3& x = this->Receiver.place(edge.a);
    const Vec3& y = this->Receiver.place(edge.b);
    const int side = sideOfFirst * sideOfPlane(a, b, x, y, frame.placeError());
    if (side != 0)
    {
      return side < 0;
    }
    const Vec3 onward = frame.onward(a);
    const double edgeBegins = std::min(glm::dot(onward, x), glm::dot(onward, y));
    const double segmentEnds = std::max(glm::dot(onward, a), glm::dot(onward, b));
    return edgeBegins - segmentEnds > 4.0 * frame.placeError() * sumOfSizes(onward);
  }

  /// Of the point where the ray through a silhouette's point meets a triangle.
  bool isBeyond(Index triangle, Index point) const
  {
    const Triangle& t = this->Receiver.mesh().triangles[triangle];
    return sideOfPlane(this->Receiver.place(t[0]), this->Receiver.place(t[1]),
             this->Receiver.place(t[2]), this->Walls.place(point),
             this->Receiver.frame().placeError()) > 0;
  }

  /// On a triangle that turns clockwise a contour runs against its segment.
  void addVertices(Index segment, Index triangle, int turn, bool holdsStart, bool holdsEnd,
    Ends& ends) const
  {
    if (holdsStart)
    {
      ends.add({ ContourEndKind::Start, 0 }, turn > 0, this->isBeyond(triangle, segment));
    }
    if (holdsEnd)
    {
      ends.add({ ContourEndKind::End, 0 }, turn < 0,
        this->isBeyond(triangle, this->Walls.next(segment)));
    }
  }

  /// A segment that the light sees as a point has its pieces where both its neighbours have theirs.
  std::optional<ContourPiece> pieceOfNoWidth(Index segment, Index triangle) const
  {
    const Triangle& t = this->Receiver.mesh().triangles[triangle];
    const int turn = turnOf(
      this->Receiver.view(t[0]), this->Receiver.view(t[1]), this->Receiver.view(t[2]));
    for (unsigned k = 0; k < 3; ++k)
    {
      const Edge edge = this->edge(triangle, k);
      const int inner = t[k] == edge.a ? turn : -turn;
      if (turn == 0 || this->side(edge, this->Walls.wall(segment).a).sign != inner)
      {
        return std::nullopt;
      }
    }
    Ends ends;
    this->addVertices(segment, triangle, turn, true, true, ends);
    return ends.piece(segment, triangle);
  }

  const ContourWalls& Walls;
  const ReceiverView& Receiver;
};

/// Searches for the walls that triangles meet.
class PieceSearch
{
public:
  PieceSearch(const ContourWalls& walls, const ReceiverView& receiver)
    : Walls(walls)
    , Receiver(receiver)
    , Test(walls, receiver)
  {
  }

  /// Of up to blockSize triangles.
  void search(const Index* begin, const Index* end)
  {
    const std::size_t count = static_cast<std::size_t>(end - begin);
    for (std::size_t chart = 0; chart < this->Walls.charts().count(); ++chart)
    {
      Box2 around;
      float sizes = 0.0f;
      std::array<Box2, blockSize>& boxes = this->Boxes[chart];
      for (std::size_t i = 0; i < count; ++i)
      {
        boxes[i] = this->Receiver.box(chart, begin[i]);
        if (!isEmpty(boxes[i]))
        {
          around.add(boxes[i]);
          sizes += boxes[i].size();
        }
      }
      if (isEmpty(around))
      {
        continue;
      }
      if (around.size() <= blockShare * sizes)
      {
        this->Walls.search(chart, around, this->Visits,
          [&](Index segment)
          {
            const Box2& box = this->Walls.box(chart, segment);
            for (std::size_t i = 0; i < count; ++i)
            {
              if (meet(box, boxes[i]))
              {
                this->test(chart, segment, begin[i], i);
              }
            }
          });
        continue;
      }
      for (std::size_t i = 0; i < count; ++i)
      {
        if (!isEmpty(boxes[i]))
        {
          this->Walls.search(chart, boxes[i], this->Visits,
            [&](Index segment) { this->test(chart, segment, begin[i], i); });
        }
      }
    }
  }

  std::vector<ContourPiece> Pieces;
  TreeVisits Visits;

private:
  /// A pair that meets in several charts counts in the first of them.
  void test(std::size_t chart, Index segment, Index triangle, std::size_t inBlock)
  {
    for (std::size_t before = 0; before < chart; ++before)
    {
      if (meet(this->Walls.box(before, segment), this->Boxes[before][inBlock]))
      {
        return;
      }
    }
    if (const std::optional<ContourPiece> piece = this->Test(segment, triangle))
    {
      this->Pieces.push_back(*piece);
    }
  }

  const ContourWalls& Walls;
  const ReceiverView& Receiver;
  PairTest Test;
  std::array<std::array<Box2, blockSize>, 6> Boxes;
};
}

std::vector<ContourPiece> findPieces(const ContourWalls& walls, const ReceiverView& receiver,
  const RangeLoop& loop, TreeVisits& visits)
{
  const std::vector<Index>& lit = receiver.lit();
  const std::size_t chunks = (lit.size() + chunkSize - 1) / chunkSize;
  std::vector<std::vector<ContourPiece>> found(chunks);
  std::vector<TreeVisits> spent(chunks);
  loop(chunks, 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t chunk = begin; chunk < end; ++chunk)
      {
        PieceSearch search(walls, receiver);
        const std::size_t last = std::min(lit.size(), (chunk + 1) * chunkSize);
        for (std::size_t i = chunk * chunkSize; i < last; i += blockSize)
        {
          search.search(lit.data() + i, lit.data() + std::min(last, i + blockSize));
        }
        found[chunk] = std::move(search.Pieces);
        spent[chunk] = search.Visits;
      }
    });
  std::vector<ContourPiece> all;
  for (std::size_t chunk = 0; chunk < chunks; ++chunk)
  {
    all.insert(all.end(), found[chunk].begin(), found[chunk].end());
    visits.add(spent[chunk]);
  }
  return all;
}
}
