/// Loops as polylines within a tolerance of their curves.
#pragma once

#include "Caster.h"
#include "ShadowReceiver.h"
#include "SilhouetteLoops.h"
#include "SmoothContour.h"

namespace shadow
{
/// Where the polylines' points are written to, loop after loop, each loop's first point not
/// repeated.
struct PolylineArrays
{
  Vec3* points;
  Vec3* meshPoints; ///< the points of the mesh that belong to them; null: not wanted
  Vec3* normals;    ///< unit length where the mesh's are; null: not wanted
};

/// What else there is to say of them.
struct LoopPolylines
{
  std::vector<Index> nodes;       ///< node of each point, None between nodes
  std::vector<std::size_t> first; ///< where each loop begins, and the end
  Deviation deviation;            ///< bound on the distance between curves and polylines
};

/// What a tolerance is measured by.
struct PolylineTolerance
{
  double length = 0.0;                      ///< world units
  const ShadowReceiver* receiver = nullptr; ///< where the shadow's deviation is meant
};

/// Subdivides each piece's curve until it is within the tolerance, or within a few roundings of the
/// coordinates. allocate(count) gives room for so many points.
LoopPolylines makePolylines(const Caster& caster, const SilhouetteChain& chain,
  const SilhouetteLoops& loops, const PolylineTolerance& tolerance, const RangeLoop& loop,
  const std::function<PolylineArrays(std::size_t count)>& allocate);
}
