/**
 * Points, directions and planes as plain arrays. The operators are for sources alone:
 * `using namespace PointArithmetic`.
 */
#ifndef PointArithmetic_h
#define PointArithmetic_h

#include "Matrix4.h"

#include <array>
#include <cmath>
#include <cstddef>

using Point3 = std::array<double, 3>;
using Point4 = std::array<double, 4>;

namespace PointArithmetic
{
inline Point3 operator-(const Point3& a, const Point3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline Point4 operator-(const Point4& plane)
{
  return { -plane[0], -plane[1], -plane[2], -plane[3] };
}

inline double Dot(const Point3& a, const Point3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Point3 Cross(const Point3& a, const Point3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double Length(const Point3& a)
{
  return std::sqrt(Dot(a, a));
}

/**
 * Of a point, or a homogeneous one, over a plane; not a distance unless the normal has length 1.
 */
inline double Height(const Point4& plane, const Point3& point)
{
  return plane[0] * point[0] + plane[1] * point[1] + plane[2] * point[2] + plane[3];
}

inline double Height(const Point4& plane, const Point4& point)
{
  return plane[0] * point[0] + plane[1] * point[1] + plane[2] * point[2] + plane[3] * point[3];
}

inline Point4 PlaneThrough(const Point3& point, const Point3& normal)
{
  return { normal[0], normal[1], normal[2], -Dot(normal, point) };
}

inline Point4 Multiply(const Matrix4& matrix, const Point4& point)
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
}

#endif
