#include "VertexNormals.h"

#include "DisjointSets.h"

namespace shadow
{
namespace
{
/// The triangle's unit normal times the angle at one of its corners.
Vec3 weightedNormal(const TriangleMesh& mesh, Index triangle, unsigned corner)
{
  const Triangle& t = mesh.triangles[triangle];
  const Vec3 p = mesh.points[t[corner]];
  const Vec3 u = mesh.points[t[next(corner)]] - p;
  const Vec3 v = mesh.points[t[next(next(corner))]] - p;
  const Vec3 normal = glm::cross(u, v);
  const double area = glm::length(normal);
  return area > 0.0 ? normal * (std::atan2(area, glm::dot(u, v)) / area) : Vec3(0.0);
}

/// Triangles without area have no normal to turn: they never make a crease.
bool isSmooth(const Vec3& n0, const Vec3& n1, double cosine)
{
  const double lengths = glm::length(n0) * glm::length(n1);
  return !(lengths > 0.0) || glm::dot(n0, n1) >= cosine * lengths;
}
}

void estimateCornerNormals(TriangleMesh& mesh, const EdgeTable& edges, double featureAngle)
{
  const double cosine = std::cos(featureAngle);
  DisjointSets corners(3 * mesh.triangles.size());
  for (std::size_t i = 0; i < edges.edges.size(); ++i)
  {
    const Index e = static_cast<Index>(i);
    if (edges.sideCount(e) != 2)
    {
      continue;
    }
    const Side s0 = edges.sides[edges.firstSide(e)];
    const Side s1 = edges.sides[edges.firstSide(e) + 1];
    if (sideSign(mesh, edges, e, s0) == sideSign(mesh, edges, e, s1) ||
      !isSmooth(mesh.areaNormal(s0 / 3), mesh.areaNormal(s1 / 3), cosine))
    {
      continue;
    }
    // The sides run against each other: where one starts the other one ends.
    corners.unite(s0, 3 * (s1 / 3) + next(s1 % 3));
    corners.unite(s1, 3 * (s0 / 3) + next(s0 % 3));
  }

  Index count = 0;
  const std::vector<Index> normalOf = corners.number(count);
  mesh.normals.assign(count, Vec3(0.0));
  mesh.normalVertex.assign(count, None);
  mesh.cornerNormals.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (unsigned k = 0; k < 3; ++k)
    {
      const Index n = normalOf[3 * t + k];
      mesh.cornerNormals[t][k] = n;
      mesh.normalVertex[n] = mesh.triangles[t][k];
      mesh.normals[n] += weightedNormal(mesh, static_cast<Index>(t), k);
    }
  }
  for (Vec3& n : mesh.normals)
  {
    n = unitOrZero(n);
  }
}

void repairNormals(TriangleMesh& mesh)
{
  std::vector<bool> broken(mesh.normals.size());
  bool any = false;
  for (std::size_t n = 0; n < mesh.normals.size(); ++n)
  {
    mesh.normals[n] = unitOrZero(mesh.normals[n]);
    broken[n] = mesh.normals[n] == Vec3(0.0);
    any = any || broken[n];
  }
  if (!any)
  {
    return;
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (unsigned k = 0; k < 3; ++k)
    {
      const Index n = mesh.cornerNormals[t][k];
      if (broken[n])
      {
        mesh.normals[n] += weightedNormal(mesh, static_cast<Index>(t), k);
      }
    }
  }
  for (std::size_t n = 0; n < mesh.normals.size(); ++n)
  {
    if (broken[n])
    {
      mesh.normals[n] = unitOrZero(mesh.normals[n]);
    }
  }
}
}
