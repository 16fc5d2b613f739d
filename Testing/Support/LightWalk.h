/**
 * @brief A light that turns in small steps, and how far silhouettes move in each.
 */
#ifndef shadowtest_LightWalk_h
#define shadowtest_LightWalk_h

#include "PolylineDistance.h"
#include "ShadowPipeline.h"

#include <cmath>
#include <vector>

namespace shadowtest
{
constexpr int WalkSteps = 1000;
constexpr double WalkStep = 1e-3; // radians, and so the true contour's movement on a unit sphere

/// A direction that turns about a tilted axis, so that it passes edges and vertices at all angles.
inline LightPosition walkingLight(int step)
{
  const double angle = WalkStep * step;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return { 0.8 * c, 0.6 * c + 0.1 * s, s, 0.0 };
}

/// The silhouette's movement (Hausdorff distance) in each step, as a multiple of the step. make
/// gives the silhouette of a light.
template <class Make>
std::vector<double> movementsOf(const Make& make)
{
  std::vector<double> movements;
  vtkNew<vtkPolyData> before;
  before->DeepCopy(make(walkingLight(0)));
  for (int step = 1; step <= WalkSteps; ++step)
  {
    vtkSmartPointer<vtkPolyData> now = make(walkingLight(step));
    movements.push_back(hausdorffDistance(before, now) / WalkStep);
    before->DeepCopy(now);
  }
  return movements;
}

inline std::vector<double> movementsOf(vtkPolyData* mesh, int kind)
{
  ShadowPipeline pipeline(mesh, walkingLight(0), kind);
  return movementsOf([&](const LightPosition& light) {
    pipeline.setLight(light);
    return pipeline.silhouette();
  });
}
}

#endif
