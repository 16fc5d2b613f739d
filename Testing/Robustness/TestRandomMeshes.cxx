// Invariants of silhouettes and volumes on seeded random meshes: closed, open, non-manifold,
// misoriented, degenerate, soups; with ties.

#include "ChainChecks.h"
#include "ExactShadow.h"
#include "Random.h"
#include "RandomMeshes.h"
#include "ShadowPipeline.h"
#include "Tolerances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

TEST(RandomMeshes, ChainsAndVolumesAreClosed)
{
  const std::uint64_t first = shadowtest::fromEnvironment("SMOOTHSHADOW_TEST_SEED", 1);
  const std::uint64_t count = shadowtest::fromEnvironment("SMOOTHSHADOW_TEST_SCENES", 1000);
  vtkIdType segments = 0;
  vtkIdType triangles = 0;
  for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed)
  {
    const shadowtest::RandomMesh scene = shadowtest::randomMesh(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind);
    const shadowtest::ChainTotals totals =
      shadowtest::expectClosedChains(scene.Surface, scene.Light);
    segments += totals.Segments;
    triangles += totals.Triangles;
  }
  EXPECT_GT(segments, static_cast<vtkIdType>(10 * count));
  EXPECT_GT(triangles, static_cast<vtkIdType>(10 * count));
}

namespace
{
bool isFinite(const shadowtest::Vec3& point)
{
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

bool lightIsInside(const shadowtest::RandomMesh& scene)
{
  return shadowtest::isInside(scene.Surface, scene.Light);
}

bool pointIsInside(const shadowtest::RandomMesh& scene, const shadowtest::Vec3& point)
{
  return shadowtest::isInside(scene.Surface, { point[0], point[1], point[2], 1.0 });
}
}

// Whatever the mesh, a point is in the discrete volume exactly if a triangle is between it and the
// light.
TEST(RandomMeshes, DiscreteVolumesWindAroundWhatIsInShadow)
{
  const std::uint64_t first = shadowtest::fromEnvironment("SMOOTHSHADOW_TEST_SEED", 1);
  const std::uint64_t count = shadowtest::fromEnvironment("SMOOTHSHADOW_TEST_SCENES", 1000);
  std::uint64_t inShadow = 0;
  std::uint64_t lit = 0;
  for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed)
  {
    const shadowtest::RandomMesh scene = shadowtest::randomMesh(seed);
    if (shadowtest::isOnSurface(scene.Surface, scene.Light))
    {
      continue;
    }
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind);
    shadowtest::ShadowPipeline pipeline(
      scene.Surface, scene.Light, vtkSmoothLightSilhouette::DISCRETE);
    // Of a closed part lit caps count what faces the light, dark ones what faces away: outside,
    // seen from outside, either is right, and lit caps know nothing of a light inside. Where open
    // parts are about one cannot tell what is inside by winding; but something is in between
    // exactly if either counts.
    const bool inside = scene.Closed && lightIsInside(scene);
    std::vector<vtkSmartPointer<vtkPolyData>> volumes;
    for (const int caps : { vtkShadowVolumeExtruder::LIT, vtkShadowVolumeExtruder::DARK })
    {
      if (!scene.Closed || (caps == vtkShadowVolumeExtruder::DARK) == inside)
      {
        pipeline.Extruder->SetCaps(caps);
        volumes.push_back(vtkSmartPointer<vtkPolyData>::New());
        volumes.back()->ShallowCopy(pipeline.volume());
      }
    }
    for (int sample = 0; sample < 8; ++sample)
    {
      const shadowtest::Vec3 point = shadowtest::samplePoint(scene.Surface, sample);
      const shadowtest::Blockers blockers =
        shadowtest::blockersTowards(scene.Surface, point.data(), scene.Light.data());
      if (!isFinite(point) || blockers.Margin < shadowtest::tolerance::TooClose ||
        (scene.Closed && pointIsInside(scene, point)))
      {
        continue;
      }
      double winding = 0.0;
      for (vtkPolyData* volume : volumes)
      {
        const double own = std::fabs(shadowtest::windingNumber(volume, point.data()));
        EXPECT_NEAR(own, std::round(own), shadowtest::tolerance::Winding);
        EXPECT_LE(std::round(own), shadowtest::fieldValue(volume, "GreatestDepth"));
        winding = std::max(winding, own);
      }
      EXPECT_EQ(winding > 0.5, blockers.Count > 0)
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
  const std::uint64_t first = shadowtest::fromEnvironment("SMOOTHSHADOW_TEST_SEED", 1);
  const std::uint64_t count = shadowtest::fromEnvironment("SMOOTHSHADOW_TEST_SCENES", 1000);
  std::uint64_t inShadow = 0;
  for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed)
  {
    const shadowtest::RandomMesh scene = shadowtest::randomMesh(seed);
    if (!scene.Closed || shadowtest::isOnSurface(scene.Surface, scene.Light) ||
      lightIsInside(scene))
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
        const shadowtest::Vec3 point = shadowtest::samplePoint(scene.Surface, sample);
        if (pointIsInside(scene, point))
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
