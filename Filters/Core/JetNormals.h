/// Normals of higher order than a mean of the triangles around a vertex.
#pragma once

#include "Geometry.h"
#include "RangeLoop.h"

namespace shadow
{
/// Replaces each corner normal that estimateCornerNormals has found by that of a jet (fitJet)
/// through the vertices around it: ring by ring, at least 16 of them, along triangles that share
/// normals, so never over a crease or a border. The order in the length of an edge is 3 on
/// irregular meshes and 4 on regular ones (angle weights: 1 and 2); noise of the points counts for
/// half as much. A normal keeps to the side of the one that it replaces.
///
/// The old normal stays where
/// - fewer than 8 vertices can be reached, or they do not tell the slopes, as two rows of them;
/// - a normal among them turns by more than 60 degrees against it: the mesh is too coarse for a
///   polynomial there, or has an edge that was not split;
/// - the triangles at the vertex are flat beside a bend;
/// - the new one turns by more than 20 degrees against it.
/// Returns how many stayed. The result does not depend on the threads of the loop.
/// O(normals), about 3 microseconds each.
std::size_t fitJetNormals(TriangleMesh& mesh, const RangeLoop& loop);
}
