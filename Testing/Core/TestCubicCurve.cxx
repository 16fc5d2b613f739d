#include "CubicCurve.h"
#include "SmoothContour.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace shadow;

namespace
{
const CubicCurve Bent{ { Vec3(0.0), Vec3(1.0, 2.0, 0.0), Vec3(2.0, -2.0, 1.0),
  Vec3(3.0, 0.0, 0.5) } };
}

TEST(CubicCurve, PartsOfASplitAreTheCurve)
{
  const auto [first, second] = Bent.split(0.3);
  for (int i = 0; i <= 10; ++i)
  {
    const double s = 0.1 * i;
    EXPECT_NEAR(glm::length(first.point(s) - Bent.point(0.3 * s)), 0.0, 1e-14);
    EXPECT_NEAR(glm::length(second.point(s) - Bent.point(0.3 + 0.7 * s)), 0.0, 1e-14);
  }
}

TEST(CubicCurve, DerivativeIsTheSlope)
{
  const double h = 1e-6;
  for (const double s : { 0.1, 0.5, 0.8 })
  {
    const Vec3 slope = (Bent.point(s + h) - Bent.point(s - h)) / (2.0 * h);
    EXPECT_NEAR(glm::length(slope - Bent.derivative(s)), 0.0, 1e-7);
  }
}

// An S-shaped curve meets its chord in the middle: a bound must not look there only.
TEST(CubicCurve, DeviationBoundHolds)
{
  const CubicCurve s{ { Vec3(0.0), Vec3(1.0, 1.0, 0.0), Vec3(2.0, -1.0, 0.0),
    Vec3(3.0, 0.0, 0.0) } };
  for (const CubicCurve& curve : { Bent, s })
  {
    double largest = 0.0;
    for (int i = 0; i <= 1000; ++i)
    {
      const double t = 0.001 * i;
      largest = std::fmax(
        largest, glm::length(curve.point(t) - (curve.b[0] + t * (curve.b[3] - curve.b[0]))));
    }
    EXPECT_LE(largest, curve.deviationBound());
    EXPECT_GT(largest, 0.25 * curve.deviationBound());
  }
}

TEST(SmoothContour, SegmentKeepsACirclesArc)
{
  const double angle = 0.2;
  const Vec3 p0(1.0, 0.0, 0.0);
  const Vec3 p1(std::cos(angle), std::sin(angle), 0.0);
  const CubicCurve curve = contourSegment(p0, p0, p1, p1);
  for (int i = 0; i <= 10; ++i)
  {
    EXPECT_NEAR(glm::length(curve.point(0.1 * i)), 1.0, 1e-8);
  }
}

TEST(SmoothContour, SubdivisionIsWithinItsTolerance)
{
  const auto inSpace = [](const CubicCurve& c)
  { return Deviation{ c.deviationBound(), 2.0 * c.deviationBound() }; };
  std::vector<double> breaks;
  const auto listBreak = [&](double s) { breaks.push_back(s); };
  const Deviation bound = subdivide(Bent, { 1e-3, 0.0 }, inSpace, listBreak);
  EXPECT_LE(bound.seen, 1e-3);
  EXPECT_EQ(bound.world, 0.5 * bound.seen);
  EXPECT_GT(breaks.size(), 10u);
  EXPECT_TRUE(std::is_sorted(breaks.begin(), breaks.end()));
  const std::size_t fine = breaks.size();
  breaks.clear();
  EXPECT_LE(subdivide(Bent, { 0.0, 1e-2 }, inSpace, listBreak).world, 1e-2);
  EXPECT_LT(breaks.size(), fine);
  breaks.clear();
  EXPECT_LT(
    subdivide(CubicCurve::line(Vec3(0.0), Vec3(1.0)), { 1e-12, 0.0 }, inSpace, listBreak).seen,
    1e-12);
  EXPECT_TRUE(breaks.empty());
}

TEST(SmoothContour, SegmentsWithoutLengthOrTangentAreFinite)
{
  const Vec3 p(1.0, 2.0, 3.0);
  EXPECT_TRUE(isFinite(contourSegment(p, p, p, p).point(0.5)));
  EXPECT_TRUE(isFinite(
    contourSegment(p, Vec3(0.0, 0.0, 1.0), p + Vec3(0.0, 0.0, 1.0), Vec3(0.0)).point(0.5)));
}
