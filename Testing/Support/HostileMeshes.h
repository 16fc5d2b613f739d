/**
 * @brief Named bad meshes, and ways of spoiling a good one.
 */
#ifndef shadowtest_HostileMeshes_h
#define shadowtest_HostileMeshes_h

#include "MeshBuilder.h"

#include <cstdint>

namespace shadowtest
{
/// `faces` triangles around the common edge (0,0,0) - (0,0,1), in turns of either orientation,
/// with flat normals, points shared along the edge.
Mesh fin(int faces);

/// A closed box with `fins` further triangles standing on one of its edges: 2 + fins faces there.
/// Without normals.
Mesh finnedBox(int fins);

/// Moebius strip of the given number of quads, each of two triangles; one cannot orient it, so
/// directed edges do not cancel across one seam. Without normals.
Mesh moebiusStrip(int quads);

/// Closed strip-like box of 1 x 1 x aspect: two pairs of sides are slivers.
Mesh sliverBox(double aspect);

/// A fan of triangles between a needle's two ends whose heights shrink down to `height`.
Mesh slivers(int count, double height);

/// Two quads, one of which is split at a point on their common edge only on its side.
Mesh tJunction();

/// The mesh with some cells: removed, turned over, collapsed to zero area, given twice.
Mesh opened(vtkPolyData* mesh, double fraction, std::uint64_t seed);
Mesh misoriented(vtkPolyData* mesh, double fraction, std::uint64_t seed);
Mesh degenerated(vtkPolyData* mesh, double fraction, std::uint64_t seed);
Mesh duplicated(vtkPolyData* mesh, double fraction, std::uint64_t seed);

/// The mesh with `count` of its points made NaN or infinite.
Mesh withBadPoints(vtkPolyData* mesh, int count, std::uint64_t seed);

/// Surface of a random set of unit cubes of an n x n x n grid: closed, integer coordinates, with
/// edges and vertices shared by several cubes. Without normals.
Mesh voxels(int n, std::uint64_t seed);
}

#endif
