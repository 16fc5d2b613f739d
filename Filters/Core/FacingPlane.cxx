#include "FacingPlane.h"

namespace shadow
{
namespace
{
template <class PlaneOf>
std::vector<Vec4> allPlanes(std::size_t count, const RangeLoop& loop, const PlaneOf& planeOf)
{
  std::vector<Vec4> planes(count);
  loop(count, lightGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        planes[i] = planeOf(static_cast<Index>(i));
      }
    });
  return planes;
}
}

std::vector<Vec4> facePlanes(const TriangleMesh& mesh, const Ball& ball, const RangeLoop& loop)
{
  return allPlanes(mesh.triangles.size(), loop,
    [&](Index t)
    { return facingPlane(mesh.areaNormal(t), mesh.points[mesh.triangles[t][0]], ball); });
}

std::vector<Vec4> cornerPlanes(const TriangleMesh& mesh, const Ball& ball, const RangeLoop& loop)
{
  return allPlanes(mesh.normals.size(), loop,
    [&](Index n)
    { return facingPlane(mesh.normals[n], mesh.points[mesh.normalVertex[n]], ball); });
}
}
