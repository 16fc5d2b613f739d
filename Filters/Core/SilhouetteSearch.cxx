#include "SilhouetteSearch.h"

#include <algorithm>
#include <iterator>

namespace shadow
{
namespace
{
template <class IsLit>
bool isMixed(const TriangleMesh& mesh, const IsLit& isLit, Index triangle)
{
  const Triangle& n = mesh.cornerNormals[triangle];
  const bool lit = isLit(n[0]);
  return lit != isLit(n[1]) || lit != isLit(n[2]);
}

/// Bytes and no bits: ranges are filled by several threads.
std::vector<std::uint8_t> findLit(
  const TriangleMesh& mesh, const LightField& field, const RangeLoop& loop)
{
  std::vector<std::uint8_t> lit(
    field.kind() == FieldKind::Face ? mesh.triangles.size() : mesh.normals.size());
  loop(lit.size(), lightGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        lit[i] = field.lit(static_cast<Index>(i));
      }
    });
  return lit;
}
}

SearchResult searchAll(
  const SearchedMesh& searched, const Light& light, FieldKind kind, const RangeLoop& loop)
{
  const LightField field(searched.mesh, light, kind);
  const std::vector<std::uint8_t> lit = findLit(searched.mesh, field, loop);
  const auto isLit = [&](Index item) { return lit[item] != 0; };
  SearchResult result;
  if (kind == FieldKind::Face)
  {
    result.tested = searched.edges.edges.size();
    result.edges = selectIndices(result.tested, loop,
      [&](Index e) { return faceMultiplicity(searched, isLit, e) != 0; });
    for (const Index e : result.edges)
    {
      result.multiplicities.push_back(faceMultiplicity(searched, isLit, e));
    }
    return result;
  }
  result.tested = searched.mesh.triangles.size() + searched.linkEdges.size();
  result.triangles = selectIndices(searched.mesh.triangles.size(), loop,
    [&](Index t) { return isMixed(searched.mesh, isLit, t); });
  result.edges = searched.linkEdges;
  return result;
}

SearchTree buildSearchTree(const SearchedMesh& searched, FieldKind kind, const Vec3& centre,
  double radius, const RangeLoop& loop)
{
  SearchItems items = kind == FieldKind::Face
    ? faceItems(searched.mesh, searched.edges, centre, radius, loop)
    : cornerItems(searched.mesh, searched.edges, searched.weights, searched.linkEdges, centre,
        radius, loop);
  return { FacingHierarchy(items.items, loop), std::move(items.apart) };
}

SearchResult searchTree(const SearchedMesh& searched, const SearchTree& tree, const Light& light,
  FieldKind kind, const RangeLoop& loop)
{
  const LightField field(searched.mesh, light, kind);
  const auto isLit = [&](Index item) { return field.lit(item); };
  SearchResult result;
  result.tested = tree.apart.size();
  const std::vector<Index> candidates = tree.hierarchy.candidates(light, loop, result.tested);
  if (kind == FieldKind::Face)
  {
    std::vector<Index> edges(candidates.size() + tree.apart.size());
    std::merge(candidates.begin(), candidates.end(), tree.apart.begin(), tree.apart.end(),
      edges.begin());
    // On a large mesh each edge waits for memory several times.
    std::vector<int> multiplicities(edges.size());
    loop(edges.size(), 8 * heavyGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          multiplicities[i] = faceMultiplicity(searched, isLit, edges[i]);
        }
      });
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      if (multiplicities[i] != 0)
      {
        result.edges.push_back(edges[i]);
        result.multiplicities.push_back(multiplicities[i]);
      }
    }
    return result;
  }
  // Creases are numbered behind the triangles.
  const Index triangleCount = static_cast<Index>(searched.mesh.triangles.size());
  const auto firstCrease = std::lower_bound(candidates.begin(), candidates.end(), triangleCount);
  std::copy_if(candidates.begin(), firstCrease, std::back_inserter(result.triangles),
    [&](Index t) { return isMixed(searched.mesh, isLit, t); });
  std::vector<Index> creases(firstCrease, candidates.end());
  for (Index& crease : creases)
  {
    crease -= triangleCount;
  }
  result.edges.resize(creases.size() + tree.apart.size());
  std::merge(creases.begin(), creases.end(), tree.apart.begin(), tree.apart.end(),
    result.edges.begin());
  return result;
}
}
