// A light that moves a little moves the smooth and the accurate silhouette a little; the discrete
// one jumps by whole triangles.

#include "AnalyticShadow.h"
#include "LightWalk.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
struct Case
{
  const char* Name;
  shadowtest::Mesh Mesh;
  double Most; ///< movement of a continuous contour, in steps
};

/// The shadow on the plane through the origin that faces a directional light.
vtkSmartPointer<vtkPolyData> shadowOf(
  vtkPolyData* silhouette, const shadowtest::LightPosition& light)
{
  const shadowtest::Plane plane{ { 0.0, 0.0, 0.0 }, { light[0], light[1], light[2] } };
  auto shadow = vtkSmartPointer<vtkPolyData>::New();
  shadow->DeepCopy(silhouette);
  for (vtkIdType i = 0; i < shadow->GetNumberOfPoints(); ++i)
  {
    shadowtest::Vec3 point;
    silhouette->GetPoint(i, point.data());
    shadow->GetPoints()->SetPoint(i, shadowtest::shadowOn(plane, light, point).data());
  }
  return shadow;
}

double largestMovement(const Case& walked, int kind)
{
  const std::vector<double> movements = shadowtest::movementsOf(walked.Mesh, kind);
  return *std::max_element(movements.begin(), movements.end());
}
}

TEST(Continuity, SmoothAndAccurateContoursFollowTheLight)
{
  // The true contour moves by one step on the sphere, by up to 3.2 on the ellipsoid.
  const Case cases[] = { { "jittered sphere", shadowtest::icosphere(2, 3), 2.0 },
    { "sphere", shadowtest::sphere(12, 24), 2.0 },
    { "ellipsoid", shadowtest::ellipsoid(24, 48), 8.0 },
    { "jittered ellipsoid", shadowtest::icoEllipsoid(3, 3), 8.0 } };
  for (const Case& walked : cases)
  {
    EXPECT_LT(largestMovement(walked, vtkSmoothLightSilhouette::SMOOTH), walked.Most)
      << walked.Name;
    EXPECT_LT(largestMovement(walked, vtkSmoothLightSilhouette::ACCURATE), walked.Most)
      << walked.Name;
    EXPECT_GT(largestMovement(walked, vtkSmoothLightSilhouette::DISCRETE), 50.0) << walked.Name;
  }
}

// On coarse meshes the field along an edge's curve can have two zeros between ends of one sign.
// When one of the ends changes its sign the crossing appears at the other zero, and the contour's
// pieces swing along the light's ray; their shadow does not.
TEST(Continuity, ShadowsOfCoarseMeshesFollowTheLight)
{
  const shadowtest::Mesh mesh = shadowtest::ellipsoid(12, 24);
  const auto largest = [&](bool asShadow) {
    shadowtest::ShadowPipeline pipeline(
      mesh, shadowtest::walkingLight(0), vtkSmoothLightSilhouette::SMOOTH);
    const std::vector<double> movements = shadowtest::movementsOf(
      [&](const shadowtest::LightPosition& light) -> vtkSmartPointer<vtkPolyData> {
        pipeline.setLight(light);
        vtkSmartPointer<vtkPolyData> silhouette = pipeline.silhouette();
        return asShadow ? shadowOf(silhouette, light) : silhouette;
      });
    return *std::max_element(movements.begin(), movements.end());
  };
  EXPECT_LT(largest(true), 8.0);
  EXPECT_GT(largest(false), 16.0) << "no swings: the mesh is of no use for this test";
}
