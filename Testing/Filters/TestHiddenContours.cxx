// Which parts of cast contours can be seen, against rays to the light from places along them.

#include "ChainChecks.h"
#include "ContourScenes.h"
#include "Random.h"
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
  int LeftOut = 0; ///< rays that pass too close to an edge to say
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

/// Looks from places `spacing` apart along all lines, moved by a share of 1e-6 of the size to the
/// side that is lit and off the receiver, at whether a caster is between them and the light.
HiddenReport lookAlong(
  const HiddenScene& scene, vtkPolyData* contours, double spacing, double size)
{
  const Mesh casters = merged(scene.Casters);
  vtkDataArray* visible = contours->GetCellData()->GetArray("Visible");
  vtkDataArray* directions = contours->GetPointData()->GetArray("ShadowDirection");
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
      Vec3 aside;
      directions->GetTuple(ids[i], aside.data());
      const Vec3 along = to - from;
      const double length = std::sqrt(dot(along, along));
      report.Length += length;
      report.Visible += isVisible ? length : 0.0;
      for (double at = untilNext; at < length; at += spacing)
      {
        const Vec3 point =
          from + at / length * along + 1e-6 * size * (0.1 * normal - normalized(cross(normal, along)));
        const Blockers blockers = blockersTowards(casters, point.data(), scene.Light.data());
        ++report.Looks;
        if (blockers.Margin < tolerance::TooClose)
        {
          ++report.LeftOut;
        }
        else
        {
          report.Wrong += (blockers.Count == 0) != isVisible ? spacing : 0.0;
        }
      }
      const double passed = length - untilNext;
      untilNext = passed > 0.0
        ? spacing - std::fmod(passed, spacing)
        : untilNext - length;
    }
  }
  return report;
}

void expectRight(const HiddenScene& scene, int looks, double allowed, const char* name)
{
  SCOPED_TRACE(name);
  const auto contours = contoursOf(scene);
  double length = 0.0;
  double size = 0.0;
  for (const auto& receiver : scene.Receivers)
  {
    size = std::max(size, receiver->GetLength());
  }
  length = lookAlong(scene, contours, 1e30, size).Length;
  ASSERT_GT(length, 0.0);
  const HiddenReport report = lookAlong(scene, contours, length / looks, size);
  std::printf("%-24s length %.3f visible %.3f wrong %.6f of it, %d looks, %d left out, %.2f ms\n",
    name, report.Length, report.Visible / report.Length, report.Wrong / report.Length, report.Looks,
    report.LeftOut, 1e3 * fieldValue(contours, "HiddenSeconds"));
  EXPECT_LE(report.Wrong, allowed * report.Length);
  EXPECT_GT(report.Looks, looks / 2);
  EXPECT_LT(report.LeftOut, looks / 50);
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
    expectRight({ { mesh }, { ground(-1.2, 4.0) }, direction }, 2000, 1e-4, name);
    expectRight({ { mesh }, { field }, lamp }, 2000, 1e-4, name);
  }
}
