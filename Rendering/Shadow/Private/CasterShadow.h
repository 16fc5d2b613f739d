/**
 * The shadow of all that may be in a box, as a convex body.
 *
 * It is the hull of the box and of the rays that go on from its corners c away from the light l,
 * with directions r = w c - l. A point light outside of the box: every point of the hull is
 * l + s (z - l), s >= 1, z in the box, so the hull is the shadow of the full box and no more. A
 * light inside: all of space.
 *
 * A plane bounds it if all corners are on its positive side and no r points to the other one. Faces
 * of the hull are those faces of the box that are turned to the light (or seen edge-on from it),
 * and planes through the light and an edge of the box that have the whole box on one side.
 */
#ifndef CasterShadow_h
#define CasterShadow_h

#include "BoxGeometry.h"

#include <array>
#include <cstddef>

class CasterShadow
{
public:
  /**
   * `light` is homogeneous.
   */
  CasterShadow(const Point4& light, const BoxCorners& caster);

  /**
   * True only if a plane of the shadow, or across an axis, separates it from bounds in VTK's order,
   * so never if they meet. Separations that only planes along two edges show are not found.
   */
  bool Misses(const std::array<double, 6>& bounds) const;

private:
  void AddPlane(const Point3& normal);

  Point4 Light;
  BoxCorners Caster;
  BoxCorners Rays;

  /**
   * The largest coordinate that takes part, for the roundings.
   */
  double Reach = 0.0;

  /**
   * Relative to what reaches farthest: by how much bounds have to be beyond a plane. Infinite if
   * the light is in the box.
   */
  double Margin = 0.0;

  std::array<double, 6> Bounds{};
  std::array<Point4, 18> Planes{};
  std::size_t NumberOfPlanes = 0;
};

#endif
