/// Where the walls of a shadow volume begin, and what joins that to the mesh.
#pragma once

#include "ShadowVolume.h"

namespace shadow
{
/// A closed line along which walls begin.
struct VolumeRim
{
  std::vector<Index> points; ///< of the volume; no two neighbours are the same
  int multiplicity;
};

/// Makes a rim of each loop of a silhouette. The volume must hold the mesh's points, by node
/// number; further points, gaps, and caps in front of concave contours are appended to it.
///
/// A smooth contour lies off the mesh; gaps fill what is between. Where it is concave (see
/// ConcaveContour) the rim stays on the mesh: lifted off it, or with a triangle in front of it that
/// faces away from the light, walls would pass over a mesh that sags, and light get in under them.
/// So it is the chord there and, around a triangle that is turned away, the lit part's other sides;
/// that part becomes cap, unless `withCaps` is false.
std::vector<VolumeRim> buildRims(const Caster& caster, const SilhouetteChain& chain,
  const SilhouetteInput& silhouette, bool withCaps, ShadowVolume& volume);
}
