#include "SmoothContour.h"

namespace shadow
{
namespace
{
/// The chord turned into the surface, lengthened as a circle's arc is longer than its chord.
Vec3 segmentTangent(const Vec3& chord, const Vec3& normal)
{
  const double length = glm::length(chord);
  const Vec3 t = chord - glm::dot(normal, chord) * normal;
  const double size = glm::length(t);
  if (!(size > 1e-9 * length))
  {
    return t;
  }
  return t * (2.0 * length / ((1.0 + size / length) * size));
}
}

CubicCurve contourSegment(const Vec3& p0, const Vec3& n0, const Vec3& p1, const Vec3& n1)
{
  const Vec3 chord = p1 - p0;
  return CubicCurve::hermite(p0, segmentTangent(chord, n0), p1, segmentTangent(chord, n1));
}
}
