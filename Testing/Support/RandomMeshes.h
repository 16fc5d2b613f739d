/**
 * @brief Random hostile meshes, each with a light.
 *
 * Closedness must not depend on anything, so the generator aims at ties and at broken input: small
 * integer coordinates under axis-aligned lights, lights on vertices and in the planes of faces,
 * zero and contradicting normals, duplicates, open, non-manifold and misoriented meshes, soups.
 */
#ifndef shadowtest_RandomMeshes_h
#define shadowtest_RandomMeshes_h

#include "HostileMeshes.h"

#include <array>
#include <cstdint>
#include <string>

namespace shadowtest
{
struct RandomMesh
{
  /// What was drawn, for messages.
  std::string Kind;
  Mesh Surface;
  /// Homogeneous, as in vtkSmoothLightSilhouette.
  std::array<double, 4> Light;
  /// Whether it was built as a closed, consistently wound surface.
  bool Closed = false;
  /// Points and light are small integers: facing fields are computed without rounding.
  bool Exact = false;
};

/// One of all the kinds; the same for the same seed. At most a few hundred triangles.
RandomMesh randomMesh(std::uint64_t seed);
}

#endif
