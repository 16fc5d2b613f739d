/**
 * @brief Meshes of known shape, made by code.
 *
 * Points are double. Closed meshes are wound counter-clockwise seen from outside and share points
 * by id, except at creases, where points with equal coordinates carry different normals. Normals
 * are those of the exact surface, of unit length, unless said otherwise.
 *
 * A jitter seed other than 0 moves the points along the surface, so that the mesh is irregular
 * while points and normals stay exact.
 */
#ifndef shadowtest_TestMeshes_h
#define shadowtest_TestMeshes_h

#include "MeshBuilder.h"

#include <cstdint>

namespace shadowtest
{
/// Unit sphere of latitudes and longitudes, one point at each pole (on z). rings >= 2 counts the
/// bands of faces between the poles, segments >= 3 those around.
Mesh sphere(int rings, int segments, std::uint64_t jitterSeed = 0);

/// Unit sphere from an icosahedron whose edges are halved `subdivisions` times: 20 * 4^n faces.
Mesh icosphere(int subdivisions, std::uint64_t jitterSeed = 0);

/// The two spheres, scaled to the half axes (2, 1, 0.5).
Mesh ellipsoid(int rings, int segments, std::uint64_t jitterSeed = 0);
Mesh icoEllipsoid(int subdivisions, std::uint64_t jitterSeed = 0);
extern const double EllipsoidAxes[3];

/// Torus around z: radius 1 of the ring, 0.4 of its tube.
Mesh torus(int around, int across, std::uint64_t jitterSeed = 0);
constexpr double TorusRadius = 1.0;
constexpr double TorusTube = 0.4;

/// Cylinder around z of radius 1, z in [-1, 1], with flat caps. The rims are creases.
Mesh cylinder(int sides, int stacks = 1);

/// Axis-aligned box of the given half extents around the origin: 24 points, normals of its faces.
Mesh box(double x = 1.0, double y = 1.0, double z = 1.0);
/// The same of 8 points, without normals.
Mesh weldedBox(double x = 1.0, double y = 1.0, double z = 1.0);
/// The same as six quads of 8 points, without normals.
Mesh quadBox(double x = 1.0, double y = 1.0, double z = 1.0);

/// Square z = height, |x| and |y| <= halfSize, of cells x cells squares, facing up, with normals.
Mesh ground(double height, double halfSize, int cells = 1);

/// One triangle (0,0,0), (1,0,0), (0,1,0), normals +z.
Mesh triangle();

/// Smooth closed surface with dents: an icosphere displaced along its radius by a few random
/// waves of the given amplitude (below 0.3 the surface stays star-shaped). Exact normals.
Mesh starShaped(int subdivisions, std::uint64_t seed, double amplitude = 0.2);

/// A copy without point normals.
Mesh withoutNormals(vtkPolyData* mesh);
/// A copy whose triangles share no points; each has its own flat normal.
Mesh facetted(vtkPolyData* mesh);
/// A copy, x -> scale * rotation(x) + shift; the rotation is drawn from the seed (0: none).
Mesh moved(vtkPolyData* mesh, double scale, const Vec3& shift, std::uint64_t rotationSeed = 0);
/// The same for a homogeneous light: directions (w = 0) are rotated only.
std::array<double, 4> movedLight(
  const double light[4], double scale, const Vec3& shift, std::uint64_t rotationSeed = 0);
/// The points and polygons of several meshes in one.
Mesh merged(const std::vector<Mesh>& meshes);

/// Mean length of the edges of all triangles: the h of convergence studies.
double meanEdgeLength(vtkPolyData* triangles);
}

#endif
