/**
 * The cone that a spotlight lights.
 */
#ifndef LightCone_h
#define LightCone_h

#include "BoxGeometry.h"

struct PlanLight
{
  /**
   * Homogeneous; w = 0: the direction towards the light.
   */
  Point4 Position{};

  /**
   * Unit vector of the cone's axis, from the light.
   */
  Point3 Direction{};

  /**
   * Between the axis and the cone's side, in degrees; from 90 on there is no cone.
   */
  double ConeAngle = 180.0;
};

/**
 * Whether a box has no point in the light's cone, which then has none of its shadow either; false
 * for a light without cone.
 *
 * Exact, but for a hair by which the cone is widened because shaders find its border in single
 * precision: a convex cone that meets a box either meets an edge of it, or cuts a face in a closed
 * curve within, through which its axis passes. On an edge p + t q (from the apex) the cone's
 * |p + t q| cos - axis.(p + t q) is convex in t and has its minimum in closed form.
 */
bool IsOutsideCone(const PlanLight& light, const BoxCorners& box);

#endif
