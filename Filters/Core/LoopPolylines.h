/// Loops as polylines within a tolerance of their curves.
#pragma once

#include "Caster.h"
#include "SilhouetteLoops.h"

namespace shadow
{
/// Points loop after loop, each loop's first point not repeated.
struct LoopPolylines
{
  std::vector<Vec3> points;
  std::vector<Vec3> meshPoints; ///< the points of the mesh that belong to them
  std::vector<Vec3> normals;    ///< unit length where the mesh's are
  std::vector<Index> nodes;     ///< node of each point, None between nodes
  std::vector<std::size_t> first; ///< where each loop begins, and the end
  double maximumDeviation = 0.0;  ///< bound on the distance between curves and polylines
};

/// Subdivides each piece's curve until it is within the tolerance (world units), or within a few
/// roundings of the coordinates.
LoopPolylines makePolylines(const Caster& caster, const SilhouetteChain& chain,
  const SilhouetteLoops& loops, double tolerance, const RangeLoop& loop);
}
