/// Which triangles are mixed, and which edges part a lit from a dark face, by looking at all.
#pragma once

#include "ChainWeights.h"
#include "RangeLoop.h"

namespace shadow
{
/// A light's field on a mesh, one value per face or per corner normal.
struct LightField
{
  FieldKind kind = FieldKind::Corner;
  std::vector<double> values;

  bool lit(Index item) const { return isLit(this->values[item]); }
};

LightField evaluateField(
  const TriangleMesh& mesh, const Light& light, FieldKind kind, const RangeLoop& loop);

/// The triangles with both lit and dark corners, ascending. O(triangles).
std::vector<Index> findMixedTriangles(
  const TriangleMesh& mesh, const LightField& field, const RangeLoop& loop);

/// How often an edge counts, from a to b, in the boundary of the chain of whole faces.
int faceMultiplicity(const TriangleMesh& mesh, const EdgeTable& edges,
  const ChainWeights& weights, const LightField& field, Index edge);

/// The edges whose face multiplicity is not zero, ascending. O(edges).
std::vector<Index> findFaceSilhouette(const TriangleMesh& mesh, const EdgeTable& edges,
  const ChainWeights& weights, const LightField& field, const RangeLoop& loop);
}
