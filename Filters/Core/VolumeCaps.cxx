#include "VolumeCaps.h"

#include <algorithm>

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

NearCap::NearCap(const Caster& caster, const SilhouetteChain& chain, CapSide side)
  : TheCaster(caster)
  , Chain(chain)
  , OnDarkField(caster.weights().capsOnDarkField(chain.field.kind(), side))
{
  this->findCrossed();
  for (const Index t : this->Crossed)
  {
    this->addParts(t);
  }
}

void NearCap::findCrossed()
{
  const EdgeTable& edges = this->TheCaster.edges();
  for (const Crossing& c : this->Chain.crossings)
  {
    const Index e = c.edge;
    for (Index i = edges.firstSide(e); i < edges.firstSide(e + 1); ++i)
    {
      this->Crossed.push_back(edges.sides[i] / 3);
    }
  }
  std::sort(this->Crossed.begin(), this->Crossed.end());
  this->Crossed.erase(
    std::unique(this->Crossed.begin(), this->Crossed.end()), this->Crossed.end());
}

void NearCap::addParts(Index triangle)
{
  const ChainWeights& weights = this->TheCaster.weights();
  const ChainWeight weight = weights.cap(
    this->Chain.field.kind(), triangle, this->OnDarkField[weights.part(triangle)]);
  for (const bool lit : { true, false })
  {
    if (weight.of(lit) == 0)
    {
      continue;
    }
    const std::vector<Index> polygon =
      partOfTriangle(this->TheCaster, this->Chain, triangle, lit);
    for (std::size_t i = 2; i < polygon.size(); ++i)
    {
      this->Parts.push_back(
        { triangle, turned({ polygon[0], polygon[i - 1], polygon[i] }, weight.of(lit)) });
    }
  }
}

void NearCap::writeWhole(
  const RangeLoop& loop, const std::function<Triangle*(std::size_t)>& allocate) const
{
  constexpr std::size_t blockSize = lightGrain;
  const TriangleMesh& mesh = this->TheCaster.mesh();
  const std::size_t blocks = (mesh.triangles.size() + blockSize - 1) / blockSize;
  std::vector<std::vector<Triangle>> found(blocks);
  loop(blocks, 1,
    [&](std::size_t firstBlock, std::size_t endBlock)
    {
      for (std::size_t block = firstBlock; block < endBlock; ++block)
      {
        std::vector<Triangle>& own = found[block];
        own.reserve(blockSize);
        this->forEachWhole(static_cast<Index>(block * blockSize),
          static_cast<Index>(std::min(mesh.triangles.size(), (block + 1) * blockSize)),
          [&](Index, const Triangle& t) {
            own.push_back({ mesh.sources[t[0]], mesh.sources[t[1]], mesh.sources[t[2]] });
          });
      }
    });
  std::size_t count = 0;
  for (const std::vector<Triangle>& own : found)
  {
    count += own.size();
  }
  Triangle* next = allocate(count);
  for (const std::vector<Triangle>& own : found)
  {
    next = std::copy(own.begin(), own.end(), next);
  }
}
}
