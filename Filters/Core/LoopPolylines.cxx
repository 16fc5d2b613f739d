#include "LoopPolylines.h"

#include <algorithm>
#include <limits>

namespace shadow
{
namespace
{
/// What a polyline's point consists of, but for its place on the mesh.
struct ContourPoint
{
  Vec3 point;
  Vec3 normal;
};

/// Where the ends' normals cancel, as on a mesh whose winding changes, a point has the first end's.
ContourPoint pointBetween(
  const CubicCurve& curve, double s, const ContourPoint& from, const ContourPoint& to)
{
  const Vec3 tangent = unitOrZero(curve.derivative(s));
  Vec3 normal = unitOr(from.normal + s * (to.normal - from.normal), from.normal);
  normal -= glm::dot(normal, tangent) * tangent;
  return { curve.point(s), unitOr(normal, from.normal) };
}

class PolylineMaker
{
public:
  PolylineMaker(const Caster& caster, const SilhouetteChain& chain, const SilhouetteLoops& loops,
    const PolylineTolerance& tolerance, const RangeLoop& loop)
    : TheCaster(caster)
    , Chain(chain)
    , Loops(loops)
    , Receiver(tolerance.receiver)
    , Loop(loop)
    , VertexCount(caster.mesh().points.size())
  {
    // Below a few roundings of the coordinates a deviation is noise, which no subdivision mends.
    this->Limit.rounding = 16.0 * std::numeric_limits<double>::epsilon() *
      (glm::length(caster.centre()) + caster.radius());
    this->Limit.tolerance = tolerance.length;
  }

  LoopPolylines make(const std::function<PolylineArrays(std::size_t count)>& allocate)
  {
    this->countPoints();
    this->Lines.nodes.resize(this->FirstPoint.back());
    for (const std::size_t piece : this->Loops.first)
    {
      this->Lines.first.push_back(this->FirstPoint[piece]);
    }
    const PolylineArrays arrays = allocate(this->FirstPoint.back());
    this->Loop(this->Loops.pieces.size(), 8 * heavyGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          this->writePiece(i, arrays);
        }
      });
    return std::move(this->Lines);
  }

private:
  template <class Emit>
  Deviation subdividePiece(Index piece, const Emit& emit) const
  {
    const CubicCurve& curve = this->Chain.curves[piece];
    if (this->Receiver)
    {
      return subdivide(curve, this->Limit,
        [&](const CubicCurve& c)
        { return Deviation{ c.deviationBound(), this->Receiver->deviationBound(c) }; }, emit);
    }
    return subdivide(curve, this->Limit,
      [](const CubicCurve& c)
      {
        const double bound = c.deviationBound();
        return Deviation{ bound, bound };
      },
      emit);
  }

  /// A point for each piece, and those that subdivision adds to a curve.
  void countPoints()
  {
    const std::size_t count = this->Loops.pieces.size();
    this->FirstPoint.resize(count + 1);
    if (this->Chain.kind != SilhouetteKind::Smooth)
    {
      for (std::size_t i = 0; i <= count; ++i)
      {
        this->FirstPoint[i] = i;
      }
      return;
    }
    std::vector<Deviation> deviations(count);
    this->FirstPoint[0] = 0;
    this->Loop(count, 4 * heavyGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          std::size_t points = 1;
          deviations[i] =
            this->subdividePiece(this->Loops.pieces[i], [&](double) { ++points; });
          this->FirstPoint[i + 1] = points;
        }
      });
    for (std::size_t i = 0; i < count; ++i)
    {
      this->FirstPoint[i + 1] += this->FirstPoint[i];
      this->Lines.deviation.include(deviations[i]);
    }
  }

  /// The first side's normal at a vertex of a link's edge; a chord's ends are crossings.
  Vec3 vertexNormal(const Piece& piece, Index vertex) const
  {
    const TriangleMesh& mesh = this->TheCaster.mesh();
    const EdgeTable& edges = this->TheCaster.edges();
    const Side side = edges.sides[edges.firstSide(piece.source)];
    const unsigned corner = side % 3;
    const unsigned at = mesh.triangles[side / 3][corner] == vertex ? corner : next(corner);
    return mesh.normals[mesh.cornerNormals[side / 3][at]];
  }

  ContourPoint pointAt(const Piece& piece, Index node) const
  {
    if (node >= this->VertexCount)
    {
      const Crossing& c = this->Chain.crossings[node - this->VertexCount];
      return { c.point, c.normal };
    }
    return { this->TheCaster.mesh().points[node], this->vertexNormal(piece, node) };
  }

  Vec3 meshPointAt(Index node) const
  {
    const TriangleMesh& mesh = this->TheCaster.mesh();
    return node < this->VertexCount
      ? mesh.points[node]
      : meshPoint(mesh, this->TheCaster.edges(), this->Chain.crossings[node - this->VertexCount]);
  }

  void writePiece(std::size_t i, const PolylineArrays& arrays)
  {
    const Index pieceIndex = this->Loops.pieces[i];
    const Piece& piece = this->Chain.pieces[pieceIndex];
    std::size_t at = this->FirstPoint[i];
    const auto write = [&](const ContourPoint& p, Index node)
    {
      arrays.points[at] = p.point;
      if (arrays.normals)
      {
        arrays.normals[at] = p.normal;
      }
      this->Lines.nodes[at++] = node;
    };
    const ContourPoint from = this->pointAt(piece, piece.from);
    write(from, piece.from);
    const Vec3 meshFrom = arrays.meshPoints ? this->meshPointAt(piece.from) : Vec3(0.0);
    if (arrays.meshPoints)
    {
      arrays.meshPoints[at - 1] = meshFrom;
    }
    if (this->FirstPoint[i + 1] == at)
    {
      return;
    }
    const ContourPoint to = this->pointAt(piece, piece.to);
    const Vec3 along = this->meshPointAt(piece.to) - meshFrom;
    this->subdividePiece(pieceIndex,
      [&](double s)
      {
        write(pointBetween(this->Chain.curves[pieceIndex], s, from, to), None);
        if (arrays.meshPoints)
        {
          arrays.meshPoints[at - 1] = meshFrom + s * along;
        }
      });
  }

  const Caster& TheCaster;
  const SilhouetteChain& Chain;
  const SilhouetteLoops& Loops;
  const ShadowReceiver* Receiver;
  const RangeLoop& Loop;
  const std::size_t VertexCount;
  SubdivisionLimit Limit;
  std::vector<std::size_t> FirstPoint; ///< of each of the loops' pieces, and the end
  LoopPolylines Lines;
};
}

LoopPolylines makePolylines(const Caster& caster, const SilhouetteChain& chain,
  const SilhouetteLoops& loops, const PolylineTolerance& tolerance, const RangeLoop& loop,
  const std::function<PolylineArrays(std::size_t count)>& allocate)
{
  return PolylineMaker(caster, chain, loops, tolerance, loop).make(allocate);
}
}
