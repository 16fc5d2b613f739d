/**
 * What is to be done for each light and each caster, decided from bounds alone: no OpenGL, no meshes.
 */
#ifndef ShadowPlan_h
#define ShadowPlan_h

#include "Matrix4.h"

#include <array>
#include <string>

using Point3 = std::array<double, 3>;
using Point4 = std::array<double, 4>;

/**
 * The corners of a box, which may have been turned and sheared.
 */
using BoxCorners = std::array<Point3, 8>;

/**
 * The corners of bounds in VTK's order (xmin, xmax, ymin, ...), moved by a matrix.
 */
BoxCorners CornersOf(const std::array<double, 6>& bounds, const Matrix4& toWorld);

/**
 * What the camera sees, and how many pixels it is drawn in.
 */
struct ShadowView
{
  Matrix4 WorldToClip{};
  int Width = 0;
  int Height = 0;
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
};

struct CasterPlan
{
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

  std::string Decision;
  std::string Reason;
};

/**
 * The plan of a frame. Lights are homogeneous, everything is in world coordinates.
 */
class ShadowPlan
{
public:
  /**
   * `receivers` holds all that a shadow can fall on; unbounded ones make it invalid (lower above
   * upper), and all volumes infinite then.
   */
  ShadowPlan(const ShadowView& view, const std::array<double, 6>& receivers, const ShadowRules& rules);

  /**
   * Whether the shadow of what lies in a box comes into view at all.
   */
  bool IsSeen(const Point4& light, const BoxCorners& caster) const;

  /**
   * How to count the volume of what lies in a box.
   */
  CasterPlan Decide(const Point4& light, const BoxCorners& caster) const;

private:
  using Volume = std::array<Point4, 16>;

  Volume VolumeOf(const Point4& light, const BoxCorners& caster, const Point4& end) const;
  Point4 FindEnd(const Point4& light, const BoxCorners& caster) const;
  bool NearPlaneIsFree(const Point4& light, const BoxCorners& caster) const;
  std::array<int, 4> FindScissor(const Volume& volume) const;

  ShadowView View;
  std::array<double, 6> Receivers;
  ShadowRules Rules;
  std::array<Point3, 4> NearCorners;
  bool NearIsKnown = false;
};

#endif
