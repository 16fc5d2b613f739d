/**
 * Views and boxes for tests of the plan.
 */
#ifndef shadowtest_PlanScene_h
#define shadowtest_PlanScene_h

#include "MeshBuilder.h"
#include "Random.h"
#include "ShadowPlan.h"

#include <vtkCamera.h>
#include <vtkNew.h>

namespace shadowtest
{
/// 200 x 200 pixels.
inline ShadowView viewFrom(
  const Point3& eye, const Point3& at, double nearPlane = 0.5, bool parallel = false)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(at.data());
  camera->SetViewUp(0.0, 0.1, 1.0);
  camera->SetClippingRange(nearPlane, 40.0);
  camera->SetParallelProjection(parallel);
  camera->SetParallelScale(3.0);
  return { ToMatrix4(camera->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0)), 200, 200 };
}

inline std::array<double, 6> boundsAround(const Point3& middle, double half)
{
  return { middle[0] - half, middle[0] + half, middle[1] - half, middle[1] + half, middle[2] - half,
    middle[2] + half };
}

inline BoxCorners boxAround(const Point3& middle, double half)
{
  Matrix4 toWorld{};
  vtkMatrix4x4::Identity(toWorld.data());
  return CornersOf(boundsAround(middle, half), toWorld);
}

inline Point3 mix(const Point3& a, const Point3& b, double t)
{
  return a + t * (b - a);
}

inline Point3 inBox(const BoxCorners& box, Random& random)
{
  const double t[3] = { random.uniform(), random.uniform(), random.uniform() };
  const Point3 low = mix(mix(box[0], box[1], t[0]), mix(box[2], box[3], t[0]), t[1]);
  const Point3 high = mix(mix(box[4], box[5], t[0]), mix(box[6], box[7], t[0]), t[1]);
  return mix(low, high, t[2]);
}

/// A box of random size, turned and sheared at random; some are flat.
inline BoxCorners randomBox(const Point3& middle, Random& random)
{
  Matrix4 toWorld{};
  toWorld[15] = 1.0;
  for (std::size_t row = 0; row < 3; ++row)
  {
    for (std::size_t column = 0; column < 3; ++column)
    {
      toWorld[4 * row + column] = random.uniform(-0.6, 0.6);
    }
    toWorld[4 * row + 3] = middle[row];
  }
  const double thickness = random.chance(0.1) ? 0.0 : 1.0;
  return CornersOf({ -1.0, 1.0, -1.0, 1.0, -thickness, thickness }, toWorld);
}
}

#endif
