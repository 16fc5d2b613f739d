/// The fields whose sign tells lit from dark, as kernels over ranges.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// normal . (l - w p) for each corner normal at its vertex.
inline void cornerField(const TriangleMesh& mesh, const Light& light, std::size_t begin,
  std::size_t end, double* field)
{
  for (std::size_t n = begin; n < end; ++n)
  {
    field[n] = glm::dot(mesh.normals[n], light.toward(mesh.points[mesh.normalVertex[n]]));
  }
}

/// N . (l - w p) for each triangle, N its area normal and p its first corner.
inline void faceField(const TriangleMesh& mesh, const Light& light, std::size_t begin,
  std::size_t end, double* field)
{
  for (std::size_t t = begin; t < end; ++t)
  {
    field[t] = glm::dot(mesh.areaNormal(static_cast<Index>(t)),
      light.toward(mesh.points[mesh.triangles[t][0]]));
  }
}
}
