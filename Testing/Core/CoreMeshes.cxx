#include "CoreMeshes.h"

namespace coretest
{
using namespace shadow;

TriangleMesh cube()
{
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
  {
    mesh.points.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  }
  mesh.triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  return mesh;
}

TriangleMesh onSphere(const std::vector<Vec3>& places, const std::vector<Triangle>& triangles)
{
  TriangleMesh mesh;
  for (const Vec3& p : places)
  {
    mesh.normalVertex.push_back(static_cast<Index>(mesh.points.size()));
    mesh.points.push_back(glm::normalize(p));
  }
  mesh.normals = mesh.points;
  mesh.triangles = triangles;
  mesh.cornerNormals = triangles;
  return mesh;
}
}
