// Small meshes as the core takes them.
#ifndef CoreMeshes_h
#define CoreMeshes_h

#include "Geometry.h"

namespace coretest
{
/// The cube [0, 1]^3 of 8 vertices and 12 triangles, wound outwards, without normals.
shadow::TriangleMesh cube();

/// Vertices on the unit sphere at the given places (any length), which triangles join; each
/// vertex's normal is its place.
shadow::TriangleMesh onSphere(
  const std::vector<shadow::Vec3>& places, const std::vector<shadow::Triangle>& triangles);
}

#endif
