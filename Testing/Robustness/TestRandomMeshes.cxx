// Invariants of silhouettes and volumes on seeded random meshes: closed, open, non-manifold,
// misoriented, degenerate, soups; with ties.

#include "ChainChecks.h"
#include "RandomMeshes.h"
#include "ShadowPipeline.h"
#include "Tolerances.h"

#include <vtkCell.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace
{
// SMOOTHSHADOW_TEST_SCENES asks for another number than the 1,000 of a usual run, and
// SMOOTHSHADOW_TEST_SEED for another first seed.
std::uint64_t fromEnvironment(const char* name, std::uint64_t otherwise)
{
  const char* value = std::getenv(name);
  return value ? std::strtoull(value, nullptr, 10) : otherwise;
}

struct Totals
{
  vtkIdType loops = 0;
  vtkIdType triangles = 0;
};

void checkScene(std::uint64_t seed, int kind, Totals& totals)
{
  const shadowtest::RandomMesh scene = shadowtest::randomMesh(seed);
  SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind + ", silhouette kind " +
    std::to_string(kind));
  shadowtest::ShadowPipeline pipeline(scene.Surface, scene.Light, kind);
  const shadowtest::LoopReport report = shadowtest::checkLoops(pipeline.silhouette());
  EXPECT_EQ(report.OpenLoops, 0);
  EXPECT_EQ(report.ShortLoops, 0);
  EXPECT_EQ(report.NonFinitePoints, 0);
  EXPECT_EQ(report.UnbalancedPoints, 0);
  EXPECT_EQ(report.BadMultiplicities, 0);
  totals.loops += report.Loops;

  for (const int caps : { vtkShadowVolumeExtruder::DARK, vtkShadowVolumeExtruder::LIT })
  {
    pipeline.Extruder->SetCaps(caps);
    vtkPolyData* volume = pipeline.volume();
    EXPECT_EQ(shadowtest::openEdges(volume), 0);
    EXPECT_EQ(shadowtest::fieldValue(volume, "Closed"), 1.0);
    totals.triangles += volume->GetNumberOfPolys();
  }
}
}

TEST(RandomMeshes, ChainsAndVolumesAreClosed)
{
  const std::uint64_t first = fromEnvironment("SMOOTHSHADOW_TEST_SEED", 1);
  const std::uint64_t count = fromEnvironment("SMOOTHSHADOW_TEST_SCENES", 1000);
  Totals totals;
  for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed)
  {
    for (const int kind : shadowtest::AllKinds)
    {
      checkScene(seed, kind, totals);
    }
  }
  EXPECT_GT(totals.loops, static_cast<vtkIdType>(count));
  EXPECT_GT(totals.triangles, static_cast<vtkIdType>(10 * count));
}

namespace
{
// A point around the mesh whose coordinates are shared by no seed's mesh.
std::array<double, 3> samplePoint(vtkPolyData* mesh, int sample)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  std::array<double, 3> point;
  for (int i = 0; i < 3; ++i)
  {
    const double t = std::fmod(0.137 + 0.618033988749895 * (sample + 8.0 * i), 1.0);
    point[i] = bounds[2 * i] + (2.0 * t - 0.5) * (bounds[2 * i + 1] - bounds[2 * i] + 0.1);
  }
  return point;
}

// From a light on the surface some of it is seen edge-on from no distance: which side of it the
// light is on is rounding, and what is behind an edge not defined.
bool isOnSurface(vtkPolyData* mesh, const shadowtest::LightPosition& light)
{
  const double position[3] = { light[0] / light[3], light[1] / light[3], light[2] / light[3] };
  for (vtkIdType cell = 0; light[3] != 0.0 && cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkCell* polygon = mesh->GetCell(cell);
    double closest[3];
    double parametric[3];
    double squaredDistance = 0.0;
    std::vector<double> weights(static_cast<std::size_t>(polygon->GetNumberOfPoints()));
    int subId;
    const int status = polygon->EvaluatePosition(
      position, closest, subId, parametric, squaredDistance, weights.data());
    // A cell without area cannot tell.
    if (status < 0 ||
      std::sqrt(squaredDistance) < shadowtest::tolerance::TooClose * mesh->GetLength())
    {
      return true;
    }
  }
  return false;
}

// Whether a closed part of the scene is around a point of space; a direction is outside.
bool isInside(const shadowtest::RandomMesh& scene, const shadowtest::LightPosition& at)
{
  const double point[3] = { at[0] / at[3], at[1] / at[3], at[2] / at[3] };
  return at[3] != 0.0 && std::fabs(shadowtest::windingNumber(scene.Surface, point)) > 0.01;
}

bool isFinite(const std::array<double, 3>& point)
{
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}
}

// Whatever the mesh, a point is in the discrete volume exactly if a triangle is between it and the
// light.
TEST(RandomMeshes, DiscreteVolumesWindAroundWhatIsInShadow)
{
  const std::uint64_t first = fromEnvironment("SMOOTHSHADOW_TEST_SEED", 1);
  const std::uint64_t count = fromEnvironment("SMOOTHSHADOW_TEST_SCENES", 1000);
  std::uint64_t inShadow = 0;
  std::uint64_t lit = 0;
  for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed)
  {
    const shadowtest::RandomMesh scene = shadowtest::randomMesh(seed);
    if (isOnSurface(scene.Surface, scene.Light))
    {
      continue;
    }
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind);
    shadowtest::ShadowPipeline pipeline(
      scene.Surface, scene.Light, vtkSmoothLightSilhouette::DISCRETE);
    // Lit caps know nothing of a light inside of a closed part; dark ones are for points outside,
    // and where a closed mesh pierces itself some points are outside in a way that inverts both.
    const bool lightIsInside = isInside(scene, scene.Light);
    pipeline.Extruder->SetCaps(
      lightIsInside ? vtkShadowVolumeExtruder::DARK : vtkShadowVolumeExtruder::LIT);
    vtkPolyData* volume = pipeline.volume();
    for (int sample = 0; sample < 8; ++sample)
    {
      const std::array<double, 3> point = samplePoint(scene.Surface, sample);
      const shadowtest::Blockers blockers =
        shadowtest::blockersTowards(scene.Surface, point.data(), scene.Light.data());
      if (!isFinite(point) || blockers.Margin < 1e-6 ||
        ((lightIsInside || scene.Closed) && isInside(scene, { point[0], point[1], point[2], 1.0 })))
      {
        continue;
      }
      const double winding = shadowtest::windingNumber(volume, point.data());
      EXPECT_NEAR(winding, std::round(winding), shadowtest::tolerance::Winding);
      EXPECT_LE(std::round(std::fabs(winding)), shadowtest::fieldValue(volume, "GreatestDepth"));
      EXPECT_EQ(std::fabs(winding) > 0.5, blockers.Count > 0)
        << "point " << point[0] << ' ' << point[1] << ' ' << point[2] << ", winding " << winding
        << ", blockers " << blockers.Count;
      ++(blockers.Count > 0 ? inShadow : lit);
    }
  }
  EXPECT_GT(inShadow, count / 2);
  EXPECT_GT(lit, count / 2);
}

// Outside of closed meshes the lit and the dark cap cast the same shadow, for every kind.
TEST(RandomMeshes, LitAndDarkCapsCastTheSameShadow)
{
  const std::uint64_t first = fromEnvironment("SMOOTHSHADOW_TEST_SEED", 1);
  const std::uint64_t count = fromEnvironment("SMOOTHSHADOW_TEST_SCENES", 1000);
  std::uint64_t inShadow = 0;
  for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed)
  {
    const shadowtest::RandomMesh scene = shadowtest::randomMesh(seed);
    if (!scene.Closed || isOnSurface(scene.Surface, scene.Light) || isInside(scene, scene.Light))
    {
      continue;
    }
    for (const int kind : shadowtest::AllKinds)
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind + ", silhouette kind " +
        std::to_string(kind));
      shadowtest::ShadowPipeline pipeline(scene.Surface, scene.Light, kind);
      vtkNew<vtkPolyData> dark;
      dark->ShallowCopy(pipeline.volume());
      pipeline.Extruder->SetCaps(vtkShadowVolumeExtruder::LIT);
      vtkPolyData* litVolume = pipeline.volume();
      for (int sample = 0; sample < 8; ++sample)
      {
        const std::array<double, 3> point = samplePoint(scene.Surface, sample);
        if (isInside(scene, { point[0], point[1], point[2], 1.0 }))
        {
          continue;
        }
        const double winding = shadowtest::windingNumber(dark, point.data());
        EXPECT_NEAR(winding, shadowtest::windingNumber(litVolume, point.data()),
          shadowtest::tolerance::Winding);
        inShadow += std::fabs(winding) > 0.5;
      }
    }
  }
  EXPECT_GT(inShadow, count / 4);
}
