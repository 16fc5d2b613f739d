// Volumes that end at a length or on a plane: ordinary closed solids of the size that they must
// have.

#include "ChainChecks.h"
#include "RandomMeshes.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkMassProperties.h>
#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
using shadowtest::LightPosition;
using shadowtest::ShadowPipeline;

constexpr double Pi = 3.14159265358979323846;

/// By VTK, which knows nothing of multiplicities and homogeneous points.
double massVolume(vtkPolyData* volume)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(volume);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputConnection(triangles->GetOutputPort());
  return mass->GetVolume();
}

/// All must agree: what the filter says, VTK, and the divergence theorem over the polygons.
void expectVolume(ShadowPipeline& pipeline, double expected, double relative)
{
  vtkPolyData* volume = pipeline.volume();
  EXPECT_EQ(shadowtest::fieldValue(volume, "Closed"), 1.0);
  EXPECT_EQ(shadowtest::openEdges(volume), 0);
  const double told = shadowtest::fieldValue(volume, "Volume");
  EXPECT_NEAR(told, expected, relative * expected);
  EXPECT_NEAR(massVolume(volume), told, 1e-6 * told);
  EXPECT_NEAR(shadowtest::enclosedVolume(volume), told, 1e-9 * told);
  pipeline.Extruder->WallStripsOn();
  EXPECT_NEAR(shadowtest::fieldValue(pipeline.volume(), "Volume"), told, 1e-9 * told);
  pipeline.Extruder->WallStripsOff();
}

void endOnPlane(ShadowPipeline& pipeline, double height)
{
  pipeline.Extruder->SetExtentToPlane();
  pipeline.Extruder->SetPlaneOrigin(7.0, -3.0, height);
  pipeline.Extruder->SetPlaneNormal(0.0, 0.0, -2.5);
}
}

// Along a direction a length away, a volume is the length times the area that is seen.
TEST(FiniteVolumes, OfALengthIsTheAreaSeenTimesIt)
{
  const double direction[3] = { 0.3, -0.5, 0.8 };
  const double norm = std::sqrt(0.3 * 0.3 + 0.5 * 0.5 + 0.8 * 0.8);
  for (const int kind : shadowtest::AllKinds)
  {
    ShadowPipeline box(shadowtest::box(),
      { direction[0], direction[1], direction[2], 0.0 }, kind);
    box.Extruder->SetExtentToLength();
    box.Extruder->SetLength(5.0);
    expectVolume(box, 5.0 * 4.0 * (0.3 + 0.5 + 0.8) / norm, 1e-12);
  }
  ShadowPipeline sphere(
    shadowtest::icosphere(4), { 0.3, -0.5, 0.8, 0.0 }, vtkSmoothLightSilhouette::SMOOTH);
  sphere.Extruder->SetExtentToLength();
  sphere.Extruder->SetLength(2.0);
  sphere.Silhouette->SetTolerance(1e-6);
  expectVolume(sphere, 2.0 * Pi, 1e-4);
  // Ten diagonals where no length is given.
  sphere.Extruder->SetLength(0.0);
  expectVolume(sphere, 10.0 * sphere.Extruder->GetPolyDataInput(0)->GetLength() * Pi, 1e-4);
}

// What stands on the plane, h high and 2 r across a light that leans by s: r s h^2, a box and a
// cylinder alike. The shadow of its dark side alone, which the body itself is no part of.
TEST(FiniteVolumes, OnThePlaneUnderStandingBodies)
{
  const double lean = 0.7;
  const LightPosition light{ lean, 0.0, 1.0, 0.0 };
  const double expected = 1.0 * lean * 4.0;
  for (const int kind : shadowtest::AllKinds)
  {
    ShadowPipeline box(shadowtest::box(), light, kind);
    endOnPlane(box, -1.0);
    expectVolume(box, expected, 1e-12);
    box.Extruder->SetCapsToLit();
    expectVolume(box, expected + 8.0, 1e-12);
    ShadowPipeline cylinder(shadowtest::cylinder(720), light, kind);
    endOnPlane(cylinder, -1.0);
    expectVolume(cylinder, expected, 1e-4);
  }
}

TEST(FiniteVolumes, BetweenABallAndThePlane)
{
  // Straight down: half a ball less than the column.
  for (const int kind : shadowtest::AllKinds)
  {
    ShadowPipeline sphere(shadowtest::icosphere(5), { 0.0, 0.0, 1.0, 0.0 }, kind);
    endOnPlane(sphere, -3.0);
    expectVolume(sphere, 3.0 * Pi - 2.0 * Pi / 3.0, 2e-3);
  }
  // From a lamp in z = 2 the tangent cone, of half angle 30 degrees, touches in z = 1/2. Of the
  // cone down to z = -3 less its tip, what is left of the ball below is taken away.
  ShadowPipeline sphere(
    shadowtest::icosphere(5), { 0.0, 0.0, 2.0, 1.0 }, vtkSmoothLightSilhouette::SMOOTH);
  sphere.Silhouette->SetTolerance(1e-6);
  endOnPlane(sphere, -3.0);
  const double cone = Pi / 9.0 * (std::pow(5.0, 3) - std::pow(1.5, 3));
  const double ballBelow = Pi * 1.5 * 1.5 * (3.0 - 1.5) / 3.0;
  expectVolume(sphere, cone - ballBelow, 1e-3);
}

TEST(FiniteVolumes, HostileMeshesGiveClosedOnes)
{
  long triangles = 0;
  for (std::uint64_t seed = 1; seed <= 300 && !HasFailure(); ++seed)
  {
    const shadowtest::RandomMesh scene = shadowtest::randomMesh(seed);
    for (const int kind : shadowtest::AllKinds)
    {
      for (const int extent : { vtkShadowVolumeExtruder::LENGTH, vtkShadowVolumeExtruder::PLANE })
      {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind + ", kind " +
          std::to_string(kind) + ", extent " + std::to_string(extent));
        ShadowPipeline pipeline(scene.Surface, { 0.2, 0.1, 1.0, 0.0 }, kind);
        pipeline.Extruder->SetExtent(extent);
        double bounds[6];
        scene.Surface->GetBounds(bounds);
        pipeline.Extruder->SetPlaneOrigin(0.0, 0.0, std::isfinite(bounds[4]) ? bounds[4] : 0.0);
        vtkPolyData* volume = pipeline.volume();
        EXPECT_EQ(shadowtest::openEdges(volume), 0);
        // Normals that contradict their triangles may turn an accurate silhouette inside out.
        if (kind == vtkSmoothLightSilhouette::DISCRETE)
        {
          const double rounding = 1e-9 * std::pow(scene.Surface->GetLength(), 3);
          EXPECT_FALSE(shadowtest::fieldValue(volume, "Volume") < -rounding);
        }
        triangles += volume->GetNumberOfPolys();
        vtkDataArray* homogeneous = volume->GetPointData()->GetArray("Homogeneous");
        for (vtkIdType i = 0; homogeneous && i < homogeneous->GetNumberOfTuples(); ++i)
        {
          EXPECT_EQ(homogeneous->GetComponent(i, 3), 1.0);
          EXPECT_TRUE(std::isfinite(homogeneous->GetComponent(i, 2)));
        }
      }
    }
  }
  EXPECT_GT(triangles, 100000);
}

// A part beyond the plane ends where it is, as does what the plane cuts.
TEST(FiniteVolumes, APlaneThroughTheMesh)
{
  ShadowPipeline box(shadowtest::box(), { 0.0, 0.0, 1.0, 0.0 }, vtkSmoothLightSilhouette::DISCRETE);
  endOnPlane(box, 0.0);
  box.Extruder->SetCapsToLit();
  vtkPolyData* volume = box.volume();
  EXPECT_EQ(shadowtest::openEdges(volume), 0);
  EXPECT_NEAR(shadowtest::fieldValue(volume, "Volume"), 4.0, 1e-12);
  box.Extruder->SetCapsToDark();
  EXPECT_NEAR(shadowtest::fieldValue(box.volume(), "Volume"), 0.0, 1e-12);
}

TEST(FiniteVolumes, PlanesThatRaysMissAreErrors)
{
  struct Case
  {
    LightPosition Light;
    double Normal[3];
  };
  // Along a direction, behind a lamp, and no plane at all.
  const Case cases[] = { { { 1.0, 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } },
    { { 0.0, 0.0, -2.0, 1.0 }, { 0.0, 0.0, 1.0 } }, { { 0.0, 0.0, 5.0, 1.0 }, { 0.0, 0.0, 0.0 } } };
  for (const Case& c : cases)
  {
    ShadowPipeline pipeline(shadowtest::box(), c.Light, vtkSmoothLightSilhouette::DISCRETE);
    pipeline.Extruder->SetExtentToPlane();
    pipeline.Extruder->SetPlaneOrigin(0.0, 0.0, -3.0);
    pipeline.Extruder->SetPlaneNormal(c.Normal);
    vtkNew<vtkTest::ErrorObserver> errors;
    pipeline.Extruder->AddObserver(vtkCommand::ErrorEvent, errors);
    pipeline.Extruder->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
    EXPECT_EQ(pipeline.volume()->GetNumberOfPolys(), 0);
    EXPECT_NE(errors->GetErrorMessage().find("do not come to the plane"), std::string::npos);
  }
}

TEST(FiniteVolumes, InfiniteOnesHaveNoVolume)
{
  ShadowPipeline box(shadowtest::box(), { 0.0, 0.0, 1.0, 0.0 }, vtkSmoothLightSilhouette::SMOOTH);
  EXPECT_TRUE(std::isnan(shadowtest::fieldValue(box.volume(), "Volume")));
  box.Extruder->SetExtentToLength();
  EXPECT_FALSE(std::isnan(shadowtest::fieldValue(box.volume(), "Volume")));
  box.Extruder->SetCapsToNone();
  EXPECT_TRUE(std::isnan(shadowtest::fieldValue(box.volume(), "Volume")));
}
