// Receivers split along cast contours: areas against analytic ones, Lit against rays by brute force,
// and nothing of the receiver lost.

#include "ChainChecks.h"
#include "ContourScenes.h"
#include "HostileMeshes.h"
#include "OutputComparison.h"
#include "Random.h"
#include "RegionOracle.h"
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
