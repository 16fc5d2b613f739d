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
/// and occurs in the middle of the first one's segment.
///
/// The result does not depend on the threads of the loop. O(n log n) where boxes around triangles
/// meet few others, which on needles that lie askew they do not.
Occurrences findPiercedTriangles(const TriangleMesh& mesh, const RangeLoop& loop);
}
