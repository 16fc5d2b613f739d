// Masks against oracles: a ray-box test by hand, the ray cast of the same triangles, and, for
// smooth shadows, the sphere that a mesh stands for.

#include "AnalyticShadow.h"
#include "MaskComparison.h"
#include "RayCast.h"
#include "ShadowScene.h"
#include "TestMeshes.h"

#include "vtkStencilShadowPass.h"

#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace
{
using namespace shadowtest;

/**
 * An oracle by hand: the ground and an axis-aligned box.
 */
struct BoxOracle
{
  Vec3 Lower{ -0.5, -0.5, 0.5 };
  Vec3 Upper{ 0.5, 0.5, 1.3 };

  enum Seen
  {
    Background,
    GroundLit,
    GroundDark,
    Box
  };

  /// Entry of a ray into the box, as a multiple of its direction; negative if it misses.
  double Enter(const Vec3& origin, const Vec3& direction) const
  {
    double enter = 0.0;
    double leave = 1e300;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double a = (this->Lower[i] - origin[i]) / direction[i];
      const double b = (this->Upper[i] - origin[i]) / direction[i];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter < leave ? enter : -1.0;
  }

  Seen Look(const RayView& view, double x, double y, const RayLight& light, Vec3& ground) const
  {
    Vec3 ends[2];
    for (int end = 0; end < 2; ++end)
    {
      const double clip[4] = { 2.0 * x / view.Width - 1.0, 2.0 * y / view.Height - 1.0,
        end == 0 ? -1.0 : 1.0, 1.0 };
      double world[4];
      vtkMatrix4x4::MultiplyPoint(view.ClipToWorld, clip, world);
      ends[end] = { world[0] / world[3], world[1] / world[3], world[2] / world[3] };
    }
    const Vec3 direction = ends[1] - ends[0];
    const double toBox = this->Enter(ends[0], direction);
    const double toGround = -ends[0][2] / direction[2];
    ground = ends[0] + toGround * direction;
    const bool onGround =
      toGround > 0.0 && std::abs(ground[0]) <= 4.0 && std::abs(ground[1]) <= 4.0;
    if (toBox >= 0.0 && (!onGround || toBox < toGround))
    {
      return Box;
    }
    if (!onGround)
    {
      return Background;
    }
    const Vec3 place = { light[0], light[1], light[2] };
    const Vec3 toLight = light[3] == 0.0 ? place : place - ground;
    return this->Enter(ground, toLight) >= 0.0 ? GroundDark : GroundLit;
  }
};

/**
 * Checks the mask and the shaded colour of ground and background pixels that are farther than one
 * pixel from every edge.
 */
void CheckBox(const RayLight& light)
{
  SCOPED_TRACE(light[3] == 0.0 ? "directional" : "point");
  const BoxOracle oracle;
  Scene scene;
  scene.Add(moved(box(0.5, 0.5, 0.4), 1.0, { 0.0, 0.0, 0.9 }));
  vtkSmartPointer<vtkLight> vtk = scene.AddLight(light);
  auto window = MakeWindow(300, 220);
  window->AddRenderer(scene.Renderer);
  window->Render();
  const Image mask = scene.Mask(vtk);
  ASSERT_TRUE(mask);
  const Image picture = Grab(window);
  const RayView view = ViewOf(scene.Renderer, mask);
  const double color[3] = { 1.0, 0.9, 0.8 };

  long seen[4] = { 0, 0, 0, 0 };
  long wrongMask = 0;
  long wrongColor = 0;
  for (int y = 0; y < view.Height; ++y)
  {
    for (int x = 0; x < view.Width; ++x)
    {
      Vec3 ground;
      const auto here = oracle.Look(view, x + 0.5, y + 0.5, light, ground);
      bool edge = false;
      for (int i = 0; i < 81 && !edge; ++i)
      {
        Vec3 unused;
        edge = here !=
          oracle.Look(
            view, x + 0.5 + (i % 9 - 4) / 4.0, y + 0.5 + (i / 9 - 4) / 4.0, light, unused);
      }
      if (edge || here == BoxOracle::Box)
      {
        continue;
      }
      ++seen[here];
      wrongMask += Byte(mask, x, y) != (here == BoxOracle::GroundDark ? 0 : 255);
      if (here != BoxOracle::Background)
      {
        const Vec3 place = { light[0], light[1], light[2] };
        const Vec3 toLight = normalized(light[3] == 0.0 ? place : place - ground);
        const double lit = here == BoxOracle::GroundLit ? 0.75 * toLight[2] : 0.0;
        for (int i = 0; i < 3; ++i)
        {
          const double expected = 255.0 * color[i] * (0.125 + lit);
          wrongColor += std::abs(Byte(picture, x, y, i) - expected) > 2.0;
        }
      }
    }
  }
  EXPECT_EQ(wrongMask, 0);
  EXPECT_EQ(wrongColor, 0);
  EXPECT_GT(seen[BoxOracle::Background], 1000);
  EXPECT_GT(seen[BoxOracle::GroundLit], 10000);
  EXPECT_GT(seen[BoxOracle::GroundDark], 1000);
}
}

TEST(StencilShadowPass, BoxOverPlaneAgainstRayBoxTest)
{
  CheckBox(PointLight);
  CheckBox(DirectionalLight);
}

TEST(StencilShadowPass, CurvedAndConcaveCastersAgainstRayCast)
{
  for (const RayLight& position : { PointLight, DirectionalLight })
  {
    Scene scene;
    const Mesh ring = moved(torus(24, 12), 0.8, { 0.0, 0.0, 1.3 }, 3);
    const Mesh ball = moved(sphere(10, 20), 0.4, { 1.2, 0.6, 2.2 });
    const Mesh quads = moved(quadBox(), 0.3, { -1.5, -1.0, 0.8 }, 5);
    scene.Add(ring);
    scene.Add(ball);
    scene.Add(quads);
    vtkSmartPointer<vtkLight> light = scene.AddLight(position);
    auto window = MakeWindow(320, 240);
    window->AddRenderer(scene.Renderer);
    window->Render();
    ExpectMask(scene, light, position, { { scene.GroundMesh }, { ring }, { ball }, { quads } },
      position[3] == 0.0 ? "directional" : "point");
  }
}

TEST(StencilShadowPass, OpenAndTangledMeshes)
{
  // A bowl, a sheet with a fin on it (three faces at an edge), and a ball with some faces turned
  // over: each triangle throws its shadow, whatever is next to it.
  const Mesh ball = sphere(10, 20);
  MeshBuilder bowl;
  MeshBuilder tangled;
  bowl.append(withoutNormals(ball));
  tangled.append(withoutNormals(ball));
  bowl.Cells.resize(bowl.Cells.size() / 2);
  for (std::size_t i = 0; i < tangled.Cells.size(); i += 3)
  {
    std::swap(tangled.Cells[i][0], tangled.Cells[i][1]);
  }
  MeshBuilder fin;
  for (const Vec3& point :
    std::vector<Vec3>{ { 0, -1, 0 }, { 0, 1, 0 }, { 1, 0, 0.3 }, { -1, 0, 0.2 }, { 0.3, 0, 1 } })
  {
    fin.addPoint(point);
  }
  fin.addTriangle(0, 1, 2);
  fin.addTriangle(0, 1, 3);
  fin.addTriangle(0, 1, 4);

  for (const RayLight& position : { PointLight, DirectionalLight })
  {
    Scene scene;
    std::vector<RayObject> objects = { { scene.GroundMesh } };
    objects.push_back({ moved(bowl.build(), 0.6, { 1.2, 0.0, 1.2 }, 5) });
    objects.push_back({ moved(tangled.build(), 0.5, { -1.2, 0.3, 1.0 }) });
    objects.push_back({ moved(fin.build(), 0.7, { 0.0, -1.3, 1.0 }, 9) });
    for (std::size_t i = 1; i < objects.size(); ++i)
    {
      scene.Add(objects[i].Surface);
    }
    vtkSmartPointer<vtkLight> light = scene.AddLight(position);
    auto window = MakeWindow(320, 240);
    window->AddRenderer(scene.Renderer);
    window->Render();
    ExpectMask(scene, light, position, objects, position[3] == 0.0 ? "directional" : "point");
  }
}

TEST(StencilShadowPass, DarkSideIsInItsOwnShadow)
{
  // Interpolated normals light faces that are turned away, so the mask must not.
  for (const RayLight& position : { PointLight, DirectionalLight })
  {
    Scene scene;
    const Mesh mesh = moved(sphere(10, 20), 0.8, { 0.0, 0.0, 1.2 });
    scene.Add(mesh);
    vtkSmartPointer<vtkLight> light = scene.AddLight(position);
    for (const auto& eye : std::vector<Vec3>{ { -3, -6, 5 }, { -5, -4, 1 }, { 2, -6, 3 } })
    {
      scene.Look(eye[0], eye[1], eye[2]);
      auto window = MakeWindow(320, 240);
      window->AddRenderer(scene.Renderer);
      window->Render();
      const Image mask = scene.Mask(light);
      ASSERT_TRUE(mask);
      const MaskComparison comparison = compareMask(RayScene({ { scene.GroundMesh }, { mesh } }),
        ViewOf(scene.Renderer, mask), position, mask, TurnedAwayPixels::Shadow);
      EXPECT_EQ(comparison.total().WrongBeyond, 0) << comparison.describe();
      EXPECT_GT(comparison.Objects[1].Shadowed, 500) << comparison.describe();
    }
  }
}

TEST(StencilShadowPass, SmoothShadowOfCoarseSphere)
{
  const double radius = 0.8;
  const Vec3 middle = { 0.0, 0.0, 1.2 };
  const double axes[3] = { radius, radius, radius };
  for (const RayLight& position : { PointLight, DirectionalLight })
  {
    Scene scene;
    scene.Add(moved(icosphere(1), radius, middle));
    vtkSmartPointer<vtkLight> light = scene.AddLight(position);
    auto window = MakeWindow(400, 300);
    window->AddRenderer(scene.Renderer);

    // Wrong pixels on the ground beyond one pixel of the sphere's true shadow.
    const auto count = [&]() {
      window->Render();
      const Image mask = scene.Mask(light);
      const RayView view = ViewOf(scene.Renderer, mask);
      const RayScene rays({ { scene.GroundMesh }, { moved(sphere(60, 120), radius, middle) } });
      const auto hidden = [&](double x, double y, bool& onGround) {
        const RaySample sample = rays.look(view, x, y, position);
        onGround = sample.Object == 0;
        RayLight moved = position;
        for (std::size_t i = 0; i < 3; ++i)
        {
          moved[i] -= position[3] * middle[i];
        }
        return onGround && ellipsoidHides(axes, sample.Point - middle, moved);
      };
      long wrong = 0;
      long dark = 0;
      for (int y = 0; y < view.Height; ++y)
      {
        for (int x = 0; x < view.Width; ++x)
        {
          bool onGround;
          const bool here = hidden(x + 0.5, y + 0.5, onGround);
          dark += here;
          if (!onGround || here == (Byte(mask, x, y) == 0))
          {
            continue;
          }
          bool edge = false;
          for (int i = 0; i < 81 && !edge; ++i)
          {
            bool groundThere;
            const bool there =
              hidden(x + 0.5 + (i % 9 - 4) / 4.0, y + 0.5 + (i / 9 - 4) / 4.0, groundThere);
            edge = there != here || !groundThere;
          }
          wrong += !edge;
        }
      }
      EXPECT_GT(dark, 2000);
      return wrong;
    };
    scene.Pass->SetKindToSmooth();
    EXPECT_EQ(count(), 0);
    scene.Pass->SetKindToDiscrete();
    EXPECT_GT(count(), 50);
  }
}
