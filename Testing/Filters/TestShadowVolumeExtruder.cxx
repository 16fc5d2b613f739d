// Contracts and invariants of the extruder.

#include "AnalyticShadow.h"
#include "ChainChecks.h"
#include "RealMeshes.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
using shadowtest::LightPosition;
using shadowtest::ShadowPipeline;

const LightPosition Lights[] = { { 0.3, 0.2, 1.0, 0.0 }, { 0.0, 0.0, 1.0, 0.0 },
  { 1.1, -2.7, 3.1, 1.0 }, { 0.0, 0.0, 5.0, 1.0 }, { 0.1, 0.05, 0.02, 1.0 } };

vtkIdType countPart(vtkPolyData* volume, int part)
{
  vtkDataArray* parts = volume->GetCellData()->GetArray("Part");
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < parts->GetNumberOfTuples(); ++i)
  {
    count += parts->GetComponent(i, 0) == part;
  }
  return count;
}

void expectClosed(ShadowPipeline& pipeline, const std::string& name)
{
  for (const int caps : { vtkShadowVolumeExtruder::AUTOMATIC, vtkShadowVolumeExtruder::LIT,
         vtkShadowVolumeExtruder::DARK })
  {
    pipeline.Extruder->SetCaps(caps);
    vtkPolyData* volume = pipeline.volume();
    EXPECT_EQ(shadowtest::openEdges(volume), 0) << name << ", caps " << caps;
    EXPECT_EQ(shadowtest::fieldValue(volume, "Closed"), 1.0) << name;
    // From inside of a closed mesh no part of it is lit.
    if (caps != vtkShadowVolumeExtruder::LIT)
    {
      EXPECT_GT(volume->GetNumberOfPolys(), 4) << name;
    }
  }
}
}

TEST(ShadowVolumeExtruder, VolumesOfKnownShapesAreClosed)
{
  const std::pair<const char*, shadowtest::Mesh> meshes[] = {
    { "sphere", shadowtest::sphere(12, 24) }, { "torus", shadowtest::torus(36, 18) },
    { "cylinder", shadowtest::cylinder(16) }, { "box", shadowtest::box() },
    { "welded box", shadowtest::weldedBox() }, { "sheet", shadowtest::ground(0.0, 1.0, 3) }
  };
  for (const auto& [name, mesh] : meshes)
  {
    for (const LightPosition& light : Lights)
    {
      for (const int kind : shadowtest::AllKinds)
      {
        ShadowPipeline pipeline(mesh, light, kind);
        expectClosed(pipeline, std::string(name) + ", kind " + std::to_string(kind));
      }
    }
  }
}

namespace
{
/// Point ids, the least first, part and multiplicity of each triangle, sorted.
std::vector<std::array<vtkIdType, 5>> sortedTriangles(vtkPolyData* volume)
{
  vtkNew<vtkTriangleFilter> split;
  split->SetInputData(volume);
  split->Update();
  vtkPolyData* triangles = split->GetOutput();
  vtkDataArray* parts = triangles->GetCellData()->GetArray("Part");
  vtkDataArray* multiplicities = triangles->GetCellData()->GetArray("Multiplicity");
  std::vector<std::array<vtkIdType, 5>> sorted;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    triangles->GetPolys()->GetCellAtId(cell, size, ids);
    std::array<vtkIdType, 3> corners{ ids[0], ids[1], ids[2] };
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    sorted.push_back({ corners[0], corners[1], corners[2],
      static_cast<vtkIdType>(parts->GetComponent(cell, 0)),
      static_cast<vtkIdType>(multiplicities->GetComponent(cell, 0)) });
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}
}

// A strip is the walls of a whole loop; short loops, and those of a direction, stay triangles.
TEST(ShadowVolumeExtruder, StripsAreTheSameWalls)
{
  for (const shadowtest::Mesh& mesh : { shadowtest::torus(36, 18), shadowtest::cylinder(32),
         shadowtest::box(), shadowtest::ground(0.0, 1.0, 9) })
  {
    for (const LightPosition& light : Lights)
    {
      for (const int kind : shadowtest::AllKinds)
      {
        ShadowPipeline pipeline(mesh, light, kind);
        const auto expected = sortedTriangles(pipeline.volume());
        EXPECT_EQ(pipeline.volume()->GetNumberOfStrips(), 0);
        const vtkIdType polygons = pipeline.volume()->GetNumberOfPolys();
        pipeline.Extruder->WallStripsOn();
        vtkPolyData* volume = pipeline.volume();
        EXPECT_EQ(sortedTriangles(volume), expected);
        vtkIdType longLoops = 0;
        for (vtkIdType loop = 0; loop < pipeline.silhouette()->GetNumberOfLines(); ++loop)
        {
          longLoops += pipeline.silhouette()->GetLines()->GetCellSize(loop) > 16;
        }
        EXPECT_EQ(volume->GetNumberOfStrips(), light[3] == 0.0 ? 0 : longLoops);
        EXPECT_EQ(volume->GetNumberOfPolys() < polygons, volume->GetNumberOfStrips() > 0);
      }
    }
  }
  ShadowPipeline pipeline(shadowtest::torus(36, 18), Lights[2], vtkSmoothLightSilhouette::SMOOTH);
  pipeline.Extruder->WallStripsOn();
  EXPECT_GT(pipeline.volume()->GetNumberOfStrips(), 0);
}

TEST(ShadowVolumeExtruder, BunnysVolumeIsClosed)
{
  const auto bunny = shadowtest::bunny();
  for (const int kind : shadowtest::AllKinds)
  {
    ShadowPipeline pipeline(bunny, { 1.5, 3.0, 2.0, 1.0 }, kind);
    expectClosed(pipeline, "bunny, kind " + std::to_string(kind));
  }
}

// Points away from the shadow's boundary are inside of the volume exactly if the ball hides the
// light.
TEST(ShadowVolumeExtruder, SphereCastsTheShadowOfTheBall)
{
  const double ball[3] = { 1.0, 1.0, 1.0 };
  const shadowtest::Mesh sphere = shadowtest::sphere(48, 96);
  for (const LightPosition& light : { Lights[0], Lights[2] })
  {
    for (const int kind : shadowtest::AllKinds)
    {
      ShadowPipeline pipeline(sphere, light, kind);
      vtkPolyData* volume = pipeline.volume();
      int inShadow = 0;
      int lit = 0;
      for (int i = 0; i < 400; ++i)
      {
        const shadowtest::Vec3 point{ -3.0 + 0.3 * (i % 20), -3.0 + 0.3 * (i / 20), -2.0 };
        const double larger[3] = { 1.01, 1.01, 1.01 };
        const double smaller[3] = { 0.99, 0.99, 0.99 };
        const bool hidden = shadowtest::ellipsoidHides(ball, point, light);
        if (shadowtest::ellipsoidHides(larger, point, light) !=
          shadowtest::ellipsoidHides(smaller, point, light))
        {
          continue;
        }
        EXPECT_NEAR(shadowtest::windingNumber(volume, point.data()), hidden ? 1.0 : 0.0,
          shadowtest::tolerance::Winding);
        ++(hidden ? inShadow : lit);
      }
      EXPECT_GT(inShadow, 20);
      EXPECT_GT(lit, 100);
    }
  }
}

// All of space outside of a closed mesh is in the shadow of a light inside of it.
TEST(ShadowVolumeExtruder, LightInsideOfAClosedMesh)
{
  for (const int kind : shadowtest::AllKinds)
  {
    ShadowPipeline pipeline(shadowtest::sphere(12, 24), { 0.1, 0.2, 0.3, 1.0 }, kind);
    vtkPolyData* volume = pipeline.volume();
    EXPECT_GT(volume->GetNumberOfPolys(), 100);
    for (const shadowtest::Vec3& point :
      { shadowtest::Vec3{ 2.0, 0.0, 0.0 }, shadowtest::Vec3{ -3.0, 5.0, 1.0 } })
    {
      EXPECT_NEAR(std::fabs(shadowtest::windingNumber(volume, point.data())), 1.0,
        shadowtest::tolerance::Winding);
    }
    const double inside[3] = { -0.2, 0.0, 0.1 };
    EXPECT_NEAR(
      shadowtest::windingNumber(volume, inside), 0.0, shadowtest::tolerance::Winding);
  }
}

TEST(ShadowVolumeExtruder, PartsAreWhatTheyAreCalled)
{
  const shadowtest::Mesh torus = shadowtest::torus(24, 12);
  ShadowPipeline pipeline(torus, Lights[2], vtkSmoothLightSilhouette::SMOOTH);
  EXPECT_GT(countPart(pipeline.volume(), vtkShadowVolumeExtruder::CAP), 100);
  EXPECT_GT(countPart(pipeline.volume(), vtkShadowVolumeExtruder::GAP), 100);
  EXPECT_GT(countPart(pipeline.volume(), vtkShadowVolumeExtruder::WALL), 100);
  EXPECT_GT(countPart(pipeline.volume(), vtkShadowVolumeExtruder::FAR_CAP), 50);

  pipeline.setLight(Lights[0]);
  EXPECT_EQ(countPart(pipeline.volume(), vtkShadowVolumeExtruder::FAR_CAP), 0);

  pipeline.Silhouette->SetKindToAccurate();
  EXPECT_EQ(countPart(pipeline.volume(), vtkShadowVolumeExtruder::GAP), 0);

  pipeline.Extruder->SetCapsToNone();
  EXPECT_EQ(countPart(pipeline.volume(), vtkShadowVolumeExtruder::CAP), 0);
  EXPECT_EQ(shadowtest::fieldValue(pipeline.volume(), "Closed"), 0.0);
  EXPECT_GT(shadowtest::openEdges(pipeline.volume()), 0);
}

// A bound, but a tight one where the silhouette is simple.
TEST(ShadowVolumeExtruder, GreatestDepth)
{
  const auto depth = [](vtkPolyData* mesh, const LightPosition& light, int kind) {
    ShadowPipeline pipeline(mesh, light, kind);
    return shadowtest::fieldValue(pipeline.volume(), "GreatestDepth");
  };
  const shadowtest::Mesh sheets = shadowtest::merged({ shadowtest::ground(0.0, 1.0, 2),
    shadowtest::ground(0.3, 0.8, 3), shadowtest::ground(0.6, 0.5, 1) });
  for (const LightPosition& light : Lights)
  {
    for (const int kind : shadowtest::AllKinds)
    {
      EXPECT_EQ(depth(shadowtest::sphere(12, 24), light, kind), 1.0);
      EXPECT_EQ(depth(shadowtest::box(), light, kind), 1.0);
      EXPECT_GE(depth(shadowtest::torus(24, 12), light, kind), 1.0);
      EXPECT_LE(depth(shadowtest::torus(24, 12), light, kind), 4.0);
    }
  }
  for (const int kind : shadowtest::AllKinds)
  {
    EXPECT_EQ(depth(sheets, Lights[1], kind), 3.0);
    // From between them one sees at most two behind each other.
    const double between = depth(sheets, { 0.2, 0.1, 0.4, 1.0 }, kind);
    EXPECT_GE(between, 2.0);
    EXPECT_LE(between, 4.0);
  }
  // The middle of its bounds is on its border.
  EXPECT_LE(depth(shadowtest::triangle(), Lights[1], vtkSmoothLightSilhouette::DISCRETE), 2.0);
}

TEST(ShadowVolumeExtruder, MakesADiscreteSilhouetteItself)
{
  const shadowtest::Mesh torus = shadowtest::torus(24, 12);
  ShadowPipeline pipeline(torus, Lights[2], vtkSmoothLightSilhouette::DISCRETE);
  vtkNew<vtkShadowVolumeExtruder> alone;
  alone->SetInputData(torus);
  alone->SetLightPosition(Lights[2].data());
  alone->Update();
  EXPECT_EQ(
    alone->GetOutput()->GetNumberOfPolys(), pipeline.volume()->GetNumberOfPolys());
  EXPECT_EQ(shadowtest::openEdges(alone->GetOutput()), 0);
}

TEST(ShadowVolumeExtruder, InfinityIsShownAtLength)
{
  const shadowtest::Mesh torus = shadowtest::torus(24, 12);
  ShadowPipeline pipeline(torus, Lights[2], vtkSmoothLightSilhouette::SMOOTH);
  pipeline.Extruder->SetLength(7.0);
  vtkPolyData* volume = pipeline.volume();
  vtkDataArray* homogeneous = volume->GetPointData()->GetArray("Homogeneous");
  ASSERT_EQ(homogeneous->GetNumberOfTuples(), volume->GetNumberOfPoints());
  vtkIdType infinite = 0;
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    double h[4];
    homogeneous->GetTuple(i, h);
    double p[3];
    volume->GetPoint(i, p);
    ASSERT_TRUE(h[3] == 0.0 || h[3] == 1.0);
    const double farthest = 7.0 + torus->GetLength();
    EXPECT_LE(std::hypot(p[0], p[1], p[2]), farthest);
    infinite += h[3] == 0.0;
    if (h[3] == 1.0)
    {
      EXPECT_EQ(h[0], p[0]);
    }
  }
  EXPECT_GT(infinite, 50);
}

TEST(ShadowVolumeExtruder, OtherMeshsSilhouetteIsAnError)
{
  ShadowPipeline torus(shadowtest::torus(24, 12), Lights[2], vtkSmoothLightSilhouette::SMOOTH);
  vtkNew<vtkShadowVolumeExtruder> extruder;
  extruder->SetInputData(shadowtest::torus(24, 12, 5));
  extruder->SetSilhouetteConnection(torus.Silhouette->GetOutputPort());
  vtkNew<vtkTest::ErrorObserver> errors;
  extruder->AddObserver(vtkCommand::ErrorEvent, errors);
  extruder->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  extruder->Update();
  EXPECT_NE(errors->GetErrorMessage().find("not that of the mesh"), std::string::npos);
  EXPECT_EQ(extruder->GetOutput()->GetNumberOfPolys(), 0);

  errors->Clear();
  extruder->SetInputConnection(1, nullptr);
  extruder->SetInputData(1, shadowtest::triangle());
  extruder->Update();
  EXPECT_NE(errors->GetErrorMessage().find("port 1"), std::string::npos);
}

// Such a light counts as just above the surface: it casts what one moved up a little casts.
TEST(ShadowVolumeExtruder, LightOnAVertex)
{
  const shadowtest::Mesh sphere = shadowtest::sphere(12, 24);
  double on[3];
  sphere->GetPoint(100, on);
  const double up = 1.0 + 1e-5;
  for (const int kind : shadowtest::AllKinds)
  {
    ShadowPipeline touching(sphere, { on[0], on[1], on[2], 1.0 }, kind);
    ShadowPipeline above(sphere, { up * on[0], up * on[1], up * on[2], 1.0 }, kind);
    EXPECT_EQ(shadowtest::openEdges(touching.volume()), 0);
    EXPECT_GT(touching.volume()->GetNumberOfPolys(), 100);
    for (int i = 0; i < 100; ++i)
    {
      const double point[3] = { -3.0 + 0.66 * (i % 10), -3.0 + 0.66 * (i / 10), -1.7 };
      EXPECT_NEAR(shadowtest::windingNumber(touching.volume(), point),
        shadowtest::windingNumber(above.volume(), point), shadowtest::tolerance::Winding);
    }
  }
}

// Whatever somebody did to the silhouette on its way, it ends in an error.
TEST(ShadowVolumeExtruder, TamperedSilhouettesAreErrors)
{
  const shadowtest::Mesh torus = shadowtest::torus(24, 12);
  using Spoil = void (*)(vtkPolyData*);
  const Spoil spoils[] = {
    [](vtkPolyData* s) { s->GetPointData()->RemoveArray("MeshNodes"); },
    [](vtkPolyData* s) { s->GetPointData()->GetArray("MeshNodes")->SetNumberOfTuples(3); },
    [](vtkPolyData* s) { s->GetPointData()->GetArray("MeshNodes")->SetComponent(0, 0, 1e15); },
    [](vtkPolyData* s) { s->GetPointData()->GetArray("MeshPoints")->SetComponent(0, 1, 9.0); },
    [](vtkPolyData* s) { s->GetCellData()->GetArray("Multiplicity")->SetComponent(0, 0, 0.0); },
    [](vtkPolyData* s) { s->GetCellData()->GetArray("Multiplicity")->SetComponent(0, 0, 2.0); },
    [](vtkPolyData* s) { s->GetPoints()->SetPoint(0, 5.0, 0.0, 0.0); },
    [](vtkPolyData* s) { s->GetFieldData()->RemoveArray("LightPosition"); },
    [](vtkPolyData* s) { s->GetFieldData()->RemoveArray("SearchComplete"); },
    [](vtkPolyData* s) {
      // Loops may be missing only where the search says so.
      vtkNew<vtkCellArray> none;
      s->SetLines(none);
      s->GetCellData()->GetArray("Multiplicity")->SetNumberOfTuples(0);
    },
    [](vtkPolyData* s) { s->GetLines()->GetConnectivityArray()->SetComponent(1, 0, 1e9); },
    [](vtkPolyData* s) { s->GetLines()->GetConnectivityArray()->SetComponent(1, 0, -5.0); },
    [](vtkPolyData* s) { s->GetLines()->GetConnectivityArray()->SetComponent(0, 0, 7.0); }
  };
  for (std::size_t i = 0; i < std::size(spoils); ++i)
  {
    ShadowPipeline pipeline(torus, Lights[2], vtkSmoothLightSilhouette::SMOOTH);
    vtkNew<vtkPolyData> spoilt;
    spoilt->DeepCopy(pipeline.silhouette());
    spoils[i](spoilt);
    vtkNew<vtkShadowVolumeExtruder> extruder;
    extruder->SetInputData(torus);
    extruder->SetInputData(1, spoilt);
    vtkNew<vtkTest::ErrorObserver> errors;
    extruder->AddObserver(vtkCommand::ErrorEvent, errors);
    extruder->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
    extruder->Update();
    EXPECT_TRUE(errors->GetError()) << "spoil " << i;
    EXPECT_EQ(extruder->GetOutput()->GetNumberOfPolys(), 0) << "spoil " << i;
  }
}
