/// Normals for the corners of a mesh that has none, or has some that are unusable.
#pragma once

#include "EdgeTable.h"

namespace shadow
{
/// Estimates the corner normals of a whole mesh: around a vertex, corners of triangles that turn
/// by at most featureAngle (radians) against their neighbours share one normal, the mean of the
/// triangles' normals weighted by the corners' angles (Thuermer & Wuethrich 1998). Order 2 in the
/// length of an edge on regular meshes, 1 on others. Fills normals, normalVertex and cornerNormals.
void estimateCornerNormals(TriangleMesh& mesh, const EdgeTable& edges, double featureAngle);

/// Gives each normal that is zero or no finite vector the angle-weighted mean of the triangles
/// whose corners have it, and all the others unit length.
void repairNormals(TriangleMesh& mesh);
}
