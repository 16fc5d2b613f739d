// Contracts and invariants of the silhouette filter.

#include "ChainChecks.h"
#include "HostileMeshes.h"
#include "RandomMeshes.h"
#include "RealMeshes.h"
#include "ShadowPipeline.h"
#include "SilhouetteOracle.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkStripper.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using shadowtest::LightPosition;
using shadowtest::ShadowPipeline;

const LightPosition Lights[] = { { 0.3, 0.2, 1.0, 0.0 }, { 0.0, 0.0, 1.0, 0.0 },
  { 1.0, 0.0, 0.0, 0.0 }, { 1.1, -2.7, 3.1, 1.0 }, { 0.0, 0.0, 5.0, 1.0 } };

vtkIdType loopsWithKind(vtkPolyData* silhouette, int kind)
{
  vtkDataArray* kinds = silhouette->GetCellData()->GetArray("Kind");
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < kinds->GetNumberOfTuples(); ++i)
  {
    count += kinds->GetComponent(i, 0) == kind;
  }
  return count;
}

bool isOnAPoint(vtkPolyData* mesh, const LightPosition& light)
{
  for (vtkIdType i = 0; light[3] != 0.0 && i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    if (p[0] == light[0] / light[3] && p[1] == light[1] / light[3] && p[2] == light[2] / light[3])
    {
      return true;
    }
  }
  return false;
}

void expectEqualOutputs(vtkPolyData* expected, vtkPolyData* actual)
{
  ASSERT_EQ(expected->GetNumberOfPoints(), actual->GetNumberOfPoints());
  ASSERT_EQ(expected->GetNumberOfCells(), actual->GetNumberOfCells());
  for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_EQ(expected->GetPoint(i)[c], actual->GetPoint(i)[c]);
    }
  }
}
}

TEST(SmoothLightSilhouette, LoopsOfKnownShapesAreClosed)
{
  const std::pair<const char*, shadowtest::Mesh> meshes[] = {
    { "sphere", shadowtest::sphere(12, 24) }, { "torus", shadowtest::torus(36, 18) },
    { "cylinder", shadowtest::cylinder(16) }, { "box", shadowtest::box() },
    { "welded box", shadowtest::weldedBox() }, { "quads", shadowtest::quadBox() },
    { "triangle", shadowtest::triangle() }, { "Moebius", shadowtest::moebiusStrip(20) },
    { "fin of 3", shadowtest::fin(3) }, { "fin of 5", shadowtest::fin(5) },
    { "slivers", shadowtest::slivers(10, 1e-12) }, { "T", shadowtest::tJunction() }
  };
  for (const auto& [name, mesh] : meshes)
  {
    for (const LightPosition& light : Lights)
    {
      for (const int kind : shadowtest::AllKinds)
      {
        ShadowPipeline pipeline(mesh, light, kind);
        const shadowtest::LoopReport report = shadowtest::checkLoops(pipeline.silhouette());
        EXPECT_TRUE(report.good()) << name << ", kind " << kind << ": " << report;
        EXPECT_GT(report.Segments, 2) << name << ", kind " << kind;
      }
    }
  }
}

TEST(SmoothLightSilhouette, BunnyIsClosed)
{
  const auto bunny = shadowtest::bunny();
  for (const int kind : shadowtest::AllKinds)
  {
    ShadowPipeline pipeline(bunny, { 1.5, 3.0, 2.0, 1.0 }, kind);
    const shadowtest::LoopReport report = shadowtest::checkLoops(pipeline.silhouette());
    EXPECT_TRUE(report.good()) << report;
    EXPECT_GT(report.Segments, 500);
    EXPECT_EQ(shadowtest::fieldValue(pipeline.silhouette(), "BoundaryEdges"), 0.0);
  }
}

// The oracle shares no code with the filter.
TEST(SmoothLightSilhouette, DiscreteAndAccurateEqualTheOracle)
{
  std::size_t segments = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed)
  {
    const shadowtest::RandomMesh scene = shadowtest::randomMesh(seed);
    if (isOnAPoint(scene.Surface, scene.Light))
    {
      continue; // the filter lifts such a light off the surface
    }
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind);
    const shadowtest::SegmentChain discrete =
      shadowtest::discreteSilhouette(scene.Surface, scene.Light.data());
    ShadowPipeline pipeline(scene.Surface, scene.Light, vtkSmoothLightSilhouette::DISCRETE);
    const double size =
      shadowtest::tolerance::SamePoint * std::fmax(scene.Surface->GetLength(), 1e-300);
    if (scene.Exact || discrete.Margin > shadowtest::tolerance::TooClose)
    {
      const auto difference =
        compareChains(discrete, shadowtest::chainOf(pipeline.silhouette()), size);
      EXPECT_TRUE(difference.none()) << difference.Message;
      segments += difference.Expected;
    }
    if (!shadowtest::hasUsableNormals(scene.Surface))
    {
      continue;
    }
    const shadowtest::SegmentChain accurate =
      shadowtest::accurateSilhouette(scene.Surface, scene.Light.data());
    if (std::fmin(accurate.Margin, accurate.WindingMargin) > shadowtest::tolerance::TooClose)
    {
      pipeline.Silhouette->SetKindToAccurate();
      const auto difference =
        compareChains(accurate, shadowtest::chainOf(pipeline.silhouette()), size);
      EXPECT_TRUE(difference.none()) << difference.Message;
      segments += difference.Expected;
    }
  }
  EXPECT_GT(segments, 2000u);
}

TEST(SmoothLightSilhouette, PolylinesAreWithinTheTolerance)
{
  const shadowtest::Mesh torus = shadowtest::torus(24, 12);
  ShadowPipeline pipeline(torus, Lights[3], vtkSmoothLightSilhouette::SMOOTH);
  vtkIdType last = 0;
  for (const double tolerance : { 1e-2, 1e-3, 1e-4, 1e-5 })
  {
    pipeline.Silhouette->SetToleranceModeToWorld();
    pipeline.Silhouette->SetTolerance(tolerance);
    vtkPolyData* output = pipeline.silhouette();
    EXPECT_LE(shadowtest::fieldValue(output, "MaximumDeviation"), tolerance);
    EXPECT_GT(shadowtest::fieldValue(output, "MaximumDeviation"), 0.0);
    EXPECT_GE(output->GetNumberOfPoints(), last);
    last = output->GetNumberOfPoints();
  }
  pipeline.Silhouette->SetToleranceModeToRelative();
  pipeline.Silhouette->SetTolerance(1e-5 / torus->GetLength());
  EXPECT_NEAR(static_cast<double>(pipeline.silhouette()->GetNumberOfPoints()),
    static_cast<double>(last), 2.0);
}

TEST(SmoothLightSilhouette, CreasesAndBordersAreNamed)
{
  ShadowPipeline cylinder(
    shadowtest::cylinder(24), { 0.4, 0.2, 1.0, 0.0 }, vtkSmoothLightSilhouette::SMOOTH);
  EXPECT_EQ(loopsWithKind(cylinder.silhouette(), 3), 1) << "one loop of contours and rims";

  ShadowPipeline box(
    shadowtest::box(), { 0.3, 0.2, 1.0, 0.0 }, vtkSmoothLightSilhouette::SMOOTH);
  EXPECT_EQ(loopsWithKind(box.silhouette(), 1), 1);
  EXPECT_EQ(box.silhouette()->GetNumberOfCells(), 1);

  ShadowPipeline sheet(
    shadowtest::ground(0.0, 1.0, 3), { 0.3, 0.2, 1.0, 0.0 }, vtkSmoothLightSilhouette::ACCURATE);
  EXPECT_EQ(loopsWithKind(sheet.silhouette(), 2), 1);
}

// What a turned or mirrored copy of the input casts is the same, turned.
TEST(SmoothLightSilhouette, MisorientedNormalsAndWindingsDoNotMatter)
{
  const shadowtest::Mesh torus = shadowtest::torus(18, 9);
  const auto expected = shadowtest::chainOf(
    ShadowPipeline(torus, Lights[3], vtkSmoothLightSilhouette::SMOOTH).silhouette());
  vtkNew<vtkPolyData> inward;
  inward->DeepCopy(torus);
  inward->BuildCells();
  for (vtkIdType i = 0; i < inward->GetNumberOfCells(); ++i)
  {
    inward->ReverseCell(i);
  }
  inward->GetPolys()->Modified();
  const auto actual = shadowtest::chainOf(
    ShadowPipeline(inward, Lights[3], vtkSmoothLightSilhouette::SMOOTH).silhouette());
  const auto difference = compareChains(expected, actual, shadowtest::tolerance::SamePoint);
  EXPECT_TRUE(difference.none()) << difference.Message;
  EXPECT_GT(difference.Expected, 20u);
}

// Where they cancel in between, a point has the normal of one of the two.
TEST(SmoothLightSilhouette, OppositeNormalsAtAnEdgesEndsGiveUnitNormals)
{
  shadowtest::MeshBuilder triangle;
  triangle.addPoint({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
  triangle.addPoint({ 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 });
  triangle.addPoint({ 0.0, 1.0, 0.0 }, { 0.0, 0.0, -1.0 });
  triangle.addTriangle(0, 1, 2);
  // The triangles of the other one are wound at random, so estimated normals are opposite, too.
  const shadowtest::Mesh meshes[] = { triangle.build(), shadowtest::cgalMesh("oblong-shuffled") };
  for (const shadowtest::Mesh& mesh : meshes)
  {
    for (const int kind : shadowtest::AllKinds)
    {
      for (const LightPosition& light : { Lights[1], Lights[2], LightPosition{ -1, 0, -1, 0 } })
      {
        ShadowPipeline pipeline(mesh, light, kind);
        const shadowtest::LoopReport report = shadowtest::checkLoops(pipeline.silhouette());
        EXPECT_TRUE(report.HasNormals);
        EXPECT_GT(report.Loops, 0);
        EXPECT_TRUE(report.good()) << "kind " << kind << ": " << report;
      }
    }
  }
}

TEST(SmoothLightSilhouette, StripsAndPolygonsAreTheirTriangles)
{
  const shadowtest::Mesh torus = shadowtest::torus(18, 9);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(torus);
  stripper->Update();
  ASSERT_GT(stripper->GetOutput()->GetNumberOfStrips(), 0);
  for (const int kind : shadowtest::AllKinds)
  {
    const auto expected =
      shadowtest::chainOf(ShadowPipeline(torus, Lights[3], kind).silhouette());
    const auto actual = shadowtest::chainOf(
      ShadowPipeline(stripper->GetOutput(), Lights[3], kind).silhouette());
    const auto difference = compareChains(expected, actual, shadowtest::tolerance::SamePoint);
    EXPECT_TRUE(difference.none()) << difference.Message;
  }
  const auto quads = shadowtest::chainOf(
    ShadowPipeline(shadowtest::quadBox(), Lights[0], vtkSmoothLightSilhouette::DISCRETE)
      .silhouette());
  const auto triangles = shadowtest::chainOf(
    ShadowPipeline(shadowtest::weldedBox(), Lights[0], vtkSmoothLightSilhouette::DISCRETE)
      .silhouette());
  EXPECT_TRUE(compareChains(triangles, quads, shadowtest::tolerance::SamePoint).none());
}

TEST(SmoothLightSilhouette, EmptyInEmptyOut)
{
  vtkNew<vtkPolyData> empty;
  for (const int kind : shadowtest::AllKinds)
  {
    ShadowPipeline pipeline(empty, Lights[0], kind);
    EXPECT_EQ(pipeline.silhouette()->GetNumberOfCells(), 0);
    EXPECT_EQ(pipeline.volume()->GetNumberOfCells(), 0);
  }
}

TEST(SmoothLightSilhouette, BadLightsAreErrorsThatNameTheValue)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const LightPosition bad[] = { { nan, 0, 0, 1 }, { 0, infinity, 0, 0 }, { 0, 0, 0, 0 } };
  for (const LightPosition& light : bad)
  {
    ShadowPipeline pipeline(
      shadowtest::triangle(), light, vtkSmoothLightSilhouette::SMOOTH);
    vtkNew<vtkTest::ErrorObserver> errors;
    pipeline.Silhouette->AddObserver(vtkCommand::ErrorEvent, errors);
    pipeline.Silhouette->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
    pipeline.Silhouette->Update();
    EXPECT_TRUE(errors->GetError());
    EXPECT_NE(errors->GetErrorMessage().find("LightPosition ("), std::string::npos);
    EXPECT_EQ(pipeline.Silhouette->GetOutput()->GetNumberOfCells(), 0);
  }
}

// On the side that the sign of w says.
TEST(SmoothLightSilhouette, PointsTooFarForDoublesAreDirections)
{
  const shadowtest::Mesh mesh = shadowtest::ellipsoid(8, 12);
  for (const double side : { 1.0, -1.0 })
  {
    for (const int kind : shadowtest::AllKinds)
    {
      ShadowPipeline far(mesh, { 1e305, 3e305, 2e305, side * 1e-10 }, kind);
      ShadowPipeline direction(mesh, { side, 3.0 * side, 2.0 * side, 0.0 }, kind);
      const auto expected = shadowtest::chainOf(direction.silhouette());
      const auto difference = compareChains(
        expected, shadowtest::chainOf(far.silhouette()), shadowtest::tolerance::SamePoint);
      EXPECT_GT(difference.Expected, 10u);
      EXPECT_TRUE(difference.none()) << difference.Message;
    }
  }
}

TEST(SmoothLightSilhouette, BadCellsAreLeftOutAndCounted)
{
  const shadowtest::Mesh spoilt = shadowtest::withBadPoints(shadowtest::sphere(8, 12), 2, 3);
  for (const int kind : shadowtest::AllKinds)
  {
    ShadowPipeline pipeline(spoilt, Lights[3], kind);
    const shadowtest::LoopReport report = shadowtest::checkLoops(pipeline.silhouette());
    EXPECT_TRUE(report.good()) << report;
    EXPECT_GT(report.Segments, 10);
    EXPECT_GE(shadowtest::fieldValue(pipeline.silhouette(), "NonFiniteCells"), 4.0);
    EXPECT_GT(shadowtest::fieldValue(pipeline.silhouette(), "BoundaryEdges"), 4.0);
  }
}

TEST(SmoothLightSilhouette, CellsOverNoPointsAreCounted)
{
  vtkNew<vtkPolyData> pointless;
  vtkNew<vtkPolyData> emptied;
  vtkNew<vtkPoints> none;
  emptied->SetPoints(none);
  for (vtkPolyData* mesh : { pointless.Get(), emptied.Get() })
  {
    mesh->SetPolys(shadowtest::weldedBox()->GetPolys());
    ShadowPipeline pipeline(mesh, Lights[3], vtkSmoothLightSilhouette::SMOOTH);
    EXPECT_EQ(shadowtest::fieldValue(pipeline.silhouette(), "NonFiniteCells"), 12.0);
    EXPECT_EQ(pipeline.silhouette()->GetNumberOfCells(), 0);
    EXPECT_EQ(pipeline.volume()->GetNumberOfCells(), 0);
  }
}

TEST(SmoothLightSilhouette, DefectsAreCounted)
{
  ShadowPipeline fin(shadowtest::fin(3), Lights[3], vtkSmoothLightSilhouette::DISCRETE);
  EXPECT_EQ(shadowtest::fieldValue(fin.silhouette(), "NonManifoldEdges"), 1.0);
  ShadowPipeline strip(
    shadowtest::moebiusStrip(20), Lights[3], vtkSmoothLightSilhouette::DISCRETE);
  EXPECT_EQ(shadowtest::fieldValue(strip.silhouette(), "InconsistentEdges"), 1.0);
  ShadowPipeline apart(shadowtest::box(), Lights[3], vtkSmoothLightSilhouette::DISCRETE);
  EXPECT_EQ(shadowtest::fieldValue(apart.silhouette(), "BoundaryEdges"), 0.0);
  apart.Silhouette->MergePointsOff();
  EXPECT_EQ(shadowtest::fieldValue(apart.silhouette(), "BoundaryEdges"), 24.0);
}

TEST(SmoothLightSilhouette, EstimatedNormalsAreCounted)
{
  struct Case
  {
    shadowtest::Mesh mesh;
    double estimated;
    double fallback;
  };
  const Case cases[] = { { shadowtest::icosphere(3), 0.0, 0.0 },
    { shadowtest::withoutNormals(shadowtest::icosphere(3)), 642.0, 0.0 },
    { shadowtest::weldedBox(), 24.0, 24.0 } };
  for (const Case& c : cases)
  {
    ShadowPipeline pipeline(c.mesh, Lights[3], vtkSmoothLightSilhouette::SMOOTH);
    vtkPolyData* output = pipeline.silhouette();
    EXPECT_EQ(shadowtest::fieldValue(output, "EstimatedNormals"), c.estimated);
    EXPECT_EQ(shadowtest::fieldValue(output, "FallbackNormals"), c.fallback);
  }
}

TEST(SmoothLightSilhouette, ModifiedMeshesAreReadAgain)
{
  const shadowtest::Mesh sphere = shadowtest::sphere(8, 12);
  ShadowPipeline pipeline(sphere, Lights[3], vtkSmoothLightSilhouette::SMOOTH);
  const double before = pipeline.silhouette()->GetLength();
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    double p[3];
    sphere->GetPoint(i, p);
    sphere->GetPoints()->SetPoint(i, 0.5 * p[0], 0.5 * p[1], 0.5 * p[2]);
  }
  sphere->GetPoints()->Modified();
  EXPECT_LT(pipeline.silhouette()->GetLength(), 0.6 * before);
}

TEST(SmoothLightSilhouette, ThreadsDoNotMatter)
{
  const auto bunny = shadowtest::bunny();
  for (const int kind : shadowtest::AllKinds)
  {
    const std::string usual = vtkSMPTools::GetBackend();
    ASSERT_TRUE(vtkSMPTools::SetBackend("Sequential"));
    ShadowPipeline serial(bunny, Lights[3], kind);
    serial.silhouette();
    ASSERT_TRUE(vtkSMPTools::SetBackend("STDThread"));
    // Its own copy, or it would share what the serial one has prepared.
    vtkNew<vtkPolyData> copy;
    copy->DeepCopy(bunny);
    ShadowPipeline threaded(copy, Lights[3], kind);
    expectEqualOutputs(serial.silhouette(), threaded.silhouette());
    expectEqualOutputs(serial.volume(), threaded.volume());
    vtkSMPTools::SetBackend(usual.c_str());
  }
}

// Away from the origin doubles are too coarse for the tolerance: subdivision stops by itself.
TEST(SmoothLightSilhouette, TolerancesBelowRoundingEnd)
{
  ShadowPipeline pipeline(shadowtest::moved(shadowtest::sphere(13, 24), 1.0, { 5e6, 5e6, 0.0 }),
    { 0.2, 0.3, 1.0, 0.0 }, vtkSmoothLightSilhouette::SMOOTH);
  pipeline.Silhouette->SetTolerance(1e-12);
  EXPECT_LT(pipeline.silhouette()->GetNumberOfPoints(), 100000);
  EXPECT_GT(shadowtest::fieldValue(pipeline.silhouette(), "MaximumDeviation"), 0.0);
  EXPECT_LT(shadowtest::fieldValue(pipeline.silhouette(), "MaximumDeviation"), 1e-7);
}

TEST(SmoothLightSilhouette, ParametersThatAreNoNumbersAreErrors)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const bool tolerance : { true, false })
  {
    ShadowPipeline pipeline(
      shadowtest::sphere(8, 12), Lights[3], vtkSmoothLightSilhouette::SMOOTH);
    tolerance ? pipeline.Silhouette->SetTolerance(nan) : pipeline.Silhouette->SetFeatureAngle(nan);
    vtkNew<vtkTest::ErrorObserver> errors;
    pipeline.Silhouette->AddObserver(vtkCommand::ErrorEvent, errors);
    pipeline.Silhouette->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
    pipeline.Silhouette->Update();
    EXPECT_NE(errors->GetErrorMessage().find("must be finite"), std::string::npos);
  }
}

// Lights and normals count by their directions.
TEST(SmoothLightSilhouette, ReceiversAreWantedWhereTheToleranceIsTheirs)
{
  vtkNew<vtkSmoothLightSilhouette> filter;
  filter->SetInputData(shadowtest::torus(24, 12));
  filter->SetToleranceModeToReceiver();
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkPolyData> endless;
  endless->DeepCopy(shadowtest::ground(-1.0, 2.0));
  endless->GetPoints()->SetPoint(0, 0.0, 0.0, -std::numeric_limits<double>::infinity());
  for (vtkPolyData* receiver : { static_cast<vtkPolyData*>(nullptr), empty.Get(), endless.Get() })
  {
    filter->SetInputData(1, receiver);
    vtkNew<vtkTest::ErrorObserver> errors;
    filter->AddObserver(vtkCommand::ErrorEvent, errors);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
    filter->Update();
    EXPECT_TRUE(errors->GetError());
    EXPECT_NE(errors->GetErrorMessage().find("port 1"), std::string::npos);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(SmoothLightSilhouette, ReceiversDecideHowFineItIs)
{
  vtkNew<vtkSmoothLightSilhouette> filter;
  filter->SetInputData(shadowtest::torus(24, 12));
  filter->SetLightPosition(0.5, 0.3, 3.0, 1.0);
  filter->SetTolerance(1e-4);
  const auto pointsWith = [&](vtkPolyData* receiver)
  {
    filter->SetInputData(1, receiver);
    filter->Update();
    return filter->GetOutput()->GetNumberOfPoints();
  };
  const vtkIdType world = [&]
  {
    filter->SetToleranceModeToWorld();
    return pointsWith(nullptr);
  }();
  EXPECT_TRUE(std::isnan(shadowtest::fieldValue(filter->GetOutput(), "MaximumShadowDeviation")));
  filter->SetToleranceModeToReceiver();
  // The shadow grows with the distance from the light, and where it does not fall nothing is split.
  const vtkIdType near = pointsWith(shadowtest::ground(-1.0, 50.0));
  const vtkIdType far = pointsWith(shadowtest::ground(-50.0, 500.0));
  EXPECT_GT(near, world);
  EXPECT_GT(far, near);
  EXPECT_LE(shadowtest::fieldValue(filter->GetOutput(), "MaximumShadowDeviation"), 1e-4);
  EXPECT_LT(pointsWith(shadowtest::moved(shadowtest::ground(0.0, 1.0), 1.0, { 60.0, 0.0, -1.0 })),
    world);
  EXPECT_EQ(shadowtest::fieldValue(filter->GetOutput(), "MaximumShadowDeviation"), 0.0);
  EXPECT_GT(shadowtest::fieldValue(filter->GetOutput(), "MaximumDeviation"), 1e-4);
  // Several receivers count together.
  filter->SetInputData(1, shadowtest::ground(-1.0, 50.0));
  filter->AddInputData(1, shadowtest::ground(-50.0, 500.0));
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), far);
}

TEST(SmoothLightSilhouette, ScalesOfLightsAndNormalsDoNotMatter)
{
  const shadowtest::Mesh torus = shadowtest::torus(18, 9);
  const auto expected = shadowtest::chainOf(
    ShadowPipeline(torus, Lights[3], vtkSmoothLightSilhouette::SMOOTH).silhouette());
  const double* l = Lights[3].data();
  vtkNew<vtkPolyData> scaled;
  scaled->DeepCopy(torus);
  for (const double scale : { 1e-200, 3.0, -2.0, 1e200 })
  {
    vtkDataArray* normals = scaled->GetPointData()->GetNormals();
    for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        normals->SetComponent(
          i, c, std::fabs(scale) * torus->GetPointData()->GetNormals()->GetComponent(i, c));
      }
    }
    normals->Modified();
    const LightPosition light{ scale * l[0], scale * l[1], scale * l[2], scale * l[3] };
    const auto actual = shadowtest::chainOf(
      ShadowPipeline(scaled, light, vtkSmoothLightSilhouette::SMOOTH).silhouette());
    const auto difference = compareChains(expected, actual, 1e-11);
    EXPECT_TRUE(difference.none()) << scale << ": " << difference.Message;
    EXPECT_GT(difference.Expected, 20u);
  }
}
