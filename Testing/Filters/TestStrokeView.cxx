// The widths of strokes as they are seen.

#include "ShadowPipeline.h"
#include "StrokeLines.h"
#include "Tolerances.h"

#include <vtkCellArray.h>
#include <vtkExecutive.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace shadowtest;

TEST(StrokeView, WidthIsExactInWorldUnits)
{
  Random random(1);
  for (int round = 0; round < 50; ++round)
  {
    const Line segment = { randomPoint(random, 1.0), randomPoint(random, 1.0) };
    const Vec3 eye = randomPoint(random, 5.0);
    const bool isPoint = round % 2 == 0;
    const double width = random.uniform(0.001, 0.1);
    const auto strokes = strokesOf(linesOf({ segment }), width);
    strokes->SetEyePosition(eye[0], eye[1], eye[2], isPoint ? 1.0 : 0.0);
    auto ribbon = update(strokes);
    for (const End& end : endsOf(ribbon, segment))
    {
      const Vec3 sight = normalized(isPoint ? eye - end.middle : eye);
      for (const Vec3& offset : end.offsets)
      {
        EXPECT_NEAR(lengthOf(offset), 0.5 * width, tolerance::SamePoint);
        EXPECT_NEAR(dot(offset, sight), 0.0, tolerance::SamePoint);
        EXPECT_NEAR(dot(offset, segment[1] - segment[0]), 0.0, tolerance::SamePoint);
      }
      EXPECT_LT(lengthOf(end.offsets[0] + end.offsets[1]), tolerance::SamePoint);
    }
    // It faces the eye.
    for (vtkIdType cell = 0; cell < ribbon->GetNumberOfPolys(); ++cell)
    {
      vtkIdType count;
      const vtkIdType* ids;
      ribbon->GetPolys()->GetCellAtId(cell, count, ids);
      const Vec3 a = pointOf(ribbon, ids[0]);
      const Vec3 normal = cross(pointOf(ribbon, ids[1]) - a, pointOf(ribbon, ids[2]) - a);
      EXPECT_GT(dot(normal, isPoint ? eye - a : eye), 0.0);
    }
  }
}

TEST(StrokeView, WidthIsExactInPixels)
{
  Random random(2);
  for (int round = 0; round < 50; ++round)
  {
    const bool isPoint = round % 2 == 0;
    Vec3 forward;
    random.direction(forward.data());
    const Vec3 right = normalized(cross(forward, { 0.3, 0.5, 0.7 }));
    const Vec3 up = cross(right, forward);
    const Vec3 eye = randomPoint(random, 1.0) - 8.0 * forward;
    const Line segment = { randomPoint(random, 2.0), randomPoint(random, 2.0) };
    const double pixel = random.uniform(0.001, 0.01);
    const auto strokes = strokesOf(linesOf({ segment }), 3.0);
    strokes->SetWidthUnitToPixels();
    strokes->SetEyePosition(isPoint ? eye[0] : -forward[0], isPoint ? eye[1] : -forward[1],
      isPoint ? eye[2] : -forward[2], isPoint ? 1.0 : 0.0);
    strokes->SetViewDirection(2.0 * forward[0], 2.0 * forward[1], 2.0 * forward[2]);
    strokes->SetPixelSize(pixel);
    const auto inPicture = [&](const Vec3& point) {
      const Vec3 ray = point - eye;
      const double scale = pixel * (isPoint ? dot(ray, forward) : 1.0);
      return Vec3{ dot(ray, right) / scale, dot(ray, up) / scale, 0.0 };
    };
    for (const End& end : endsOf(update(strokes), segment))
    {
      const Vec3 along = normalized(inPicture(segment[1]) - inPicture(segment[0]));
      for (const Vec3& offset : end.offsets)
      {
        const Vec3 seen = inPicture(end.middle + offset) - inPicture(end.middle);
        EXPECT_NEAR(lengthOf(seen), 1.5, 1e4 * tolerance::SamePoint);
        EXPECT_NEAR(dot(seen, along), 0.0, 1e4 * tolerance::SamePoint);
      }
    }
  }
}

TEST(StrokeView, PixelsNeedPointsBeforeTheEye)
{
  const auto strokes = strokesOf(
    linesOf({ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, 0.0, 9.0 }, { 0.0, 1.0, 5.0 } } }),
    2.0);
  strokes->SetWidthUnitToPixels();
  strokes->SetEyePosition(0.0, 0.0, 5.0, 1.0);
  auto ribbon = update(strokes);
  EXPECT_EQ(fieldValue(ribbon, "HiddenPoints"), 2.0);
  EXPECT_EQ(ribbon->GetNumberOfPolys(), 4);

  vtkNew<vtkTest::ErrorObserver> errors;
  strokes->AddObserver(vtkCommand::ErrorEvent, errors);
  strokes->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  strokes->SetViewDirection(0.0, 0.0, 0.0);
  EXPECT_EQ(update(strokes)->GetNumberOfCells(), 0);
  EXPECT_NE(errors->GetErrorMessage().find("ViewDirection (0, 0, 0)"), std::string::npos);
  errors->Clear();
  strokes->SetWidthUnitToWorld();
  EXPECT_GE(update(strokes)->GetNumberOfPolys(), 12);
  strokes->SetEyePosition(0.0, std::nan(""), 0.0, 1.0);
  EXPECT_EQ(update(strokes)->GetNumberOfCells(), 0);
  EXPECT_NE(errors->GetErrorMessage().find("EyePosition (0, nan, 0, 1)"), std::string::npos);
}
