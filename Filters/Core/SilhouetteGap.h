/// What is seen between a mesh and its smooth silhouette.
#pragma once

#include "NearEnd.h"

namespace shadow
{
/// Triangles with normals, counter-clockwise as seen from the light, or from an eye there.
struct SilhouetteGap
{
  std::vector<Vec3> points;
  std::vector<Vec3> normals; ///< of the smooth surface, outwards; unit, or zero where none is known
  std::vector<Triangle> triangles;
};

/// The near end's gaps that face the light. Cap and gaps have the rims as their boundary: where
/// these wind around a ray to the light at least once, one of them is met from its front. So the
/// mesh and these triangles cover all that the rims enclose as seen from the light. Gaps that face
/// away lie where the silhouette runs inside of the mesh's outline.
///
/// `normals` are those of the silhouette's points. Costs in proportion to the silhouette.
SilhouetteGap makeSilhouetteGap(
  const NearEnd& end, const SilhouetteInput& silhouette, const std::vector<Vec3>& normals);
}
