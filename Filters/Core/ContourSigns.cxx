#include "ContourSigns.h"

#include "ExactSum.h"

namespace shadow
{
namespace
{
/// Of three signs the first that is not zero, in the order of the powers of a shift.
int firstOf(int x, int y, int z)
{
  return x != 0 ? x : y != 0 ? y : z;
}

/// By a x b.
int crossTie(const Vec3& a, const Vec3& b)
{
  return firstOf(crossSign(a.y, a.z, b.y, b.z), crossSign(a.z, a.x, b.z, b.x),
    crossSign(a.x, a.y, b.x, b.y));
}

/// The sign of (end - start).k b.l - (end - start).l b.k.
int differenceCrossSign(const Vec3& start, const Vec3& end, const Vec3& b, int k, int l)
{
  ExactSum sum;
  sum.addProduct(end[k], b[l]);
  sum.addProduct(-start[k], b[l]);
  sum.addProduct(-end[l], b[k]);
  sum.addProduct(start[l], b[k]);
  return sum.sign();
}

/// By (end - start) x b.
int differenceCrossTie(const Vec3& start, const Vec3& end, const Vec3& b)
{
  return firstOf(differenceCrossSign(start, end, b, 1, 2),
    differenceCrossSign(start, end, b, 2, 0), differenceCrossSign(start, end, b, 0, 1));
}

/// What is left where all is parallel: f.((end - start) x e), the product of both shifts.
int shiftsTie(const Vec3& start, const Vec3& end)
{
  // Its terms are f (k e z - k^2 e y + k^2 e^2 x) and smaller ones with the same factors.
  return firstOf(
    signOf(end.z - start.z), -signOf(end.y - start.y), signOf(end.x - start.x));
}

int positiveIfZero(int sign)
{
  return sign < 0 ? -1 : 1;
}

// det(a + f, b + f, x + e) = det(a, b, x) + e.(a x b) + f.((b - a) x x) + f.((b - a) x e)
int wallTie(const WallPlane& wall, const Vec3& x)
{
  int sign = crossTie(wall.a, wall.b);
  sign = sign != 0 ? sign : differenceCrossTie(wall.a, wall.b, x);
  return positiveIfZero(sign != 0 ? sign : shiftsTie(wall.a, wall.b));
}

// det(x + e, y + e, a + f) = det(x, y, a) + e.((y - x) x a) + f.(x x y) + f.(e x (y - x))
int edgeTie(const Vec3& x, const Vec3& y, const Vec3& a)
{
  int sign = differenceCrossTie(x, y, a);
  sign = sign != 0 ? sign : crossTie(x, y);
  return positiveIfZero(sign != 0 ? sign : -shiftsTie(x, y));
}

/// By (y - x) x (z - x).
int normalSign(const Vec3& x, const Vec3& y, const Vec3& z, int k, int l)
{
  ExactSum sum;
  sum.addProduct(x[k], y[l]);
  sum.addProduct(-x[l], y[k]);
  sum.addProduct(y[k], z[l]);
  sum.addProduct(-y[l], z[k]);
  sum.addProduct(z[k], x[l]);
  sum.addProduct(-z[l], x[k]);
  return sum.sign();
}
}

WallPlane::WallPlane(const Vec3& start, const Vec3& end)
  : a(start)
  , b(end)
  , normal(glm::cross(start, end))
  , permanent(std::fabs(start.y * end.z) + std::fabs(start.z * end.y),
      std::fabs(start.z * end.x) + std::fabs(start.x * end.z),
      std::fabs(start.x * end.y) + std::fabs(start.y * end.x))
{
}

ContourSide sideOfWall(const WallPlane& wall, const Vec3& x)
{
  double value = wall.normal.x * x.x + wall.normal.y * x.y + wall.normal.z * x.z;
  const double permanent = wall.permanent.x * std::fabs(x.x) + wall.permanent.y * std::fabs(x.y) +
    wall.permanent.z * std::fabs(x.z);
  if (!(std::fabs(value) > determinantError * permanent))
  {
    // A vertex of the segment itself is the commonest tie, where a caster receives its own shadow.
    value = x == wall.a || x == wall.b ? 0.0 : exactDeterminant(wall.a, wall.b, x);
  }
  const int sign = signOf(value);
  return { value, sign != 0 ? sign : wallTie(wall, x) };
}

ContourSide sideOfEdge(const Vec3& x, const Vec3& y, const Vec3& a)
{
  const double value = a == x || a == y ? 0.0 : determinant(x, y, a);
  const int sign = signOf(value);
  return { value, sign != 0 ? sign : edgeTie(x, y, a) };
}

int turnOf(const Vec3& x, const Vec3& y, const Vec3& z)
{
  const int sign = signOf(determinant(x, y, z));
  return sign != 0 ? sign
                   : firstOf(normalSign(x, y, z, 1, 2), normalSign(x, y, z, 2, 0),
                       normalSign(x, y, z, 0, 1));
}
}
