#include "ShadowPlan.h"

#include "CasterShadow.h"
#include "VolumeView.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace PointArithmetic;

namespace
{
/**
 * Whether all of a box is on the outer side of a plane of the pyramid; `inner` is positive if the
 * normal points to the pyramid, and 0 if all of that lies in the plane, whose sides are both outer
 * ones then.
 */
bool Separates(const Point3& point, const Point3& normal, double inner, const BoxCorners& box)
{
  const Point4 plane = PlaneThrough(point, normal);
  return (inner >= 0.0 && AllBehind(plane, box)) || (inner <= 0.0 && AllBehind(-plane, box));
}

CasterPlan Skipped(const char* reason)
{
  CasterPlan plan;
  plan.Skip = true;
  plan.Decision = "skip";
  plan.Reason = reason;
  return plan;
}
}

ShadowPlan::ShadowPlan(const ShadowView& view, PlanReceivers receivers, const ShadowRules& rules)
  : View(view)
  , Receivers(std::move(receivers))
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

CasterPlan ShadowPlan::Decide(const PlanLight& light, const BoxCorners& caster) const
{
  if (this->Rules.SkipOutsideCones && IsOutsideCone(light, caster))
  {
    return Skipped("it is outside of the light's cone");
  }
  if (this->Rules.SkipWithoutReceivers && !this->SomethingReceives(light.Position, caster))
  {
    return Skipped("nothing behind it receives");
  }
  const Point4 end = this->FindEnd(light.Position, caster);
  const VolumeView volume(this->View, light.Position, caster, end);
  if (this->Rules.SkipUnseen && !volume.IsSeen())
  {
    return Skipped("its shadow does not come into view");
  }

  CasterPlan plan;
  plan.End = end;
  plan.Pixel = volume.FindPixel();
  const bool nearIsFree = this->NearPlaneIsFree(light.Position, caster);
  plan.ZPass = this->Rules.Counting == CountingMethod::ZPass ||
    (this->Rules.Counting == CountingMethod::Automatic && nearIsFree);
  plan.Scissor = this->Rules.Scissor
    ? volume.FindScissor()
    : std::array<int, 4>{ 0, 0, this->View.Width, this->View.Height };
  if (this->Rules.DepthBounds)
  {
    plan.DepthRange = volume.FindDepthRange();
  }
  plan.Decision = std::string(plan.ZPass ? "z-pass" : "z-fail") +
    (end != Point4{} ? ", ends behind the receivers" : ", to infinity");
  plan.Reason = this->Rules.Counting != CountingMethod::Automatic ? "counting is set"
    : nearIsFree ? "nothing of it is between the light and the near plane"
                 : "some of it may be between the light and the near plane";
  return plan;
}

/**
 * Usually the caster or the ground around it receives, whose bounds have the caster's middle in
 * them: that is found before any plane of its shadow is.
 */
bool ShadowPlan::SomethingReceives(const Point4& light, const BoxCorners& caster) const
{
  const Point3 middle = MiddleOf(caster);
  if (!this->Receivers.Bounded || !std::isfinite(Length(middle)))
  {
    return true;
  }
  const auto holdsMiddle = [&](const std::array<double, 6>& b) {
    return b[0] <= middle[0] && middle[0] <= b[1] && b[2] <= middle[1] && middle[1] <= b[3] &&
      b[4] <= middle[2] && middle[2] <= b[5];
  };
  const std::vector<std::array<double, 6>>& bounds = this->Receivers.Bounds;
  if (std::any_of(bounds.begin(), bounds.end(), holdsMiddle))
  {
    return true;
  }
  const CasterShadow shadow(light, caster);
  return !std::all_of(bounds.begin(), bounds.end(),
    [&](const std::array<double, 6>& receiver) { return shadow.Misses(receiver); });
}

/**
 * Of the planes of the receivers' bounds, and of one across the ray of the caster's middle, that to
 * which all rays come after the shortest way, a little behind all that receives.
 */
Point4 ShadowPlan::FindEnd(const Point4& light, const BoxCorners& caster) const
{
  const std::array<double, 6>& b = this->Receivers.AllBounds;
  if (!this->Rules.FiniteVolumes || !this->Receivers.Bounded || !(b[0] <= b[1]))
  {
    return {};
  }
  constexpr double behind = 0.01;
  const double margin = behind *
    std::sqrt((b[1] - b[0]) * (b[1] - b[0]) + (b[3] - b[2]) * (b[3] - b[2]) +
      (b[5] - b[4]) * (b[5] - b[4]));
  std::array<Point4, 7> planes{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    planes[2 * axis][axis] = 1.0;
    planes[2 * axis][3] = margin - b[2 * axis];
    planes[2 * axis + 1][axis] = -1.0;
    planes[2 * axis + 1][3] = margin + b[2 * axis + 1];
  }
  const Point3 ray = RayOf(light, MiddleOf(caster));
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
    const Point3 corner = { b[i & 1], b[2 + (i >> 1 & 1)], b[4 + (i >> 2 & 1)] };
    lowest = std::min(lowest, Height(across, corner));
  }
  across[3] = margin - lowest;

  Point4 best{};
  double least = std::numeric_limits<double>::infinity();
  for (const Point4& plane : planes)
  {
    double longest = 0.0;
    for (const Point3& corner : caster)
    {
      const Point3 cornerRay = RayOf(light, corner);
      longest = std::max(longest, StepsToPlane(plane, corner, cornerRay) * Length(cornerRay));
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
 * rectangle, which the eye looks through, be in the volume or cut it. A plane of the pyramid or of
 * the caster's box that separates them is proof of the contrary.
 */
bool ShadowPlan::NearPlaneIsFree(const Point4& light, const BoxCorners& caster) const
{
  if (!this->NearIsKnown)
  {
    return false;
  }
  const std::array<Point3, 4>& corners = this->NearCorners;
  const auto towardLight = [&](const Point3& point) { return Point3{} - RayOf(light, point); };

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
  return std::any_of(BoxFaces.begin(), BoxFaces.end(), [&](const BoxFace& face) {
    const Point4 plane = FacePlane(caster, face);
    return Height(plane, caster[static_cast<std::size_t>(face.Opposite)]) > 0.0 &&
      Height(plane, light) < 0.0 &&
      std::all_of(corners.begin(), corners.end(),
        [&](const Point3& corner) { return Height(plane, corner) < 0.0; });
  });
}
