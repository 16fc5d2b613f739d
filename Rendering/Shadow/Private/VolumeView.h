/**
 * What of a shadow volume the camera sees, and where.
 */
#ifndef VolumeView_h
#define VolumeView_h

#include "BoxGeometry.h"

#include <array>

/**
 * What the camera sees, and how many pixels it is drawn in.
 */
struct ShadowView
{
  Matrix4 WorldToClip{};
  int Width = 0;
  int Height = 0;
};

/**
 * The hull of a caster's box and of the ends of its corners' rays, in clip coordinates.
 *
 * The place x + t r on the ray of x (r = w x - l, l the homogeneous light) is written as the
 * homogeneous (x, 1) - s l, s = t / (1 + t w), which is its 1 / (1 + t w) fold. A step d of x makes
 * one of d (1 + t w) there, so the fourth coordinate, 1 - s w, is one over the magnification; and
 * the hull of such points over all x in the box and all s up to the end plane is that of the 16
 * points of the corners, as both are linear.
 */
class VolumeView
{
public:
  /**
   * `end` as CasterPlan::End.
   */
  VolumeView(
    const ShadowView& view, const Point4& light, const BoxCorners& caster, const Point4& end);

  /**
   * False only if a plane of the view's pyramid has all of the volume on its outer side.
   */
  bool IsSeen() const;

  /**
   * The pixels that it can cover: left, lower, width, height.
   */
  std::array<int, 4> FindScissor() const;

  /**
   * The window depths, 0 to 1, that points of it can have.
   *
   * With a margin of 16 steps of 24 bits on either side: walls are drawn 4 steps behind where they
   * are and caps 1 step (offsets of (0, 4) and (1, 1); the part of a cap's that grows with its
   * slope needs no room, as it leaves surfaces at the cap where they are, in the range), the rest
   * is for the roundings of stored depths; and of 2^-21 of the terms that a point's depth is the
   * sum of, as shaders add these up in single precision.
   */
  std::array<double, 2> FindDepthRange() const;

  /**
   * See CasterPlan::Pixel.
   *
   * A step d at a visible place of clip weight W moves it on the screen by at most K d / (W - e d)
   * pixels: e is the length of the gradient g of W, and K the greatest singular value of the two
   * rows width / 2 (gradient of clip x - a g), height / 2 (gradient of clip y - b g) for any a and
   * b in [-1, 1], which is at a corner of the window. That is a pixel or less if (K + e) d <= W.
   * With the magnification m the caster's step may be W / m / (K + e), and W / m is the fourth clip
   * coordinate of the points above: linear on the hull. Its minimum over what is in view is bounded
   * from below by the greatest of those over what is on the inner side of one of the pyramid's
   * planes, at a time: there it is attained where edges between the 16 points cut the plane.
   */
  double FindPixel() const;

private:
  /**
   * How far a point is on the inner side of a plane of the pyramid.
   */
  static double Inside(const Point4& point, std::size_t plane);
  double LeastWeightInside(std::size_t plane) const;
  double PixelsPerLength() const;

  ShadowView View;
  std::array<Point4, 16> Points;

  /**
   * The last 8 points are one and the same direction, that may be added any number of times.
   */
  bool EndsInDirection = false;

  /**
   * For each point the sum of the sizes of the terms of its depth and weight.
   */
  std::array<double, 16> Terms;

  /**
   * Below which points of the volume are not told apart as it is drawn.
   */
  double Resolution = 0.0;
};

#endif
