#include "SilhouetteSearch.h"

#include "LightFacing.h"

namespace shadow
{
LightField evaluateField(
  const TriangleMesh& mesh, const Light& light, FieldKind kind, const RangeLoop& loop)
{
  LightField field{ kind, {} };
  field.values.resize(kind == FieldKind::Face ? mesh.triangles.size() : mesh.normals.size());
  loop(field.values.size(), lightGrain,
    [&](std::size_t begin, std::size_t end)
    {
      const auto kernel = kind == FieldKind::Face ? faceField : cornerField;
      kernel(mesh, light, begin, end, field.values.data());
    });
  return field;
}

std::vector<Index> findMixedTriangles(
  const TriangleMesh& mesh, const LightField& field, const RangeLoop& loop)
{
  return selectIndices(mesh.triangles.size(), loop,
    [&](Index t)
    {
      const Triangle& n = mesh.cornerNormals[t];
      const bool lit = field.lit(n[0]);
      return lit != field.lit(n[1]) || lit != field.lit(n[2]);
    });
}

int faceMultiplicity(const TriangleMesh& mesh, const EdgeTable& edges,
  const ChainWeights& weights, const LightField& field, Index edge)
{
  int sum = 0;
  for (Index i = edges.firstSide[edge]; i < edges.firstSide[edge + 1]; ++i)
  {
    const Side side = edges.sides[i];
    const Index t = side / 3;
    sum += sideSign(mesh, edges, edge, side) *
      weights.silhouette(FieldKind::Face, t).of(field.lit(t));
  }
  return sum;
}

std::vector<Index> findFaceSilhouette(const TriangleMesh& mesh, const EdgeTable& edges,
  const ChainWeights& weights, const LightField& field, const RangeLoop& loop)
{
  return selectIndices(edges.edges.size(), loop,
    [&](Index e) { return faceMultiplicity(mesh, edges, weights, field, e) != 0; });
}
}
