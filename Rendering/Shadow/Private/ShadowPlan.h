/**
 * What is to be done for each light and each caster, decided from bounds alone: no OpenGL, no
 * meshes.
 */
#ifndef ShadowPlan_h
#define ShadowPlan_h

#include "BoxGeometry.h"
#include "LightCone.h"
#include "VolumeView.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

/**
 * In world coordinates, bounds in VTK's order.
 */
struct PlanReceivers
{
  /**
   * Of each prop that can show a shadow.
   */
  std::vector<std::array<double, 6>> Bounds;

  /**
   * False if something that is visible has no bounds: volumes are infinite then, and no caster is
   * left out for want of receivers.
   */
  bool Bounded = true;

  /**
   * Of all that is visible; lower above upper if nothing is.
   */
  std::array<double, 6> AllBounds{ 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
};

enum class CountingMethod
{
  Automatic,
  ZPass,
  ZFail
};

/**
 * Rules that may be forced off. The picture stays the same, only the time changes.
 */
struct ShadowRules
{
  CountingMethod Counting = CountingMethod::Automatic;
  bool SkipUnseen = true;
  bool FiniteVolumes = true;
  bool Scissor = true;
  bool SkipOutsideCones = true;
  bool SkipWithoutReceivers = true;
  bool DepthBounds = true;
};

struct CasterPlan
{
  /**
   * There is nothing to draw, for the given reason.
   */
  bool Skip = false;

  /**
   * From the eye to the surface instead of from the surface to infinity.
   */
  bool ZPass = false;

  /**
   * The plane on which the volume ends, positive on the receivers' side; all zero if it ends at
   * infinity.
   */
  Point4 End{};

  /**
   * The pixels that the volume can cover: left, lower, width, height.
   */
  std::array<int, 4> Scissor{};

  /**
   * The window depths that points of the volume can have, for glDepthBounds: a pixel whose stored
   * depth is outside of it is not in the volume, whichever way it is counted. [0, 1] if the rule is
   * off.
   */
  std::array<double, 2> DepthRange{ 0.0, 1.0 };

  /**
   * A length of the world: the step that a silhouette point of the caster may make, across the
   * light's rays, until its shadow moves by at most one pixel wherever in view that falls, the
   * caster itself included. Infinite if the volume is not in view, else above 0, and never more
   * than that: it may be less by a small factor, the more so where the volume surrounds the eye.
   *
   * What it does not contain is the slant of receivers: a shadow's edge slides along the light's
   * rays by the tangent of the incidence, which depends on the surface that it falls on.
   *
   * It is not finer than the single precision in which volumes are drawn (2^-22 of the caster's
   * size): only there, with the light in or next to the caster, can the shadow move by more.
   */
  double Pixel = std::numeric_limits<double>::infinity();

  std::string Decision;
  std::string Reason;
};

/**
 * The plan of a frame. Everything is in world coordinates.
 *
 * A caster is skipped, in this order, if its box is outside of the light's cone, if no receiver's
 * bounds meet its shadow, or if its volume is outside of the view. Each test asks for a proof (see
 * LightCone, CasterShadow and VolumeView), and without one the caster is drawn.
 */
class ShadowPlan
{
public:
  ShadowPlan(const ShadowView& view, PlanReceivers receivers, const ShadowRules& rules);

  /**
   * What to do for what lies in a box. Takes a microsecond or two, and for casters that lie in no
   * receiver's bounds as many separations as there are receivers.
   */
  CasterPlan Decide(const PlanLight& light, const BoxCorners& caster) const;

private:
  bool SomethingReceives(const Point4& light, const BoxCorners& caster) const;
  Point4 FindEnd(const Point4& light, const BoxCorners& caster) const;
  bool NearPlaneIsFree(const Point4& light, const BoxCorners& caster) const;

  ShadowView View;
  PlanReceivers Receivers;
  ShadowRules Rules;
  std::array<Point3, 4> NearCorners;
  bool NearIsKnown = false;
};

#endif
