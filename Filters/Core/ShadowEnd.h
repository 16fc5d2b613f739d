/// Where a point's shadow ends.
#pragma once

#include "Geometry.h"

namespace shadow
{
enum class Extent
{
  Infinite, ///< at infinity
  Length,   ///< at a length from the point
  Plane     ///< on a plane; a point that is beyond it is its own end
};

struct ShadowEnd
{
  Extent extent = Extent::Infinite;
  double length = 0.0;   ///< Length: world units
  Vec3 planeOrigin{ 0.0 };
  Vec3 planeNormal{ 0.0, 0.0, 1.0 }; ///< any length but zero, either side

  /// Homogeneous, w = 1, or w = 0 at infinity. A ray that does not come to the plane ends at its
  /// point: such rays are to be refused.
  Vec4 of(const Vec3& point, const Light& light) const;

  /// Whether a point's ray comes to the plane, or came through it before the point.
  bool reachesPlane(const Vec3& point, const Light& light) const;

private:
  /// The plane is at point + t ray, with the ray away from the light as extrude gives it.
  double placeOfPlane(const Vec3& point, const Light& light) const
  {
    return glm::dot(this->planeNormal, this->planeOrigin - point) /
      glm::dot(this->planeNormal, Vec3(light.extrude(point)));
  }
};
}
