/// The shadow volume of a caster: caps, gaps, walls and far cap as one closed chain of triangles.
#pragma once

#include "NearEnd.h"
#include "ShadowEnd.h"

namespace shadow
{
/// The walls along a loop as one strip of triangles: a loop's point, where its shadow ends, the
/// next point, and so on around; the first two come again at the end.
struct WallStrip
{
  std::vector<Index> points;
  int multiplicity;
};

struct ShadowVolume
{
  std::vector<Vec4> points; ///< homogeneous, w = 1, or w = 0 at infinity
  std::vector<VolumeTriangle> triangles;
  std::vector<WallStrip> strips; ///< if wanted: of long loops, which then have no wall triangles
  /// For each point at which shadows end the point whose shadow ends there; None for those that
  /// belong to no single one. firstEnd + i is the point of origin[i].
  std::size_t firstEnd = 0;
  std::vector<Index> origin;
  int greatestDepth = 0;     ///< how often it winds around a point at most, see VolumeDepth
  std::size_t unreached = 0; ///< points whose rays do not come to the plane they should end on
};

struct VolumeSettings
{
  ShadowEnd end;
  bool wallStrips = false; ///< not to infinity in a direction, where walls have one point in common
};

/// Extrudes to where the shadow is to end. The sum of all directed edges, with multiplicity, is
/// zero unless caps are left out, or pieces of the silhouette missing.
///
/// A finite volume's far cap is its near cap and gaps, moved to where their shadows end.
///
/// To infinity walls are quads for a point light and triangles for a directional one, all of whose
/// shadows end at one point there; only a point light has a far cap. With the light outside the
/// ball around the caster this is a fan at infinity, otherwise all of the near cap is projected
/// there: then it covers the sphere at infinity as often as the light is enclosed by the caster.
ShadowVolume extrude(const NearEnd& near, const VolumeSettings& settings);

/// What a finite, closed volume encloses, as often as it winds around it. By the divergence theorem
/// about `centre`, which should be near.
double enclosedVolume(const ShadowVolume& volume, const Vec3& centre);
}
