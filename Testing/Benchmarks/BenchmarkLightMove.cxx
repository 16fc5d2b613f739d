// Time of a light move, silhouette with and without the volume, beside what VTK has: for the
// discrete silhouette vtkPolyDataSilhouette, whose viewpoint moves likewise, for the accurate one
// the scalar n . l, vtkContourFilter and vtkStripper. Full filter updates with polydata out.
//
// BenchmarkLightMove [n ...]: the bunny subdivided n times after Loop, each time into four; 0 and 2
// without arguments.

#include "Measure.h"
#include "ShadowPipeline.h"
#include "SubdividedBunny.h"

#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkPolyDataSilhouette.h>
#include <vtkSMPTools.h>
#include <vtkStripper.h>
#include <vtkVersion.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace
{
using benchmarks::Figure;

shadowtest::LightPosition lightAt(int step)
{
  const double angle = 0.05 * step;
  return { 3.0 * std::cos(angle), 3.0 * std::sin(angle), 2.0, 1.0 };
}

vtkSmartPointer<vtkPolyData> bunnyWithNormals(int subdivisions)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(benchmarks::subdividedBunny(subdivisions));
  normals->SetFeatureAngle(60.0);
  normals->Update();
  return normals->GetOutput();
}

/// A mesh that no filter has seen yet.
vtkNew<vtkPolyData> unseen(vtkPolyData* mesh)
{
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(mesh);
  return copy;
}

void print(const std::string& name, const Figure& f, double rival)
{
  std::printf("%-36s %9.3f %9.3f %9.3f %10.1f\n", name.c_str(), f.median, f.least, f.most,
    rival / f.median);
}

/// The field at the points, which the contour filter wants as scalars.
void setScalars(vtkPolyData* mesh, vtkDoubleArray* field, const shadowtest::LightPosition& light)
{
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double n[3];
    mesh->GetPoint(i, p);
    normals->GetTuple(i, n);
    field->SetValue(i,
      n[0] * (light[0] - light[3] * p[0]) + n[1] * (light[1] - light[3] * p[1]) +
        n[2] * (light[2] - light[3] * p[2]));
  }
  field->Modified();
}

struct Rivals
{
  double discrete;
  double accurate;
};

Rivals measureRivals(vtkPolyData* given, int runs)
{
  const auto mesh = unseen(given);
  vtkNew<vtkPolyDataSilhouette> silhouette;
  silhouette->SetInputData(mesh);
  silhouette->SetDirectionToSpecifiedOrigin();
  const Figure discrete = benchmarks::measure(
    [&](int i)
    {
      silhouette->SetOrigin(lightAt(i).data());
      silhouette->Update();
    },
    runs);
  print("vtkPolyDataSilhouette", discrete, discrete.median);

  vtkNew<vtkDoubleArray> field;
  field->SetNumberOfTuples(mesh->GetNumberOfPoints());
  mesh->GetPointData()->SetScalars(field);
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(mesh);
  contour->SetValue(0, 0.0);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(contour->GetOutputPort());
  const Figure accurate = benchmarks::measure(
    [&](int i)
    {
      setScalars(mesh, field, lightAt(i));
      mesh->Modified();
      stripper->Update();
    },
    runs);
  print("n.l, vtkContourFilter, vtkStripper", accurate, accurate.median);
  return { discrete.median, accurate.median };
}

void measureMoves(vtkPolyData* given, const Rivals& rivals, int runs)
{
  const char* names[] = { "discrete", "accurate", "smooth" };
  for (const int kind : shadowtest::AllKinds)
  {
    const double rival =
      kind == vtkSmoothLightSilhouette::DISCRETE ? rivals.discrete : rivals.accurate;
    const std::string name = names[kind];
    const auto mesh = unseen(given);
    shadowtest::ShadowPipeline pipeline(mesh, lightAt(0), kind);
    const auto move = [&](int i)
    {
      pipeline.setLight(lightAt(i));
      pipeline.silhouette();
    };
    pipeline.Silhouette->SetSearch(vtkSmoothLightSilhouette::BRUTE_FORCE);
    print(name + ", brute force", benchmarks::measure(move, runs), rival);
    pipeline.Silhouette->SetSearch(vtkSmoothLightSilhouette::HIERARCHY);
    print(name + ", hierarchy", benchmarks::measure(move, runs), rival);
    std::printf("    %.2f%% looked at; %lld points\n",
      100.0 * shadowtest::fieldValue(pipeline.silhouette(), "EdgesTested") /
        ((kind == vtkSmoothLightSilhouette::DISCRETE ? 1.5 : 1.0) *
          static_cast<double>(mesh->GetNumberOfCells())),
      static_cast<long long>(pipeline.silhouette()->GetNumberOfPoints()));
    for (const bool strips : { false, true })
    {
      pipeline.Extruder->SetWallStrips(strips);
      print(name + (strips ? " and its volume, strips" : " and its volume"),
        benchmarks::measure(
          [&](int i)
          {
            pipeline.setLight(lightAt(i + 1));
            pipeline.volume();
          },
          runs),
        rival);
    }
  }
}

/// With what is kept for faces and for corners, and all curves' corrections.
void measureMemory(vtkPolyData* given)
{
  const auto mesh = unseen(given);
  shadowtest::ShadowPipeline pipeline(mesh, lightAt(0), vtkSmoothLightSilhouette::DISCRETE);
  pipeline.silhouette();
  pipeline.Silhouette->SetKindToSmooth();
  pipeline.silhouette();
  std::printf("%-36s %9.1f bytes a triangle\n", "kept for both kinds of field",
    1024.0 * static_cast<double>(pipeline.Silhouette->GetKeptMemorySize()) /
      static_cast<double>(mesh->GetNumberOfCells()));
}

/// First updates: what a mesh costs that is new each time.
void measureFirst(vtkPolyData* given)
{
  const int runs = 9;
  const Figure rival = benchmarks::measure(
    [&](int)
    {
      vtkNew<vtkPolyDataSilhouette> silhouette;
      silhouette->SetDirectionToSpecifiedOrigin();
      silhouette->SetOrigin(lightAt(0).data());
      const auto mesh = unseen(given);
      silhouette->SetInputData(mesh);
      silhouette->Update();
    },
    runs);
  print("first: vtkPolyDataSilhouette", rival, rival.median);
  for (const int kind : { vtkSmoothLightSilhouette::DISCRETE, vtkSmoothLightSilhouette::SMOOTH })
  {
    print(kind == vtkSmoothLightSilhouette::DISCRETE ? "first: discrete" : "first: smooth",
      benchmarks::measure(
        [&](int)
        {
          const auto mesh = unseen(given);
          shadowtest::ShadowPipeline pipeline(mesh, lightAt(0), kind);
          pipeline.silhouette();
        },
        runs),
      rival.median);
  }
}
}

int main(int argc, char* argv[])
{
  std::vector<int> levels;
  for (int i = 1; i < argc; ++i)
  {
    levels.push_back(std::atoi(argv[i]));
  }
  if (levels.empty())
  {
    levels = { 0, 2 };
  }
  std::string load = "unknown";
  std::getline(std::ifstream("/proc/loadavg"), load);
  std::printf("VTK %s, %s with %d threads; load %s\n", vtkVersion::GetVTKVersion(),
    vtkSMPTools::GetBackend(), vtkSMPTools::GetEstimatedNumberOfThreads(), load.c_str());
  for (const int level : levels)
  {
    const auto mesh = bunnyWithNormals(level);
    const int runs = level > 1 ? 9 : 25;
    std::printf("\nbunny, %lld triangles; milliseconds of %d light moves\n",
      static_cast<long long>(mesh->GetNumberOfCells()), runs);
    std::printf("%-36s %9s %9s %9s %10s\n", "", "median", "least", "most", "rival/this");
    const Rivals rivals = measureRivals(mesh, runs);
    measureMoves(mesh, rivals, runs);
    measureMemory(mesh);
    measureFirst(mesh);
  }
  return 0;
}
