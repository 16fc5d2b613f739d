// What a silhouette reports of its distance from its curves is a bound, keeps to the tolerance, and
// is not much more than the true distance: that to the points of a very fine silhouette, which lie
// on the same curves.

#include "AnalyticShadow.h"
#include "MeshBuilder.h"
#include "RealMeshes.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCellArray.h>
#include <vtkLine.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{
using shadowtest::LightPosition;
using shadowtest::ShadowPipeline;
using shadowtest::Vec3;
using Polyline = std::vector<Vec3>;

/// A mode of the tolerance, and how its deviation is measured without the filter.
struct Mode
{
  std::string Name;
  std::function<void(vtkSmoothLightSilhouette*)> Set;
  const char* Reported;                          ///< the field with the bound
  std::function<double(vtkPolyData* mesh)> Unit; ///< of the tolerance, in world units
  std::function<Vec3(const Vec3& point, const LightPosition&)> Seen; ///< where it is measured
};

const auto InPlace = [](const Vec3& point, const LightPosition&) { return point; };

/// Below all shapes.
constexpr double GroundHeight = -4.0;

void setGroundAsReceiver(vtkSmoothLightSilhouette* silhouette)
{
  silhouette->SetToleranceModeToReceiver();
  silhouette->SetInputDataObject(1, shadowtest::ground(GroundHeight, 100.0));
}

Vec3 onTheGround(const Vec3& point, const LightPosition& light)
{
  return shadowtest::shadowOn({ { 0.0, 0.0, GroundHeight }, { 0.0, 0.0, 1.0 } }, light, point);
}

const Mode Modes[] = {
  { "relative", [](vtkSmoothLightSilhouette* s) { s->SetToleranceModeToRelative(); },
    "MaximumDeviation", [](vtkPolyData* mesh) { return mesh->GetLength(); }, InPlace },
  { "world", [](vtkSmoothLightSilhouette* s) { s->SetToleranceModeToWorld(); }, "MaximumDeviation",
    [](vtkPolyData*) { return 1.0; }, InPlace },
  { "receiver", setGroundAsReceiver, "MaximumShadowDeviation", [](vtkPolyData*) { return 1.0; },
    onTheGround },
};

/// The silhouette cut at its nodes: what stands for one curve each, in the order of the loops.
std::vector<Polyline> piecesOf(
  vtkPolyData* silhouette, const Mode& mode, const LightPosition& light)
{
  vtkDataArray* nodes = silhouette->GetPointData()->GetArray("MeshNodes");
  std::vector<Polyline> pieces;
  vtkCellArray* lines = silhouette->GetLines();
  for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    lines->GetCellAtId(cell, size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      Vec3 point;
      silhouette->GetPoint(ids[i], point.data());
      point = mode.Seen(point, light);
      if (i > 0)
      {
        pieces.back().push_back(point);
      }
      const bool isNode = i == 0 || nodes->GetComponent(ids[i], 0) >= 0.0;
      if (isNode && i + 1 < size)
      {
        pieces.push_back({ point });
      }
    }
  }
  return pieces;
}

double distanceTo(const Polyline& polyline, const Vec3& point)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i)
  {
    double t;
    least = std::min(least,
      vtkLine::DistanceToLine(
        point.data(), polyline[i].data(), polyline[i + 1].data(), t, nullptr));
  }
  return std::sqrt(least);
}

/// The farthest that a curve is from the polyline that stands for it.
double trueDeviation(const std::vector<Polyline>& polylines, const std::vector<Polyline>& curves)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < polylines.size(); ++i)
  {
    for (const Vec3& point : curves[i])
    {
      largest = std::max(largest, distanceTo(polylines[i], point));
    }
  }
  return largest;
}

struct Shape
{
  std::string Name;
  shadowtest::Mesh Mesh;
  LightPosition Light;
};

std::vector<Shape> shapes()
{
  const LightPosition direction{ 0.4, 0.2, 1.0, 0.0 };
  const LightPosition point{ 1.1, -2.7, 3.1, 1.0 };
  const auto bunny = shadowtest::standing(shadowtest::bunny(), 1);
  return { { "torus, point", shadowtest::torus(24, 12), point },
    { "torus, direction", shadowtest::torus(24, 12), direction },
    { "cylinder, point", shadowtest::cylinder(12), point },
    { "cylinder, direction", shadowtest::cylinder(24), direction },
    { "jittered sphere", shadowtest::icosphere(1, 3), point }, { "bunny, point", bunny, point },
    { "bunny, direction", bunny, direction } };
}

constexpr double Finest = 1e-9;
}

TEST(MaximumDeviation, IsATightBoundWithinTheTolerance)
{
  for (const Shape& shape : shapes())
  {
    for (const Mode& mode : Modes)
    {
      ShadowPipeline pipeline(shape.Mesh, shape.Light, vtkSmoothLightSilhouette::SMOOTH);
      mode.Set(pipeline.Silhouette);
      const double unit = mode.Unit(shape.Mesh);
      pipeline.Silhouette->SetTolerance(Finest);
      const std::vector<Polyline> curves = piecesOf(pipeline.silhouette(), mode, shape.Light);
      const vtkIdType finestPoints = pipeline.silhouette()->GetNumberOfPoints();
      for (const double tolerance : { 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6 })
      {
        const std::string label =
          shape.Name + ", " + mode.Name + ", tolerance " + std::to_string(tolerance);
        pipeline.Silhouette->SetTolerance(tolerance);
        vtkPolyData* silhouette = pipeline.silhouette();
        const std::vector<Polyline> polylines = piecesOf(silhouette, mode, shape.Light);
        ASSERT_EQ(polylines.size(), curves.size()) << label;
        ASSERT_GT(finestPoints, 3 * silhouette->GetNumberOfPoints()) << label;
        const double reported = shadowtest::fieldValue(silhouette, mode.Reported);
        const double deviation = trueDeviation(polylines, curves);
        EXPECT_LE(reported, tolerance * unit) << label;
        EXPECT_LE(deviation, reported * (1.0 + shadowtest::tolerance::ReportedBound)) << label;
        EXPECT_GE(deviation, shadowtest::tolerance::DeviationShare * reported) << label;
      }
    }
  }
}

// Light from ever farther away is light from a direction.
TEST(MaximumDeviation, OnReceiversOfFarLightsIsThatOfTheDirection)
{
  const shadowtest::Mesh mesh = shadowtest::sphere(16, 24);
  const shadowtest::Mesh ground =
    shadowtest::moved(shadowtest::ground(0.0, 8.0), 1.0, { 0.0, 0.0, -2.0 });
  const LightPosition direction{ 0.3, 0.5, 1.0, 0.0 };
  ShadowPipeline pipeline(mesh, direction, vtkSmoothLightSilhouette::SMOOTH);
  pipeline.Silhouette->SetInputData(1, ground);
  pipeline.Silhouette->SetToleranceModeToReceiver();
  const vtkIdType points = pipeline.silhouette()->GetNumberOfPoints();
  const double bound =
    shadowtest::fieldValue(pipeline.silhouette(), "MaximumShadowDeviation");
  ASSERT_GT(points, 200);
  ASSERT_GT(bound, 0.0);
  for (double distance = 1e6; distance < 1e300; distance *= 100.0)
  {
    pipeline.setLight(
      { distance * direction[0], distance * direction[1], distance * direction[2], 1.0 });
    EXPECT_EQ(pipeline.silhouette()->GetNumberOfPoints(), points) << distance;
    // The rays' directions differ by what the mesh's size is of the distance.
    EXPECT_NEAR(shadowtest::fieldValue(pipeline.silhouette(), "MaximumShadowDeviation"), bound,
      10.0 / distance + shadowtest::tolerance::ReportedBound * bound)
      << distance;
  }
}
