/// Borders that were meant to be none: seams open by rounding, and T-junctions.
#pragma once

#include "EdgeTable.h"
#include "Occurrences.h"
#include "RangeLoop.h"

namespace shadow
{
/// Both occur at vertices.
struct BorderGaps
{
  Occurrences nearSeams;  ///< border vertices with another one near, at some distance
  Occurrences tJunctions; ///< border vertices near the inside of a border edge
};

/// Near is what is within `reach`, and within a tenth of the shortest edge at the vertices, or of
/// the border edge, in question: a mesh that is finer than `reach` is not taken to be all seams.
/// Borders are edges with one side. The corner of a triangle is no T-junction with its own side.
/// Vertices at one place count each, but are judged as one, with the least reach among them.
/// The result does not depend on the threads of the loop.
///
/// Memory O(n). Time O(n log n) unless boxes around very many border edges hold the same vertex,
/// as those of long edges that lie askew do, or very many places are within reach of one another.
BorderGaps findBorderGaps(
  const TriangleMesh& mesh, const EdgeTable& edges, double reach, const RangeLoop& loop);
}
