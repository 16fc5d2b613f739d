/// How strokes are seen: from where, and what a unit of their width is at a point.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// An eye, homogeneous as a light is. In pixels widths are measured in a picture: in planes at
/// right angles to the direction of projection; in world units at right angles to each line of
/// sight.
struct StrokeView
{
  Light eye;
  bool inPixels = false;
  Vec3 projection{ 0.0, 0.0, -1.0 }; ///< unit; in pixels only
  double pixelSize = 1.0; ///< world units in a pixel, at distance 1 along the projection if w = 1

  /// From the eye to a point, not normalised.
  Vec3 ray(const Vec3& point) const { return -this->eye.toward(point); }

  /// The unit normal, towards the eye, of the plane in which widths are measured at a point. Zero
  /// in the eye.
  Vec3 facing(const Vec3& point) const
  {
    return this->inPixels ? -this->projection : unitOrZero(this->eye.toward(point));
  }

  /// World units in a unit of width; not above zero in pixels for what is not before the eye.
  double unit(const Vec3& point) const
  {
    if (!this->inPixels)
    {
      return 1.0;
    }
    return this->eye.isDirectional()
      ? this->pixelSize
      : this->pixelSize * glm::dot(this->projection, this->ray(point));
  }

  /// To the left of a line as it is seen, in the plane of widths: unit, or zero for a line of
  /// sight. Along a straight line it is the same for all points.
  Vec3 left(const Vec3& point, const Vec3& tangent) const
  {
    const Vec3 normal = glm::cross(tangent, this->ray(point));
    return unitOrZero(
      this->inPixels ? normal - glm::dot(normal, this->projection) * this->projection : normal);
  }

  /// How long the way to another point is seen, in the plane of widths at the first one: 0 if the
  /// other one is not before the eye.
  double seenLength(const Vec3& from, const Vec3& to) const
  {
    const Vec3 forward = -this->facing(from);
    const Vec3 ray = this->ray(from);
    const double depth = glm::dot(ray, forward);
    if (this->eye.isDirectional())
    {
      const Vec3 way = to - from;
      return glm::length(way - glm::dot(way, forward) / depth * ray);
    }
    const Vec3 other = this->ray(to);
    const double otherDepth = glm::dot(other, forward);
    return otherDepth > 0.0 ? glm::length(depth / otherDepth * other - ray) : 0.0;
  }
};
}
