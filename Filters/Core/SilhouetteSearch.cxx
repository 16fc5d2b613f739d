#include "SilhouetteSearch.h"

#include "CasterEdges.h"
#include "FacingPlane.h"

#include <algorithm>
#include <iterator>

namespace shadow
{
namespace
{
/// Of a crease's four fields: those at the ends of its first side, then those of its second.
Index creaseNormal(const SearchedMesh& s, Index edge, unsigned k)
{
  const SideNormals normals =
    sideNormals(s.mesh, s.edges, edge, s.edges.sides[s.edges.firstSide(edge) + k / 2]);
  return k % 2 == 0 ? normals.a : normals.b;
}

SearchResult searchFaces(const SearchedMesh& s, const SearchIndex& index, const Light& light,
  bool useTree, const RangeLoop& loop)
{
  const LightField field(s.mesh, light, FieldKind::Face);
  FacingFound found = index.items.search(light, useTree,
    [&](Index e, unsigned k) { return field.lit(s.edges.sides[2 * e + k] / 3); }, loop);
  SearchResult result;
  result.tested = found.tested + index.apart.size();
  result.edges = std::move(found.items);
  result.multiplicities.resize(result.edges.size());
  for (std::size_t i = 0; i < result.edges.size(); ++i)
  {
    // The first side runs from a to b; the second one weighs the same.
    const ChainWeight weight = s.weights.face(s.edges.sides[2 * result.edges[i]] / 3);
    const int direction = found.lit[i] == 1 ? 1 : -1;
    result.multiplicities[i] = direction * (weight.lit - weight.dark);
  }
  // Numbered behind the regular edges.
  for (const Index e : index.apart)
  {
    const int multiplicity =
      faceMultiplicity(s, [&](Index t) { return field.lit(t); }, e);
    if (multiplicity != 0)
    {
      result.edges.push_back(e);
      result.multiplicities.push_back(multiplicity);
    }
  }
  return result;
}

SearchResult searchCorners(const SearchedMesh& s, const SearchIndex& index, const Light& light,
  bool useTree, const RangeLoop& loop)
{
  const LightField field(s.mesh, light, FieldKind::Corner);
  FacingFound mixed = index.items.search(light, useTree,
    [&](Index t, unsigned k) { return field.lit(s.mesh.cornerNormals[t][k]); }, loop);
  const FacingFound creases = index.creases.search(light, useTree,
    [&](Index i, unsigned k) { return field.lit(creaseNormal(s, index.creaseEdges[i], k)); }, loop);
  SearchResult result;
  result.tested = mixed.tested + creases.tested + index.apart.size();
  result.triangles = std::move(mixed.items);
  result.litCorners = std::move(mixed.lit);
  std::vector<Index> links(creases.items.size());
  std::transform(creases.items.begin(), creases.items.end(), links.begin(),
    [&](Index i) { return index.creaseEdges[i]; });
  result.edges.reserve(links.size() + index.apart.size());
  std::merge(links.begin(), links.end(), index.apart.begin(), index.apart.end(),
    std::back_inserter(result.edges));
  return result;
}
}

std::size_t SearchIndex::memory() const
{
  return this->items.memory() + this->creases.memory() +
    (this->creaseEdges.capacity() + this->apart.capacity()) * sizeof(Index);
}

SearchIndex buildSearchIndex(
  const SearchedMesh& s, FieldKind kind, const Ball& ball, const RangeLoop& loop)
{
  SearchIndex index;
  index.kind = kind;
  if (kind == FieldKind::Face)
  {
    const std::vector<Vec4> planes = facePlanes(s.mesh, ball, loop);
    index.items = FacingHierarchy(2, s.edges.regular, ball, loop,
      [&](Index e, unsigned k) { return planes[s.edges.sides[2 * e + k] / 3]; });
    for (std::size_t e = s.edges.regular; e < s.edges.edges.size(); ++e)
    {
      index.apart.push_back(static_cast<Index>(e));
    }
    return index;
  }
  const std::vector<Vec4> planes = cornerPlanes(s.mesh, ball, loop);
  index.items = FacingHierarchy(3, s.mesh.triangles.size(), ball, loop,
    [&](Index t, unsigned k) { return planes[s.mesh.cornerNormals[t][k]]; });
  for (const Index e : s.linkEdges)
  {
    const ChainWeight sum = sumOfSides(s.mesh, s.edges, s.weights, FieldKind::Corner, e);
    const bool fits = s.edges.sideCount(e) == 2 && sum.isZero();
    (fits ? index.creaseEdges : index.apart).push_back(e);
  }
  index.creases = FacingHierarchy(4, index.creaseEdges.size(), ball, loop,
    [&](Index i, unsigned k) { return planes[creaseNormal(s, index.creaseEdges[i], k)]; });
  return index;
}

SearchResult search(const SearchedMesh& searched, const SearchIndex& index, const Light& light,
  bool useTree, const RangeLoop& loop)
{
  return index.kind == FieldKind::Face ? searchFaces(searched, index, light, useTree, loop)
                                       : searchCorners(searched, index, light, useTree, loop);
}
}
