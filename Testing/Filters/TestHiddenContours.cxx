// Which parts of cast contours can be seen, against rays to the light from places along them.

#include "ChainChecks.h"
#include "ContourScenes.h"
#include "Random.h"
#include "RayCast.h"
#include "RealMeshes.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCastShadowContour.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace shadowtest;

namespace
{
struct HiddenScene
{
  std::vector<Mesh> Casters;
  std::vector<Mesh> Receivers;
  LightPosition Light;
  int Kind = vtkSmoothLightSilhouette::DISCRETE;
};

struct HiddenReport
{
  double Length = 0.0;
  double Visible = 0.0;
  double Wrong = 0.0; ///< of the length that was looked at
  int Looks = 0;
  int LeftOut = 0; ///< where two rays beside each other do not see the same
};

vtkSmartPointer<vtkPolyData> contoursOf(const HiddenScene& scene)
{
  vtkNew<vtkCastShadowContour> filter;
  for (vtkPolyData* caster : scene.Casters)
  {
    vtkNew<vtkSmoothLightSilhouette> silhouette;
    silhouette->SetInputData(caster);
    silhouette->SetKind(scene.Kind);
    silhouette->SetLightPosition(scene.Light.data());
    filter->AddSilhouetteConnection(silhouette->GetOutputPort());
    filter->AddInputData(2, caster);
  }
  for (vtkPolyData* receiver : scene.Receivers)
  {
    filter->AddInputData(1, receiver);
  }
  filter->KeepHiddenOn();
  filter->Update();
  return filter->GetOutput();
}

/// Without the ray cast's slack, at a thousandth of its distance.
bool isBlockedNearer(
  vtkPolyData* casters, const Vec3& point, const Vec3& aside, const HiddenScene& scene)
{
  const Vec3 at = point + 1e-3 * aside;
  return blockersTowards(casters, at.data(), scene.Light.data()).Count > 0;
}

/// Looks from places `spacing` apart along all lines, moved by 1e-6 of the casters' size to the side
/// that is lit, and by twice as much, at whether a caster is between them and the light. Where both
/// do not see the same, or an exact one at a thousandth of that does not, something else begins there.
HiddenReport lookAlong(
  const HiddenScene& scene, const RayScene& rays, vtkPolyData* contours, double spacing, double lift)
{
  const Mesh casters = merged(scene.Casters);
  const double aside = tolerance::BesideContour * casters->GetLength();
  vtkDataArray* visible = contours->GetCellData()->GetArray("Visible");
  vtkDataArray* normals = contours->GetPointData()->GetArray("ReceiverNormals");
  HiddenReport report;
  double untilNext = 0.5 * spacing;
  for (vtkIdType line = 0; line < contours->GetNumberOfLines(); ++line)
  {
    vtkIdType count;
    const vtkIdType* ids;
    contours->GetLines()->GetCellAtId(line, count, ids);
    const bool isVisible = visible->GetComponent(line, 0) != 0.0;
    for (vtkIdType i = 0; i + 1 < count; ++i)
    {
      Vec3 from;
      Vec3 to;
      Vec3 normal;
      contours->GetPoint(ids[i], from.data());
      contours->GetPoint(ids[i + 1], to.data());
      normals->GetTuple(ids[i], normal.data());
      const Vec3 along = to - from;
      const double length = std::sqrt(dot(along, along));
      const Vec3 right = normalized(cross(along, normal));
      report.Length += length;
      report.Visible += isVisible ? length : 0.0;
      for (; untilNext < length; untilNext += spacing)
      {
        const Vec3 place = from + untilNext / length * along;
        const Vec3 point = place + (lift * aside) * normal;
        const bool near = rays.isBlocked(point + aside * right, scene.Light);
        const bool far = rays.isBlocked(point + (2.0 * aside) * right, scene.Light);
        ++report.Looks;
        const bool isLeftOut = near != far ||
          (near == isVisible && isBlockedNearer(casters, place, aside * (lift * normal + right), scene) != near);
        report.LeftOut += isLeftOut;
        report.Wrong += !isLeftOut && near == isVisible ? spacing : 0.0;
      }
      untilNext -= length;
    }
  }
  return report;
}

/// `lift`: how far off the receiver rays begin, in steps aside: where it casts itself.
void expectRight(const char* name, const HiddenScene& scene, int looks, double allowed,
  double lift = 0.0)
{
  SCOPED_TRACE(name);
  std::vector<RayObject> objects;
  for (const Mesh& caster : scene.Casters)
  {
    objects.push_back({ caster });
  }
  const RayScene rays(objects);
  const auto contours = contoursOf(scene);
  const double length = lookAlong(scene, rays, contours, 1e30, lift).Length;
  ASSERT_GT(length, 0.0);
  const HiddenReport report = lookAlong(scene, rays, contours, length / looks, lift);
  std::printf("%-32s length %.3f visible %.3f wrong %.6f, %d looks, %d left out, %.2f + %.2f ms\n",
    name, report.Length, report.Visible / report.Length, report.Wrong / report.Length, report.Looks,
    report.LeftOut, 1e3 * fieldValue(contours, "QuerySeconds"),
    1e3 * fieldValue(contours, "HiddenSeconds"));
  EXPECT_LE(report.Wrong, allowed * report.Length);
  EXPECT_GT(report.Looks, looks / 2);
  EXPECT_LT(report.LeftOut, looks / 100);
  EXPECT_GT(report.Visible, 0.01 * report.Length);
  EXPECT_LT(report.Visible, 0.99 * report.Length);
}

Mesh dragon()
{
  return standing(cgalMesh("ChineseDragon-10kv"), 1);
}
}

TEST(HiddenContours, RealMeshesOverReceivers)
{
  Random random(51);
  const Mesh field = terrain(random, 40, 4.0, -1.1, 0.2, false);
  const LightPosition direction{ 0.3, 0.2, 1.0, 0.0 };
  const LightPosition lamp{ 1.2, -0.8, 3.5, 1.0 };
  for (const auto& [name, mesh] : { std::pair<const char*, Mesh>{ "dragon", dragon() },
         { "bunny", standing(bunny(), 1) }, { "armadillo", standing(cgalMesh("armadillo"), 1) } })
  {
    expectRight(name, { { mesh }, { ground(-1.2, 4.0) }, direction }, 50000,
      tolerance::HiddenLength);
    expectRight(name, { { mesh }, { field }, lamp }, 50000, tolerance::HiddenLength);
  }
}

// Their shadows hide each other, and one stands in the ground.
TEST(HiddenContours, ThreeCasters)
{
  Random random(52);
  const Mesh field = terrain(random, 40, 4.0, -0.7, 0.2, false);
  const std::vector<Mesh> casters = { dragon(),
    moved(standing(cgalMesh("armadillo"), 1), 0.7, { 0.9, 0.7, 0.3 }, 3),
    moved(starShaped(4, 5), 0.6, { -0.9, -0.4, -0.7 }) };
  for (const LightPosition& light :
    { LightPosition{ 0.3, 0.2, 1.0, 0.0 }, LightPosition{ 1.2, -0.8, 3.5, 1.0 } })
  {
    expectRight("three casters", { casters, { field, ground(-0.8, 4.0) }, light }, 50000,
      tolerance::HiddenLength);
  }
}

// With the light among the receivers, all around of a caster.
TEST(HiddenContours, LightAmongReceivers)
{
  const Mesh room = moved(icosphere(4), -4.0, { 0.0, 0.0, 0.0 });
  const std::vector<Mesh> casters = { dragon(), moved(dragon(), 0.8, { 0.4, 1.9, 0.7 }, 4) };
  expectRight("light among receivers", { casters, { room }, { -0.3, 1.2, 1.3, 1.0 } }, 50000,
    tolerance::HiddenLength);
}

// Casters on their own surface.
TEST(HiddenContours, CastersAsReceivers)
{
  for (const auto& [name, mesh] :
    { std::pair<const char*, Mesh>{ "own receiver, dragon", dragon() },
      { "own receiver, armadillo", standing(cgalMesh("armadillo"), 1) } })
  {
    expectRight(
      name, { { mesh }, { mesh }, { 0.3, 0.2, 1.0, 0.0 } }, 50000, tolerance::HiddenLength, 0.5);
  }
}
