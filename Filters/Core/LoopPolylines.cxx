#include "LoopPolylines.h"

#include "SmoothContour.h"

#include <algorithm>
#include <limits>

namespace shadow
{
namespace
{
/// What a polyline's point consists of.
struct ContourPoint
{
  Vec3 point;
  Vec3 meshPoint;
  Vec3 normal;
};

/// The first side's normal at a vertex of a link's edge; a chord's ends are crossings.
Vec3 vertexNormal(const Caster& caster, const Piece& piece, Index vertex)
{
  const EdgeTable& edges = caster.edges();
  const Side side = edges.sides[edges.firstSide[piece.source]];
  const SideNormals normals = sideNormals(caster.mesh(), edges, piece.source, side);
  return caster.mesh()
    .normals[caster.mesh().normalVertex[normals.a] == vertex ? normals.a : normals.b];
}

ContourPoint pointAt(
  const Caster& caster, const SilhouetteChain& chain, const Piece& piece, Index node)
{
  const std::size_t vertexCount = caster.mesh().points.size();
  if (node >= vertexCount)
  {
    const Crossing& c = chain.crossings[node - vertexCount];
    return { c.point, c.meshPoint, c.normal };
  }
  const Vec3& p = caster.mesh().points[node];
  return { p, p, vertexNormal(caster, piece, node) };
}

/// Below a few roundings of the coordinates a deviation is noise, which no subdivision mends.
double finestTolerance(const Caster& caster)
{
  return 16.0 * std::numeric_limits<double>::epsilon() *
    (glm::length(caster.centre()) + caster.radius());
}

ContourPoint pointBetween(
  const CubicCurve& curve, double s, const ContourPoint& from, const ContourPoint& to)
{
  const Vec3 tangent = unitOrZero(curve.derivative(s));
  Vec3 normal = from.normal + s * (to.normal - from.normal);
  normal -= glm::dot(normal, tangent) * tangent;
  return { curve.point(s), from.meshPoint + s * (to.meshPoint - from.meshPoint),
    unitOrZero(normal) };
}
}

LoopPolylines makePolylines(const Caster& caster, const SilhouetteChain& chain,
  const SilhouetteLoops& loops, double tolerance, const RangeLoop& loop)
{
  const std::size_t count = loops.pieces.size();
  const bool curved = chain.kind == SilhouetteKind::Smooth;
  std::vector<std::vector<double>> inner(curved ? count : 0);
  std::vector<double> deviation(inner.size(), 0.0);
  tolerance = std::max(tolerance, finestTolerance(caster));
  loop(inner.size(), heavyGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        deviation[i] = subdivide(chain.curves[loops.pieces[i]], tolerance,
          [&](double s) { inner[i].push_back(s); });
      }
    });

  std::vector<std::size_t> firstPoint(count + 1, 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    firstPoint[i + 1] = firstPoint[i] + 1 + (curved ? inner[i].size() : 0);
  }
  LoopPolylines lines;
  lines.points.resize(firstPoint[count]);
  lines.meshPoints.resize(firstPoint[count]);
  lines.normals.resize(firstPoint[count]);
  lines.nodes.assign(firstPoint[count], None);
  for (const std::size_t piece : loops.first)
  {
    lines.first.push_back(firstPoint[piece]);
  }
  for (const double d : deviation)
  {
    lines.maximumDeviation = std::max(lines.maximumDeviation, d);
  }

  loop(count, curved ? heavyGrain : lightGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Index pieceIndex = loops.pieces[i];
        const Piece& piece = chain.pieces[pieceIndex];
        const ContourPoint from = pointAt(caster, chain, piece, piece.from);
        const auto store = [&](std::size_t at, const ContourPoint& p)
        {
          lines.points[at] = p.point;
          lines.meshPoints[at] = p.meshPoint;
          lines.normals[at] = p.normal;
        };
        store(firstPoint[i], from);
        lines.nodes[firstPoint[i]] = piece.from;
        if (!curved || inner[i].empty())
        {
          continue;
        }
        const ContourPoint to = pointAt(caster, chain, piece, piece.to);
        for (std::size_t j = 0; j < inner[i].size(); ++j)
        {
          store(firstPoint[i] + 1 + j,
            pointBetween(chain.curves[pieceIndex], inner[i][j], from, to));
        }
      }
    });
  return lines;
}
}
