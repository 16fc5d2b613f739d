/// Receivers split into what a light reaches and what it does not.
#pragma once

#include "CastContour.h"

namespace shadow
{
enum class Illumination : std::uint8_t
{
  Lit,
  Shadowed,  ///< faces the light, but something is in between
  TurnedAway ///< faces away from it, or is edge-on to it
};

/// A point by its place on the receiver.
struct RegionPoint
{
  Vec3 place;
  Triangle vertices; ///< of the receiver, that it lies between; None where fewer do
  Vec3 weights;      ///< of each, of sum 1; 0 where there is none
};

/// Convex polygons that cover a receiver, in the order of its triangles and wound as these. Two
/// polygons that meet have all points on what they share in common, so some have points in the
/// middle of straight sides.
struct LitRegions
{
  std::vector<RegionPoint> points;     ///< the receiver's vertices first
  std::vector<std::size_t> first{ 0 }; ///< where each polygon's corners begin, and the end
  std::vector<Index> corners;
  std::vector<Index> triangles; ///< that each polygon is of
  std::vector<Illumination> illumination;
  std::array<double, 3> areas{}; ///< of each illumination
};

/// Of each receiver. Triangles that face the light are cut along the visible contours and where
/// casters meet them; so what remains is all lit or all in shadow, and a ray from its middle tells.
/// Near silhouettes that are not made of edges, which lie within their own mesh's shadow, the side
/// of the nearest contour does.
///
/// None where the light is on a silhouette (the report says so). Same bytes whatever the threads.
std::vector<LitRegions> findLitRegions(
  const ContourScene& scene, TreeBuilder builder, const RangeLoop& loop, ContourReport& report);
}
