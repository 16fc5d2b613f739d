#include "CasterEdges.h"

#include <algorithm>

namespace shadow
{
namespace
{
bool sidesShareNormals(const TriangleMesh& mesh, const EdgeTable& edges, Index edge)
{
  const Index first = edges.firstSide(edge);
  const SideNormals normals = sideNormals(mesh, edges, edge, edges.sides[first]);
  for (Index i = first + 1; i < edges.firstSide(edge + 1); ++i)
  {
    if (!(sideNormals(mesh, edges, edge, edges.sides[i]) == normals))
    {
      return false;
    }
  }
  return true;
}
}

std::vector<SideNormals> distinctNormals(
  const TriangleMesh& mesh, const EdgeTable& edges, Index edge)
{
  std::vector<SideNormals> distinct;
  for (Index i = edges.firstSide(edge); i < edges.firstSide(edge + 1); ++i)
  {
    const SideNormals normals = sideNormals(mesh, edges, edge, edges.sides[i]);
    if (std::find(distinct.begin(), distinct.end(), normals) == distinct.end())
    {
      distinct.push_back(normals);
    }
  }
  return distinct;
}

EdgeKind edgeKind(const TriangleMesh& mesh, const EdgeTable& edges, Index edge)
{
  if (edges.sideCount(edge) < 2 || signSum(mesh, edges, edge) != 0)
  {
    return EdgeKind::Border;
  }
  return sidesShareNormals(mesh, edges, edge) ? EdgeKind::Plain : EdgeKind::Crease;
}

ChainWeight sumOfSides(const TriangleMesh& mesh, const EdgeTable& edges,
  const ChainWeights& weights, FieldKind kind, Index edge)
{
  int lit = 0;
  int dark = 0;
  for (Index i = edges.firstSide(edge); i < edges.firstSide(edge + 1); ++i)
  {
    const Side side = edges.sides[i];
    const int sign = sideSign(mesh, edges, edge, side);
    const ChainWeight weight = weights.silhouette(kind, side / 3);
    lit += sign * weight.lit;
    dark += sign * weight.dark;
  }
  return { lit, dark };
}

std::vector<EdgeKind> findEdgeKinds(const TriangleMesh& mesh, const EdgeTable& edges)
{
  std::vector<EdgeKind> kinds(edges.edges.size());
  bool plain = true;
  for (std::size_t e = 0; e < kinds.size(); ++e)
  {
    kinds[e] = edgeKind(mesh, edges, static_cast<Index>(e));
    plain = plain && kinds[e] == EdgeKind::Plain;
  }
  return plain ? std::vector<EdgeKind>() : kinds;
}

EdgeDefects countEdgeDefects(const TriangleMesh& mesh, const EdgeTable& edges)
{
  EdgeDefects defects;
  for (std::size_t i = edges.regular; i < edges.edges.size(); ++i)
  {
    const EdgeDefect defect = edgeDefect(mesh, edges, static_cast<Index>(i));
    defects.boundary += defect == EdgeDefect::Border;
    defects.nonManifold += defect == EdgeDefect::NonManifold;
    defects.inconsistent += defect == EdgeDefect::Inconsistent;
  }
  return defects;
}

std::vector<Index> findLinkEdges(const TriangleMesh& mesh, const EdgeTable& edges,
  const ChainWeights& weights, const std::vector<EdgeKind>& kinds)
{
  std::vector<Index> found;
  // Sides with the same normals cancel at a regular edge if they are weighed alike.
  const bool alike = weights.agreeing.empty();
  if (kinds.empty() && alike && edges.regular == edges.edges.size())
  {
    return found;
  }
  for (std::size_t i = 0; i < edges.edges.size(); ++i)
  {
    const Index e = static_cast<Index>(i);
    const bool isPlain = kinds.empty() || kinds[e] == EdgeKind::Plain;
    if (alike && isPlain && edges.isRegular(e))
    {
      continue;
    }
    const ChainWeight sum = sumOfSides(mesh, edges, weights, FieldKind::Corner, e);
    if (!sum.isZero() || !sidesShareNormals(mesh, edges, e))
    {
      found.push_back(e);
    }
  }
  return found;
}
}
