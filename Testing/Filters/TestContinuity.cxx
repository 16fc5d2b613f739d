// A light that moves a little moves the smooth and the accurate silhouette a little; the discrete
// one jumps by whole triangles.

#include "PolylineDistance.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
constexpr int Steps = 1000;
constexpr double Step = 1e-3; // radians, and so the true contour's movement on a sphere of radius 1

/// A direction that turns about a tilted axis, so that it passes edges and vertices at all angles.
shadowtest::LightPosition lightAt(int step)
{
  const double angle = Step * step;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return { 0.8 * c, 0.6 * c + 0.1 * s, s, 0.0 };
}

/// The largest movement of the silhouette in one step, as a multiple of the step.
double largestMovement(vtkPolyData* mesh, int kind)
{
  shadowtest::ShadowPipeline pipeline(mesh, lightAt(0), kind);
  vtkNew<vtkPolyData> before;
  before->DeepCopy(pipeline.silhouette());
  double largest = 0.0;
  for (int step = 1; step <= Steps; ++step)
  {
    pipeline.setLight(lightAt(step));
    largest = std::max(largest, shadowtest::hausdorffDistance(before, pipeline.silhouette()));
    before->DeepCopy(pipeline.silhouette());
  }
  return largest / Step;
}
}

TEST(Continuity, SmoothAndAccurateContoursFollowTheLight)
{
  for (const shadowtest::Mesh& mesh : { shadowtest::icosphere(2, 3), shadowtest::sphere(12, 24) })
  {
    EXPECT_LT(largestMovement(mesh, vtkSmoothLightSilhouette::SMOOTH), 2.0);
    EXPECT_LT(largestMovement(mesh, vtkSmoothLightSilhouette::ACCURATE), 2.0);
    EXPECT_GT(largestMovement(mesh, vtkSmoothLightSilhouette::DISCRETE), 50.0);
  }
}
