#include "ShadowPlan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
Point3 operator-(const Point3& a, const Point3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Dot(const Point3& a, const Point3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point3 Cross(const Point3& a, const Point3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double Length(const Point3& a)
{
  return std::sqrt(Dot(a, a));
}

double Height(const Point4& plane, const Point3& point)
{
  return plane[0] * point[0] + plane[1] * point[1] + plane[2] * point[2] + plane[3];
}

double Height(const Point4& plane, const Point4& point)
{
  return plane[0] * point[0] + plane[1] * point[1] + plane[2] * point[2] + plane[3] * point[3];
}

/**
 * Away from the light, not normalised.
 */
Point3 RayOf(const Point4& light, const Point3& point)
{
  return { light[3] * point[0] - light[0], light[3] * point[1] - light[1],
    light[3] * point[2] - light[2] };
}

/**
 * How far, along its ray, a point is from a plane that it lies on the inner side of; infinite if
 * the ray does not come there.
 */
double DistanceToPlane(const Point4& plane, const Point4& light, const Point3& point)
{
  const Point3 ray = RayOf(light, point);
  const double toward = plane[0] * ray[0] + plane[1] * ray[1] + plane[2] * ray[2];
  const double height = Height(plane, point);
  return toward < 0.0 && height > 0.0 ? -height / toward * Length(ray)
                                      : std::numeric_limits<double>::infinity();
}

Point4 Multiply(const Matrix4& matrix, const Point4& point)
{
  Point4 result{};
  for (std::size_t row = 0; row < 4; ++row)
  {
    for (std::size_t column = 0; column < 4; ++column)
    {
      result[row] += matrix[4 * row + column] * point[column];
    }
  }
  return result;
}

bool AllBehind(const Point4& plane, const BoxCorners& points)
{
  return std::all_of(points.begin(), points.end(),
    [&](const Point3& point) { return Height(plane, point) < 0.0; });
}

/**
 * The plane through a point with a normal.
 */
Point4 PlaneThrough(const Point3& point, const Point3& normal)
{
  return { normal[0], normal[1], normal[2], -Dot(normal, point) };
}
}

namespace
{
/**
 * Whether all of a box is on the outer side of a plane of the pyramid; `inner` is positive if the normal
 * points to the pyramid, and 0 if all of that lies in the plane, whose sides are both outer ones then.
 */
bool Separates(
  const Point3& point, const Point3& normal, double inner, const BoxCorners& box)
{
  const Point4 plane = PlaneThrough(point, normal);
  const Point4 opposite = { -plane[0], -plane[1], -plane[2], -plane[3] };
  return (inner >= 0.0 && AllBehind(plane, box)) || (inner <= 0.0 && AllBehind(opposite, box));
}
}

BoxCorners CornersOf(const std::array<double, 6>& bounds, const Matrix4& toWorld)
{
  BoxCorners corners;
  for (std::size_t i = 0; i < 8; ++i)
  {
    const Point4 corner = Multiply(
      toWorld, { bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2 & 1)], 1.0 });
    corners[i] = { corner[0] / corner[3], corner[1] / corner[3], corner[2] / corner[3] };
  }
  return corners;
}

ShadowPlan::ShadowPlan(
  const ShadowView& view, const std::array<double, 6>& receivers, const ShadowRules& rules)
  : View(view)
  , Receivers(receivers)
  , Rules(rules)
{
  Matrix4 clipToWorld;
  vtkMatrix4x4::Invert(view.WorldToClip.data(), clipToWorld.data());
  // Around the rectangle in turn.
  const double corners[4][2] = { { -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 } };
  this->NearIsKnown = true;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Point4 corner = Multiply(clipToWorld, { corners[i][0], corners[i][1], -1.0, 1.0 });
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->NearCorners[i][axis] = corner[axis] / corner[3];
      this->NearIsKnown = this->NearIsKnown && std::isfinite(this->NearCorners[i][axis]);
    }
  }
}

ShadowPlan::Volume ShadowPlan::VolumeOf(
  const Point4& light, const BoxCorners& caster, const Point4& end) const
{
  Volume volume;
  for (std::size_t i = 0; i < 8; ++i)
  {
    const Point3& corner = caster[i];
    const Point3 ray = RayOf(light, corner);
    volume[i] = { corner[0], corner[1], corner[2], 1.0 };
    const double distance = DistanceToPlane(end, light, corner) / Length(ray);
    volume[i + 8] = std::isfinite(distance)
      ? Point4{ corner[0] + distance * ray[0], corner[1] + distance * ray[1],
          corner[2] + distance * ray[2], 1.0 }
      : Point4{ ray[0], ray[1], ray[2], 0.0 };
  }
  for (Point4& point : volume)
  {
    point = Multiply(this->View.WorldToClip, point);
  }
  return volume;
}

bool ShadowPlan::IsSeen(const Point4& light, const BoxCorners& caster) const
{
  if (!this->Rules.SkipUnseen)
  {
    return true;
  }
  const Volume volume = this->VolumeOf(light, caster, this->FindEnd(light, caster));
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -1.0, 1.0 })
    {
      if (std::all_of(volume.begin(), volume.end(),
            [&](const Point4& p) { return side * p[axis] > p[3]; }))
      {
        return false;
      }
    }
  }
  return true;
}

CasterPlan ShadowPlan::Decide(const Point4& light, const BoxCorners& caster) const
{
  CasterPlan plan;
  plan.End = this->FindEnd(light, caster);
  const bool isFinite = plan.End != Point4{};
  const bool nearIsFree = this->NearPlaneIsFree(light, caster);
  plan.ZPass = this->Rules.Counting == CountingMethod::ZPass ||
    (this->Rules.Counting == CountingMethod::Automatic && nearIsFree);
  plan.Scissor = this->Rules.Scissor
    ? this->FindScissor(this->VolumeOf(light, caster, plan.End))
    : std::array<int, 4>{ 0, 0, this->View.Width, this->View.Height };
  plan.Decision = std::string(plan.ZPass ? "z-pass" : "z-fail") +
    (isFinite ? ", ends behind the receivers" : ", to infinity");
  plan.Reason = this->Rules.Counting != CountingMethod::Automatic
    ? "counting is set"
    : nearIsFree ? "nothing of it is between the light and the near plane"
                 : "some of it may be between the light and the near plane";
  return plan;
}

/**
 * Of the planes of the receivers' bounds, and of one across the ray of the caster's middle, that to
 * which all rays come after the shortest way, a little behind all that receives.
 */
Point4 ShadowPlan::FindEnd(const Point4& light, const BoxCorners& caster) const
{
  const std::array<double, 6>& b = this->Receivers;
  if (!this->Rules.FiniteVolumes || !(b[0] <= b[1]))
  {
    return {};
  }
  constexpr double behind = 0.01;
  const double margin = behind * std::sqrt((b[1] - b[0]) * (b[1] - b[0]) +
                                   (b[3] - b[2]) * (b[3] - b[2]) + (b[5] - b[4]) * (b[5] - b[4]));
  std::array<Point4, 7> planes{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    planes[2 * axis][axis] = 1.0;
    planes[2 * axis][3] = margin - b[2 * axis];
    planes[2 * axis + 1][axis] = -1.0;
    planes[2 * axis + 1][3] = margin + b[2 * axis + 1];
  }
  Point3 middle{};
  for (const Point3& corner : caster)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      middle[axis] += corner[axis] / 8.0;
    }
  }
  const Point3 ray = RayOf(light, middle);
  const double length = Length(ray);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return {};
  }
  Point4& across = planes[6];
  across = { -ray[0] / length, -ray[1] / length, -ray[2] / length, 0.0 };
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 8; ++i)
  {
    lowest = std::min(lowest, Height(across, Point3{ b[i & 1], b[2 + (i >> 1 & 1)], b[4 + (i >> 2 & 1)] }));
  }
  across[3] = margin - lowest;

  Point4 best{};
  double least = std::numeric_limits<double>::infinity();
  for (const Point4& plane : planes)
  {
    double longest = 0.0;
    for (const Point3& corner : caster)
    {
      longest = std::max(longest, DistanceToPlane(plane, light, corner));
    }
    if (longest < least)
    {
      least = longest;
      best = plane;
    }
  }
  return best;
}

/**
 * False if the caster may meet the pyramid of the near rectangle and the light: only then can the
 * rectangle, which the eye looks through, be in the volume or cut it. A plane of the pyramid or of the
 * caster's box that separates them is proof of the contrary.
 */
bool ShadowPlan::NearPlaneIsFree(const Point4& light, const BoxCorners& caster) const
{
  if (!this->NearIsKnown)
  {
    return false;
  }
  const std::array<Point3, 4>& corners = this->NearCorners;
  const auto towardLight = [&](const Point3& point)
  { return Point3{} - RayOf(light, point); };

  // The rectangle's own plane, and those through its sides and the light.
  const Point3 normal = Cross(corners[1] - corners[0], corners[3] - corners[0]);
  if (Separates(corners[0], normal, Dot(normal, towardLight(corners[0])), caster))
  {
    return true;
  }
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Point3& from = corners[i];
    const Point3& to = corners[(i + 1) % 4];
    const Point3& opposite = corners[(i + 2) % 4];
    const Point3 across = Cross(to - from, towardLight(from));
    if (Separates(from, across, Dot(across, opposite - from), caster))
    {
      return true;
    }
  }
  // The box's faces: all of the pyramid outside of one.
  constexpr std::size_t bits[3] = { 1, 2, 4 };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Point3 across = Cross(caster[bits[(axis + 1) % 3]] - caster[0],
      caster[bits[(axis + 2) % 3]] - caster[0]);
    for (const std::size_t base : { std::size_t{ 0 }, bits[axis] })
    {
      const Point3& inner = caster[base == 0 ? bits[axis] : 0];
      Point4 plane = PlaneThrough(caster[base], across);
      if (Height(plane, inner) < 0.0)
      {
        plane = { -plane[0], -plane[1], -plane[2], -plane[3] };
      }
      if (Height(plane, inner) > 0.0 && Height(plane, light) < 0.0 &&
        std::all_of(corners.begin(), corners.end(),
          [&](const Point3& corner) { return Height(plane, corner) < 0.0; }))
      {
        return true;
      }
    }
  }
  return false;
}

/**
 * Every point of the convex hull in front of the near plane is seen within the bounds of its edges
 * there, for which all pairs of points are taken.
 */
std::array<int, 4> ShadowPlan::FindScissor(const Volume& volume) const
{
  double lower[2] = { 1.0, 1.0 };
  double upper[2] = { -1.0, -1.0 };
  const auto add = [&](const Point4& point)
  {
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      const double place = point[axis] / point[3];
      // Not a number where the eye itself is: everything may be covered.
      lower[axis] = std::isnan(place) ? -1.0 : std::min(lower[axis], place);
      upper[axis] = std::isnan(place) ? 1.0 : std::max(upper[axis], place);
    }
  };
  const auto inFront = [](const Point4& point) { return point[2] + point[3]; };
  for (std::size_t i = 0; i < volume.size(); ++i)
  {
    const double heightI = inFront(volume[i]);
    if (heightI >= 0.0)
    {
      add(volume[i]);
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      const double heightJ = inFront(volume[j]);
      if ((heightI > 0.0) != (heightJ > 0.0))
      {
        const double t = heightI / (heightI - heightJ);
        Point4 cut;
        for (std::size_t k = 0; k < 4; ++k)
        {
          cut[k] = volume[i][k] + t * (volume[j][k] - volume[i][k]);
        }
        add(cut);
      }
    }
  }
  const double size[2] = { static_cast<double>(this->View.Width),
    static_cast<double>(this->View.Height) };
  std::array<int, 4> scissor{};
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    // A pixel more on either side, for roundings.
    const double first = std::floor(0.5 * (std::max(lower[axis], -1.0) + 1.0) * size[axis]) - 1.0;
    const double last = std::ceil(0.5 * (std::min(upper[axis], 1.0) + 1.0) * size[axis]) + 1.0;
    scissor[axis] = static_cast<int>(std::max(first, 0.0));
    scissor[axis + 2] =
      static_cast<int>(std::max(std::min(last, size[axis]) - static_cast<double>(scissor[axis]), 0.0));
  }
  return scissor;
}
