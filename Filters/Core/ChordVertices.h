/// Which vertices of the casters are around the segments of silhouettes that cross triangles.
#pragma once

#include "ContourWalls.h"
#include "ReceiverView.h"

namespace shadow
{
/// A silhouette that is not made of edges runs within the mesh's own shadow, as the mesh has
/// surface on both sides of it; a smooth one runs beside the mesh besides. So what is around a
/// segment is not to hide its contour: the triangles that hold its chord on the mesh, known by
/// their place to within rounding, and those that share a vertex with them. All else may hide it,
/// of the same mesh as of others. Where the silhouette's mesh is not among the casters nothing is
/// around it.
///
/// A segment that lies on an edge itself, at which the mesh turns from the light or ends, is as one
/// of a silhouette of edges: nothing is around it. Nor is anything around a chord in a closed part
/// of the mesh that is concave there: in front of it the surface is in its own shadow, so that it
/// is right if that hides the contour.
class ChordVertices
{
public:
  ChordVertices(const ContourLoops& loops, const std::vector<ContourReceiver>& casters,
    const Light& light, const RangeLoop& loop);

  /// Whether a triangle has a vertex around a segment. Vertices have numbers over all casters, one
  /// caster's after those of the one before.
  bool touches(Index segment, const Triangle& triangle) const;
  /// Around any segment.
  bool touchesAny(const Triangle& triangle) const;

private:
  std::vector<std::size_t> First; ///< where those of each segment begin, and the end
  std::vector<Index> Vertices;
  std::vector<Index> All; ///< around any segment, ascending
};
}
