/// The near cap of a shadow volume: whole triangles of the mesh, and parts of the mixed ones.
#pragma once

#include "ShadowVolume.h"

namespace shadow
{
/// Appends the cap's triangles over the chain's nodes. Its boundary is the chain's pieces.
void addCaps(const Caster& caster, const SilhouetteChain& chain, CapSide side,
  std::vector<VolumeTriangle>& triangles);
}
