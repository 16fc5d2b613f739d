#include "FacingItems.h"

namespace shadow
{
namespace
{
/// Whether an edge's pieces cancel wherever all corners at it are lit, and where all are dark.
bool cancelsUnlessMixed(const TriangleMesh& mesh, const EdgeTable& edges,
  const ChainWeights& weights, Index edge)
{
  int lit = 0;
  int dark = 0;
  for (Index i = edges.firstSide[edge]; i < edges.firstSide[edge + 1]; ++i)
  {
    const Side side = edges.sides[i];
    const int sign = sideSign(mesh, edges, edge, side);
    lit += sign * weights.corner[side / 3].lit;
    dark += sign * weights.corner[side / 3].dark;
  }
  return lit == 0 && dark == 0;
}

template <class Plane>
std::vector<glm::vec4> makePlanes(std::size_t count, const RangeLoop& loop, const Plane& plane)
{
  std::vector<glm::vec4> planes(count);
  loop(count, lightGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        planes[i] = plane(static_cast<Index>(i));
      }
    });
  return planes;
}
}

SearchItems faceItems(const TriangleMesh& mesh, const EdgeTable& edges, const Vec3& centre,
  double radius, const RangeLoop& loop)
{
  SearchItems result;
  FacingItems& items = result.items;
  items.centre = centre;
  items.radius = radius;
  items.planes = makePlanes(mesh.triangles.size(), loop,
    [&](Index t)
    { return facingPlane(mesh.areaNormal(t), mesh.points[mesh.triangles[t][0]], centre, radius); });
  items.arity = 2;
  items.ids.reserve(edges.edges.size());
  items.fields.reserve(2 * edges.edges.size());
  for (std::size_t i = 0; i < edges.edges.size(); ++i)
  {
    const Index e = static_cast<Index>(i);
    // All triangles at an edge are of one part and have the same weights.
    if (edges.sideCount(e) != 2 || signSum(mesh, edges, e) != 0)
    {
      result.apart.push_back(e);
      continue;
    }
    items.ids.push_back(e);
    items.fields.push_back(edges.sides[edges.firstSide[e]] / 3);
    items.fields.push_back(edges.sides[edges.firstSide[e] + 1] / 3);
  }
  return result;
}

SearchItems cornerItems(const TriangleMesh& mesh, const EdgeTable& edges,
  const ChainWeights& weights, const std::vector<Index>& linkEdges, const Vec3& centre,
  double radius, const RangeLoop& loop)
{
  SearchItems result;
  FacingItems& items = result.items;
  items.centre = centre;
  items.radius = radius;
  items.planes = makePlanes(mesh.normals.size(), loop,
    [&](Index n)
    { return facingPlane(mesh.normals[n], mesh.points[mesh.normalVertex[n]], centre, radius); });
  std::vector<Index> creases;
  for (const Index e : linkEdges)
  {
    const bool fits = edges.sideCount(e) == 2 && cancelsUnlessMixed(mesh, edges, weights, e);
    (fits ? creases : result.apart).push_back(e);
  }
  items.arity = creases.empty() ? 3 : 4;
  const std::size_t triangles = mesh.triangles.size();
  items.ids.reserve(triangles + creases.size());
  items.fields.reserve(items.arity * items.ids.capacity());
  for (std::size_t t = 0; t < triangles; ++t)
  {
    const Triangle& n = mesh.cornerNormals[t];
    items.ids.push_back(static_cast<Index>(t));
    items.fields.insert(items.fields.end(), n.begin(), n.end());
    items.fields.resize(items.arity * items.ids.size(), n[0]);
  }
  for (const Index e : creases)
  {
    items.ids.push_back(static_cast<Index>(triangles) + e);
    for (Index i = edges.firstSide[e]; i < edges.firstSide[e + 1]; ++i)
    {
      const SideNormals normals = sideNormals(mesh, edges, e, edges.sides[i]);
      items.fields.push_back(normals.a);
      items.fields.push_back(normals.b);
    }
  }
  return result;
}
}
