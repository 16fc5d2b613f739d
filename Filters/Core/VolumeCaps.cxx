#include "VolumeCaps.h"

namespace shadow
{
namespace
{
bool isLitAt(const TriangleMesh& mesh, const SilhouetteChain& chain, Index t, unsigned corner)
{
  return chain.field.lit(
    chain.field.kind() == FieldKind::Face ? t : mesh.cornerNormals[t][corner]);
}

void appendCrossings(const Caster& caster, const SilhouetteChain& chain, Index t, unsigned k,
  bool lit, std::vector<Index>& polygon)
{
  const TriangleMesh& mesh = caster.mesh();
  const EdgeTable& edges = caster.edges();
  const Index e = edges.triangleEdges[t][k];
  const Side side = 3 * t + k;
  const auto [first, end] = chain.crossingsOn(e);
  const Index own = chain.crossingOf(caster, e, sideNormals(mesh, edges, e, side));
  const bool forward = sideSign(mesh, edges, e, side) > 0;
  bool inside = isLitAt(mesh, chain, t, k) == lit;
  for (Index i = first; i < end; ++i)
  {
    const Index c = forward ? i : first + (end - 1 - i);
    if (inside || c == own)
    {
      polygon.push_back(static_cast<Index>(mesh.points.size()) + c);
    }
    inside = inside != (c == own);
  }
}

class CapBuilder
{
public:
  CapBuilder(const Caster& caster, const SilhouetteChain& chain, CapSide side,
    std::vector<VolumeTriangle>& triangles)
    : TheCaster(caster)
    , Mesh(caster.mesh())
    , Edges(caster.edges())
    , Chain(chain)
    , Which(side)
    , Triangles(triangles)
  {
  }

  void build()
  {
    const std::vector<bool> crossed = this->trianglesAtCrossedEdges();
    const ChainWeights& weights = this->TheCaster.weights();
    const FieldKind kind = this->Chain.field.kind();
    const std::vector<bool> onDarkField = weights.capsOnDarkField(kind, this->Which);
    this->Triangles.reserve(this->Triangles.size() + this->Mesh.triangles.size());
    for (std::size_t i = 0; i < this->Mesh.triangles.size(); ++i)
    {
      const Index t = static_cast<Index>(i);
      const ChainWeight weight = weights.cap(kind, t, onDarkField[weights.part(t)]);
      if (!crossed[t])
      {
        this->addTriangle(
          this->Mesh.triangles[t], weight.of(isLitAt(this->Mesh, this->Chain, t, 0)));
        continue;
      }
      for (const bool lit : { true, false })
      {
        if (weight.of(lit) != 0)
        {
          this->addPolygon(
            partOfTriangle(this->TheCaster, this->Chain, t, lit), weight.of(lit));
        }
      }
    }
  }

private:
  std::vector<bool> trianglesAtCrossedEdges() const
  {
    std::vector<bool> crossed(this->Mesh.triangles.size(), false);
    for (const Crossing& c : this->Chain.crossings)
    {
      const Index e = c.edge;
      for (Index i = this->Edges.firstSide(e); i < this->Edges.firstSide(e + 1); ++i)
      {
        crossed[this->Edges.sides[i] / 3] = true;
      }
    }
    return crossed;
  }

  void addPolygon(const std::vector<Index>& polygon, int weight)
  {
    for (std::size_t i = 2; i < polygon.size(); ++i)
    {
      this->addTriangle({ polygon[0], polygon[i - 1], polygon[i] }, weight);
    }
  }

  /// A weight of -1 turns the triangle's winding around. The first corner stays the first, as the
  /// mesh has it, so that rasterisers that interpolate from it give the same depth.
  void addTriangle(const Triangle& t, int weight)
  {
    if (weight != 0)
    {
      this->Triangles.push_back(
        { weight > 0 ? t : Triangle{ t[0], t[2], t[1] }, VolumePart::Cap, 1 });
    }
  }

  const Caster& TheCaster;
  const TriangleMesh& Mesh;
  const EdgeTable& Edges;
  const SilhouetteChain& Chain;
  const CapSide Which;
  std::vector<VolumeTriangle>& Triangles;
};
}

std::vector<Index> partOfTriangle(
  const Caster& caster, const SilhouetteChain& chain, Index triangle, bool lit)
{
  std::vector<Index> polygon;
  for (unsigned k = 0; k < 3; ++k)
  {
    if (isLitAt(caster.mesh(), chain, triangle, k) == lit)
    {
      polygon.push_back(caster.mesh().triangles[triangle][k]);
    }
    appendCrossings(caster, chain, triangle, k, lit, polygon);
  }
  return polygon;
}

void addCaps(const Caster& caster, const SilhouetteChain& chain, CapSide side,
  std::vector<VolumeTriangle>& triangles)
{
  CapBuilder(caster, chain, side, triangles).build();
}
}
