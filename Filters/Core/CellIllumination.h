/// What of a receiver's cells the light reaches.
#pragma once

#include "HiddenContours.h"
#include "LitRegions.h"
#include "ReceiverCells.h"

namespace shadow
{
/// Of each cell that was not cut further; of others nothing is said. A ray from its middle tells,
/// unless it meets nothing but what is around segments of silhouettes. Then the contours at the
/// cell's rim tell, by the sides that they have on it, or else the nearest cell that is known and
/// can be reached without crossing a contour or a caster; if there is none it is in shadow.
/// Without blockers all that faces the light is lit.
std::vector<Illumination> illuminate(const ReceiverCells& cells, const ReceiverView& receiver,
  const ContourBlockers* blockers, const RangeLoop& loop);

/// Of a polygon, as its triangle is wound: normal, twice its area long.
Vec3 areaNormal(const std::vector<CellSide>& sides, const CellEdges& edges);
}
