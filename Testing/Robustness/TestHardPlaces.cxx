// The same scenes at other sizes, in other places and turned: the same shadows.

#include "ChainChecks.h"
#include "ExactShadow.h"
#include "HostileMeshes.h"
#include "SegmentChain.h"
#include "ShadowScene.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPoints.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace shadowtest;

/// x -> Scale * rotation(x) + Shift, as of moved.
struct Placement
{
  double Scale = 1.0;
  Vec3 Shift{ 0.0, 0.0, 0.0 };
  std::uint64_t RotationSeed = 0;

  Mesh of(vtkPolyData* mesh) const
  {
    return moved(mesh, this->Scale, this->Shift, this->RotationSeed);
  }
  LightPosition of(const LightPosition& light) const
  {
    return movedLight(light.data(), this->Scale, this->Shift, this->RotationSeed);
  }
  Vec3 of(const Vec3& point) const
  {
    const LightPosition moved = this->of(LightPosition{ point[0], point[1], point[2], 1.0 });
    return { moved[0], moved[1], moved[2] };
  }
  Mesh ofLines(vtkPolyData* lines) const
  {
    Mesh copy = Mesh::New();
    copy->DeepCopy(lines);
    for (vtkIdType i = 0; i < copy->GetNumberOfPoints(); ++i)
    {
      Vec3 point;
      lines->GetPoint(i, point.data());
      copy->GetPoints()->SetPoint(i, this->of(point).data());
    }
    return copy;
  }
};

/// Lights in no special direction: what is lit is no matter of rounding.
const LightPosition Lights[] = { { 1.1, -1.7, 3.1, 1.0 }, { 0.31, 0.23, 1.0, 0.0 } };

std::vector<std::pair<std::string, Mesh>> placedMeshes()
{
  return { { "ball", sphere(8, 14, 3) }, { "torus", torus(18, 9, 3) }, { "cylinder", cylinder(11) },
    { "box", box() }, { "star without normals", withoutNormals(starShaped(2, 5)) },
    { "torn", opened(icosphere(2, 3), 0.2, 7) },
    { "turned over", misoriented(withoutNormals(torus(12, 7, 3)), 0.3, 7) },
    { "fin", moved(fin(5), 1.0, { 0.0, 0.0, 0.0 }, 2) } };
}

/// Of a turned mesh the bounds are others, which a relative tolerance of subdivision goes by.
void subdivideTo(ShadowPipeline& pipeline, double length)
{
  pipeline.Silhouette->SetToleranceModeToWorld();
  pipeline.Silhouette->SetTolerance(length);
}

/// Expects silhouettes and windings of a scene and of the same scene put elsewhere to be the same.
/// The tolerance is relative to the scene's size.
void expectSameElsewhere(
  vtkPolyData* mesh, const LightPosition& light, const Placement& placement, double tolerance)
{
  const double size = mesh->GetLength();
  for (const int kind : AllKinds)
  {
    SCOPED_TRACE("silhouette kind " + std::to_string(kind));
    ShadowPipeline here(mesh, light, kind);
    ShadowPipeline there(placement.of(mesh), placement.of(light), kind);
    if (placement.RotationSeed != 0)
    {
      subdivideTo(here, 1e-4 * size);
      subdivideTo(there, placement.Scale * 1e-4 * size);
    }
    const LoopReport report = checkLoops(there.silhouette());
    EXPECT_TRUE(report.good()) << report;
    EXPECT_EQ(there.silhouette()->GetNumberOfPoints(), here.silhouette()->GetNumberOfPoints());
    const ChainDifference difference = compareChains(chainOf(placement.ofLines(here.silhouette())),
      chainOf(there.silhouette()), tolerance * placement.Scale * size);
    EXPECT_TRUE(difference.none()) << difference.Message;
    EXPECT_GT(difference.Expected, 3u);
    EXPECT_NEAR(fieldValue(there.silhouette(), "MaximumDeviation"),
      placement.Scale * fieldValue(here.silhouette(), "MaximumDeviation"),
      tolerance * placement.Scale * size);

    EXPECT_EQ(openEdges(there.volume()), 0);
    EXPECT_EQ(there.volume()->GetNumberOfCells(), here.volume()->GetNumberOfCells());
    int around = 0;
    for (int sample = 0; sample < 100; ++sample)
    {
      const Vec3 point = samplePoint(mesh, sample);
      const double winding = windingNumber(here.volume(), point.data());
      EXPECT_NEAR(
        windingNumber(there.volume(), placement.of(point).data()), winding, tolerance::Winding);
      around += std::fabs(winding) > 0.5;
    }
    EXPECT_GT(around, 1);
  }
}

void expectSameElsewhere(const Placement& placement, double tolerance)
{
  for (const auto& [name, mesh] : placedMeshes())
  {
    for (const LightPosition& light : Lights)
    {
      SCOPED_TRACE(name + (light[3] == 0.0 ? ", directional" : ", point"));
      expectSameElsewhere(mesh, light, placement, tolerance);
    }
  }
}

/// The pass's scene, put elsewhere, and its mask against the ray cast.
void expectMaskElsewhere(const Placement& placement)
{
  for (const RayLight& position : { PointLight, DirectionalLight })
  {
    SCOPED_TRACE(position[3] == 0.0 ? "directional" : "point");
    Scene scene;
    scene.Renderer->RemoveAllViewProps();
    std::vector<RayObject> objects;
    for (const Mesh& mesh : { scene.GroundMesh, moved(torus(18, 9), 0.7, { -0.4, 0.2, 1.2 }, 4),
           moved(opened(sphere(8, 14), 0.3, 11), 0.5, { 1.3, -0.5, 0.9 }) })
    {
      objects.push_back({ placement.of(mesh) });
      // Otherwise VTK itself draws with the precision that floats have there.
      vtkActor* actor = scene.Add(objects.back().Surface);
      vtkOpenGLPolyDataMapper::SafeDownCast(actor->GetMapper())
        ->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE);
    }
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->SetPosition(placement.of(Vec3{ -3.0, -6.0, 5.0 }).data());
    camera->SetFocalPoint(placement.of(Vec3{ 0.0, 0.0, 0.5 }).data());
    camera->SetClippingRange(0.5 * placement.Scale, 40.0 * placement.Scale);
    const RayLight there = placement.of(position);
    const vtkSmartPointer<vtkLight> light = scene.AddLight(there);
    auto window = MakeWindow(240, 180);
    window->AddRenderer(scene.Renderer);
    window->Render();
    ExpectMask(scene, light, there, objects, "");
  }
}
}

// Which rounds nothing: the same to the last bit.
TEST(HardPlaces, ScaledByPowersOfTwo)
{
  for (const int exponent : { -30, 30 })
  {
    const Placement placement{ std::ldexp(1.0, exponent) };
    for (const auto& [name, mesh] : placedMeshes())
    {
      for (const LightPosition& light : Lights)
      {
        for (const int kind : AllKinds)
        {
          SCOPED_TRACE(name + ", exponent " + std::to_string(exponent) + ", silhouette kind " +
            std::to_string(kind));
          ShadowPipeline here(mesh, light, kind);
          ShadowPipeline there(placement.of(mesh), placement.of(light), kind);
          const Mesh expected = placement.ofLines(here.silhouette());
          vtkPolyData* actual = there.silhouette();
          ASSERT_GT(expected->GetNumberOfPoints(), 3);
          ASSERT_EQ(actual->GetNumberOfPoints(), expected->GetNumberOfPoints());
          for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
          {
            Vec3 point;
            expected->GetPoint(i, point.data());
            Vec3 found;
            actual->GetPoint(i, found.data());
            ASSERT_EQ(found, point);
          }
        }
      }
    }
  }
}

TEST(HardPlaces, ScaledByPowersOfTen)
{
  for (const int exponent : { -9, -6, -3, 3, 6, 9 })
  {
    SCOPED_TRACE("1e" + std::to_string(exponent));
    const Placement placement{ std::pow(10.0, exponent) };
    expectSameElsewhere(placement, tolerance::SamePoint);
    expectMaskElsewhere(placement);
  }
}

// Coordinates lose digits there, and with them the mesh changes. So it is held against what it has
// become, moved back, which is exact.
TEST(HardPlaces, MovedByTenMillionSizes)
{
  for (const auto& [name, original] : placedMeshes())
  {
    const double far = 1e7 * original->GetLength();
    const Placement there{ 1.0, { 0.9 * far, -0.8 * far, 0.7 * far } };
    const Placement back{ 1.0, { -0.9 * far, 0.8 * far, -0.7 * far } };
    const Mesh mesh = back.of(there.of(original));
    for (const LightPosition& light : Lights)
    {
      SCOPED_TRACE(name + (light[3] == 0.0 ? ", directional" : ", point"));
      expectSameElsewhere(mesh, back.of(there.of(light)), there, tolerance::FarPlace);
    }
  }
  const Mesh ring = torus(18, 9);
  const Placement there{ 1.0, { 2.5e7, -3e7, 2e7 } };
  for (const LightPosition& light : Lights)
  {
    const PointTotals points =
      expectExactWinding(there.of(ring), there.of(light), { there.of(ring), nullptr });
    EXPECT_GT(points.InShadow, 30);
    EXPECT_GT(points.Lit, 100);
  }
  expectMaskElsewhere(there);
}

TEST(HardPlaces, Turned)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    SCOPED_TRACE(seed);
    expectSameElsewhere({ 1.0, { 0.0, 0.0, 0.0 }, seed }, tolerance::SamePoint);
  }
}

TEST(HardPlaces, ScaledMovedAndTurned)
{
  for (std::uint64_t seed = 20; seed <= 22; ++seed)
  {
    SCOPED_TRACE(seed);
    const double scale = std::pow(10.0, 3.0 * static_cast<double>(seed % 5) - 3.0);
    expectSameElsewhere({ scale, { 2.0 * scale, -3.0 * scale, scale }, seed }, tolerance::Moved);
  }
}
