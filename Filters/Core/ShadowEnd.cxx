#include "ShadowEnd.h"

namespace shadow
{
Vec4 ShadowEnd::of(const Vec3& point, const Light& light) const
{
  const Vec4 ray = light.extrude(point);
  switch (this->extent)
  {
    case Extent::Length:
      return Vec4(point + this->length * unitOrZero(Vec3(ray)), 1.0);
    case Extent::Plane:
    {
      const double t = this->placeOfPlane(point, light);
      return Vec4(t > 0.0 && std::isfinite(t) ? point + t * Vec3(ray) : point, 1.0);
    }
    default:
      return ray;
  }
}

/// From a light in l the ray is l + (1 + w t) (p - l): behind the light for w t < -1.
bool ShadowEnd::reachesPlane(const Vec3& point, const Light& light) const
{
  const double t = this->placeOfPlane(point, light);
  return std::isfinite(t) && (t >= 0.0 || light.w * t > -1.0);
}
}
