#include "SilhouetteChain.h"

#include "Caster.h"
#include "SmoothContour.h"

#include <algorithm>

namespace shadow
{
namespace
{
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
    this->findCrossedEdges(found.triangles);
    this->listCrossings();
    this->solveCrossings();
    this->orderCrossings();
    for (const Index t : found.triangles)
    {
      this->addChord(t);
    }
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

  SideNormals normalsOf(Side side) const
  {
    return sideNormals(
      this->Mesh, this->Edges, this->Edges.triangleEdges[side / 3][side % 3], side);
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

  void findCrossedEdges(const std::vector<Index>& mixed)
  {
    std::vector<Index>& found = this->Chain.crossedEdges;
    for (const Index t : mixed)
    {
      const Triangle& n = this->Mesh.cornerNormals[t];
      for (unsigned k = 0; k < 3; ++k)
      {
        if (this->Chain.field.lit(n[k]) != this->Chain.field.lit(n[next(k)]))
        {
          found.push_back(this->Edges.triangleEdges[t][k]);
        }
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    this->Chain.indexCrossedEdges();
  }

  void listCrossings()
  {
    for (const Index e : this->Chain.crossedEdges)
    {
      this->Chain.firstCrossing.push_back(static_cast<Index>(this->Chain.crossings.size()));
      for (Index i = this->Edges.firstSide[e]; i < this->Edges.firstSide[e + 1]; ++i)
      {
        const SideNormals normals = sideNormals(this->Mesh, this->Edges, e, this->Edges.sides[i]);
        if (this->crosses(normals) && !this->isListed(normals))
        {
          this->Chain.crossings.push_back({ e, normals, 0.0, Vec3(0.0), Vec3(0.0), Vec3(0.0) });
        }
      }
    }
    this->Chain.firstCrossing.push_back(static_cast<Index>(this->Chain.crossings.size()));
  }

  /// Among the crossings of the edge that is being listed.
  bool isListed(const SideNormals& normals) const
  {
    return std::any_of(this->Chain.crossings.begin() + this->Chain.firstCrossing.back(),
      this->Chain.crossings.end(), [&](const Crossing& c) { return c.normals == normals; });
  }

  void solveCrossings()
  {
    std::vector<EdgeCurve> curves;
    if (this->Chain.kind == SilhouetteKind::Smooth)
    {
      curves = this->TheCaster.curves(this->Chain.crossedEdges, this->Loop);
    }
    this->Loop(this->Chain.crossedEdges.size(), curves.empty() ? lightGrain : heavyGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          for (Index c = this->Chain.firstCrossing[i]; c < this->Chain.firstCrossing[i + 1]; ++c)
          {
            this->solveCrossing(this->Chain.crossings[c], curves.empty() ? nullptr : &curves[i]);
          }
        }
      });
  }

  /// Without a curve the field is linear on the edge.
  void solveCrossing(Crossing& c, const EdgeCurve* curve) const
  {
    const Vec3& a = this->Mesh.points[this->Edges.edges[c.edge].a];
    const Vec3& b = this->Mesh.points[this->Edges.edges[c.edge].b];
    const Vec3& normalA = this->Mesh.normals[c.normals.a];
    const Vec3& normalB = this->Mesh.normals[c.normals.b];
    const double fieldA = this->Chain.field.value(c.normals.a);
    const double fieldB = this->Chain.field.value(c.normals.b);
    EdgeCurve::Sample sample{ Vec3(0.0), Vec3(0.0) };
    if (curve)
    {
      c.parameter =
        shadow::solveCrossing(*curve, normalA, normalB, fieldA, fieldB, this->Chain.light);
      sample = curve->sample(c.parameter, normalA, normalB);
    }
    else
    {
      c.parameter = linearCrossing(fieldA, fieldB);
      sample = { a + c.parameter * (b - a), normalA + c.parameter * (normalB - normalA) };
    }
    c.meshPoint = a + c.parameter * (b - a);
    c.point = sample.point;
    c.normal = unitOrZero(sample.normal);
  }

  void orderCrossings()
  {
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

  Index crossingOfSide(Index triangle, unsigned k) const
  {
    const Side side = 3 * triangle + k;
    return this->Chain.crossingOf(
      this->Edges.triangleEdges[triangle][k], this->normalsOf(side));
  }

  /// From the crossing where, counter-clockwise, lit turns dark to the one where dark turns lit:
  /// the lit part lies to its left.
  void addChord(Index triangle)
  {
    const Triangle& n = this->Mesh.cornerNormals[triangle];
    Index from = None;
    Index to = None;
    for (unsigned k = 0; k < 3; ++k)
    {
      const bool here = this->Chain.field.lit(n[k]);
      if (here != this->Chain.field.lit(n[next(k)]))
      {
        (here ? from : to) = this->crossingNode(this->crossingOfSide(triangle, k));
      }
    }
    const ChainWeight weight = this->TheCaster.weights().corner[triangle];
    this->addPiece(from, to, triangle, true, weight.lit - weight.dark);
  }

  /// Multiplicity, from a to b, of an edge's interval that begins after `passed` crossings.
  int intervalMultiplicity(Index edge, Index firstCrossing, Index passed) const
  {
    int sum = 0;
    for (Index i = this->Edges.firstSide[edge]; i < this->Edges.firstSide[edge + 1]; ++i)
    {
      const Side side = this->Edges.sides[i];
      const SideNormals normals = sideNormals(this->Mesh, this->Edges, edge, side);
      const bool beyond = this->crosses(normals) &&
        this->Chain.crossingOf(edge, normals) < firstCrossing + passed;
      const bool lit = this->Chain.field.lit(beyond ? normals.b : normals.a);
      sum += sideSign(this->Mesh, this->Edges, edge, side) *
        this->TheCaster.weights().corner[side / 3].of(lit);
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
    // Chords come first.
    const std::vector<Piece>& pieces = this->Chain.pieces;
    const std::size_t firstLink = static_cast<std::size_t>(
      std::find_if(pieces.begin(), pieces.end(), [](const Piece& p) { return !p.isChord; }) -
      pieces.begin());
    std::vector<Index> linked;
    for (std::size_t i = firstLink; i < pieces.size(); ++i)
    {
      linked.push_back(pieces[i].source);
    }
    const std::vector<EdgeCurve> edgeCurves = this->TheCaster.curves(linked, this->Loop);
    this->Chain.curves.resize(pieces.size());
    this->Loop(pieces.size(), heavyGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const Piece& p = pieces[i];
          this->Chain.curves[i] = i < firstLink
            ? this->chordCurve(p)
            : edgeCurves[i - firstLink].arc(
                this->parameterOn(p.source, p.from), this->parameterOn(p.source, p.to));
        }
      });
  }

  CubicCurve chordCurve(const Piece& p) const
  {
    const Crossing& c0 = this->Chain.crossings[p.from - this->Mesh.points.size()];
    const Crossing& c1 = this->Chain.crossings[p.to - this->Mesh.points.size()];
    return contourSegment(c0.point, c0.normal, c1.point, c1.normal);
  }

  Caster& TheCaster;
  const TriangleMesh& Mesh;
  const EdgeTable& Edges;
  SilhouetteChain& Chain;
  const RangeLoop& Loop;
};
}

/// Where an edge's place is, or the free slot that ends its search.
std::size_t SilhouetteChain::slotOf(Index edge) const
{
  // The high half of a product with the golden ratio spreads neighbouring numbers.
  const std::uint32_t hash = edge * 2654435769u;
  const std::size_t size = this->crossedPlaces.size();
  std::size_t slot = (std::uint64_t(hash) * size) >> 32;
  while (this->crossedPlaces[slot] != None && this->crossedEdges[this->crossedPlaces[slot]] != edge)
  {
    slot = slot + 1 < size ? slot + 1 : 0;
  }
  return slot;
}

void SilhouetteChain::indexCrossedEdges()
{
  this->crossedPlaces.assign(2 * this->crossedEdges.size() + 1, None);
  for (std::size_t i = 0; i < this->crossedEdges.size(); ++i)
  {
    this->crossedPlaces[this->slotOf(this->crossedEdges[i])] = static_cast<Index>(i);
  }
}

std::pair<Index, Index> SilhouetteChain::crossingsOn(Index edge) const
{
  const Index i = this->crossedPlaces.empty() ? None : this->crossedPlaces[this->slotOf(edge)];
  return i == None ? std::pair<Index, Index>{ 0, 0 }
                   : std::pair<Index, Index>{ this->firstCrossing[i], this->firstCrossing[i + 1] };
}

Index SilhouetteChain::crossingOf(Index edge, const SideNormals& normals) const
{
  const auto [first, end] = this->crossingsOn(edge);
  for (Index c = first; c < end; ++c)
  {
    if (this->crossings[c].normals == normals)
    {
      return c;
    }
  }
  return None;
}

SilhouetteChain buildSilhouetteChain(Caster& caster, const Light& light, SilhouetteKind kind,
  SearchMethod method, const RangeLoop& loop)
{
  const FieldKind fieldKind =
    kind == SilhouetteKind::Discrete ? FieldKind::Face : FieldKind::Corner;
  SilhouetteChain chain;
  chain.light = light;
  chain.kind = kind;
  chain.field = LightField(caster.mesh(), light, fieldKind);
  chain.method = method;
  const SearchResult found = caster.search(light, fieldKind, method, loop);
  chain.itemsTested = found.tested;
  ChainBuilder builder(caster, chain, loop);
  if (fieldKind == FieldKind::Face)
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
