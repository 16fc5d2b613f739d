#include "ContourPoints.h"

#include "ExactSum.h"

namespace shadow
{
namespace
{
/// Where something crosses from one side to the other, as a share of the way, by values of opposite
/// signs or one of them zero.
double shareOf(double from, double to)
{
  const double sum = std::fabs(from) + std::fabs(to);
  return sum > 0.0 ? std::fabs(from) / sum : 0.5;
}

ContourPoint crossingPoint(const Edge& edge, Index segment, const ContourWalls& walls,
  const ContourLoops& loops, const ReceiverView& receiver)
{
  const WallPlane& wall = walls.wall(segment);
  const Vec3& x = receiver.view(edge.a);
  const Vec3& y = receiver.view(edge.b);
  const double onEdge = shareOf(sideOfWall(wall, x).value, sideOfWall(wall, y).value);
  const double onSegment =
    shareOf(sideOfEdge(x, y, wall.a).value, sideOfEdge(x, y, wall.b).value);
  const std::vector<Vec3>& points = receiver.mesh().points;
  return { glm::mix(points[edge.a], points[edge.b], onEdge),
    glm::mix(loops.points[segment], loops.points[walls.next(segment)], onSegment) };
}

ContourPoint vertexPoint(Index triangle, Index point, const Vec3& view,
  const ContourLoops& loops, const ReceiverView& receiver)
{
  const Triangle& t = receiver.mesh().triangles[triangle];
  std::array<double, 3> weights;
  double sum = 0.0;
  for (unsigned k = 0; k < 3; ++k)
  {
    weights[k] = std::fabs(
      determinant(receiver.view(t[next(k)]), receiver.view(t[next(next(k))]), view));
    sum += weights[k];
  }
  Vec3 place(0.0);
  for (unsigned k = 0; k < 3; ++k)
  {
    place += (sum > 0.0 ? weights[k] / sum : 1.0 / 3.0) * receiver.mesh().points[t[k]];
  }
  return { place, loops.points[point] };
}

/// Where the segment meets the triangle's plane, between the two ends that the piece would have.
ContourPoint piercePoint(const ContourPiece& piece, const ContourWalls& walls,
  const ContourLoops& loops, const ReceiverView& receiver)
{
  const Triangle& t = receiver.mesh().triangles[piece.triangle];
  const std::vector<Vec3>& points = receiver.mesh().points;
  const Vec3 normal =
    glm::cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
  const Vec3& a = loops.points[piece.segment];
  const Vec3& b = loops.points[walls.next(piece.segment)];
  const double before = glm::dot(normal, a - points[t[0]]);
  const double behind = glm::dot(normal, b - points[t[0]]);
  const double share =
    before != behind ? std::clamp(before / (before - behind), 0.0, 1.0) : 0.5;
  const Vec3 at = glm::mix(a, b, share);
  return { at, at };
}
}

ContourPoint pointAt(const ContourPiece& piece, const ContourEnd& end, const ContourWalls& walls,
  const ContourLoops& loops, const ReceiverView& receiver)
{
  const EdgeTable& edges = receiver.edges();
  switch (end.kind)
  {
    case ContourEndKind::Edge:
      return crossingPoint(edges.edges[edges.triangleEdges[piece.triangle][end.side]],
        piece.segment, walls, loops, receiver);
    case ContourEndKind::Start:
      return vertexPoint(
        piece.triangle, piece.segment, walls.wall(piece.segment).a, loops, receiver);
    case ContourEndKind::End:
      return vertexPoint(piece.triangle, walls.next(piece.segment), walls.wall(piece.segment).b,
        loops, receiver);
    default:
      return piercePoint(piece, walls, loops, receiver);
  }
}
}
