/// Sums of products in double, exactly, and determinants of the right sign.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// A sum that is held as doubles that do not overlap, the smallest first (Shewchuk 1997). Exact as
/// long as no product is so small that doubles lose its digits (1e-290).
class ExactSum
{
public:
  void add(double term);
  void addProduct(double a, double b);
  void addProduct(double a, double b, double c);

  int sign() const;
  /// Within a few roundings, and of the right sign.
  double value() const;

private:
  /// Of a determinant of three vectors: six products of four terms.
  static constexpr std::size_t mostTerms = 24;

  std::array<double, mostTerms> Terms;
  std::size_t Count = 0;
};

inline int signOf(double value)
{
  return value > 0.0 ? 1 : value < 0.0 ? -1 : 0;
}

/// Bound on the error of a determinant of three vectors that was computed in double, as a share of
/// its permanent (the same sum of products with all of them positive): eight roundings are more
/// than there are on the way to any of the products.
constexpr double determinantError = 8.0 * std::numeric_limits<double>::epsilon();

/// det(a, b, c) from exact sums.
double exactDeterminant(const Vec3& a, const Vec3& b, const Vec3& c);

/// det(a, b, c), of the exact sign: zero if and only if it is zero.
double determinant(const Vec3& a, const Vec3& b, const Vec3& c);

/// The exact sign of a.x b.y - a.y b.x, of numbers.
int crossSign(double ax, double ay, double bx, double by);
}
