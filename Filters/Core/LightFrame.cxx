#include "LightFrame.h"

namespace shadow
{
namespace
{
/// Nearer than this many radii of the scene a light is among it: farther away the cone around the
/// scene is narrow enough for one plane chart. Rounding the centre takes up to 0.22 radii of it.
constexpr double nearRadii = 1.75;

/// Of the coordinate axes the one that a vector is least along.
Vec3 leastAxis(const Vec3& v)
{
  const Vec3 size(std::fabs(v.x), std::fabs(v.y), std::fabs(v.z));
  return size.x <= size.y && size.x <= size.z ? Vec3(1.0, 0.0, 0.0)
    : size.y <= size.z                        ? Vec3(0.0, 1.0, 0.0)
                                              : Vec3(0.0, 0.0, 1.0);
}

/// By a power of two, which keeps all digits, to a size of about 1.
Vec3 scaledToOne(const Vec3& v)
{
  int exponent;
  std::frexp(largestComponent(v), &exponent);
  return Vec3(
    std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent));
}

/// To a number of few digits, so that differences from it do not round what had few digits before.
Vec3 roundedCentre(const Box& bounds, double radius)
{
  int exponent;
  std::frexp(radius, &exponent);
  const double step = std::ldexp(1.0, exponent - 3);
  const Vec3 centre = 0.5 * (bounds.low + bounds.high);
  const Vec3 rounded = step * glm::round(centre / step);
  return isFinite(rounded) ? rounded : centre;
}
}

LightFrame::LightFrame(const Light& light, const Box& bounds)
{
  const double radius = 0.5 * glm::length(bounds.high - bounds.low);
  const Vec3 centre = roundedCentre(bounds, radius);
  const Vec3 toLight =
    light.isDirectional() ? light.position : light.position / light.w - centre;
  const bool isNear = !light.isDirectional() && !(glm::length(toLight) > nearRadii * radius);
  this->Kind = light.isDirectional() ? Kinds::Direction : isNear ? Kinds::Near : Kinds::Far;
  this->Origin = isNear ? light.position / light.w : centre;
  this->Along = scaledToOne(toLight);
  this->Across = glm::cross(leastAxis(this->Along), this->Along);
  this->Up = glm::cross(this->Along, this->Across);
  this->Distance = this->Kind == Kinds::Far ? glm::dot(toLight, this->Along) : 0.0;
  this->Size = radius;
  // Of a few products and sums of a coordinate and an axis, which is shorter than 2, and of what
  // rounding the points' own coordinates may have done.
  const double farthest = largestComponent(
    glm::max(glm::abs(bounds.low - this->Origin), glm::abs(bounds.high - this->Origin)));
  const double coordinates =
    std::max(largestComponent(bounds.low), largestComponent(bounds.high));
  this->Error = 8.0 * std::numeric_limits<double>::epsilon() * (farthest + coordinates);
}

Vec3 LightFrame::place(const Vec3& point) const
{
  const Vec3 back = this->Origin - point;
  return this->Kind == Kinds::Near ? back
                                   : Vec3(glm::dot(back, this->Across), glm::dot(back, this->Up),
                                       glm::dot(back, this->Along));
}
}
