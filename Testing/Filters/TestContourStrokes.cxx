// The filter: what it leaves out, lifts and takes along.

#include "OutputComparison.h"
#include "ShadowPipeline.h"
#include "StrokeLines.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCastShadowContour.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkSmoothLightSilhouette.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

using namespace shadowtest;

TEST(ContourStrokes, LeavesOutWhatCannotBeDrawn)
{
  vtkNew<vtkPolyData> nothing;
  EXPECT_EQ(update(strokesOf(nothing, 1.0))->GetNumberOfCells(), 0);

  const double nan = std::nan("");
  const Vec3 a{ 0.0, 0.0, 0.0 };
  const Vec3 b{ 1.0, 0.0, 0.0 };
  const Vec3 c{ 2.0, 0.0, 0.0 };
  // Twice without length, once repeated points, once parted, once twice not finite.
  const auto lines =
    linesOf({ { a }, { b, b, b }, { a, a, b, b, c }, { a, b, { nan, 0.0, 0.0 }, a, c },
      { { 0.0, nan, 0.0 }, { 0.0, 0.0, std::numeric_limits<double>::infinity() } } });
  lines->GetLines()->InsertNextCell({ 0, 4, 999, -1 });
  lines->GetLines()->InsertNextCell(0);
  const auto strokes = strokesOf(lines, 0.1);
  auto ribbons = update(strokes);
  std::vector<int> triangles(7);
  for (vtkIdType cell = 0; cell < ribbons->GetNumberOfPolys(); ++cell)
  {
    const double line = ribbons->GetCellData()->GetArray("Line")->GetComponent(cell, 0);
    ++triangles.at(static_cast<std::size_t>(line));
  }
  // The last one has two points at one place.
  EXPECT_EQ(triangles, (std::vector<int>{ 0, 0, 8, 8, 0, 0, 0 }));
  EXPECT_EQ(fieldValue(ribbons, "NonFinitePoints"), 5.0);
  EXPECT_EQ(fieldValue(ribbons, "DegenerateLines"), 3.0);
  EXPECT_EQ(fieldValue(ribbons, "HiddenPoints"), 0.0);
  for (vtkIdType id = 0; id < ribbons->GetNumberOfPoints(); ++id)
  {
    EXPECT_TRUE(std::isfinite(lengthOf(pointOf(ribbons, id))));
  }

  // A closed line without one of its points is one piece that starts behind that.
  Line broken = circle(20, 1.0);
  broken[7][1] = nan;
  ribbons = update(strokesOf(linesOf({ broken }, true), 0.1));
  EXPECT_EQ(ribbons->GetNumberOfPolys(), 4 * 18);
  EXPECT_EQ(fieldValue(ribbons, "NonFinitePoints"), 1.0);

  // Along the line of sight nothing is seen of it, and nothing breaks.
  const Line bent = { a, { 0.0, 0.0, 1.0 }, { 1.0, 0.0, 1.0 } };
  const auto sight = strokesOf(linesOf({ bent }), 0.1);
  ribbons = update(sight);
  ASSERT_EQ(ribbons->GetNumberOfPoints(), 9);
  for (vtkIdType id = 0; id < 9; ++id)
  {
    const double across = ribbons->GetPointData()->GetArray("Across")->GetComponent(id, 0);
    EXPECT_NEAR(distanceToLine(pointOf(ribbons, id), bent, false), across == 0.0 ? 0.0 : 0.05,
      tolerance::SamePoint);
  }
  sight->SetWobble(0.5);
  ribbons = update(sight);
  ASSERT_GT(ribbons->GetNumberOfPolys(), 8);
  for (vtkIdType id = 0; id < ribbons->GetNumberOfPoints(); ++id)
  {
    EXPECT_TRUE(std::isfinite(lengthOf(pointOf(ribbons, id))));
  }
}

TEST(ContourStrokes, SameForAnyNumberOfThreads)
{
  Random random(4);
  std::vector<Line> lines;
  for (int i = 0; i < 300; ++i)
  {
    lines.push_back(zigzag(random, random.integer(1, 20)));
  }
  const auto strokes = strokesOf(linesOf(lines), 0.1);
  strokes->SetWobble(0.4);
  strokes->SetTaper(0.2);
  strokes->SetOvershoot(1.0);
  const std::string usual = vtkSMPTools::GetBackend();
  ASSERT_TRUE(vtkSMPTools::SetBackend("Sequential"));
  vtkNew<vtkPolyData> serial;
  serial->DeepCopy(update(strokes));
  ASSERT_TRUE(vtkSMPTools::SetBackend("STDThread"));
  vtkSMPTools::Initialize(4);
  strokes->Modified();
  auto threaded = update(strokes);
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(usual.c_str());
  ASSERT_GT(serial->GetNumberOfPolys(), 3000);
  EXPECT_TRUE(sameBytes(serial->GetPoints()->GetData(), threaded->GetPoints()->GetData()));
  EXPECT_TRUE(sameBytes(
    serial->GetPolys()->GetConnectivityArray(), threaded->GetPolys()->GetConnectivityArray()));
  EXPECT_EQ(differingArray(serial->GetCellData(), threaded->GetCellData()), "");
}

TEST(ContourStrokes, LiftedOffTheReceiverIntoTheShadow)
{
  vtkNew<vtkSmoothLightSilhouette> silhouette;
  silhouette->SetInputData(icosphere(3));
  silhouette->SetLightPosition(0.4, 0.3, 1.0, 0.0);
  vtkNew<vtkCastShadowContour> contour;
  contour->SetSilhouetteConnection(silhouette->GetOutputPort());
  contour->AddInputData(1, ground(-2.0, 8.0, 5));
  contour->Update();
  vtkPolyData* line = contour->GetOutput();
  ASSERT_EQ(line->GetNumberOfLines(), 1);
  const double width = 0.05;
  const auto strokes = strokesOf(line, width);
  strokes->SetLift(0.5);
  strokes->SetEyePosition(3.0, -9.0, 4.0, 1.0);
  auto ribbon = update(strokes);
  ASSERT_EQ(middlesOf(ribbon).size(), static_cast<std::size_t>(line->GetNumberOfPoints()));
  EXPECT_GT(ribbon->GetBounds()[4], -2.0); // no part of it is under the ground
  for (vtkIdType id = 0; id < line->GetNumberOfPoints(); ++id)
  {
    Vec3 into;
    line->GetPointData()->GetArray("ShadowDirection")->GetTuple(id, into.data());
    const Vec3 wanted = pointOf(line, id) + 0.5 * width * (into + Vec3{ 0.0, 0.0, 1.0 });
    EXPECT_LT(lengthOf(middlesOf(ribbon)[static_cast<std::size_t>(id)] - wanted),
      10.0 * tolerance::SamePoint);
  }
  // The contour's own data come along.
  EXPECT_EQ(ribbon->GetCellData()->GetArray("Visible")->GetComponent(7, 0), 1.0);
  EXPECT_NE(ribbon->GetPointData()->GetArray("CasterPoints"), nullptr);
  EXPECT_EQ(fieldValue(ribbon, "LightPosition"), 0.4);

  // Other lines come nearer to the eye.
  const Line segment = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } };
  const auto towards = strokesOf(linesOf({ segment }), 0.2);
  towards->SetLift(0.75);
  towards->SetEyePosition(0.0, 0.0, 6.0, 0.0);
  EXPECT_NEAR(update(towards)->GetBounds()[4], 0.15, tolerance::SamePoint);
  EXPECT_NEAR(towards->GetOutput()->GetBounds()[5], 0.15, tolerance::SamePoint);
}

TEST(ContourStrokes, DataComeAlong)
{
  const auto lines =
    linesOf({ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 }, { 1.0, 1.0, 0.0 } } });
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  lines->SetVerts(vertices);
  vtkNew<vtkDoubleArray> values;
  values->SetName("X");
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType id = 0; id < 4; ++id)
  {
    values->InsertNextValue(pointOf(lines, id)[0]);
  }
  for (const int number : { 5, 6, 7 })
  {
    numbers->InsertNextValue(number);
  }
  lines->GetPointData()->AddArray(values);
  lines->GetCellData()->AddArray(numbers);
  const auto strokes = strokesOf(lines, 0.01);
  strokes->SetTaper(0.3);
  auto ribbons = update(strokes);
  ASSERT_EQ(
    ribbons->GetPointData()->GetArray("X")->GetNumberOfTuples(), ribbons->GetNumberOfPoints());
  for (vtkIdType id = 0; id < ribbons->GetNumberOfPoints(); ++id)
  {
    EXPECT_NEAR(ribbons->GetPointData()->GetArray("X")->GetComponent(id, 0),
      pointOf(ribbons, id)[0], tolerance::SamePoint);
  }
  std::set<double> found;
  for (vtkIdType cell = 0; cell < ribbons->GetNumberOfPolys(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    ribbons->GetPolys()->GetCellAtId(cell, count, ids);
    const double number = ribbons->GetCellData()->GetArray("Number")->GetComponent(cell, 0);
    EXPECT_EQ(number, pointOf(ribbons, ids[0])[1] > 0.5 ? 7.0 : 6.0);
    EXPECT_EQ(ribbons->GetCellData()->GetArray("Line")->GetComponent(cell, 0), number - 6.0);
    found.insert(number);
  }
  EXPECT_EQ(found.size(), 2u);
}

/// Arrays that have too few values are left out, not read beyond their end.
TEST(ContourStrokes, ArraysThatAreTooShort)
{
  const auto lines = linesOf({ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 2.0, 1.0, 0.0 } } });
  for (const char* name : { "ReceiverNormals", "ShadowDirection", "Other" })
  {
    vtkNew<vtkDoubleArray> vectors;
    vectors->SetName(name);
    vectors->SetNumberOfComponents(3);
    vectors->InsertNextTuple3(0.0, 0.0, 1.0);
    lines->GetPointData()->AddArray(vectors);
  }
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Numbers");
  lines->GetCellData()->AddArray(numbers);
  vtkNew<vtkContourStrokes> strokes;
  strokes->SetInputData(lines);
  strokes->SetWidthUnitToWorld();
  strokes->SetWidth(0.1);
  strokes->SetEyePosition(0.0, 0.0, 10.0, 1.0);
  strokes->Update();
  vtkPolyData* ribbons = strokes->GetOutput();
  ASSERT_GT(ribbons->GetNumberOfPolys(), 0);
  EXPECT_FALSE(ribbons->GetPointData()->HasArray("Other"));
  EXPECT_FALSE(ribbons->GetCellData()->HasArray("Numbers"));
  double bounds[6];
  ribbons->GetBounds(bounds);
  EXPECT_LT(bounds[1] - bounds[0], 2.5);
}

/// VTK's limits of settings let NaN through.
TEST(ContourStrokes, SettingsThatAreNotFinite)
{
  const auto lines = linesOf({ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } } });
  vtkNew<vtkContourStrokes> strokes;
  vtkNew<vtkTest::ErrorObserver> errors;
  strokes->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  strokes->AddObserver(vtkCommand::ErrorEvent, errors);
  strokes->SetInputData(lines);
  strokes->SetLift(std::numeric_limits<double>::quiet_NaN());
  strokes->Update();
  EXPECT_TRUE(errors->GetError());
  EXPECT_NE(errors->GetErrorMessage().find("Lift"), std::string::npos);
  EXPECT_EQ(strokes->GetOutput()->GetNumberOfPolys(), 0);
}
