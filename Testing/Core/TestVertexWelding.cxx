#include "VertexWelding.h"

#include <gtest/gtest.h>

#include <limits>

using namespace shadow;

TEST(VertexWelding, EqualPointsAreOneAndZeroHasNoSign)
{
  const Welding w = weldPoints(
    { { 0.0, 1.0, 2.0 }, { 3.0, 0.0, 0.0 }, { -0.0, 1.0, 2.0 }, { 3.0, -0.0, 0.0 }, { 3.0, 0.0, 1e-300 } });
  EXPECT_EQ(w.target, (std::vector<Index>{ 0, 1, 0, 1, 2 }));
  EXPECT_EQ(w.first, (std::vector<Index>{ 0, 1, 4 }));
}

TEST(VertexWelding, NeighbouringDoublesStayApart)
{
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_EQ(weldPoints({ { 1.0, 0.0, 0.0 }, { next, 0.0, 0.0 } }).first.size(), 2u);
}

TEST(VertexWelding, WhatIsNoNumberStaysSingle)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(weldPoints({ { nan, 0.0, 0.0 }, { nan, 0.0, 0.0 } }).first.size(), 2u);
}

TEST(VertexWelding, NormalsAreWeldedPerVertex)
{
  const Vec3 up{ 0.0, 0.0, 1.0 };
  const Vec3 aside{ 1.0, 0.0, 0.0 };
  const Welding w = weldNormals({ up, aside, up, up, aside }, { 0, 0, 0, 1, 0 });
  EXPECT_EQ(w.target, (std::vector<Index>{ 0, 1, 0, 2, 1 }));
}
