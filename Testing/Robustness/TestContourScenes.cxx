// Cast contours in seeded random scenes full of ties: lines are closed, or end where they may.

#include "ChainChecks.h"
#include "ContourScenes.h"
#include "PolylineDistance.h"
#include "Random.h"
#include "ShadowPipeline.h"
#include "Tolerances.h"

#include <vtkCastShadowContour.h>
#include <vtkExecutive.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>


namespace
{
/// All filters of a scene.
struct ContourPipeline
{
  ContourPipeline(const shadowtest::ContourScene& scene, int kind)
  {
    for (vtkPolyData* mesh : scene.Casters)
    {
      this->Silhouettes.push_back(vtkSmartPointer<vtkSmoothLightSilhouette>::New());
      this->Silhouettes.back()->SetInputData(mesh);
      this->Silhouettes.back()->SetKind(kind);
      this->Silhouettes.back()->SetTolerance(1e-2);
      this->Silhouettes.back()->SetLightPosition(scene.Light.data());
      this->Contour->AddSilhouetteConnection(this->Silhouettes.back()->GetOutputPort());
    }
    for (vtkPolyData* mesh : scene.Receivers)
    {
      this->Contour->AddInputData(1, mesh);
    }
    this->Contour->AddObserver(vtkCommand::ErrorEvent, this->Errors);
    this->Contour->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Errors);
  }

  std::vector<vtkSmartPointer<vtkSmoothLightSilhouette>> Silhouettes;
  vtkNew<vtkCastShadowContour> Contour;
  vtkNew<vtkTest::ErrorObserver> Errors;
};
}

TEST(ContourScenes, LinesAreClosedOrEndWhereTheyMay)
{
  const std::uint64_t first = shadowtest::fromEnvironment("SMOOTHSHADOW_TEST_SEED", 1);
  const std::uint64_t count = shadowtest::fromEnvironment("SMOOTHSHADOW_TEST_SCENES", 1000);
  std::uint64_t refused = 0;
  shadowtest::LineReport all;
  for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed)
  {
    const shadowtest::ContourScene scene = shadowtest::randomContourScene(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind);
    ContourPipeline pipeline(scene, shadowtest::AllKinds[seed % 3]);
    pipeline.Contour->Update();
    if (pipeline.Errors->GetError())
    {
      EXPECT_NE(pipeline.Errors->GetErrorMessage().find("lies on a silhouette"), std::string::npos);
      ++refused;
      continue;
    }
    vtkPolyData* contours = pipeline.Contour->GetOutput();
    EXPECT_EQ(shadowtest::fieldValue(contours, "LooseEnds"), 0.0);
    EXPECT_EQ(shadowtest::nonFiniteNumbers(contours), 0);
    const shadowtest::LineReport report =
      shadowtest::checkLines(contours, scene.Receivers, scene.Light);
    EXPECT_EQ(report.BadEnds, 0);
    EXPECT_EQ(report.BadClosed, 0);
    all.Lines += report.Lines;
    all.ClosedLines += report.ClosedLines;
    all.Segments += report.Segments;
    all.EndsAtBorders += report.EndsAtBorders;
    all.EndsAtCasters += report.EndsAtCasters;
  }
  const auto several = static_cast<vtkIdType>(count);
  EXPECT_GT(all.Lines, 2 * several);
  EXPECT_GT(all.ClosedLines, several / 4);
  EXPECT_GT(all.Segments, 10 * several);
  EXPECT_GT(all.EndsAtBorders, several);
  EXPECT_GT(all.EndsAtCasters, several / 4);
  EXPECT_LT(refused, count / 8);
}

// Hidden parts are cut out of lines and nothing is lost, whatever touches or pierces whatever.
TEST(ContourScenes, HiddenAndVisiblePartsAreTheWhole)
{
  const std::uint64_t first = shadowtest::fromEnvironment("SMOOTHSHADOW_TEST_SEED", 1);
  const std::uint64_t count = shadowtest::fromEnvironment("SMOOTHSHADOW_TEST_SCENES", 1000);
  double hidden = 0.0;
  double visible = 0.0;
  for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed)
  {
    const shadowtest::ContourScene scene = shadowtest::randomContourScene(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind);
    ContourPipeline pipeline(scene, shadowtest::AllKinds[seed % 3]);
    pipeline.Contour->Update();
    if (pipeline.Errors->GetError())
    {
      continue;
    }
    const double whole = shadowtest::lengthOfLines(pipeline.Contour->GetOutput());
    for (vtkPolyData* caster : scene.Casters)
    {
      pipeline.Contour->AddInputData(2, caster);
    }
    pipeline.Contour->KeepHiddenOn();
    pipeline.Contour->Update();
    EXPECT_EQ(shadowtest::nonFiniteNumbers(pipeline.Contour->GetOutput()), 0);
    EXPECT_NEAR(shadowtest::lengthOfLines(pipeline.Contour->GetOutput()), whole,
      shadowtest::tolerance::Moved * whole);
    pipeline.Contour->KeepHiddenOff();
    pipeline.Contour->Update();
    const double seen = shadowtest::lengthOfLines(pipeline.Contour->GetOutput());
    EXPECT_LE(seen, (1.0 + shadowtest::tolerance::Moved) * whole);
    visible += seen;
    hidden += whole - seen;
  }
  EXPECT_GT(visible, static_cast<double>(count));
  EXPECT_GT(hidden, static_cast<double>(count));
}
