// Watertightness as Embree's own test has it: closed surfaces of radius 2, and planes, at a far
// away place, and no ray may leak. Here the rays are those of lamps: of 100,000 points none may be
// wrong, and none of some million pixels. Embree allows a rate of 2e-5.

#include "ChainChecks.h"
#include "MaskComparison.h"
#include "Random.h"
#include "RayCast.h"
#include "ShadowPipeline.h"
#include "ShadowScene.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{
using namespace shadowtest;

const Vec3 Place = { 148376.0, 1234.0, -223423.0 };
constexpr double Radius = 2.0;
constexpr int Kinds[] = { vtkSmoothLightSilhouette::DISCRETE, vtkSmoothLightSilhouette::ACCURATE,
  vtkSmoothLightSilhouette::SMOOTH };

struct ClosedMesh
{
  std::string Name;
  Mesh Surface;
  /// Inside.
  std::vector<LightPosition> Lamps;
};

LightPosition lampAt(double x, double y, double z)
{
  return { Place[0] + x, Place[1] + y, Place[2] + z, 1.0 };
}

// A ball, one with dents, and a ring: from its inside some of a ring faces away, so its volume has
// walls.
std::vector<ClosedMesh> closedMeshes(int subdivisions)
{
  const std::vector<LightPosition> lamps = { lampAt(0.0, 0.0, 0.0), lampAt(0.3, -0.9, 0.4),
    lampAt(-1.0, 0.5, -0.6) };
  const double ringSize = Radius / (TorusRadius + TorusTube);
  const int sides = 6 << (subdivisions / 2);
  return { { "ball", moved(icosphere(subdivisions), Radius, Place, 5), lamps },
    { "bumpy", moved(starShaped(subdivisions, 11, 0.5), Radius, Place, 5), lamps },
    { "ring", moved(torus(2 * sides, sides), ringSize, Place),
      { lampAt(1.4, 0.1, 0.1), lampAt(-0.9, -1.0, 0.3), lampAt(0.2, 1.6, -0.2) } } };
}

std::vector<LightPosition> lightsOutside()
{
  const Vec3 lamp = Place + Vec3{ 2.0, 1.5, 3.5 };
  return { { lamp[0], lamp[1], lamp[2], 1.0 }, { 0.5, -0.3, 1.0, 0.0 } };
}

Vec3 randomPoint(Random& random, double reach)
{
  Vec3 point = Place;
  for (double& coordinate : point)
  {
    coordinate += random.uniform(-reach, reach);
  }
  return point;
}

// Behind a vertex or the middle of an edge, seen from a lamp: where a surface is most likely to
// leak.
Vec3 pointBehindAnEdge(Random& random, vtkPolyData* mesh, const LightPosition& lamp)
{
  vtkIdType size;
  const vtkIdType* ids;
  mesh->GetCellPoints(random.integer(0, static_cast<int>(mesh->GetNumberOfCells()) - 1), size, ids);
  const int corner = random.integer(0, 2);
  Vec3 a;
  Vec3 b;
  mesh->GetPoint(ids[corner], a.data());
  mesh->GetPoint(ids[(corner + random.integer(0, 1)) % 3], b.data());
  const Vec3 light = { lamp[0], lamp[1], lamp[2] };
  const double beyond = random.uniform(1.01, 3.0);
  return light + beyond * (0.5 * (a + b) - light);
}

struct PointCount
{
  long Shadow = 0;
  long Lit = 0;
  long Unclear = 0;
  long Wrong = 0;
  long Loops = 0;
};

void add(PointCount& sum, const PointCount& count)
{
  sum.Shadow += count.Shadow;
  sum.Lit += count.Lit;
  sum.Unclear += count.Unclear;
  sum.Wrong += count.Wrong;
  sum.Loops += count.Loops;
}

bool windsAround(const VolumeWinding& winding, const Vec3& point)
{
  return std::fabs(winding.around(point.data())) > 0.5;
}

// A leak of any size would leave another winding number than a whole one.
bool isInShadow(const VolumeWinding& winding, const Vec3& point)
{
  const double number = winding.around(point.data());
  EXPECT_NEAR(number, std::round(number), tolerance::Winding);
  return std::fabs(number) > 0.5;
}

// Points outside of a mesh with a lamp in it, all of which are in shadow.
PointCount leaks(vtkPolyData* mesh, const LightPosition& lamp, int kind, int points)
{
  ShadowPipeline pipeline(mesh, lamp, kind);
  const VolumeWinding shadow(pipeline.volume());
  const VolumeWinding inside(mesh);
  Random random(static_cast<std::uint64_t>(kind) + 1);
  PointCount count;
  count.Loops = static_cast<long>(pipeline.silhouette()->GetNumberOfLines());
  for (int i = 0; i < points; ++i)
  {
    const bool anywhere = i % 2 == 0;
    const Vec3 point =
      anywhere ? randomPoint(random, 3.0 * Radius) : pointBehindAnEdge(random, mesh, lamp);
    // Between the triangles and the smooth surface that they stand for, either is right.
    const Vec3 fromMiddle = point - Place;
    const bool nearby = kind == vtkSmoothLightSilhouette::SMOOTH &&
      dot(fromMiddle, fromMiddle) < 4.0 * Radius * Radius;
    if (nearby || windsAround(inside, point))
    {
      continue;
    }
    // On a wall's edge, behind an edge of a contour, solid angles are good to 1e-4 only.
    const bool dark = anywhere ? isInShadow(shadow, point) : windsAround(shadow, point);
    ++(dark ? count.Shadow : count.Wrong);
  }
  return count;
}

// Points outside of a mesh against the triangles between them and the light.
PointCount comparison(vtkPolyData* mesh, const LightPosition& light, int points)
{
  ShadowPipeline pipeline(mesh, light, vtkSmoothLightSilhouette::DISCRETE);
  const VolumeWinding shadow(pipeline.volume());
  const VolumeWinding inside(mesh);
  const double margin = tolerance::RoundingsOfPlace * std::sqrt(dot(Place, Place)) *
    std::numeric_limits<double>::epsilon() / meanEdgeLength(mesh);
  Random random(3);
  PointCount count;
  for (int i = 0; i < points; ++i)
  {
    const Vec3 point = randomPoint(random, 2.0 * Radius);
    if (windsAround(inside, point))
    {
      continue;
    }
    const Blockers blockers = blockersTowards(mesh, point.data(), light.data());
    if (blockers.Margin < margin)
    {
      ++count.Unclear;
      continue;
    }
    const bool expected = blockers.Count > 0;
    count.Wrong += isInShadow(shadow, point) != expected;
    ++(expected ? count.Shadow : count.Lit);
  }
  return count;
}
}

TEST(Watertight, LampsInsideLightNoPointOutside)
{
  PointCount sum;
  for (const ClosedMesh& mesh : closedMeshes(2))
  {
    for (const LightPosition& lamp : mesh.Lamps)
    {
      const double at[3] = { lamp[0], lamp[1], lamp[2] };
      ASSERT_NEAR(windingNumber(mesh.Surface, at), 1.0, tolerance::Winding);
      for (const int kind : Kinds)
      {
        const bool discrete = kind == vtkSmoothLightSilhouette::DISCRETE;
        const PointCount count = leaks(mesh.Surface, lamp, kind, discrete ? 9000 : 3000);
        EXPECT_EQ(count.Wrong, 0) << mesh.Name << ", silhouette kind " << kind;
        add(sum, count);
      }
    }
  }
  EXPECT_GT(sum.Shadow, 80000);
  EXPECT_GE(sum.Loops, 3); // in the ring, under each lamp
}

TEST(Watertight, LightsOutsideShadeWhatTheyDoNotSee)
{
  PointCount sum;
  std::vector<ClosedMesh> meshes = closedMeshes(2);
  meshes.push_back({ "plane", moved(ground(0.0, 1.0, 12), Radius, Place, 5), {} });
  for (const ClosedMesh& mesh : meshes)
  {
    for (const LightPosition& light : lightsOutside())
    {
      const PointCount count = comparison(mesh.Surface, light, 8000);
      EXPECT_EQ(count.Wrong, 0) << mesh.Name << ", w " << light[3];
      EXPECT_LT(count.Unclear, 10);
      add(sum, count);
    }
  }
  EXPECT_GT(sum.Shadow, 3000);
  EXPECT_GT(sum.Lit, 20000);
}

namespace
{
/// A closed mesh over a ground at the far away place.
struct FarScene : Scene
{
  Mesh Caster;
  Mesh Plane = moved(ground(-1.5 * Radius, 5.0 * Radius, 3), 1.0, Place);

  explicit FarScene(vtkPolyData* caster)
    : Caster(caster)
  {
    this->Renderer->RemoveAllViewProps();
    for (const Mesh& mesh : { this->Plane, this->Caster })
    {
      // Otherwise VTK itself draws the mesh with what precision floats have there.
      vtkOpenGLPolyDataMapper::SafeDownCast(this->Add(mesh)->GetMapper())
        ->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE);
    }
  }

  void LookFrom(const Vec3& eye, const Vec3& at)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const Vec3 position = Place + eye;
    const Vec3 focus = Place + at;
    camera->SetPosition(position[0], position[1], position[2]);
    camera->SetFocalPoint(focus[0], focus[1], focus[2]);
    camera->SetViewAngle(40.0);
    camera->SetClippingRange(0.05, 60.0);
  }

  std::vector<RayObject> Objects() const { return { { this->Plane }, { this->Caster } }; }
};

constexpr int Width = 512;
constexpr int Height = 384;

// The mask's lit pixels of the ground that are farther than one pixel from anything else.
long litGround(const RayScene& rays, FarScene& scene, vtkImageData* mask, const RayLight& light)
{
  const RayPicture picture = rays.render(ViewOf(scene.Renderer, mask), light);
  constexpr int Reach = tolerance::MaskPixels;
  long lit = 0;
  for (int y = Reach; y < Height - Reach; ++y)
  {
    for (int x = Reach; x < Width - Reach; ++x)
    {
      bool ground = true;
      for (int i = -Reach; i <= Reach; ++i)
      {
        for (int j = -Reach; j <= Reach; ++j)
        {
          ground = ground && picture.at(x + i, y + j).Object == 0;
        }
      }
      lit += ground && Byte(mask, x, y) != 0;
    }
  }
  return lit;
}

void expectRight(const MaskComparison& comparison)
{
  EXPECT_EQ(comparison.total().WrongBeyond, 0) << comparison.describe();
  EXPECT_GT(comparison.Objects[1].Compared, 1000) << comparison.describe();
}
}

TEST(Watertight, LampsInsideLightNoPixelOutside)
{
  long compared = 0;
  for (const ClosedMesh& mesh : closedMeshes(4))
  {
    FarScene scene(mesh.Surface);
    auto window = MakeWindow(Width, Height);
    window->AddRenderer(scene.Renderer);
    scene.LookFrom({ -5.0, -9.0, 6.0 }, { 0.0, 0.0, -1.0 });
    const RayScene rays(scene.Objects());
    for (const LightPosition& lamp : mesh.Lamps)
    {
      SCOPED_TRACE(mesh.Name);
      scene.Renderer->RemoveAllLights();
      vtkSmartPointer<vtkLight> light = scene.AddLight(lamp);
      window->Render();
      const Image mask = scene.Mask(light);
      ASSERT_TRUE(mask);
      const MaskComparison comparison =
        compareMask(rays, ViewOf(scene.Renderer, mask), lamp, mask, TurnedAwayPixels::Shadow);
      expectRight(comparison);
      EXPECT_GT(comparison.Objects[0].Shadowed, 50000) << comparison.describe();
      EXPECT_EQ(litGround(rays, scene, mask, lamp), 0);
      compared += comparison.total().Compared;
    }
  }
  EXPECT_GT(compared, 1000000);
}

TEST(Watertight, EyesInsideSeeAllThatTheirLampLights)
{
  long compared = 0;
  for (const ClosedMesh& mesh : closedMeshes(4))
  {
    if (mesh.Name == "ring")
    {
      continue; // hides some of its inside
    }
    FarScene scene(mesh.Surface);
    auto window = MakeWindow(Width, Height);
    window->AddRenderer(scene.Renderer);
    scene.LookFrom({ 0.6, 0.5, -0.3 }, { -2.0, -1.0, 0.2 });
    const RayScene rays(scene.Objects());
    const LightPosition& lamp = mesh.Lamps.front();
    vtkSmartPointer<vtkLight> light = scene.AddLight(lamp);
    window->Render();
    const Image mask = scene.Mask(light);
    ASSERT_TRUE(mask);
    const MaskComparison comparison = compareMask(rays, ViewOf(scene.Renderer, mask), lamp, mask);
    expectRight(comparison);
    EXPECT_EQ(comparison.total().Shadowed, 0) << comparison.describe();
    compared += comparison.Objects[1].Compared;
  }
  EXPECT_EQ(compared, 2L * Width * Height);
}

TEST(Watertight, LightsOutsideCastTheShadowsOfRays)
{
  long compared = 0;
  for (const ClosedMesh& mesh : closedMeshes(4))
  {
    FarScene scene(mesh.Surface);
    auto window = MakeWindow(Width, Height);
    window->AddRenderer(scene.Renderer);
    const RayScene rays(scene.Objects());
    for (const LightPosition& position : lightsOutside())
    {
      SCOPED_TRACE(mesh.Name);
      scene.Renderer->RemoveAllLights();
      vtkSmartPointer<vtkLight> light = scene.AddLight(position);
      for (const Vec3& eye : { Vec3{ -5.0, -9.0, 6.0 }, Vec3{ 7.0, -6.0, 5.0 } })
      {
        scene.LookFrom(eye, { 0.0, 0.0, -1.0 });
        window->Render();
        const Image mask = scene.Mask(light);
        ASSERT_TRUE(mask);
        const MaskComparison comparison =
          compareMask(rays, ViewOf(scene.Renderer, mask), position, mask);
        expectRight(comparison);
        EXPECT_GT(comparison.Objects[0].Shadowed, 2000) << comparison.describe();
        compared += comparison.total().Compared;
      }
    }
  }
  EXPECT_GT(compared, 1000000);
}
