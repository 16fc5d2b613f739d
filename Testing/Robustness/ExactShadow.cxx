#include "ExactShadow.h"

#include "ChainChecks.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkBoundingBox.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace shadowtest
{
namespace
{
bool isFinite(const Vec3& point)
{
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

vtkBoundingBox usedBounds(vtkPolyData* mesh)
{
  MeshBuilder builder;
  builder.append(mesh);
  vtkBoundingBox bounds;
  for (const auto& cell : builder.Cells)
  {
    for (const vtkIdType id : cell)
    {
      const Vec3& point = builder.Points[static_cast<std::size_t>(id)];
      if (isFinite(point))
      {
        bounds.AddPoint(point[0], point[1], point[2]);
      }
    }
  }
  return bounds;
}

int componentOf(vtkPolyData* data, const char* name, vtkIdType cell)
{
  return static_cast<int>(data->GetCellData()->GetArray(name)->GetComponent(cell, 0));
}

bool isAllFinite(vtkDataArray* array)
{
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int component = 0; component < array->GetNumberOfComponents(); ++component)
    {
      if (!std::isfinite(array->GetComponent(i, component)))
      {
        return false;
      }
    }
  }
  return true;
}

/// Normals are of unit length, or zero where the mesh has none.
vtkIdType countZeroNormals(vtkDataArray* normals)
{
  vtkIdType zero = 0;
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    Vec3 normal;
    normals->GetTuple(i, normal.data());
    const double length = std::sqrt(dot(normal, normal));
    zero += length == 0.0;
    EXPECT_TRUE(length == 0.0 || std::fabs(length - 1.0) <= tolerance::UnitNormal) << length;
  }
  return zero;
}

void expectSilhouette(vtkPolyData* silhouette, ChainTotals& totals)
{
  LoopReport report = checkLoops(silhouette);
  report.NormalError = 0.0; // judged below
  EXPECT_TRUE(report.good()) << report;
  totals.Segments += report.Segments;
  if (vtkDataArray* normals = silhouette->GetPointData()->GetArray("Normals"))
  {
    totals.ZeroNormals += countZeroNormals(normals);
  }
  EXPECT_TRUE(report.HasNormals);
  EXPECT_EQ(report.Loops, silhouette->GetNumberOfCells());
  for (vtkIdType loop = 0; loop < silhouette->GetNumberOfCells(); ++loop)
  {
    EXPECT_EQ(componentOf(silhouette, "Closed", loop), 1);
    totals.GreatestMultiplicity =
      std::max(totals.GreatestMultiplicity, componentOf(silhouette, "Multiplicity", loop));
  }
  if (vtkDataArray* meshPoints = silhouette->GetPointData()->GetArray("MeshPoints"))
  {
    EXPECT_TRUE(isAllFinite(meshPoints));
  }
}

/// Whether a volume of this kind of silhouette and light has such triangles.
bool canHave(int part, int kind, const LightPosition& light)
{
  return part == vtkShadowVolumeExtruder::CAP || part == vtkShadowVolumeExtruder::WALL ||
    (part == vtkShadowVolumeExtruder::GAP && kind == vtkSmoothLightSilhouette::SMOOTH) ||
    (part == vtkShadowVolumeExtruder::FAR_CAP && light[3] != 0.0);
}

void expectVolume(vtkPolyData* volume, int kind, const LightPosition& light, ChainTotals& totals)
{
  EXPECT_EQ(openEdges(volume), 0);
  EXPECT_EQ(fieldValue(volume, "Closed"), 1.0);
  for (vtkIdType cell = 0; cell < volume->GetNumberOfCells(); ++cell)
  {
    EXPECT_TRUE(canHave(componentOf(volume, "Part", cell), kind, light));
    EXPECT_GE(componentOf(volume, "Multiplicity", cell), 1);
  }
  if (volume->GetNumberOfPoints() > 0)
  {
    EXPECT_TRUE(isAllFinite(volume->GetPoints()->GetData()));
    EXPECT_TRUE(isAllFinite(volume->GetPointData()->GetArray("Homogeneous")));
  }
  totals.Triangles += volume->GetNumberOfPolys();
}
}

Vec3 samplePoint(vtkPolyData* mesh, int sample)
{
  // The additive recurrence whose steps are the powers of 1 / 1.2207..., the root of
  // x^4 = x + 1: in three dimensions as even as the golden ratio in one.
  constexpr double Steps[3] = { 0.8191725133961645, 0.6710436067037893, 0.5497004779019703 };
  const vtkBoundingBox bounds = usedBounds(mesh);
  if (!bounds.IsValid())
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return { nan, nan, nan };
  }
  const double longest = bounds.GetMaxLength();
  Vec3 point;
  for (std::size_t i = 0; i < 3; ++i)
  {
    // Something around flat meshes, too.
    const double size = std::max(bounds.GetLength(static_cast<int>(i)), 0.1 * longest);
    const double t = std::fmod(0.137 + Steps[i] * (sample + 1.0), 1.0);
    point[i] = bounds.GetMinPoint()[i] + (2.0 * t - 0.5) * size;
  }
  return point;
}

bool isOnSurface(vtkPolyData* mesh, const LightPosition& light)
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
    if (status < 0 || std::sqrt(squaredDistance) < tolerance::TooClose * mesh->GetLength())
    {
      return true;
    }
  }
  return false;
}

bool isInside(vtkPolyData* closed, const LightPosition& at)
{
  const double point[3] = { at[0] / at[3], at[1] / at[3], at[2] / at[3] };
  return at[3] != 0.0 && std::fabs(windingNumber(closed, point)) > 0.01;
}

ChainTotals expectClosedChains(vtkPolyData* mesh, const LightPosition& light)
{
  ChainTotals totals;
  for (const int kind : AllKinds)
  {
    ShadowPipeline pipeline(mesh, light, kind);
    SCOPED_TRACE("silhouette kind " + std::to_string(kind));
    expectSilhouette(pipeline.silhouette(), totals);
    for (const int caps : { vtkShadowVolumeExtruder::AUTOMATIC, vtkShadowVolumeExtruder::LIT,
           vtkShadowVolumeExtruder::DARK })
    {
      SCOPED_TRACE("caps " + std::to_string(caps));
      pipeline.Extruder->SetCaps(caps);
      expectVolume(pipeline.volume(), kind, light, totals);
    }
  }
  return totals;
}

PointTotals expectExactWinding(
  vtkPolyData* mesh, const LightPosition& light, const CastingParts& parts, int samples)
{
  const auto blockersOf = [&](vtkPolyData* part, const Vec3& point) {
    return part ? blockersTowards(part, point.data(), light.data()) : Blockers();
  };
  std::vector<Mesh> all;
  for (const Mesh& part : { parts.Closed, parts.Others })
  {
    if (part)
    {
      all.push_back(withoutNormals(part));
    }
  }
  const Mesh around = merged(all);
  PointTotals totals;
  ShadowPipeline pipeline(mesh, light, vtkSmoothLightSilhouette::DISCRETE);
  for (const int caps : { vtkShadowVolumeExtruder::AUTOMATIC, vtkShadowVolumeExtruder::LIT })
  {
    const bool onLitSide = caps == vtkShadowVolumeExtruder::LIT;
    SCOPED_TRACE(onLitSide ? "lit caps" : "automatic caps");
    pipeline.Extruder->SetCaps(caps);
    vtkPolyData* volume = pipeline.volume();
    int wrong = 0;
    std::ostringstream first;
    for (int sample = 0; sample < samples; ++sample)
    {
      const Vec3 point = samplePoint(around, sample);
      const Blockers closed = blockersOf(parts.Closed, point);
      const Blockers others = blockersOf(parts.Others, point);
      if (!isFinite(point) || std::min(closed.Margin, others.Margin) < tolerance::TooClose)
      {
        continue;
      }
      const int facing = (closed.Count + closed.Signed) / 2;
      const int expected = others.Count + (onLitSide ? facing : closed.Count - facing);
      const double winding = windingNumber(volume, point.data());
      if (!(std::fabs(winding - expected) <= tolerance::Winding) && wrong++ == 0)
      {
        first << "point " << point[0] << ' ' << point[1] << ' ' << point[2] << ": winding "
              << winding << ", expected " << expected << ", blockers " << closed.Count << " and "
              << others.Count;
      }
      ++(closed.Count + others.Count > 0 ? totals.InShadow : totals.Lit);
      totals.Deepest = std::max(totals.Deepest, expected);
    }
    EXPECT_EQ(wrong, 0) << first.str();
  }
  return totals;
}
}
