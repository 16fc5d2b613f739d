#include "SilhouetteChain.h"

#include "Caster.h"
#include "SmoothContour.h"

#include <algorithm>

namespace shadow
{
namespace
{
/// The sides of a mixed triangle where, counter-clockwise, lit turns dark and dark turns lit.
struct CrossedSides
{
  std::uint8_t toDark;
  std::uint8_t toLit;
};

/// By the bits of the lit corners; 0 and 7 are not mixed.
constexpr CrossedSides crossedSides[8] = { { 0, 0 }, { 0, 2 }, { 1, 0 }, { 1, 2 }, { 2, 1 },
  { 0, 1 }, { 2, 0 }, { 0, 0 } };

class ChainBuilder
{
public:
  ChainBuilder(Caster& caster, SilhouetteChain& chain, const RangeLoop& loop)
    : TheCaster(caster)
    , Mesh(caster.mesh())
    , Edges(caster.edges())
    , Chain(chain)
    , Loop(loop)
  {
  }

  void buildFromFaces(const SearchResult& found)
  {
    this->Chain.pieces.reserve(found.edges.size());
    for (std::size_t i = 0; i < found.edges.size(); ++i)
    {
      const Index e = found.edges[i];
      const Edge& ends = this->Edges.edges[e];
      this->addPiece(ends.a, ends.b, e, false, found.multiplicities[i]);
    }
  }

  void buildFromCorners(const SearchResult& found)
  {
    this->findCrossedEdges(found);
    this->listCrossings();
    this->solveCrossings();
    this->orderCrossings();
    this->addChords(found);
    for (const Index e : found.edges)
    {
      this->addLinks(e);
    }
    if (this->Chain.kind == SilhouetteKind::Smooth)
    {
      this->shapePieces();
    }
  }

private:
  bool crosses(const SideNormals& normals) const
  {
    return this->Chain.field.lit(normals.a) != this->Chain.field.lit(normals.b);
  }

  SideNormals normalsOf(Index edge, Side side) const
  {
    return sideNormals(this->Mesh, this->Edges, edge, side);
  }

  /// Negative multiplicities turn the piece around, zero leaves it out.
  void addPiece(Index from, Index to, Index source, bool isChord, int multiplicity)
  {
    if (multiplicity < 0)
    {
      std::swap(from, to);
      multiplicity = -multiplicity;
    }
    if (multiplicity > 0)
    {
      this->Chain.pieces.push_back({ from, to, source, isChord, multiplicity });
    }
  }

  void findCrossedEdges(const SearchResult& found)
  {
    // Mostly as many edges as triangles, each of which has two.
    IndexSet& crossed = this->Chain.crossedEdges;
    crossed.reserve(found.triangles.size() + found.triangles.size() / 8);
    this->Chords.resize(found.triangles.size());
    for (std::size_t i = 0; i < found.triangles.size(); ++i)
    {
      const Triangle& edges = this->Edges.triangleEdges[found.triangles[i]];
      const CrossedSides sides = crossedSides[found.litCorners[i]];
      this->Chords[i].toDark = crossed.insert(edges[sides.toDark]).place;
      this->Chords[i].toLit = crossed.insert(edges[sides.toLit]).place;
    }
  }

  /// The sides of an edge share their normals but at creases.
  void listCrossings()
  {
    const std::vector<Index>& crossed = this->Chain.crossedEdges.items();
    std::vector<Index>& first = this->Chain.firstCrossing;
    this->CrossingSides.reserve(crossed.size());
    first.reserve(crossed.size() + 1);
    for (const Index e : crossed)
    {
      first.push_back(static_cast<Index>(this->CrossingSides.size()));
      const Index firstSide = this->Edges.firstSide(e);
      if (this->TheCaster.edgeKind(e) == EdgeKind::Plain)
      {
        this->CrossingSides.push_back(this->Edges.sides[firstSide]);
        continue;
      }
      for (Index i = firstSide; i < this->Edges.firstSide(e + 1); ++i)
      {
        const Side side = this->Edges.sides[i];
        const SideNormals normals = this->normalsOf(e, side);
        if (this->crosses(normals) && !this->isListed(e, normals))
        {
          this->CrossingSides.push_back(side);
        }
      }
    }
    first.push_back(static_cast<Index>(this->CrossingSides.size()));
  }

  /// Among the crossings of the edge that is being listed.
  bool isListed(Index edge, const SideNormals& normals) const
  {
    return std::any_of(this->CrossingSides.begin() + this->Chain.firstCrossing.back(),
      this->CrossingSides.end(),
      [&](Side side) { return this->normalsOf(edge, side) == normals; });
  }

  void solveCrossings()
  {
    std::vector<Crossing>& crossings = this->Chain.crossings;
    crossings.resize(this->CrossingSides.size());
    this->Loop(crossings.size(), 4 * heavyGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const Side side = this->CrossingSides[i];
          crossings[i].side = side;
          crossings[i].edge = this->Edges.triangleEdges[side / 3][side % 3];
        }
        if (this->Chain.kind != SilhouetteKind::Smooth)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            this->solveLinear(crossings[i]);
          }
          return;
        }
        for (std::size_t i = begin; i < end; i += QuarticZeros::size)
        {
          this->solveOnCurves(&crossings[i], std::min(QuarticZeros::size, end - i));
        }
      });
  }

  /// The ends of a crossing's edge on one of its sides.
  struct Ends
  {
    Vec3 normalA, normalB;
    double fieldA, fieldB;
  };

  Ends endsOf(const Crossing& c) const
  {
    const SideNormals normals = this->normalsOf(c.edge, c.side);
    return { this->Mesh.normals[normals.a], this->Mesh.normals[normals.b],
      this->Chain.field.value(normals.a), this->Chain.field.value(normals.b) };
  }

  /// Opposite normals at the ends cancel: then a crossing has the first end's.
  void solveLinear(Crossing& c) const
  {
    const Ends ends = this->endsOf(c);
    c.parameter = linearCrossing(ends.fieldA, ends.fieldB);
    c.point = meshPoint(this->Mesh, this->Edges, c);
    c.normal =
      unitOr(ends.normalA + c.parameter * (ends.normalB - ends.normalA), ends.normalA);
  }

  /// Those on curves of shape Surface, nearly all, together.
  void solveOnCurves(Crossing* crossings, std::size_t count) const
  {
    std::array<EdgeCurve, QuarticZeros::size> curves;
    std::array<Ends, QuarticZeros::size> ends;
    QuarticZeros zeros;
    for (std::size_t i = 0; i < count; ++i)
    {
      ends[i] = this->endsOf(crossings[i]);
      curves[i] = this->TheCaster.curve(crossings[i].edge);
      if (curves[i].shape == EdgeCurve::Shape::Surface)
      {
        const Ends& e = ends[i];
        zeros.add(fieldQuartic(curves[i], this->Chain.light),
          guessCrossing(curves[i], e.normalA, e.normalB, e.fieldA, e.fieldB));
      }
    }
    zeros.refine();
    std::size_t passed = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      Crossing& c = crossings[i];
      const Ends& e = ends[i];
      c.parameter = curves[i].shape == EdgeCurve::Shape::Surface
        ? zeros.zero(passed++, isLit(e.fieldA))
        : solveCrossing(
            curves[i], e.normalA, e.normalB, e.fieldA, e.fieldB, this->Chain.light);
      const EdgeCurve::Sample sample = curves[i].sample(c.parameter, e.normalA, e.normalB);
      c.point = sample.point;
      c.normal = unitOr(sample.normal, e.normalA);
    }
  }

  void orderCrossings()
  {
    if (this->Chain.crossings.size() == this->Chain.crossedEdges.size())
    {
      return; // one an edge
    }
    const std::vector<Index>& first = this->Chain.firstCrossing;
    const auto begin = this->Chain.crossings.begin();
    for (std::size_t i = 0; i + 1 < first.size(); ++i)
    {
      std::stable_sort(begin + first[i], begin + first[i + 1],
        [](const Crossing& l, const Crossing& r) { return l.parameter < r.parameter; });
    }
  }

  Index crossingNode(Index crossing) const
  {
    return static_cast<Index>(this->Mesh.points.size()) + crossing;
  }

  /// The crossing of a triangle's side, given its edge's place.
  Index crossingOfSide(Index place, Index triangle, unsigned k) const
  {
    const Index first = this->Chain.firstCrossing[place];
    if (this->Chain.firstCrossing[place + 1] == first + 1)
    {
      return first;
    }
    const Index edge = this->Chain.crossedEdges.items()[place];
    return this->Chain.crossingOf(this->TheCaster, edge, this->normalsOf(edge, 3 * triangle + k));
  }

  /// From the crossing where, counter-clockwise, lit turns dark to the one where dark turns lit:
  /// the lit part lies to its left.
  void addChords(const SearchResult& found)
  {
    this->Chain.pieces.reserve(found.triangles.size() + found.edges.size());
    const ChainWeights& weights = this->TheCaster.weights();
    for (std::size_t i = 0; i < found.triangles.size(); ++i)
    {
      const Index t = found.triangles[i];
      const CrossedSides sides = crossedSides[found.litCorners[i]];
      const ChainWeight weight = weights.corner(t);
      this->addPiece(
        this->crossingNode(this->crossingOfSide(this->Chords[i].toDark, t, sides.toDark)),
        this->crossingNode(this->crossingOfSide(this->Chords[i].toLit, t, sides.toLit)), t, true,
        weight.lit - weight.dark);
    }
  }

  /// Multiplicity, from a to b, of an edge's interval that begins after `passed` crossings.
  int intervalMultiplicity(Index edge, Index firstCrossing, Index passed) const
  {
    int sum = 0;
    for (Index i = this->Edges.firstSide(edge); i < this->Edges.firstSide(edge + 1); ++i)
    {
      const Side side = this->Edges.sides[i];
      const SideNormals normals = this->normalsOf(edge, side);
      const bool beyond = this->crosses(normals) &&
        this->Chain.crossingOf(this->TheCaster, edge, normals) < firstCrossing + passed;
      const bool lit = this->Chain.field.lit(beyond ? normals.b : normals.a);
      sum += sideSign(this->Mesh, this->Edges, edge, side) *
        this->TheCaster.weights().corner(side / 3).of(lit);
    }
    return sum;
  }

  void addLinks(Index edge)
  {
    const auto [first, end] = this->Chain.crossingsOn(edge);
    Index from = this->Edges.edges[edge].a;
    for (Index c = first; c <= end; ++c)
    {
      const Index to = c < end ? this->crossingNode(c) : this->Edges.edges[edge].b;
      this->addPiece(from, to, edge, false, this->intervalMultiplicity(edge, first, c - first));
      from = to;
    }
  }

  double parameterOn(Index edge, Index node) const
  {
    if (node < this->Mesh.points.size())
    {
      return node == this->Edges.edges[edge].a ? 0.0 : 1.0;
    }
    return this->Chain.crossings[node - this->Mesh.points.size()].parameter;
  }

  void shapePieces()
  {
    const std::vector<Piece>& pieces = this->Chain.pieces;
    this->Chain.curves.resize(pieces.size());
    this->Loop(pieces.size(), 4 * heavyGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          this->Chain.curves[i] = pieces[i].isChord ? this->chordCurve(pieces[i])
                                                    : this->linkCurve(pieces[i]);
        }
      });
  }

  CubicCurve chordCurve(const Piece& p) const
  {
    const Crossing& c0 = this->Chain.crossings[p.from - this->Mesh.points.size()];
    const Crossing& c1 = this->Chain.crossings[p.to - this->Mesh.points.size()];
    return contourSegment(c0.point, c0.normal, c1.point, c1.normal);
  }

  CubicCurve linkCurve(const Piece& p) const
  {
    return this->TheCaster.curve(p.source).arc(
      this->parameterOn(p.source, p.from), this->parameterOn(p.source, p.to));
  }

  /// The places in Chain.crossedEdges of the edges at a chord's ends.
  struct Chord
  {
    Index toDark;
    Index toLit;
  };

  Caster& TheCaster;
  const TriangleMesh& Mesh;
  const EdgeTable& Edges;
  SilhouetteChain& Chain;
  const RangeLoop& Loop;
  std::vector<Chord> Chords;       ///< of the mixed triangles
  std::vector<Side> CrossingSides; ///< of each crossing, the first of its sides
};
}

Index SilhouetteChain::crossingOf(
  const Caster& caster, Index edge, const SideNormals& normals) const
{
  const auto [first, end] = this->crossingsOn(edge);
  for (Index c = first; c < end; ++c)
  {
    if (sideNormals(caster.mesh(), caster.edges(), edge, this->crossings[c].side) == normals)
    {
      return c;
    }
  }
  return None;
}

SilhouetteChain buildSilhouetteChain(Caster& caster, const Light& light, SilhouetteKind kind,
  const SearchResult& found, const RangeLoop& loop)
{
  SilhouetteChain chain;
  chain.light = light;
  chain.kind = kind;
  chain.field = LightField(caster.mesh(), light, fieldKind(kind));
  chain.itemsTested = found.tested;
  ChainBuilder builder(caster, chain, loop);
  if (chain.field.kind() == FieldKind::Face)
  {
    builder.buildFromFaces(found);
  }
  else
  {
    builder.buildFromCorners(found);
  }
  return chain;
}
}
