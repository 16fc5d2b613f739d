/// A field as a plane: for points and directions, faces and corners alike.
#pragma once

#include "RangeLoop.h"

namespace shadow
{
/// The field N . (l - w p) is q . (l, w) with q = (N, -N . p). This is q at unit length of N in the
/// frame of the ball, where no component is above 1.001; zero where N has no direction or the ball
/// is none.
inline Vec4 facingPlane(const Vec3& normal, const Vec3& point, const Ball& ball)
{
  const double length = glm::length(normal);
  if (!(length > 1e-150 && length < 1e150))
  {
    return Vec4(0.0);
  }
  const Vec3 n = normal / length;
  const double offset = -glm::dot(n, (point - ball.centre) / ball.radius);
  // In the ball it is at most 1; what is not has a ball that rounding made meaningless.
  return std::fabs(offset) < 1.001 && isFinite(n) ? Vec4(n, offset) : Vec4(0.0);
}

/// The planes of all triangles.
std::vector<Vec4> facePlanes(const TriangleMesh& mesh, const Ball& ball, const RangeLoop& loop);

/// The planes of all corner normals.
std::vector<Vec4> cornerPlanes(const TriangleMesh& mesh, const Ball& ball, const RangeLoop& loop);
}
