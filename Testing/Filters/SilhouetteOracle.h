/**
 * @brief Discrete and accurate silhouettes by brute force, from their definition alone.
 *
 * The silhouette is the boundary of a weighted chain of triangles. Points with equal coordinates
 * are one vertex. Parts are connected by edges. A part whose directed edges sum to zero counts its
 * lit side once and its dark side not at all; any other part counts all of itself, each piece as if
 * it faced the light: lit +1, dark -1.
 *
 * A discrete silhouette's field belongs to the faces, and to face the light is to have the winding
 * that faces it. An accurate one's belongs to the corners: there a triangle faces the light with
 * the side that its normals are on, so a triangle (of a closed part: the part, in sum) whose
 * winding contradicts its normals counts reversed.
 *
 * Cells with points that are not finite, and triangles with two equal corners, are left out.
 * Polygons are fans of triangles; strips are not read. O(n log n).
 */
#ifndef shadowtest_SilhouetteOracle_h
#define shadowtest_SilhouetteOracle_h

#include "SegmentChain.h"

namespace shadowtest
{
/// light: homogeneous, as in vtkSmoothLightSilhouette.
SegmentChain discreteSilhouette(vtkPolyData* mesh, const double light[4]);

/// Whether the mesh has point normals and none is zero or not finite: the filter puts estimates in
/// the place of such normals, the oracle does not.
bool hasUsableNormals(vtkPolyData* mesh);

/// The mesh must have point normals; they are taken at unit length.
SegmentChain accurateSilhouette(vtkPolyData* mesh, const double light[4]);
}

#endif
