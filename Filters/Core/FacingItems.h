/// What a silhouette can run through, as items of a hierarchy.
#pragma once

#include "CasterEdges.h"
#include "FacingHierarchy.h"

namespace shadow
{
/// A hierarchy's items, and the edges that a search has to look at one by one: those whose pieces do
/// not cancel where all fields have one sign, and those with more fields than an item takes.
struct SearchItems
{
  FacingItems items;
  std::vector<Index> apart; ///< ascending
};

/// The edges with the fields of their triangles. Ids are edges.
SearchItems faceItems(const TriangleMesh& mesh, const EdgeTable& edges, const Vec3& centre,
  double radius, const RangeLoop& loop);

/// The triangles with the fields of their corners, and those creases whose pieces cancel with those
/// of their sides' ends. Ids are triangles, or the number of triangles plus a crease's edge.
SearchItems cornerItems(const TriangleMesh& mesh, const EdgeTable& edges,
  const ChainWeights& weights, const std::vector<Index>& linkEdges, const Vec3& centre,
  double radius, const RangeLoop& loop);
}
