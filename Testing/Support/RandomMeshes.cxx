#include "RandomMeshes.h"

#include "Random.h"
#include "TestMeshes.h"

#include <cmath>

namespace shadowtest
{
namespace
{
MeshBuilder opening(vtkPolyData* mesh)
{
  MeshBuilder builder;
  builder.append(mesh);
  return builder;
}

const Vec3& pointOf(const MeshBuilder& mesh, vtkIdType id)
{
  return mesh.Points[static_cast<std::size_t>(id)];
}

Vec3 integerPoint(Random& random, int reach)
{
  return { static_cast<double>(random.integer(-reach, reach)),
    static_cast<double>(random.integer(-reach, reach)),
    static_cast<double>(random.integer(-reach, reach)) };
}

// Of the 26 directions of a grid, not of unit length; or, if allowed, the zero vector.
Vec3 integerNormal(Random& random, bool zeroToo)
{
  Vec3 normal = integerPoint(random, 1);
  while (!zeroToo && dot(normal, normal) == 0.0)
  {
    normal = integerPoint(random, 1);
  }
  return normal;
}

Vec3 randomPoint(Random& random, double reach)
{
  return { random.uniform(-reach, reach), random.uniform(-reach, reach),
    random.uniform(-reach, reach) };
}

// Triangles between few points: every edge has many faces, some of them with a corner twice.
Mesh soup(Random& random, bool integers)
{
  MeshBuilder mesh;
  const bool zeroNormals = random.chance(0.5);
  const int points = random.integer(3, 12);
  for (int i = 0; i < points; ++i)
  {
    Vec3 normal;
    random.direction(normal.data());
    if (integers)
    {
      normal = integerNormal(random, zeroNormals);
    }
    mesh.addPoint(integers ? integerPoint(random, 2) : randomPoint(random, 1.0), normal);
  }
  const int triangles = random.integer(1, 40);
  for (int i = 0; i < triangles; ++i)
  {
    mesh.addTriangle(
      random.integer(0, points - 1), random.integer(0, points - 1), random.integer(0, points - 1));
  }
  return mesh.build();
}

// Normals that have nothing to do with the surface: every sign pattern, everywhere.
Mesh scrambledNormals(vtkPolyData* surface, Random& random)
{
  MeshBuilder mesh = opening(surface);
  mesh.Normals.resize(mesh.Points.size());
  const bool zeroNormals = random.chance(0.5);
  for (Vec3& normal : mesh.Normals)
  {
    normal = integerNormal(random, zeroNormals);
  }
  return mesh.build();
}

// Every corner its own point and normal: each edge is a crease, with all crossings different.
Mesh scrambledCorners(vtkPolyData* surface, Random& random)
{
  MeshBuilder mesh = opening(facetted(surface));
  for (Vec3& normal : mesh.Normals)
  {
    Vec3 noise;
    random.direction(noise.data());
    normal = normalized(normal + random.uniform(0.0, 2.0) * noise);
  }
  return mesh.build();
}

Mesh withExtraTriangles(vtkPolyData* surface, Random& random)
{
  MeshBuilder mesh = opening(surface);
  const int extra = random.integer(1, 10);
  const int last = static_cast<int>(mesh.pointCount()) - 1;
  for (int i = 0; i < extra; ++i)
  {
    mesh.addTriangle(random.integer(0, last), random.integer(0, last), random.integer(0, last));
  }
  return mesh.build();
}

Mesh smallSmoothMesh(Random& random, std::uint64_t seed)
{
  switch (random.integer(0, 4))
  {
    case 0:
      return sphere(random.integer(2, 8), random.integer(3, 12), seed);
    case 1:
      return icosphere(random.integer(0, 2), seed);
    case 2:
      return ellipsoid(random.integer(2, 8), random.integer(3, 12), seed);
    case 3:
      return torus(random.integer(3, 16), random.integer(3, 8), seed);
    default:
      return starShaped(random.integer(1, 2), seed, random.uniform(0.0, 0.3));
  }
}

std::array<double, 4> integerLight(const MeshBuilder& mesh, Random& random)
{
  switch (random.integer(0, 3))
  {
    case 0: // along an axis
    {
      std::array<double, 4> light{ 0.0, 0.0, 0.0, 0.0 };
      light[static_cast<std::size_t>(random.integer(0, 2))] = random.chance(0.5) ? 1.0 : -1.0;
      return light;
    }
    case 1: // on a vertex
    {
      const Vec3& p = pointOf(mesh, random.integer(0, static_cast<int>(mesh.pointCount()) - 1));
      return { p[0], p[1], p[2], 1.0 };
    }
    case 2: // a direction
    {
      const Vec3 p = integerPoint(random, 2);
      return { p[0], p[1], p[2] == 0.0 && p[0] == 0.0 && p[1] == 0.0 ? 1.0 : p[2], 0.0 };
    }
    default: // a point, of any w
    {
      const Vec3 p = integerPoint(random, 5);
      return { p[0], p[1], p[2], random.chance(0.2) ? 2.0 : 1.0 };
    }
  }
}

std::array<double, 4> anyLight(const MeshBuilder& mesh, Random& random)
{
  switch (random.integer(0, 5))
  {
    case 0: // a direction
    {
      Vec3 d;
      random.direction(d.data());
      return { d[0], d[1], d[2], 0.0 };
    }
    case 1: // in a triangle's plane, as well as doubles can say
    {
      const auto& cell = mesh.Cells[static_cast<std::size_t>(
        random.integer(0, static_cast<int>(mesh.Cells.size()) - 1))];
      const Vec3 a = pointOf(mesh, cell[0]);
      const Vec3 p = a + random.uniform(-3.0, 3.0) * (pointOf(mesh, cell[1]) - a) +
        random.uniform(-3.0, 3.0) * (pointOf(mesh, cell[2]) - a);
      return { p[0], p[1], p[2], 1.0 };
    }
    case 2: // anywhere inside the bounds
    {
      const Vec3 p = randomPoint(random, 0.8);
      return { p[0], p[1], p[2], 1.0 };
    }
    case 3: // far
    {
      Vec3 d;
      random.direction(d.data());
      const double distance = std::pow(10.0, random.uniform(3.0, 9.0));
      return { distance * d[0], distance * d[1], distance * d[2], 1.0 };
    }
    case 4:
      return integerLight(mesh, random);
    default: // near
    {
      Vec3 d;
      random.direction(d.data());
      const double distance = random.uniform(1.1, 10.0);
      return { distance * d[0], distance * d[1], distance * d[2], 1.0 };
    }
  }
}
}

RandomMesh randomMesh(std::uint64_t seed)
{
  Random random(seed);
  // 0 would ask for meshes without jitter.
  const std::uint64_t meshSeed = seed + 1;
  RandomMesh drawn;
  switch (random.integer(0, 15))
  {
    case 0:
    case 1:
      drawn.Kind = "smooth";
      drawn.Closed = true;
      drawn.Surface = smallSmoothMesh(random, meshSeed);
      break;
    case 2:
      drawn.Kind = "integer box";
      drawn.Closed = drawn.Exact = true;
      drawn.Surface = box(random.integer(1, 3), random.integer(1, 3), random.integer(1, 3));
      break;
    case 3:
      drawn.Kind = "cylinder";
      drawn.Closed = true;
      drawn.Surface = cylinder(random.integer(3, 16), random.integer(1, 3));
      break;
    case 4:
      drawn.Kind = "soup";
      drawn.Surface = soup(random, false);
      break;
    case 5:
    case 6:
      drawn.Kind = "integer soup";
      drawn.Exact = true;
      drawn.Surface = soup(random, true);
      break;
    case 7:
      drawn.Kind = "voxels";
      drawn.Closed = drawn.Exact = true;
      drawn.Surface = voxels(random.integer(1, 4), meshSeed);
      break;
    case 8:
      drawn.Kind = "voxels with scrambled normals";
      drawn.Closed = drawn.Exact = true;
      drawn.Surface = scrambledNormals(voxels(random.integer(1, 3), meshSeed), random);
      break;
    case 9:
      drawn.Kind = "opened";
      drawn.Surface = opened(smallSmoothMesh(random, meshSeed), random.uniform(0.02, 0.6), seed);
      break;
    case 10:
      drawn.Kind = "misoriented";
      drawn.Surface =
        misoriented(smallSmoothMesh(random, meshSeed), random.uniform(0.02, 0.6), seed);
      break;
    case 11:
      drawn.Kind = "degenerate";
      drawn.Surface =
        degenerated(smallSmoothMesh(random, meshSeed), random.uniform(0.02, 0.6), seed);
      break;
    case 12:
      drawn.Kind = "duplicates";
      drawn.Surface =
        duplicated(smallSmoothMesh(random, meshSeed), random.uniform(0.02, 1.0), seed);
      break;
    case 13:
      drawn.Kind = "non-manifold";
      drawn.Surface = withExtraTriangles(smallSmoothMesh(random, meshSeed), random);
      break;
    case 14:
      drawn.Kind = "scrambled corners";
      drawn.Closed = true;
      drawn.Surface = scrambledCorners(smallSmoothMesh(random, meshSeed), random);
      break;
    default:
      drawn.Kind = "several parts";
      drawn.Surface = merged({ smallSmoothMesh(random, meshSeed),
        opened(smallSmoothMesh(random, meshSeed + 1), 0.2, seed),
        moved(smallSmoothMesh(random, meshSeed + 2), 0.5, { 1.0, 0.5, 0.25 }) });
      break;
  }
  const MeshBuilder mesh = opening(drawn.Surface);
  if (mesh.Cells.empty())
  {
    drawn.Light = { 0.0, 0.0, 1.0, 0.0 };
    return drawn;
  }
  drawn.Light = drawn.Exact ? integerLight(mesh, random) : anyLight(mesh, random);
  if (!mesh.Normals.empty() && random.chance(0.15))
  {
    drawn.Kind += " without normals";
    drawn.Surface = withoutNormals(drawn.Surface);
  }
  return drawn;
}
}
