#include "ExactSum.h"

#include <cassert>

namespace shadow
{
void ExactSum::add(double term)
{
  double carried = term;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    // The sum and what rounding took from it, whichever of both is larger (Knuth).
    const double sum = carried + this->Terms[i];
    const double back = sum - carried;
    const double lost = (carried - (sum - back)) + (this->Terms[i] - back);
    if (lost != 0.0)
    {
      this->Terms[kept++] = lost;
    }
    carried = sum;
  }
  if (carried != 0.0)
  {
    assert(kept < mostTerms);
    this->Terms[kept++] = carried;
  }
  this->Count = kept;
}

void ExactSum::addProduct(double a, double b)
{
  const double product = a * b;
  this->add(std::fma(a, b, -product));
  this->add(product);
}

void ExactSum::addProduct(double a, double b, double c)
{
  const double product = a * b;
  this->addProduct(std::fma(a, b, -product), c);
  this->addProduct(product, c);
}

int ExactSum::sign() const
{
  return this->Count > 0 ? signOf(this->Terms[this->Count - 1]) : 0;
}

double ExactSum::value() const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    sum += this->Terms[i];
  }
  return sum;
}

double exactDeterminant(const Vec3& a, const Vec3& b, const Vec3& c)
{
  ExactSum sum;
  sum.addProduct(a.x, b.y, c.z);
  sum.addProduct(-a.x, b.z, c.y);
  sum.addProduct(a.y, b.z, c.x);
  sum.addProduct(-a.y, b.x, c.z);
  sum.addProduct(a.z, b.x, c.y);
  sum.addProduct(-a.z, b.y, c.x);
  return sum.value();
}

double determinant(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double x1 = b.y * c.z;
  const double x2 = b.z * c.y;
  const double y1 = b.z * c.x;
  const double y2 = b.x * c.z;
  const double z1 = b.x * c.y;
  const double z2 = b.y * c.x;
  const double value = a.x * (x1 - x2) + a.y * (y1 - y2) + a.z * (z1 - z2);
  const double permanent = std::fabs(a.x) * (std::fabs(x1) + std::fabs(x2)) +
    std::fabs(a.y) * (std::fabs(y1) + std::fabs(y2)) +
    std::fabs(a.z) * (std::fabs(z1) + std::fabs(z2));
  return std::fabs(value) > determinantError * permanent ? value : exactDeterminant(a, b, c);
}

int crossSign(double ax, double ay, double bx, double by)
{
  // Rounding keeps the order of two products unless it makes them equal.
  const double first = ax * by;
  const double second = ay * bx;
  return first != second ? signOf(first - second)
                         : signOf(std::fma(ax, by, -first) - std::fma(ay, bx, -second));
}
}
