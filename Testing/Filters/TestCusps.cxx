// The smooth contour turns back, as seen from the light, where the true one does and nowhere else.

#include "AnalyticShadow.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
using shadowtest::LightPosition;
using shadowtest::operator+;
using shadowtest::operator-;
using shadowtest::operator*;
using shadowtest::Vec3;

struct NamedLight
{
  const char* Name;
  LightPosition Position;
  bool HasCusps;
};

const NamedLight Lights[] = { { "steep direction", { 0.3, 0.2, 1.0, 0.0 }, false },
  { "slanting direction", { 1.0, 0.3, 0.4, 0.0 }, true },
  { "low direction", { -0.5, 1.0, 0.3, 0.0 }, true },
  { "point above", { 0.7, 0.5, 1.9, 1.0 }, false },
  { "point aside", { 3.1, -1.3, 2.2, 1.0 }, true },
  { "far point aside", { 20.0, 31.0, 16.0, 1.0 }, true } };

/// On which side of the ray a chord of the contour runs, seen along the surface: 0 for a chord
/// without length.
int sideOf(vtkPolyData* silhouette, vtkIdType from, vtkIdType to, const LightPosition& light)
{
  vtkDataArray* normals = silhouette->GetPointData()->GetNormals();
  Vec3 p[2];
  Vec3 n[2];
  silhouette->GetPoint(from, p[0].data());
  silhouette->GetPoint(to, p[1].data());
  normals->GetTuple(from, n[0].data());
  normals->GetTuple(to, n[1].data());
  const Vec3 ray = Vec3{ light[0], light[1], light[2] } - (0.5 * light[3]) * (p[0] + p[1]);
  const double determinant = shadowtest::dot(ray, shadowtest::cross(p[1] - p[0], n[0] + n[1]));
  return (determinant > 0.0) - (determinant < 0.0);
}

/// Places where loops of the silhouette turn back.
int turnsOf(vtkPolyData* silhouette, const LightPosition& light)
{
  int turns = 0;
  vtkCellArray* lines = silhouette->GetLines();
  for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    lines->GetCellAtId(cell, size, ids);
    int first = 0;
    int last = 0;
    for (vtkIdType i = 0; i + 1 < size; ++i)
    {
      const int side = sideOf(silhouette, ids[i], ids[i + 1], light);
      turns += side * last < 0;
      last = side != 0 ? side : last;
      first = first != 0 ? first : side;
    }
    turns += last * first < 0;
  }
  return turns;
}
}

TEST(Cusps, RegularMeshesHaveAsManyAsTheTorus)
{
  for (const NamedLight& light : Lights)
  {
    const int cusps =
      shadowtest::torusCusps(shadowtest::TorusRadius, shadowtest::TorusTube, light.Position);
    EXPECT_EQ(cusps > 0, light.HasCusps) << light.Name;
    for (const int around : { 38, 76, 152 })
    {
      const shadowtest::Mesh mesh = shadowtest::torus(around, around / 2 + 1);
      shadowtest::ShadowPipeline pipeline(mesh, light.Position, vtkSmoothLightSilhouette::SMOOTH);
      EXPECT_EQ(turnsOf(pipeline.silhouette(), light.Position), cusps)
        << light.Name << ", " << mesh->GetNumberOfCells() << " triangles";
    }
  }
}
