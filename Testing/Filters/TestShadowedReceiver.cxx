// Receivers split along cast contours: areas against analytic ones, Lit against rays by brute force,
// and nothing of the receiver lost.

#include "AnalyticShadow.h"
#include "ChainChecks.h"
#include "ContourScenes.h"
#include "HostileMeshes.h"
#include "OutputComparison.h"
#include "Random.h"
#include "RegionOracle.h"
#include "RealMeshes.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkShadowedReceiver.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <map>

using namespace shadowtest;

namespace
{
struct Regions
{
  Regions(const std::vector<Mesh>& casters, const std::vector<Mesh>& receivers,
    const LightPosition& light, int kind = vtkSmoothLightSilhouette::DISCRETE)
  {
    for (vtkPolyData* caster : casters)
    {
      this->Silhouettes.push_back(vtkSmartPointer<vtkSmoothLightSilhouette>::New());
      this->Silhouettes.back()->SetInputData(caster);
      this->Silhouettes.back()->SetKind(kind);
      this->Silhouettes.back()->SetLightPosition(light.data());
      this->Filter->AddSilhouetteConnection(this->Silhouettes.back()->GetOutputPort());
      this->Filter->AddInputData(2, caster);
    }
    for (vtkPolyData* receiver : receivers)
    {
      this->Filter->AddInputData(1, receiver);
    }
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this->Errors);
    this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Errors);
  }

  vtkPolyData* update()
  {
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  double area(const char* name, vtkIdType receiver = 0)
  {
    return this->update()->GetFieldData()->GetArray(name)->GetComponent(receiver, 0);
  }

  std::vector<vtkSmartPointer<vtkSmoothLightSilhouette>> Silhouettes;
  vtkNew<vtkShadowedReceiver> Filter;
  vtkNew<vtkTest::ErrorObserver> Errors;
};
}

TEST(ShadowedReceiver, RandomScenes)
{
  const std::uint64_t first = fromEnvironment("SMOOTHSHADOW_TEST_SEED", 1);
  const std::uint64_t count = fromEnvironment("SMOOTHSHADOW_TEST_SCENES", 300);
  int looks = 0;
  int shadowed = 0;
  for (std::uint64_t seed = first; seed < first + count; ++seed)
  {
    const ContourScene scene = randomContourScene(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind);
    Regions regions(scene.Casters, scene.Receivers, scene.Light);
    vtkPolyData* output = regions.update();
    if (regions.Errors->GetError())
    {
      continue;
    }
    Random random(seed);
    const RegionReport report =
      checkRegions(output, scene.Receivers, scene.Casters, scene.Light, random, 2);
    EXPECT_EQ(report.Wrong, 0) << report.FirstWrong;
    EXPECT_EQ(report.Turned, 0);
    EXPECT_LE(report.AreaError, 1e-12);
    EXPECT_LE(report.BorderError, 1e-12);
    looks += report.Looks;
    shadowed += report.Shadowed;
    if (report.Wrong) printf("%d wrong of %d (unclear %d) polygons %lld\n", report.Wrong, report.Looks, report.Unclear, (long long)report.Polygons);
  }
  printf("%d looks %d shadowed\n", looks, shadowed);
}

namespace
{
double analyticSphere(const LightPosition& light, double height)
{
  const double axes[3] = { 1.0, 1.0, 1.0 };
  const Plane plane{ { 0.0, 0.0, height }, { 0.0, 0.0, 1.0 } };
  const auto contour = ellipsoidShadow(axes, light, plane)->contour(200000);
  double sum = 0;
  for (std::size_t i = 0; i < contour.size(); ++i)
  {
    const Vec3 a = shadowOn(plane, light, contour[i]);
    const Vec3 b = shadowOn(plane, light, contour[(i + 1) % contour.size()]);
    sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return std::fabs(sum);
}
}
TEST(Probe, Real)
{
  for (const std::string& name : { std::string("bunny"), std::string("armadillo"), std::string("elephant") })
  {
    Mesh caster = name == "bunny" ? standing(bunny(), 1) : standing(cgalMesh(name), 1);
    for (int kind : AllKinds)
    for (int cells : {1, 128})
    {
      const double* b = caster->GetBounds();
      const double size = caster->GetLength();
      Mesh plane = moved(ground(0, 1.0, cells), 3 * size, { 0.5*(b[0]+b[1]), 0.5*(b[2]+b[3]), b[4] - 0.3 * size });
      Regions regions({ caster }, { plane }, {0.3, 0.2, 1.0, 0.0}, kind);
      regions.Silhouettes[0]->Update();
      auto t0 = std::chrono::steady_clock::now();
      const double area = regions.area("ShadowedArea");
      double dt = std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
      printf("%s kind %d cells %d segments %lld: polygons %lld area %.9g  %.0f ms\n", name.c_str(), kind, cells, (long long)regions.Silhouettes[0]->GetOutput()->GetNumberOfPoints(), (long long)regions.update()->GetNumberOfPolys(), area / (size * size), dt*1e3);
    }
    if (caster->GetNumberOfPolys() < 200000)
    for (int kind : {0, 2})
    {
      Regions regions({ caster }, { caster }, {0.3, 0.2, 1.0, 0.0}, kind);
      regions.Silhouettes[0]->Update();
      auto t0 = std::chrono::steady_clock::now();
      const double area = regions.area("ShadowedArea");
      double dt = std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
      const double size = caster->GetLength();
      printf("  itself kind %d: polygons %lld of %lld area %.9g lit %.9g away %.9g  %.0f ms\n", kind, (long long)regions.update()->GetNumberOfPolys(), (long long)caster->GetNumberOfPolys(), area / (size * size), regions.area("LitArea")/(size*size), regions.area("TurnedAwayArea")/(size*size), dt*1e3);
    }
    fflush(stdout);
  }
}
