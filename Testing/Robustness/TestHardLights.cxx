// Lights where no light should be: on the mesh, in the planes of its faces, inside of it, very far,
// along its axes, and what is no light at all.

#include "AnalyticShadow.h"
#include "ChainChecks.h"
#include "ExactShadow.h"
#include "HardScene.h"
#include "HostileMeshes.h"
#include "PolylineDistance.h"
#include "SegmentChain.h"
#include "ShadowScene.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkRenderWindow.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace shadowtest;

/// Scales and shifts that are exact in doubles: what is in a plane stays there.
Mesh overTheGround(vtkPolyData* mesh)
{
  return moved(mesh, 0.5, { 0.0, 0.0, 1.25 });
}

LightPosition overTheGround(const LightPosition& light)
{
  return movedLight(light.data(), 0.5, { 0.0, 0.0, 1.25 });
}

MeshBuilder opening(vtkPolyData* mesh)
{
  MeshBuilder builder;
  builder.append(mesh);
  return builder;
}

LightPosition pointAt(const Vec3& place)
{
  return { place[0], place[1], place[2], 1.0 };
}

/// All checks that hold of any light off the surface.
void expectExactShadow(vtkPolyData* mesh, const LightPosition& light, const CastingParts& parts)
{
  const ChainTotals chains = expectClosedChains(mesh, light);
  EXPECT_GT(chains.Segments, 3);
  EXPECT_GT(chains.Triangles, 3);
  const PointTotals points = expectExactWinding(mesh, light, parts);
  EXPECT_GT(points.InShadow, 4);
  EXPECT_GT(points.Lit, 20);
}

/// What a convex mesh, wound outwards, is for a segment from a point to a light.
struct ConvexHit
{
  double Length;    ///< of the segment inside, as a share of it; 0 or less if there is none
  double Clearance; ///< from the point to the nearest plane of a face
};

ConvexHit hitConvex(const MeshBuilder& mesh, const Vec3& point, const LightPosition& light)
{
  const Vec3 towards{ light[0] - light[3] * point[0], light[1] - light[3] * point[1],
    light[2] - light[3] * point[2] };
  double enter = 0.0;
  double leave = light[3] == 0.0 ? std::numeric_limits<double>::infinity() : 1.0;
  double clearance = std::numeric_limits<double>::infinity();
  for (const auto& cell : mesh.Cells)
  {
    const Vec3& a = mesh.Points[static_cast<std::size_t>(cell[0])];
    const Vec3 normal = normalized(cross(mesh.Points[static_cast<std::size_t>(cell[1])] - a,
      mesh.Points[static_cast<std::size_t>(cell[2])] - a));
    const double outside = dot(normal, point - a);
    const double speed = dot(normal, towards);
    clearance = std::min(clearance, std::fabs(outside));
    if (speed < 0.0)
    {
      enter = std::max(enter, -outside / speed);
    }
    else if (speed > 0.0)
    {
      leave = std::min(leave, -outside / speed);
    }
    else if (outside > 0.0)
    {
      leave = -1.0;
    }
  }
  return { leave - enter, clearance };
}

/// Expects points outside of a convex mesh to be in its discrete volume exactly if it hides the
/// light, which may be on it.
void expectConvexShadow(vtkPolyData* mesh, const LightPosition& light)
{
  const MeshBuilder planes = opening(mesh);
  ShadowPipeline pipeline(mesh, light, vtkSmoothLightSilhouette::DISCRETE);
  vtkPolyData* volume = pipeline.volume();
  int inShadow = 0;
  int lit = 0;
  for (int sample = 0; sample < 400; ++sample)
  {
    const Vec3 point = samplePoint(mesh, sample);
    const ConvexHit hit = hitConvex(planes, point, light);
    // Seen from a light on the mesh the shadow ends on the planes of the faces there.
    if (isInside(mesh, pointAt(point)) ||
      hit.Clearance < 2.0 * tolerance::LightLift * mesh->GetLength())
    {
      continue;
    }
    const bool hidden = hit.Length > tolerance::TooClose;
    EXPECT_NEAR(windingNumber(volume, point.data()), hidden ? 1.0 : 0.0, tolerance::Winding)
      << "point " << point[0] << ' ' << point[1] << ' ' << point[2] << ", hidden " << hit.Length;
    ++(hidden ? inShadow : lit);
  }
  EXPECT_GT(inShadow, 10);
  EXPECT_GT(lit, 10);
}

std::vector<std::pair<const char*, Mesh>> convexMeshes()
{
  return { { "ball", icosphere(1) }, { "box", box() }, { "welded box", weldedBox() },
    { "cylinder", cylinder(12) } };
}
}

TEST(HardLights, OnAVertex)
{
  for (const auto& [name, mesh] : convexMeshes())
  {
    SCOPED_TRACE(name);
    for (const vtkIdType vertex : { 0, 3, 7 })
    {
      Vec3 place;
      mesh->GetPoint(vertex, place.data());
      const ChainTotals chains = expectClosedChains(mesh, pointAt(place));
      EXPECT_GT(chains.Segments, 3);
      EXPECT_GT(chains.Triangles, 3);
      expectConvexShadow(mesh, pointAt(place));
    }
  }
  // An open mesh, and one with five faces at an edge: closed chains is all there is to ask for.
  for (const Mesh& mesh : { ground(0.0, 1.0, 3), fin(5), moebiusStrip(16) })
  {
    for (vtkIdType vertex = 0; vertex < 9; ++vertex)
    {
      Vec3 place;
      mesh->GetPoint(vertex, place.data());
      EXPECT_GT(expectClosedChains(mesh, pointAt(place)).Triangles, 3);
    }
  }
  // The top of a ball. The truth is a little above it, as the ray cast would hit the vertex.
  const Mesh ball = overTheGround(sphere(8, 12));
  expectCastMask({ { ball } }, { 0.0, 0.0, 1.75, 1.0 }, { 0.0, 0.0, 1.75 + 1e-5, 1.0 });
}

TEST(HardLights, InAFacesPlane)
{
  const LightPosition inTop{ 3.0, 0.25, 1.0, 1.0 };
  for (const auto& [name, mesh] : convexMeshes())
  {
    if (std::string(name) != "ball")
    {
      SCOPED_TRACE(name);
      expectExactShadow(mesh, inTop, { mesh, nullptr });
      expectConvexShadow(mesh, inTop);
    }
  }
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    SCOPED_TRACE(seed);
    const Mesh cubes = voxels(3, seed);
    expectExactShadow(cubes, { 7.0, 2.0, 3.0, 1.0 }, { cubes, nullptr });
    expectExactShadow(cubes, { -2.0, 1.0, 5.0, 1.0 }, { cubes, nullptr });
  }
  const Mesh solid = overTheGround(box());
  const LightPosition light = overTheGround(LightPosition{ 1.0, 0.25, 4.0, 1.0 });
  expectExactShadow(solid, light, { solid, nullptr });
  expectCastMask({ { solid } }, light);
}

TEST(HardLights, OnAnEdgesLine)
{
  const LightPosition onLine{ 1.0, 1.0, 5.0, 1.0 };
  for (const Mesh& mesh : { box(), weldedBox(), quadBox() })
  {
    expectExactShadow(mesh, onLine, { mesh, nullptr });
    expectConvexShadow(mesh, onLine);
  }
  const Mesh cubes = voxels(3, 4);
  expectExactShadow(cubes, { 1.0, 2.0, 6.0, 1.0 }, { cubes, nullptr });
  expectExactShadow(cubes, { 1.0, 1.0, 1.0, 0.0 }, { cubes, nullptr });

  const Mesh solid = overTheGround(box());
  expectCastMask({ { solid } }, overTheGround(onLine));

  // Five faces with a common edge, from a light on its line: all are edge-on and hide nothing.
  const Mesh leaves = fin(5);
  const LightPosition above{ 0.0, 0.0, 4.0, 1.0 };
  EXPECT_GT(expectClosedChains(leaves, above).Segments, 3);
  const PointTotals points = expectExactWinding(leaves, above, { nullptr, leaves });
  EXPECT_EQ(points.InShadow, 0);
  EXPECT_GT(points.Lit, 100);
}

// Dark caps have all that is outside in shadow; lit ones what faces the light stands before.
TEST(HardLights, InsideTheMesh)
{
  struct Case
  {
    const char* Name;
    Mesh Surface;
    LightPosition Light;
  };
  const Case cases[] = { { "ball", icosphere(2), { 0.1, 0.2, 0.3, 1.0 } },
    { "box", box(), { 0.0, 0.0, 0.0, 1.0 } }, { "cylinder", cylinder(12), { 0.3, 0.1, 0.9, 1.0 } },
    { "torus", torus(24, 12), { 1.0, 0.05, 0.1, 1.0 } },
    { "star", starShaped(2, 3, 0.29), { 0.1, 0.0, 0.05, 1.0 } } };
  for (const Case& c : cases)
  {
    SCOPED_TRACE(c.Name);
    ASSERT_TRUE(isInside(c.Surface, c.Light));
    EXPECT_GT(expectClosedChains(c.Surface, c.Light).Triangles, 20);
    const PointTotals points = expectExactWinding(c.Surface, c.Light, { c.Surface, nullptr });
    EXPECT_GT(points.InShadow, 100);
    EXPECT_GE(points.Deepest, 1);
  }
  // What is convex casts nothing with lit caps.
  ShadowPipeline pipeline(box(), cases[1].Light, vtkSmoothLightSilhouette::DISCRETE);
  pipeline.Extruder->SetCapsToLit();
  EXPECT_EQ(pipeline.volume()->GetNumberOfCells(), 0);
  pipeline.Extruder->SetCapsToDark();
  EXPECT_GT(pipeline.volume()->GetNumberOfCells(), 20);

  const Mesh ring = moved(torus(24, 12), 0.75, { 0.0, 0.0, 1.25 });
  expectCastMask({ { ring } }, { 0.75, 0.0, 1.25, 1.0 });
  const Mesh solid = overTheGround(box());
  expectCastMask({ { solid } }, { 0.0, 0.0, 1.25, 1.0 });
}

TEST(HardLights, InsideItsBoundsButOutside)
{
  const Mesh ring = torus(24, 12);
  for (const LightPosition& light : { LightPosition{ 0.0, 0.0, 0.0, 1.0 },
         LightPosition{ 0.1, -0.2, 0.3, 1.0 }, LightPosition{ 1.3, 1.3, 0.1, 1.0 } })
  {
    ASSERT_FALSE(isInside(ring, light));
    expectExactShadow(ring, light, { ring, nullptr });
  }
  // Between cubes.
  const Mesh cubes = voxels(3, 2);
  int between = 0;
  for (int i = 0; i < 27; ++i)
  {
    const LightPosition light{ i % 3 + 0.5, i / 3 % 3 + 0.5, i / 9 + 0.5, 1.0 };
    if (!isInside(cubes, light))
    {
      ++between;
      EXPECT_GT(expectClosedChains(cubes, light).Segments, 3);
      EXPECT_GT(expectExactWinding(cubes, light, { cubes, nullptr }, 60).InShadow, 10);
    }
  }
  EXPECT_GT(between, 5);

  const Mesh standing = moved(ring, 0.75, { 0.0, 0.0, 1.25 }, 4);
  expectCastMask({ { standing } }, { 0.05, 0.02, 1.25, 1.0 });
}

// Where the silhouette of another light runs: on vertices, within edges, and just off the mesh.
TEST(HardLights, OnTheSilhouette)
{
  const Mesh ball = icosphere(1);
  for (const int kind : AllKinds)
  {
    SCOPED_TRACE("silhouette kind " + std::to_string(kind));
    ShadowPipeline other(ball, { 0.3, 0.2, 1.0, 0.0 }, kind);
    vtkPolyData* silhouette = other.silhouette();
    ASSERT_GT(silhouette->GetNumberOfPoints(), 8);
    int outside = 0;
    for (vtkIdType i = 0; i < silhouette->GetNumberOfPoints(); i += 3)
    {
      Vec3 place;
      silhouette->GetPoint(i, place.data());
      const LightPosition light = pointAt(place);
      EXPECT_GT(expectClosedChains(ball, light).Triangles, 3);
      // In the middle of an edge the volume is closed, but not defined behind the edge.
      const bool onAVertex = kind == vtkSmoothLightSilhouette::DISCRETE;
      if (onAVertex || !isOnSurface(ball, light))
      {
        ++outside;
        expectConvexShadow(ball, light);
      }
    }
    EXPECT_EQ(outside > 2, kind != vtkSmoothLightSilhouette::ACCURATE);
  }
  // The light on its own silhouette: on the edges that part what it sees from what it does not.
  const Mesh solid = box();
  for (const Vec3& place : { Vec3{ 1.0, 1.0, 0.0 }, Vec3{ 1.0, 0.3, -1.0 }, Vec3{ 0.2, 1.0, 1.0 } })
  {
    EXPECT_GT(expectClosedChains(solid, pointAt(place)).Triangles, 3);
  }
}

namespace
{
const Vec3 FarDirection = normalized({ 0.3, 0.2, 1.0 });

LightPosition farLight(double distance)
{
  return pointAt(distance * FarDirection);
}

/// The silhouette's shadow on a plane below the mesh.
Mesh shadowOf(vtkPolyData* silhouette, const LightPosition& light)
{
  const Plane plane{ { 0.0, 0.0, -3.0 }, { 0.0, 0.0, 1.0 } };
  Mesh shadow = Mesh::New();
  shadow->DeepCopy(silhouette);
  for (vtkIdType i = 0; i < shadow->GetNumberOfPoints(); ++i)
  {
    Vec3 point;
    silhouette->GetPoint(i, point.data());
    shadow->GetPoints()->SetPoint(i, shadowOn(plane, light, point).data());
  }
  return shadow;
}
}

// In proportion to the inverse of the distance, until rounding is all that is left.
TEST(HardLights, FarOnesConvergeToTheDirection)
{
  const LightPosition direction{ FarDirection[0], FarDirection[1], FarDirection[2], 0.0 };
  for (const auto& [name, mesh] : { std::pair<const char*, Mesh>{ "ball", sphere(10, 16, 3) },
         std::pair<const char*, Mesh>{ "torus", torus(16, 8, 3) } })
  {
    const double size = mesh->GetLength();
    for (const int kind : AllKinds)
    {
      SCOPED_TRACE(std::string(name) + ", silhouette kind " + std::to_string(kind));
      ShadowPipeline pipeline(mesh, direction, kind);
      // Lines may differ by as much as they may be off their curves.
      pipeline.Silhouette->SetTolerance(1e-6);
      vtkNew<vtkPolyData> limit;
      limit->DeepCopy(pipeline.silhouette());
      const Mesh limitShadow = shadowOf(limit, direction);
      std::vector<double> inverse;
      std::vector<double> contours;
      std::vector<double> shadows;
      for (const int exponent : { 3, 5, 7, 9, 12 })
      {
        const double distance = std::pow(10.0, exponent) * size;
        SCOPED_TRACE("1e" + std::to_string(exponent));
        pipeline.setLight(farLight(distance));
        const LoopReport report = checkLoops(pipeline.silhouette());
        EXPECT_TRUE(report.good()) << report;
        EXPECT_EQ(openEdges(pipeline.volume()), 0);
        EXPECT_GT(pipeline.volume()->GetNumberOfPolys(), 50);
        const double contour = hausdorffDistance(limit, pipeline.silhouette()) / size;
        const double shadow =
          hausdorffDistance(limitShadow, shadowOf(pipeline.silhouette(), farLight(distance))) /
          size;
        // Of lines that are some sizes from the plane and, at most, turned by the angle between the
        // light's directions over the mesh.
        EXPECT_LE(shadow, 10.0 * size / distance + tolerance::SamePoint);
        if (exponent <= 7)
        {
          inverse.push_back(size / distance);
          contours.push_back(contour);
          shadows.push_back(shadow);
        }
        if (exponent >= 6 && kind == vtkSmoothLightSilhouette::DISCRETE)
        {
          const ChainDifference difference = compareChains(
            chainOf(limit), chainOf(pipeline.silhouette()), tolerance::SamePoint * size);
          EXPECT_TRUE(difference.none()) << difference.Message;
          EXPECT_GT(difference.Expected, 20u);
        }
      }
      EXPECT_NEAR(fitOrder(inverse, shadows), 1.0, tolerance::FarLightOrder);
      if (kind != vtkSmoothLightSilhouette::DISCRETE)
      {
        EXPECT_NEAR(fitOrder(inverse, contours), 1.0, tolerance::FarLightOrder);
      }
    }
  }
}

TEST(HardLights, FarOnesCastTheDirectionsMask)
{
  const Mesh ring = moved(torus(24, 12), 0.75, { 0.0, 0.0, 1.25 }, 4);
  const Mesh leaf = moved(ground(0.0, 0.5, 2), 1.0, { 1.5, -1.0, 1.0 }, 5);
  const LightPosition direction{ FarDirection[0], FarDirection[1], FarDirection[2], 0.0 };
  for (int exponent = 3; exponent <= 12; exponent += 3)
  {
    SCOPED_TRACE("1e" + std::to_string(exponent));
    const LightPosition light = farLight(std::pow(10.0, exponent));
    expectCastMask({ { ring }, { leaf } }, light, light);
    // A thousandth of a size is less than a pixel.
    expectCastMask({ { ring }, { leaf } }, light, direction);
  }
}

// Faces along the light are neither before nor behind it: their fields are exactly 0, which is lit.
TEST(HardLights, AlongAnAxisOfBoxesAndCylinders)
{
  const std::pair<const char*, Mesh> meshes[] = { { "box", box() }, { "welded box", weldedBox() },
    { "quads", quadBox() }, { "cylinder", cylinder(12) }, { "triangular", cylinder(3, 2) } };
  for (const auto& [name, mesh] : meshes)
  {
    const MeshBuilder planes = opening(mesh);
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const double sign : { 1.0, -1.0 })
      {
        SCOPED_TRACE(
          std::string(name) + ", axis " + std::to_string(axis) + ", sign " + std::to_string(sign));
        LightPosition light{ 0.0, 0.0, 0.0, 0.0 };
        light[static_cast<std::size_t>(axis)] = sign;
        expectExactShadow(mesh, light, { mesh, nullptr });
        expectConvexShadow(mesh, light);
      }
    }
    // From above what is dark is the bottom alone, and the silhouette its rim.
    for (const int kind : AllKinds)
    {
      SCOPED_TRACE(std::string(name) + ", silhouette kind " + std::to_string(kind));
      ShadowPipeline pipeline(mesh, { 0.0, 0.0, 1.0, 0.0 }, kind);
      vtkPolyData* silhouette = pipeline.silhouette();
      ASSERT_EQ(silhouette->GetNumberOfLines(), 1);
      EXPECT_EQ(silhouette->GetCellData()->GetArray("Multiplicity")->GetComponent(0, 0), 1.0);
      EXPECT_GE(silhouette->GetNumberOfPoints(), 3);
      for (vtkIdType i = 0; i < silhouette->GetNumberOfPoints(); ++i)
      {
        EXPECT_NEAR(silhouette->GetPoint(i)[2], -1.0, tolerance::SamePoint);
      }
    }
  }
  const Mesh pillar = overTheGround(cylinder(12));
  const Mesh solid = moved(box(), 0.25, { 1.5, -0.5, 0.75 });
  expectCastMask({ { pillar }, { solid } }, { 0.0, 0.0, 1.0, 0.0 });
}

namespace
{
struct BadLight
{
  LightPosition Light;
  const char* Said;
};

/// An update with a bad light says so and leaves no output, and the next good light is as ever.
template <class Filter>
void expectErrorThatSays(Filter* filter, const BadLight& bad)
{
  const double good[4] = { 0.3, 0.2, 1.0, 0.0 };
  filter->SetLightPosition(good);
  filter->Update();
  const vtkIdType cells = filter->GetOutput()->GetNumberOfCells();
  EXPECT_GT(cells, 0);

  vtkNew<vtkTest::ErrorObserver> errors;
  filter->AddObserver(vtkCommand::ErrorEvent, errors);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  filter->SetLightPosition(bad.Light.data());
  filter->Update();
  EXPECT_TRUE(errors->GetError());
  EXPECT_NE(errors->GetErrorMessage().find(bad.Said), std::string::npos)
    << errors->GetErrorMessage();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

  errors->Clear();
  filter->SetLightPosition(good);
  filter->Update();
  EXPECT_FALSE(errors->GetError());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), cells);
}

void expectErrors(const BadLight& bad)
{
  SCOPED_TRACE(bad.Said);
  for (const int kind : AllKinds)
  {
    vtkNew<vtkSmoothLightSilhouette> silhouette;
    silhouette->SetInputData(torus(12, 8));
    silhouette->SetKind(kind);
    expectErrorThatSays(silhouette.Get(), bad);
  }
  vtkNew<vtkShadowVolumeExtruder> extruder;
  extruder->SetInputData(torus(12, 8));
  expectErrorThatSays(extruder.Get(), bad);

  // An extruder behind it is not updated, and says so.
  ShadowPipeline pipeline(torus(12, 8), { 0.0, 0.0, 1.0, 0.0 }, vtkSmoothLightSilhouette::SMOOTH);
  EXPECT_GT(pipeline.volume()->GetNumberOfCells(), 0);
  vtkNew<vtkTest::ErrorObserver> errors;
  for (vtkAlgorithm* filter :
    std::initializer_list<vtkAlgorithm*>{ pipeline.Silhouette.Get(), pipeline.Extruder.Get() })
  {
    filter->AddObserver(vtkCommand::ErrorEvent, errors);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  }
  pipeline.setLight(bad.Light);
  EXPECT_EQ(pipeline.Extruder->GetExecutive()->Update(), 0);
  EXPECT_TRUE(errors->GetError());
  EXPECT_NE(errors->GetErrorMessage().find(bad.Said), std::string::npos);
}
}

TEST(HardLights, NotFinite)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const BadLight& bad : { BadLight{ { nan, 0.0, 0.0, 1.0 }, "LightPosition (nan, 0, 0, 1)" },
         BadLight{ { 0.0, 2.0, infinity, 0.0 }, "LightPosition (0, 2, inf, 0)" },
         BadLight{ { 0.0, -infinity, 1.0, 1.0 }, "LightPosition (0, -inf, 1, 1)" },
         BadLight{ { 1.0, 2.0, 3.0, nan }, "LightPosition (1, 2, 3, nan)" } })
  {
    expectErrors(bad);
  }
}

// In a scene such a light casts nothing, and takes no shadow from the others.
TEST(HardLights, NotFiniteInThePass)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Scene scene;
  const Mesh ball = overTheGround(sphere(8, 12));
  scene.Add(ball);
  const vtkSmartPointer<vtkLight> bad = scene.AddLight({ nan, 1.0, 3.0, 1.0 });
  const vtkSmartPointer<vtkLight> good = scene.AddLight(PointLight);
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  window->Render();
  ExpectMask(scene, good, PointLight, { { scene.GroundMesh }, { ball } }, "beside a bad light");
  EXPECT_FALSE(scene.Mask(bad));
}

TEST(HardLights, AllZero)
{
  expectErrors({ { 0.0, 0.0, 0.0, 0.0 }, "LightPosition (0, 0, 0, 0)" });
}
