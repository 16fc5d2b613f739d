// The gap is what of the extruder's faces the eye; its edges are the mesh's and the silhouette's.

#include "vtkSilhouetteGap.h"

#include "ChainChecks.h"
#include "HostileMeshes.h"
#include "RandomMeshes.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkPointData.h>
#include <vtkReverseSense.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace
{
using shadowtest::cross;
using shadowtest::dot;
using shadowtest::LightPosition;
using shadowtest::Mesh;
using shadowtest::ShadowPipeline;
using shadowtest::Vec3;
using shadowtest::operator-;

const LightPosition Eyes[] = { { 0.3, 0.2, 1.0, 0.0 }, { 1.1, -2.7, 3.1, 1.0 },
  { 9.0, 4.0, 7.0, 2.0 } };

using Triangle = std::array<Vec3, 3>;
using Segment = std::pair<Vec3, Vec3>;

Vec3 towardsEye(const LightPosition& eye, const Vec3& p)
{
  return { eye[0] - eye[3] * p[0], eye[1] - eye[3] * p[1], eye[2] - eye[3] * p[2] };
}

/// Above zero if it faces the eye.
double facing(const Triangle& t, const LightPosition& eye)
{
  return dot(cross(t[1] - t[0], t[2] - t[0]), towardsEye(eye, t[0]));
}

/// Each turned so that its least corner comes first.
std::multiset<Triangle> trianglesOf(vtkPolyData* data)
{
  std::multiset<Triangle> triangles;
  for (vtkIdType cell = 0; cell < data->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    data->GetPolys()->GetCellAtId(cell, size, ids);
    EXPECT_EQ(size, 3);
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k)
    {
      data->GetPoint(ids[k], t[k].data());
    }
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.insert(t);
  }
  return triangles;
}

/// Directed edges that do not cancel.
std::map<Segment, int> boundaryOf(const std::multiset<Triangle>& triangles)
{
  std::map<Segment, int> boundary;
  const auto add = [&boundary](const Segment& edge, int times) {
    if ((boundary[edge] += times) == 0)
    {
      boundary.erase(edge);
    }
  };
  for (const Triangle& t : triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vec3& from = t[k];
      const Vec3& to = t[(k + 1) % 3];
      add({ std::min(from, to), std::max(from, to) }, from < to ? 1 : -1);
    }
  }
  return boundary;
}

struct GapPipeline : ShadowPipeline
{
  vtkNew<vtkSilhouetteGap> Gap;

  GapPipeline(
    vtkPolyData* mesh, const LightPosition& eye, int kind = vtkSmoothLightSilhouette::SMOOTH)
    : ShadowPipeline(mesh, eye, kind)
  {
    this->Gap->SetInputData(mesh);
    this->Gap->SetSilhouetteConnection(this->Silhouette->GetOutputPort());
    this->Extruder->SetCapsToNone();
    this->Extruder->SetExtentToNearEnd();
  }

  vtkPolyData* gap()
  {
    this->Gap->Update();
    return this->Gap->GetOutput();
  }
};

/// Silhouette points by where they are, with their normals.
std::map<Vec3, Vec3> silhouetteNormals(vtkPolyData* silhouette)
{
  std::map<Vec3, Vec3> normals;
  for (vtkIdType i = 0; i < silhouette->GetNumberOfPoints(); ++i)
  {
    Vec3 point;
    silhouette->GetPoint(i, point.data());
    silhouette->GetPointData()->GetArray("Normals")->GetTuple(i, normals[point].data());
  }
  return normals;
}

/// Whether rounding may decide which side of a triangle the eye sees, as it is edge-on or has two
/// corners at one place; or where an eye on a vertex is, which counts as just above it.
bool isUnclear(const Triangle& t, const LightPosition& eye, double size)
{
  const auto length = [](const Vec3& v) { return std::sqrt(dot(v, v)); };
  const double first = length(t[1] - t[0]);
  const double second = length(t[2] - t[0]);
  const double away = length(towardsEye(eye, t[0]));
  const double slack = first * second *
      (shadowtest::tolerance::TooClose * away +
        std::abs(eye[3]) * shadowtest::tolerance::LightLift * size) +
    shadowtest::tolerance::SamePoint * size * (first + second) * away;
  return std::abs(facing(t, eye)) <= slack;
}

/// Returns how many triangles these are.
std::size_t expectWhatFacesTheEye(vtkPolyData* mesh, const LightPosition& eye)
{
  GapPipeline pipeline(mesh, eye);
  std::multiset<Triangle> expected;
  for (const Triangle& t : trianglesOf(pipeline.volume()))
  {
    if (facing(t, eye) > 0.0)
    {
      expected.insert(t);
    }
  }
  const std::multiset<Triangle> actual = trianglesOf(pipeline.gap());
  std::vector<Triangle> differing;
  std::set_symmetric_difference(
    actual.begin(), actual.end(), expected.begin(), expected.end(), std::back_inserter(differing));
  for (const Triangle& t : differing)
  {
    EXPECT_TRUE(isUnclear(t, eye, mesh->GetLength()));
  }
  EXPECT_EQ(shadowtest::nonFiniteNumbers(pipeline.gap()), 0);
  return expected.size();
}
}

TEST(SilhouetteGap, IsWhatOfTheExtrudersFacesTheEye)
{
  for (const Mesh& mesh :
    { shadowtest::sphere(7, 12), shadowtest::torus(16, 8, 3), shadowtest::starShaped(2, 5),
      shadowtest::cylinder(9, 2), shadowtest::opened(shadowtest::icosphere(2), 0.2, 4) })
  {
    for (const LightPosition& eye : Eyes)
    {
      EXPECT_GT(expectWhatFacesTheEye(mesh, eye), 20u);
    }
  }
}

TEST(SilhouetteGap, OfRandomMeshes)
{
  std::size_t triangles = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed)
  {
    const shadowtest::RandomMesh mesh = shadowtest::randomMesh(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + mesh.Kind);
    triangles += expectWhatFacesTheEye(mesh.Surface, mesh.Light);
  }
  EXPECT_GT(triangles, 3000u);
}

// All around a sphere the smooth outline is outside of the mesh's. Its edge is the silhouette
// itself; the other one is on the mesh, at the silhouette's own places there.
TEST(SilhouetteGap, JoinsTheMeshToTheSilhouette)
{
  for (const std::uint64_t jitter : { 0, 3 })
  {
    const Mesh mesh = shadowtest::icosphere(2, jitter);
    for (const LightPosition& eye : Eyes)
    {
      GapPipeline pipeline(mesh, eye);
      std::map<Segment, int> expected;
      const auto add = [&expected](const Vec3& from, const Vec3& to) {
        expected[{ std::min(from, to), std::max(from, to) }] += from < to ? 1 : -1;
      };
      vtkPolyData* silhouette = pipeline.silhouette();
      vtkDataArray* meshPoints = silhouette->GetPointData()->GetArray("MeshPoints");
      vtkDataArray* nodes = silhouette->GetPointData()->GetArray("MeshNodes");
      for (vtkIdType line = 0; line < silhouette->GetNumberOfLines(); ++line)
      {
        vtkIdType count;
        const vtkIdType* ids;
        silhouette->GetLines()->GetCellAtId(line, count, ids);
        Vec3 before;
        Vec3 nodeBefore;
        silhouette->GetPoint(ids[0], before.data());
        meshPoints->GetTuple(ids[0], nodeBefore.data());
        ASSERT_GE(nodes->GetComponent(ids[0], 0), 0.0);
        for (vtkIdType i = 1; i < count; ++i)
        {
          Vec3 point;
          silhouette->GetPoint(ids[i], point.data());
          add(before, point);
          before = point;
          if (nodes->GetComponent(ids[i], 0) >= 0.0)
          {
            Vec3 node;
            meshPoints->GetTuple(ids[i], node.data());
            add(node, nodeBefore);
            nodeBefore = node;
          }
        }
      }
      EXPECT_GT(expected.size(), 60u);
      EXPECT_EQ(boundaryOf(trianglesOf(pipeline.gap())), expected);
    }
  }
}

// On the silhouette its own; on the mesh those that shading has there, of a sphere whose points are
// its normals.
TEST(SilhouetteGap, NormalsAreThoseOfShading)
{
  const Mesh sphere = shadowtest::icosphere(1, 2);
  for (const LightPosition& eye : Eyes)
  {
    GapPipeline pipeline(sphere, eye);
    const std::map<Vec3, Vec3> ofSilhouette = silhouetteNormals(pipeline.silhouette());
    vtkPolyData* gap = pipeline.gap();
    vtkDataArray* normals = gap->GetPointData()->GetNormals();
    ASSERT_TRUE(normals);
    vtkIdType onSilhouette = 0;
    vtkIdType onMesh = 0;
    for (vtkIdType i = 0; i < gap->GetNumberOfPoints(); ++i)
    {
      Vec3 point;
      Vec3 normal;
      gap->GetPoint(i, point.data());
      normals->GetTuple(i, normal.data());
      const auto found = ofSilhouette.find(point);
      const Vec3 expected =
        found != ofSilhouette.end() ? found->second : shadowtest::normalized(point);
      ++(found != ofSilhouette.end() ? onSilhouette : onMesh);
      EXPECT_NEAR(dot(normal, expected), 1.0, shadowtest::tolerance::UnitNormal);
    }
    EXPECT_GT(onSilhouette, 20);
    EXPECT_GT(onMesh, 20);
  }
}

TEST(SilhouetteGap, NormalsPointOutOfAMeshThatIsInsideOut)
{
  vtkNew<vtkReverseSense> reversed;
  reversed->SetInputData(shadowtest::torus(16, 8, 3));
  reversed->ReverseNormalsOn();
  reversed->Update();
  for (const LightPosition& eye : Eyes)
  {
    GapPipeline pipeline(reversed->GetOutput(), eye);
    vtkPolyData* gap = pipeline.gap();
    EXPECT_GT(gap->GetNumberOfPolys(), 100);
    for (const Triangle& t : trianglesOf(gap))
    {
      EXPECT_GT(facing(t, eye), 0.0);
    }
    for (vtkIdType i = 0; i < gap->GetNumberOfPoints(); ++i)
    {
      Vec3 point;
      Vec3 normal;
      gap->GetPoint(i, point.data());
      gap->GetPointData()->GetNormals()->GetTuple(i, normal.data());
      const double around = std::hypot(point[0], point[1]);
      const Vec3 onRing = { point[0] / around, point[1] / around, 0.0 };
      EXPECT_GT(dot(normal, shadowtest::normalized(point - onRing)), 0.9);
    }
  }
}

TEST(SilhouetteGap, IsEmptyWhereTheSilhouetteIsOnTheMesh)
{
  for (const int kind : { vtkSmoothLightSilhouette::DISCRETE, vtkSmoothLightSilhouette::ACCURATE })
  {
    GapPipeline pipeline(shadowtest::torus(16, 8), Eyes[0], kind);
    EXPECT_EQ(pipeline.gap()->GetNumberOfPolys(), 0);
    EXPECT_GT(pipeline.silhouette()->GetNumberOfLines(), 0);
  }
  GapPipeline box(shadowtest::box(), Eyes[1]);
  EXPECT_EQ(box.gap()->GetNumberOfPolys(), 0);
  vtkNew<vtkPolyData> nothing;
  GapPipeline empty(nothing, Eyes[0]);
  EXPECT_EQ(empty.gap()->GetNumberOfPolys(), 0);
}

TEST(SilhouetteGap, RefusesAnothersSilhouette)
{
  GapPipeline other(shadowtest::torus(24, 12), Eyes[0]);
  vtkNew<vtkSilhouetteGap> gap;
  vtkNew<vtkTest::ErrorObserver> errors;
  gap->AddObserver(vtkCommand::ErrorEvent, errors);
  gap->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  gap->SetInputData(shadowtest::torus(24, 12, 5));
  gap->SetSilhouetteConnection(other.Silhouette->GetOutputPort());
  gap->Update();
  EXPECT_NE(errors->GetErrorMessage().find("not that of the mesh"), std::string::npos);
  EXPECT_EQ(gap->GetOutput()->GetNumberOfPolys(), 0);

  errors->Clear();
  gap->SetInputConnection(1, nullptr);
  gap->SetInputData(1, shadowtest::triangle());
  gap->Update();
  EXPECT_NE(errors->GetErrorMessage().find("port 1"), std::string::npos);

  errors->Clear();
  const Mesh withoutNormals = Mesh::New();
  withoutNormals->DeepCopy(other.silhouette());
  withoutNormals->GetPointData()->SetNormals(nullptr);
  gap->SetInputData(0, shadowtest::torus(24, 12));
  gap->SetInputData(1, withoutNormals);
  gap->Update();
  EXPECT_TRUE(errors->GetError());
  EXPECT_EQ(gap->GetOutput()->GetNumberOfPolys(), 0);
}
