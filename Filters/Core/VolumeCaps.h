/// The near cap of a shadow volume: whole triangles of the mesh, and parts of the mixed ones.
#pragma once

#include "ShadowVolume.h"

namespace shadow
{
/// The lit or the dark part of a triangle that the silhouette crosses, counter-clockwise over the
/// chain's nodes, with every crossing on its edges, those of the other sides too, so that
/// neighbours share all points.
std::vector<Index> partOfTriangle(
  const Caster& caster, const SilhouetteChain& chain, Index triangle, bool lit);

/// Appends the cap's triangles over the chain's nodes. Its boundary is the chain's pieces.
void addCaps(const Caster& caster, const SilhouetteChain& chain, CapSide side,
  std::vector<VolumeTriangle>& triangles);
}
