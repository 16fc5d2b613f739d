#include "ShadowReceiver.h"

#include <algorithm>

namespace shadow
{
namespace
{
constexpr double infinite = std::numeric_limits<double>::infinity();

double distanceToSegment(const Vec3& point, const Vec3& p, const Vec3& q)
{
  const Vec3 along = q - p;
  const double squared = glm::dot(along, along);
  const double t =
    squared > 0.0 ? std::clamp(glm::dot(point - p, along) / squared, 0.0, 1.0) : 0.0;
  return glm::length(point - p - t * along);
}
}

ShadowReceiver::ShadowReceiver(const Light& light, const Vec3& low, const Vec3& high)
  : TheLight(light.isDirectional() ? light : Light{ light.position / light.w, 1.0 })
{
  for (int axis = 0; axis < 3; ++axis)
  {
    Vec3 normal(0.0);
    normal[axis] = 1.0;
    const std::size_t face = 2 * static_cast<std::size_t>(axis);
    this->Faces[face] = { normal, high[axis] };
    this->Faces[face + 1] = { -normal, -low[axis] };
  }
}

double ShadowReceiver::Meeting::least() const
{
  return *std::min_element(this->nearness.begin(), this->nearness.end());
}

double ShadowReceiver::Meeting::most() const
{
  return *std::max_element(this->nearness.begin(), this->nearness.end());
}

/// With the light in l a point's ray is l + T (p - l), which meets the face's plane at 1/T - 1 =
/// (n.p - offset) / (offset - n.l). With a direction the ray is p + t e, which meets it at -t =
/// (n.p - offset) / n.e. Either is below zero beyond the point, and as exact as n.p - offset is,
/// however far the light: 1/T itself would be 1 for all that is seen from afar.
ShadowReceiver::Meeting ShadowReceiver::meet(const Face& face, const CubicCurve& curve) const
{
  Meeting meeting;
  const double ahead = face.offset - glm::dot(face.normal, this->TheLight.position);
  for (std::size_t i = 0; i < 4; ++i)
  {
    const double speed = -glm::dot(face.normal, this->TheLight.toward(curve.b[i]));
    meeting.leaves = meeting.leaves && speed > 0.0;
    meeting.enters = meeting.enters && speed < 0.0;
    meeting.nearness[i] = (glm::dot(face.normal, curve.b[i]) - face.offset) /
      (this->TheLight.isDirectional() ? speed : ahead);
  }
  return meeting;
}

double ShadowReceiver::deviationBound(const CubicCurve& curve) const
{
  const bool directional = this->TheLight.isDirectional();
  std::array<Meeting, 6> meetings;
  double soonest = -infinite; // the ray that stays in longest has left by then
  for (std::size_t f = 0; f < 6; ++f)
  {
    const Face& face = this->Faces[f];
    meetings[f] = this->meet(face, curve);
    const bool isBehind =
      !directional && !(glm::dot(face.normal, this->TheLight.position) < face.offset);
    if (meetings[f].leaves)
    {
      if (isBehind || meetings[f].least() > 0.0)
      {
        return 0.0;
      }
      soonest = std::max(soonest, meetings[f].least());
    }
    // From a point outside of a face all that comes in comes through its plane, and what turns away
    // from it (at a nearness below -1) never does. From a point in the plane it is in at once.
    const bool isOutside =
      !directional && glm::dot(face.normal, this->TheLight.position) > face.offset;
    meetings[f].enters = directional ? meetings[f].enters : isOutside;
  }
  for (std::size_t in = 0; in < 6; ++in)
  {
    for (std::size_t out = 0; out < 6 && meetings[in].enters; ++out)
    {
      bool misses = meetings[out].leaves;
      for (std::size_t i = 0; i < 4; ++i)
      {
        misses = misses && meetings[in].nearness[i] < meetings[out].nearness[i];
      }
      if (misses)
      {
        return 0.0;
      }
    }
  }
  if (soonest == -infinite)
  {
    return infinite;
  }
  double bound = 0.0;
  for (std::size_t f = 0; f < 6; ++f)
  {
    const bool canBeFirst = meetings[f].most() >= soonest;
    if (meetings[f].leaves && canBeFirst)
    {
      bound = std::fmax(bound, this->deviationOn(this->Faces[f], curve));
    }
    else if (!directional && !meetings[f].enters && canBeFirst)
    {
      return infinite; // some of the rays may leave here, and others not
    }
  }
  return bound;
}

/// Projected on a plane the curve is a rational cubic. Its points are means of the projected
/// control points, of which the inner ones have at most 3 r / (1 + 3 r) of the weight, r being the
/// largest ratio of an inner one's own weight to an outer one's; and the distance from a segment is
/// convex.
double ShadowReceiver::deviationOn(const Face& face, const CubicCurve& curve) const
{
  std::array<Vec3, 4> shadow;
  std::array<double, 4> weight;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const Vec3 ray = -this->TheLight.toward(curve.b[i]);
    const double speed = glm::dot(face.normal, ray);
    weight[i] = speed;
    shadow[i] = curve.b[i] + ray * ((face.offset - glm::dot(face.normal, curve.b[i])) / speed);
  }
  const double ratio = std::max(weight[1], weight[2]) / std::min(weight[0], weight[3]);
  const double farthest = std::fmax(distanceToSegment(shadow[1], shadow[0], shadow[3]),
    distanceToSegment(shadow[2], shadow[0], shadow[3]));
  const double bound = farthest * (3.0 * ratio / (1.0 + 3.0 * ratio));
  return std::isnan(bound) ? infinite : bound;
}
}
