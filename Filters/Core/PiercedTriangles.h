/// Triangles of a mesh that pierce each other.
#pragma once

#include "Occurrences.h"
#include "RangeLoop.h"

namespace shadow
{
/// Triangles that pierce another one: each has corners on both sides of the other's plane, and they
/// have a segment of some length in common, all by more than what rounding could make up (the error
/// bound of Shewchuk 1997 on the sign of a determinant). Triangles that touch, or lie in one
/// another's plane, do not pierce. Each counts once, whatever the number of those that it pierces,
/// and occurs in the middle of the segment with the one that is met first. Where it pierces
/// several, the place can depend on the order of the mesh: to look at all of them takes much longer.
/// The count does not, and nothing depends on the threads of the loop.
///
/// O(n log n) where boxes around triangles meet few others. Quadratic where they meet most, as they
/// do on needles that lie askew and around the apex of a fan: pairs of a fan are told apart by
/// boxes around their opposite sides, which takes some 15 ns each.
Occurrences findPiercedTriangles(const TriangleMesh& mesh, const RangeLoop& loop);
}
