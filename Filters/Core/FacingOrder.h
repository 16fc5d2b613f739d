/// The order of a mesh's tables in memory: what faces alike and lies alike is side by side.
#pragma once

#include "EdgeTable.h"
#include "RangeLoop.h"

namespace shadow
{
/// Sorts by a Morton code in the four dimensions of facing planes, so that a run of neighbours is a
/// small box there, and neighbours in space are mostly neighbours in memory. O(n), by digits.
///
/// Triangles by the middle of their corners' planes; vertices and normals get numbers in order of
/// first use. Corners keep their order. The mesh needs its corner normals.
void orderTriangles(TriangleMesh& mesh, const RangeLoop& loop);

/// Regular edges by the middle of their two faces' planes.
void orderEdges(
  const TriangleMesh& mesh, EdgeTable& edges, const Ball& ball, const RangeLoop& loop);
}
