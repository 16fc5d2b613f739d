/// The pieces of cast contours: where a silhouette's wall meets a receiver's triangle.
#pragma once

#include "ContourWalls.h"
#include "EdgeTable.h"
#include "RangeLoop.h"

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

/// A surface that shadows fall on.
struct ContourReceiver
{
  const TriangleMesh* mesh;
  const EdgeTable* edges;
};

/// A receiver as the light sees it.
class ReceiverView
{
public:
  ReceiverView(const ContourReceiver& receiver, const LightFrame& frame, const RangeLoop& loop);

  const TriangleMesh& mesh() const { return *this->Receiver.mesh; }
  const EdgeTable& edges() const { return *this->Receiver.edges; }
  const LightFrame& frame() const { return this->Frame; }
  const Vec3& view(Index vertex) const { return this->Views[vertex]; }
  Vec3 place(Index vertex) const { return this->Frame.place(this->mesh().points[vertex]); }

  /// Triangles that face the light, edge-on ones included.
  const std::vector<Index>& lit() const { return this->Lit; }
  bool isLit(Index triangle) const;

  /// The box of a triangle in a chart.
  Box2 box(std::size_t chart, Index triangle) const;

private:
  ContourReceiver Receiver;
  const LightFrame& Frame;
  std::vector<Vec3> Views;
  std::vector<Box2> Boxes; ///< of each vertex, where there is one chart
  std::vector<Index> Lit;
};

/// All pieces of all segments on what faces the light, beyond the segments: ordered by blocks of
/// triangles, in the same order whatever the number of threads.
std::vector<ContourPiece> findPieces(const ContourWalls& walls, const ReceiverView& receiver,
  const RangeLoop& loop, TreeVisits& visits);

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
