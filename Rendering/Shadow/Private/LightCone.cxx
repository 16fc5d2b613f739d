#include "LightCone.h"

#include <algorithm>

using namespace PointArithmetic;

namespace
{
/**
 * Of the cosine, and of a face's sides: some roundings of single precision.
 */
constexpr double Widening = 0x1p-18;

/**
 * The least of |v| cosine - axis.v for v on the segment from p to p + q.
 */
double LeastOnSegment(const Point3& p, const Point3& q, const Point3& axis, double cosine)
{
  const auto at = [&](double t) {
    const Point3 v = { p[0] + t * q[0], p[1] + t * q[1], p[2] + t * q[2] };
    return Length(v) * cosine - Dot(axis, v);
  };
  double least = std::min(at(0.0), at(1.0));
  const double length = Length(q);
  const double slope = Dot(axis, q) / (cosine * length);
  if (length > 0.0 && std::abs(slope) < 1.0)
  {
    const double nearest = -Dot(p, q) / length;
    const double height = Length(Cross(p, q)) / length;
    const double along = nearest + slope * height / std::sqrt(1.0 - slope * slope);
    least = std::min(least, at(std::clamp(along / length, 0.0, 1.0)));
  }
  return least;
}

/**
 * Whether a ray from the origin passes through a parallelogram; false if it is in its plane.
 */
bool PassesThrough(
  const Point3& direction, const Point3& corner, const Point3& first, const Point3& second)
{
  // corner + a first + b second = t direction, by Cramer's rule.
  const Point3 normal = Cross(first, second);
  const double determinant = Dot(normal, direction);
  const double t = Dot(normal, corner) / determinant;
  const double a = -Dot(Cross(second, direction), corner) / determinant;
  const double b = -Dot(Cross(direction, first), corner) / determinant;
  const auto isInside = [](double place) { return place >= -Widening && place <= 1.0 + Widening; };
  return determinant != 0.0 && t >= 0.0 && isInside(a) && isInside(b);
}
}

bool IsOutsideCone(const PlanLight& light, const BoxCorners& box)
{
  constexpr double degree = 3.14159265358979323846 / 180.0;
  const double length = Length(light.Direction);
  if (!(light.Position[3] > 0.0) || !(light.ConeAngle < 90.0) || !(length > 0.0) ||
    !std::isfinite(length))
  {
    return false;
  }
  const double cosine = std::cos(light.ConeAngle * degree) - Widening;
  if (!(cosine > 0.0))
  {
    return false;
  }
  const Point3 axis = { light.Direction[0] / length, light.Direction[1] / length,
    light.Direction[2] / length };
  const Point3 apex = { light.Position[0] / light.Position[3],
    light.Position[1] / light.Position[3], light.Position[2] / light.Position[3] };
  BoxCorners fromApex;
  for (std::size_t i = 0; i < 8; ++i)
  {
    fromApex[i] = box[i] - apex;
  }
  const auto corner = [&](int number) -> const Point3& {
    return fromApex[static_cast<std::size_t>(number)];
  };
  const bool edgesAreOutside =
    std::all_of(BoxEdges.begin(), BoxEdges.end(), [&](const std::pair<int, int>& edge) {
      const Point3& from = corner(edge.first);
      return LeastOnSegment(from, corner(edge.second) - from, axis, cosine) > 0.0;
    });
  return edgesAreOutside &&
    std::none_of(BoxFaces.begin(), BoxFaces.end(), [&](const BoxFace& face) {
      const Point3& at = corner(face.Corner);
      return PassesThrough(axis, at, corner(face.First) - at, corner(face.Second) - at);
    });
}
