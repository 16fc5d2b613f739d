#include "CasterShadow.h"

#include <algorithm>
#include <limits>

using namespace PointArithmetic;

namespace
{
/**
 * Relative to the terms: some thousand roundings. What is nearer than that counts as met.
 */
constexpr double Rounding = 0x1p-40;

constexpr double Infinity = std::numeric_limits<double>::infinity();
}

CasterShadow::CasterShadow(const Point4& light, const BoxCorners& caster)
  : Light(light)
  , Caster(caster)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Reach = std::max(this->Reach, light[3] != 0.0 ? std::abs(light[axis] / light[3]) : 0.0);
    double lower = Infinity;
    double upper = -Infinity;
    for (std::size_t i = 0; i < 8; ++i)
    {
      const double ray = light[3] * caster[i][axis] - light[axis];
      this->Rays[i][axis] = ray;
      lower = std::min(lower, ray < 0.0 ? -Infinity : caster[i][axis]);
      upper = std::max(upper, ray > 0.0 ? Infinity : caster[i][axis]);
      this->Reach = std::max(this->Reach, std::abs(caster[i][axis]));
    }
    this->Bounds[2 * axis] = lower;
    this->Bounds[2 * axis + 1] = upper;
  }

  double distance = 0.0;
  for (const BoxFace& face : BoxFaces)
  {
    const Point4 plane = FacePlane(caster, face);
    const Point3 normal = { plane[0], plane[1], plane[2] };
    const double length = Length(normal);
    if (length > 0.0)
    {
      distance = std::max(distance, -Height(plane, light) / length);
    }
    this->AddPlane(normal);
  }
  // Roundings of a plane through the light grow with the distance from it.
  this->Margin = light[3] == 0.0 ? Rounding
    : distance > 0.0             ? Rounding * std::max(1.0, this->Reach * light[3] / distance)
                                 : Infinity;
  for (const auto& [from, to] : BoxEdges)
  {
    const Point3& begin = caster[static_cast<std::size_t>(from)];
    const Point3& end = caster[static_cast<std::size_t>(to)];
    const Point3 normal = Cross(end - begin, this->Rays[static_cast<std::size_t>(from)]);
    const Point4 plane = PlaneThrough(begin, normal);
    double sum = 0.0;
    for (const Point3& corner : caster)
    {
      sum += Height(plane, corner);
    }
    this->AddPlane(sum < 0.0 ? Point3{} - normal : normal);
  }
}

/**
 * Takes it only if it bounds the shadow. It is moved out to all corners, as its own may be off by
 * roundings.
 */
void CasterShadow::AddPlane(const Point3& normal)
{
  const double length = Length(normal);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return;
  }
  double lowest = Infinity;
  const Point3 unit = { normal[0] / length, normal[1] / length, normal[2] / length };
  for (std::size_t i = 0; i < 8; ++i)
  {
    // Rays in the plane point to either side by roundings.
    const double toward = Dot(unit, this->Rays[i]);
    const double rounding = 8.0 * 0x1p-52 *
      (this->Light[3] != 0.0 ? this->Light[3] * this->Reach : Length(this->Rays[i]));
    if (!(toward >= -rounding))
    {
      return;
    }
    lowest = std::min(lowest, Dot(unit, this->Caster[i]));
  }
  this->Planes[this->NumberOfPlanes++] = { unit[0], unit[1], unit[2], -lowest };
}

bool CasterShadow::Misses(const std::array<double, 6>& bounds) const
{
  double reach = this->Reach;
  for (const double bound : bounds)
  {
    reach = std::max(reach, std::abs(bound));
  }
  const double margin = this->Margin * reach;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (bounds[2 * axis + 1] + margin < this->Bounds[2 * axis] ||
      bounds[2 * axis] - margin > this->Bounds[2 * axis + 1])
    {
      return true;
    }
  }
  for (std::size_t i = 0; i < this->NumberOfPlanes; ++i)
  {
    const Point4& plane = this->Planes[i];
    double highest = plane[3];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      highest += plane[axis] * bounds[2 * axis + (plane[axis] > 0.0 ? 1 : 0)];
    }
    if (highest < -margin)
    {
      return true;
    }
  }
  return false;
}
