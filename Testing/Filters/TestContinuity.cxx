// A light that moves a little moves the smooth and the accurate silhouette a little; the discrete
// one jumps by whole triangles.

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

double largestMovement(const Case& walked, int kind)
{
  const std::vector<double> movements = shadowtest::movementsOf(walked.Mesh, kind);
  return *std::max_element(movements.begin(), movements.end());
}
}

TEST(Continuity, SmoothAndAccurateContoursFollowTheLight)
{
  // The true contour moves by one step on the sphere, by up to 3.2 on the ellipsoid. On coarser
  // ellipsoids smooth pieces swing along the light's ray where the contour passes a vertex.
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
