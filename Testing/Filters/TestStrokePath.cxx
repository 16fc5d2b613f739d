// Lines as if drawn by hand: unsteady, pointed, and longer than they are.

#include "StrokeLines.h"
#include "Tolerances.h"

#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace shadowtest;

TEST(StrokePath, WobbleStaysWithinItsBound)
{
  // Two lines of 500 widths.
  const double width = 0.02;
  const Line segment = { { 0.0, 0.0, 0.0 }, { 10.0, 0.0, 0.0 } };
  const auto strokes = strokesOf(linesOf({ segment, segment }), width);
  strokes->SetWobble(1.5);
  std::set<Line> different;
  for (const int seed : { 1, 2, 1 })
  {
    strokes->SetSeed(seed);
    strokes->Modified();
    const Line middles = middlesOf(update(strokes));
    ASSERT_GT(middles.size(), 2u * 8u * 12u);
    double least = 0.0;
    double most = 0.0;
    for (const Vec3& point : middles)
    {
      least = std::min(least, point[1]);
      most = std::max(most, point[1]);
      EXPECT_EQ(point[2], 0.0);
    }
    EXPECT_LE(most, 1.5 * width);
    EXPECT_GE(least, -1.5 * width);
    EXPECT_GT(most, 0.7 * width);
    EXPECT_LT(least, -0.7 * width);
    different.insert(middles);
    // Each line has its own: no point but by chance is there twice.
    EXPECT_EQ(std::set<Vec3>(middles.begin(), middles.end()).size(), middles.size());
  }
  EXPECT_EQ(different.size(), 2u);
  // Where it is asked for less often there are fewer points.
  const vtkIdType before = strokes->GetOutput()->GetNumberOfPoints();
  strokes->SetWobbleLength(160.0);
  EXPECT_LT(update(strokes)->GetNumberOfPoints(), before / 2);

  // All around a closed line it is smooth: over a segment, 1.6 widths, it changes by no more than
  // 1.5 times as much as it would evenly from -1 to 1 over 40 widths.
  const auto around = strokesOf(linesOf({ circle(400, 2.0) }, true), width);
  around->SetWobble(1.0);
  std::vector<double> radii;
  for (const Vec3& point : middlesOf(update(around)))
  {
    radii.push_back(lengthOf(point));
  }
  ASSERT_GT(radii.size(), 400u);
  const auto [low, high] = std::minmax_element(radii.begin(), radii.end());
  EXPECT_GT(*high - *low, width);
  EXPECT_LE(*high, 2.0 + width);
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    EXPECT_LT(std::fabs(radii[i] - radii[(i + 1) % radii.size()]), 0.12 * width);
  }
}

// A short line is hardly unsteady: over a tenth of the way from one random number to the next the
// curve moves by less than 3% of the way between them, which is at most 2.
TEST(StrokePath, ShortLinesAreSteady)
{
  const double width = 0.02;
  std::vector<Line> lines;
  for (int i = 0; i < 50; ++i)
  {
    lines.push_back({ { 0.0, 0.1 * i, 0.0 }, { 4.0 * width, 0.1 * i, 0.0 } });
  }
  const auto strokes = strokesOf(linesOf(lines), width);
  strokes->SetWobble(1.0);
  const Line middles = middlesOf(update(strokes));
  ASSERT_EQ(middles.size(), 2 * lines.size());
  double most = 0.0;
  for (std::size_t i = 0; i < middles.size(); i += 2)
  {
    const double change = (middles[i + 1] - lines[i / 2][1])[1] - (middles[i] - lines[i / 2][0])[1];
    most = std::max(most, std::fabs(change));
  }
  EXPECT_GT(most, 0.02 * width);
  EXPECT_LT(most, 0.06 * width);
}

TEST(StrokePath, TapersFromNothing)
{
  const Line line = { { 0.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 10.0, 0.0, 0.0 } };
  const auto strokes = strokesOf(linesOf({ line }), 0.3);
  for (const double taper : { 0.25, 0.5 })
  {
    strokes->SetTaper(taper);
    auto ribbon = update(strokes);
    std::set<double> places;
    for (vtkIdType id = 0; id < ribbon->GetNumberOfPoints(); ++id)
    {
      const Vec3 point = pointOf(ribbon, id);
      const double share = std::min(1.0, std::min(point[0], 10.0 - point[0]) / (10.0 * taper));
      places.insert(point[0]);
      const double across = ribbon->GetPointData()->GetArray("Across")->GetComponent(id, 0);
      EXPECT_NEAR(point[1], 0.15 * share * across, tolerance::SamePoint);
    }
    EXPECT_EQ(places.size(), taper == 0.25 ? 5u : 4u); // ends, middle, and where it is wide
    for (const double area : doubleAreas(ribbon))
    {
      EXPECT_GT(area, 0.0);
    }
    double area = 0.0;
    for (const double part : doubleAreas(ribbon))
    {
      area += 0.5 * part;
    }
    EXPECT_NEAR(area, 0.3 * 10.0 * (1.0 - taper), 10.0 * tolerance::SamePoint);
  }
}

TEST(StrokePath, OvershootsByWidths)
{
  const Line line = { { 0.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 4.0, 3.0, 0.0 } };
  const auto strokes = strokesOf(linesOf({ line }), 0.1);
  strokes->SetOvershoot(2.5);
  auto ribbon = update(strokes);
  EXPECT_NEAR(ribbon->GetBounds()[0], -0.25, tolerance::SamePoint);
  EXPECT_NEAR(ribbon->GetBounds()[3], 3.25, tolerance::SamePoint);
  EXPECT_NEAR(ribbon->GetBounds()[1], 4.05, tolerance::SamePoint);
  EXPECT_EQ(ribbon->GetNumberOfPolys(), 8);
}
