// The triangles of ribbons, above all at corners.

#include "StrokeLines.h"
#include "Tolerances.h"

#include <vtkCellArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace shadowtest;

// No gap at any corner, nothing turned over, and nothing farther away than the longest mitre.
TEST(Strokes, CornersAreFilled)
{
  Random random(3);
  const double width = 0.2;
  int sampled = 0;
  for (int round = 0; round < 40; ++round)
  {
    SCOPED_TRACE("round " + std::to_string(round));
    const Line line = zigzag(random, 9);
    const bool closed = round % 2 == 1;
    auto ribbon = update(strokesOf(linesOf({ line }, closed), width));
    for (const double area : doubleAreas(ribbon))
    {
      EXPECT_GE(area, -width * tolerance::SamePoint);
    }
    double farthest = 0.0;
    for (vtkIdType id = 0; id < ribbon->GetNumberOfPoints(); ++id)
    {
      farthest = std::max(farthest, distanceToLine(pointOf(ribbon, id), line, closed));
    }
    EXPECT_LT(farthest, width * (1.0 + tolerance::SamePoint));
    EXPECT_GT(farthest, 0.5 * width * (1.0 - tolerance::SamePoint));
    for (int i = 0; i < 300; ++i)
    {
      // Around corners above all, which are round to a fiftieth: cos(pi / 16).
      const auto corner =
        static_cast<std::size_t>(random.integer(0, static_cast<int>(line.size()) - 1));
      const Vec3 place =
        line[corner] + Vec3{ random.uniform(-width, width), random.uniform(-width, width), 0.0 };
      const bool isAtEnd = !closed &&
        std::min(lengthOf(place - line.front()), lengthOf(place - line.back())) < 0.5 * width;
      if (!isAtEnd && distanceToLine(place, line, closed) < 0.49 * width)
      {
        EXPECT_TRUE(covers(ribbon, place)) << place[0] << ", " << place[1];
        ++sampled;
      }
    }
  }
  EXPECT_GT(sampled, 2000);
}

// The same of lines in space, in both units: seen from the eye each triangle is counter-clockwise.
TEST(Strokes, NothingIsTurnedOver)
{
  Random random(5);
  vtkIdType triangles = 0;
  for (int round = 0; round < 200; ++round)
  {
    SCOPED_TRACE("round " + std::to_string(round));
    Line line;
    for (int i = 0; i < 12; ++i)
    {
      const bool isShort = i > 0 && random.chance(0.4);
      line.push_back(isShort ? line.back() + randomPoint(random, 0.03) : randomPoint(random, 1.0));
    }
    const auto strokes = strokesOf(linesOf({ line }, round % 3 == 0), 0.05);
    const Vec3 eye = { 0.0, 0.0, 4.0 };
    strokes->SetEyePosition(eye[0], eye[1], eye[2], 1.0);
    if (round % 2 == 0)
    {
      strokes->SetWidthUnitToPixels();
      strokes->SetWidth(6.0);
      strokes->SetPixelSize(0.002);
    }
    strokes->SetTaper(round % 5 == 0 ? 0.4 : 0.0);
    strokes->SetWobble(round % 7 == 0 ? 0.3 : 0.0);
    const auto ribbon = update(strokes);
    triangles += ribbon->GetNumberOfPolys();
    for (vtkIdType cell = 0; cell < ribbon->GetNumberOfPolys(); ++cell)
    {
      vtkIdType count;
      const vtkIdType* ids;
      ribbon->GetPolys()->GetCellAtId(cell, count, ids);
      const Vec3 a = pointOf(ribbon, ids[0]);
      const Vec3 normal = cross(pointOf(ribbon, ids[1]) - a, pointOf(ribbon, ids[2]) - a);
      EXPECT_GT(dot(normal, eye - a), -tolerance::SamePoint);
    }
  }
  EXPECT_GT(triangles, 10000);
}

TEST(Strokes, MitredAndRoundCorners)
{
  // A right angle has its mitre's tip; a turn of 160 degrees none.
  for (const bool sharp : { false, true })
  {
    const double angle = (sharp ? 20.0 : 90.0) * std::acos(-1.0) / 180.0;
    const Line line = { { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 },
      { std::cos(angle), std::sin(angle), 0.0 } };
    auto ribbon = update(strokesOf(linesOf({ line }), 0.2));
    double farthest = 0.0;
    for (vtkIdType id = 0; id < ribbon->GetNumberOfPoints(); ++id)
    {
      farthest = std::max(farthest, distanceToLine(pointOf(ribbon, id), line, false));
    }
    EXPECT_NEAR(farthest, sharp ? 0.1 : 0.1 * std::sqrt(2.0), tolerance::SamePoint);
    EXPECT_EQ(ribbon->GetNumberOfPolys() > 8, sharp);
  }
}

TEST(Strokes, ClosedLinesClose)
{
  const Line line = circle(60, 2.0);
  for (const bool closed : { false, true })
  {
    auto ribbon = update(strokesOf(linesOf({ line }, closed), 0.1));
    EXPECT_EQ(ribbon->GetNumberOfPolys(), 4 * (closed ? 60 : 59));
    EXPECT_EQ(ribbon->GetNumberOfPoints(), 180);
    // Between the first and the last point.
    EXPECT_EQ(covers(ribbon, 0.5 * (line.front() + line.back())), closed);
    double area = 0.0;
    for (const double part : doubleAreas(ribbon))
    {
      EXPECT_GT(part, 0.0);
      area += 0.5 * part;
    }
    const double side = lengthOf(line[1] - line[0]);
    EXPECT_EQ(std::fabs(area - 60.0 * side * 0.1) < 60.0 * tolerance::SamePoint, closed);
  }
  // Equal coordinates close a line, too. Neither taper nor overshoot has an end to be at.
  Line repeated = line;
  repeated.push_back(line.front());
  const auto strokes = strokesOf(linesOf({ repeated }), 0.1);
  strokes->SetTaper(0.3);
  strokes->SetOvershoot(2.0);
  EXPECT_EQ(update(strokes)->GetNumberOfPolys(), 240);
}

// Coordinates and widths at the ends of what doubles hold neither hang nor give what is not finite.
TEST(Strokes, ExtremeLengths)
{
  for (const double size : { 1e-200, 1e150, 1e300 })
  {
    for (const double width : { 1e-300, 1.0, 1e200 })
    {
      const auto strokes = strokesOf(
        linesOf({ { { 0.0, 0.0, 0.0 }, { size, 0.0, 0.0 }, { size, size, 0.0 } } }), width);
      strokes->SetWobble(0.5);
      strokes->SetTaper(0.2);
      strokes->SetOvershoot(1.0);
      strokes->SetLift(0.5);
      const auto ribbon = update(strokes);
      EXPECT_GE(ribbon->GetNumberOfPoints(), 3);
      EXPECT_LT(ribbon->GetNumberOfPoints(), 200000);
      for (vtkIdType id = 0; id < ribbon->GetNumberOfPoints(); ++id)
      {
        for (const double coordinate : pointOf(ribbon, id))
        {
          EXPECT_TRUE(std::isfinite(coordinate)) << size << ", " << width;
        }
      }
    }
  }
}
