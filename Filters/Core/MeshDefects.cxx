#include "MeshDefects.h"

#include <algorithm>

namespace shadow
{
namespace
{
Vec3 middleOf(const TriangleMesh& mesh, const Edge& edge)
{
  return 0.5 * (mesh.points[edge.a] + mesh.points[edge.b]);
}

Vec3 middleOf(const TriangleMesh& mesh, const Triangle& t)
{
  return (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3.0;
}

void addEdges(const TriangleMesh& mesh, const EdgeTable& edges, MeshDefects& defects)
{
  for (std::size_t i = edges.regular; i < edges.edges.size(); ++i)
  {
    const Index e = static_cast<Index>(i);
    const Vec3 place = middleOf(mesh, edges.edges[e]);
    switch (edgeDefect(mesh, edges, e))
    {
      case EdgeDefect::Border:
        defects.borderEdges.add(place);
        break;
      case EdgeDefect::NonManifold:
        defects.nonManifoldEdges.add(place);
        break;
      case EdgeDefect::Inconsistent:
        defects.inconsistentEdges.add(place);
        break;
      case EdgeDefect::None:
        break;
    }
  }
}

void addDuplicates(const TriangleMesh& mesh, MeshDefects& defects)
{
  std::vector<Triangle> sorted = mesh.triangles;
  for (Triangle& t : sorted)
  {
    std::sort(t.begin(), t.end());
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    if (sorted[i] == sorted[i - 1])
    {
      defects.duplicateTriangles.add(middleOf(mesh, sorted[i]));
    }
  }
}

struct Shape
{
  bool isFlat;
  bool isSliver;
};

Shape shapeOf(const TriangleMesh& mesh, Index triangle)
{
  const Triangle& t = mesh.triangles[triangle];
  std::array<Vec3, 3> sides;
  double size = 0.0;
  double coordinate = 0.0;
  for (unsigned k = 0; k < 3; ++k)
  {
    const Vec3& p = mesh.points[t[k]];
    sides[k] = mesh.points[t[next(k)]] - p;
    size = std::max(size, largestComponent(sides[k]));
    coordinate = std::max(coordinate, largestComponent(p));
  }
  // Of size 1, for areas and their squares leave the range of doubles long before lengths do.
  double longest = 0.0;
  for (Vec3& side : sides)
  {
    side /= size;
    longest = std::max(longest, glm::length(side));
  }
  // Of a point that is computed on a line, as a mean of two others, the coordinates are rounded
  // twice, each time by half an epsilon: in space that is less than two of them. The same again
  // leaves room for the area's own roundings.
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * (coordinate / size);
  const double doubleArea = glm::length(glm::cross(sides[0], sides[1]));
  const bool isFlat = !(doubleArea > longest * rounding);
  return { isFlat, !isFlat && sliverAspect * doubleArea <= longest * longest };
}

void addTriangles(const TriangleMesh& mesh, const ChainWeights& weights, MeshDefects& defects)
{
  std::vector<Occurrences> insideOut(weights.parts.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const Index t = static_cast<Index>(i);
    const Vec3 place = middleOf(mesh, mesh.triangles[t]);
    const Shape shape = shapeOf(mesh, t);
    if (shape.isFlat)
    {
      defects.flatTriangles.add(place);
    }
    if (shape.isSliver)
    {
      defects.slivers.add(place);
    }
    const MeshPart& part = weights.parts[weights.part(t)];
    defects.twoSidedTriangles += !part.closed;
    if (part.closed && !part.outward)
    {
      insideOut[weights.part(t)].add(place);
    }
    if (!weights.agreeing.empty() && weights.agreeing[t] == 0)
    {
      defects.turnedNormals.add(place);
    }
    const double agreement = normalAgreement(mesh, t);
    if (part.closed && !shape.isFlat && (part.normalsAgree ? agreement < 0.0 : agreement > 0.0))
    {
      defects.contraryNormals.add(place);
    }
  }
  for (const Occurrences& part : insideOut)
  {
    if (part.count > 0)
    {
      defects.insideOutParts.add(part.place);
    }
  }
}
}

MeshDefects findMeshDefects(
  const TriangleMesh& mesh, const EdgeTable& edges, const ChainWeights& weights)
{
  MeshDefects defects;
  addEdges(mesh, edges, defects);
  addDuplicates(mesh, defects);
  addTriangles(mesh, weights, defects);
  defects.closedParts = static_cast<std::size_t>(std::count_if(weights.parts.begin(),
    weights.parts.end(), [](const MeshPart& part) { return part.closed; }));
  return defects;
}
}
