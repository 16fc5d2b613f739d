/**
 * Vectors, and what the tool and the examples compute with them.
 */
#ifndef Vectors_h
#define Vectors_h

#include <algorithm>
#include <array>
#include <cmath>

using Vector3 = std::array<double, 3>;

/// A point at (x, y, z) / w, or for w = 0 a direction.
using Homogeneous = std::array<double, 4>;

inline double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline double Length(const Vector3& a)
{
  return std::sqrt(Dot(a, a));
}

inline Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

/// a + s b
inline Vector3 Along(const Vector3& a, double s, const Vector3& b)
{
  return { a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2] };
}

inline Vector3 Unit(const Vector3& a)
{
  // Divided first: squares of very long or very short vectors would leave the range of a double.
  const double largest = std::max({ std::abs(a[0]), std::abs(a[1]), std::abs(a[2]) });
  const Vector3 scaled = { a[0] / largest, a[1] / largest, a[2] / largest };
  const double length = Length(scaled);
  return { scaled[0] / length, scaled[1] / length, scaled[2] / length };
}

#endif
