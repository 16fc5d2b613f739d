#include "ContourSigns.h"
#include "ExactSum.h"
#include "Random.h"

#include <gtest/gtest.h>

#include <map>

using namespace shadow;

namespace
{
__extension__ typedef __int128 Wide;

int signOfWide(Wide value)
{
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

using Whole = std::array<std::int64_t, 3>;

Vec3 toVector(const Whole& v, double scale = 1.0)
{
  return scale *
    Vec3(static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]));
}

Wide wideDeterminant(const Whole& a, const Whole& b, const Whole& c)
{
  const auto times = [](std::int64_t x, std::int64_t y) { return Wide(x) * y; };
  return a[0] * (times(b[1], c[2]) - times(b[2], c[1])) +
    a[1] * (times(b[2], c[0]) - times(b[0], c[2])) +
    a[2] * (times(b[0], c[1]) - times(b[1], c[0]));
}

Whole randomWhole(shadowtest::Random& random, int bits)
{
  Whole v;
  for (std::int64_t& c : v)
  {
    c = static_cast<std::int64_t>(random.uniform(-1.0, 1.0) * std::ldexp(1.0, bits));
  }
  return v;
}

/// A polynomial in the shifts: coefficients by the powers of f, e and k. That order is the one of
/// their size, the largest term first.
using Polynomial = std::map<std::array<int, 3>, std::int64_t>;

Polynomial operator+(const Polynomial& l, const Polynomial& r)
{
  Polynomial sum = l;
  for (const auto& [powers, factor] : r)
  {
    sum[powers] += factor;
  }
  return sum;
}

Polynomial operator*(const Polynomial& l, const Polynomial& r)
{
  Polynomial product;
  for (const auto& [p, a] : l)
  {
    for (const auto& [q, b] : r)
    {
      product[{ p[0] + q[0], p[1] + q[1], p[2] + q[2] }] += a * b;
    }
  }
  return product;
}

Polynomial operator-(const Polynomial& p)
{
  return p * Polynomial{ { { 0, 0, 0 }, -1 } };
}

using Shifted = std::array<Polynomial, 3>;

Shifted receiver(const Whole& v)
{
  return { Polynomial{ { { 0, 0, 0 }, v[0] }, { { 0, 1, 0 }, 1 } },
    Polynomial{ { { 0, 0, 0 }, v[1] }, { { 0, 2, 0 }, 1 } },
    Polynomial{ { { 0, 0, 0 }, v[2] }, { { 0, 3, 0 }, 1 } } };
}

Shifted silhouette(const Whole& v)
{
  return { Polynomial{ { { 0, 0, 0 }, v[0] }, { { 1, 0, 0 }, 1 } },
    Polynomial{ { { 0, 0, 0 }, v[1] }, { { 1, 0, 1 }, 1 } },
    Polynomial{ { { 0, 0, 0 }, v[2] }, { { 1, 0, 2 }, 1 } } };
}

int shiftedSign(const Shifted& a, const Shifted& b, const Shifted& c)
{
  const Polynomial all = a[0] * (b[1] * c[2] + -(b[2] * c[1])) +
    a[1] * (b[2] * c[0] + -(b[0] * c[2])) + a[2] * (b[0] * c[1] + -(b[1] * c[0]));
  for (const auto& [powers, factor] : all)
  {
    if (factor != 0)
    {
      return factor > 0 ? 1 : -1;
    }
  }
  return 0;
}

Whole smallWhole(shadowtest::Random& random)
{
  return { random.integer(-2, 2), random.integer(-2, 2), random.integer(-2, 2) };
}
}

TEST(ExactSum, DeterminantsHaveTheExactSign)
{
  shadowtest::Random random(31);
  int zeros = 0;
  int inexact = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const int bits = random.integer(2, 36);
    const Whole a = randomWhole(random, bits);
    const Whole b = randomWhole(random, bits);
    // In the plane of both, or beside it by as little as whole numbers can be.
    Whole c;
    for (std::size_t k = 0; k < 3; ++k)
    {
      c[k] = a[k] - 3 * b[k] + (random.chance(0.5) ? random.integer(-1, 1) : 0);
    }
    const Wide wanted = wideDeterminant(a, b, c);
    const double scale = std::ldexp(1.0, random.integer(-120, 120));
    const double found = determinant(toVector(a, scale), toVector(b, scale), toVector(c, scale));
    ASSERT_EQ(signOf(found), signOfWide(wanted)) << i;
    const double exact = exactDeterminant(toVector(a), toVector(b), toVector(c));
    // Two roundings of a few 1e-16 each.
    EXPECT_NEAR(exact, static_cast<double>(wanted), 1e-15 * std::fabs(exact));
    zeros += wanted == 0;
    const Vec3 rounded = glm::cross(toVector(b), toVector(c));
    inexact += signOf(glm::dot(toVector(a), rounded)) != signOfWide(wanted);
  }
  EXPECT_GT(zeros, 2000);
  EXPECT_GT(inexact, 500); // the task is not solved by rounding
}

TEST(ExactSum, CrossSignsAreExact)
{
  shadowtest::Random random(32);
  int zeros = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Whole a = randomWhole(random, 52);
    const int times = random.integer(-1, 1);
    const std::int64_t bx = times * a[0] + random.integer(-1, 1);
    const std::int64_t by = times * a[1] + random.integer(-1, 1);
    const Wide wanted = Wide(a[0]) * by - Wide(a[1]) * bx;
    EXPECT_EQ(crossSign(static_cast<double>(a[0]), static_cast<double>(a[1]),
                static_cast<double>(bx), static_cast<double>(by)),
      signOfWide(wanted));
    zeros += wanted == 0;
  }
  EXPECT_GT(zeros, 500);
}

// Every sign is that of one and the same shift, which a polynomial of it tells.
TEST(ContourSigns, TiesAreThoseOfOneShift)
{
  shadowtest::Random random(33);
  std::array<int, 3> ties{};
  int undecided = 0;
  for (int i = 0; i < 100000; ++i)
  {
    Whole p = smallWhole(random);
    Whole q = smallWhole(random);
    Whole r = smallWhole(random);
    if (random.chance(0.3)) // on one line with the light
    {
      const Whole unit = smallWhole(random);
      for (std::size_t k = 0; k < 3; ++k)
      {
        p[k] = unit[k];
        q[k] = random.chance(0.5) ? 2 * unit[k] : q[k];
        r[k] = q[k] + 3 * unit[k];
      }
    }
    const Vec3 hp = toVector(p);
    const Vec3 hq = toVector(q);
    const Vec3 hr = toVector(r);

    const int wall = shiftedSign(silhouette(p), silhouette(q), receiver(r));
    const ContourSide wallSide = sideOfWall(WallPlane(hp, hq), hr);
    ASSERT_EQ(wallSide.sign, wall < 0 ? -1 : 1) << i;
    ASSERT_EQ(signOf(wallSide.value), signOfWide(wideDeterminant(p, q, r)));

    const int edge = shiftedSign(receiver(p), receiver(q), silhouette(r));
    ASSERT_EQ(sideOfEdge(hp, hq, hr).sign, edge < 0 ? -1 : 1) << i;
    ASSERT_EQ(turnOf(hp, hq, hr), shiftedSign(receiver(p), receiver(q), receiver(r))) << i;

    ties[0] += wallSide.value == 0.0;
    undecided += wall == 0 || edge == 0;
    ties[1] += sideOfEdge(hp, hq, hr).value == 0.0;
    ties[2] += turnOf(hp, hq, hr) == 0;
  }
  EXPECT_GT(ties[0], 10000);
  EXPECT_GT(ties[1], 10000);
  EXPECT_GT(ties[2], 1000);
  EXPECT_GT(undecided, 100);
}

TEST(ContourSigns, SidesAreTheExactOnes)
{
  shadowtest::Random random(34);
  int closeOnes = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Whole a = randomWhole(random, 36);
    const Whole b = randomWhole(random, 36);
    Whole x;
    for (std::size_t k = 0; k < 3; ++k)
    {
      x[k] = 2 * a[k] + b[k] + random.integer(-1, 1);
    }
    const int wanted = signOfWide(wideDeterminant(a, b, x));
    const ContourSide wall = sideOfWall(WallPlane(toVector(a), toVector(b)), toVector(x));
    EXPECT_EQ(signOf(wall.value), wanted);
    EXPECT_EQ(signOf(sideOfEdge(toVector(a), toVector(b), toVector(x)).value), wanted);
    if (wanted != 0)
    {
      EXPECT_EQ(wall.sign, wanted);
      ++closeOnes;
    }
  }
  EXPECT_GT(closeOnes, 10000);
}
