#include "QuarticZeros.h"

#include <gtest/gtest.h>

#include <random>

using namespace shadow;

namespace
{
double size(const Quartic& q)
{
  double sum = 0.0;
  for (const double c : q.c)
  {
    sum += std::fabs(c);
  }
  return sum;
}

double zeroOf(const Quartic& q, double start)
{
  QuarticZeros zeros;
  zeros.add(q, start);
  zeros.refine();
  return zeros.zero(0, isLit(q.value(0.0)));
}
}

// Of any quartic that changes its sign between 0 and 1, from any start.
TEST(QuarticZeros, AreZeros)
{
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  long solved = 0;
  for (int i = 0; i < 400000; ++i)
  {
    Quartic q;
    for (double& c : q.c)
    {
      // Of very different sizes, as where an end is nearly a zero.
      c = uniform(engine) * (uniform(engine) > 0.6 ? 1e-5 : 1.0);
    }
    if (isLit(q.value(0.0)) == isLit(q.value(1.0)))
    {
      continue;
    }
    ++solved;
    const double start = uniform(engine) > 0.0 ? q.value(0.0) / (q.value(0.0) - q.value(1.0))
                                               : std::fabs(uniform(engine));
    const double s = zeroOf(q, start);
    ASSERT_GE(s, 0.0);
    ASSERT_LE(s, 1.0);
    ASSERT_LE(std::fabs(q.value(s)), 1e-14 * size(q)) << "quartic " << i << " at " << s;
  }
  EXPECT_GT(solved, 100000);
}

// Found by a fuzzer: an extremum beside the start, where Halley's steps vanish.
TEST(QuarticZeros, AnExtremumIsNoZero)
{
  const Quartic q{ { -2.22e-5, -1.335e-5, 0.9714, 0.7100, 0.9062 } };
  const double s = zeroOf(q, 8.6e-6);
  EXPECT_NEAR(s, 0.0048, 1e-4);
  EXPECT_NEAR(q.value(s), 0.0, 1e-17);
}

TEST(QuarticZeros, FlatOnesAndThoseWithoutNumbersEnd)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Quartic& q : { Quartic{ { 0.0, 0.0, 0.0, 0.0, 0.0 } },
         Quartic{ { nan, 1.0, 0.0, 0.0, 0.0 } }, Quartic{ { 1.0, 0.0, 0.0, 0.0, nan } } })
  {
    const double s = zeroOf(q, 0.3);
    EXPECT_GE(s, 0.0);
    EXPECT_LE(s, 1.0);
  }
}

// Which place a quartic has among others does not matter, to the last bit.
TEST(QuarticZeros, AllPlacesAreAlike)
{
  const Quartic q{ { -0.2, 1.1, 0.3, -0.4, 0.1 } };
  const double alone = zeroOf(q, 0.25);
  for (std::size_t count = 1; count <= QuarticZeros::size; ++count)
  {
    QuarticZeros zeros;
    for (std::size_t i = 0; i < count; ++i)
    {
      zeros.add(q, 0.25);
    }
    zeros.refine();
    for (std::size_t i = 0; i < count; ++i)
    {
      EXPECT_EQ(zeros.zero(i, false), alone);
    }
  }
}
