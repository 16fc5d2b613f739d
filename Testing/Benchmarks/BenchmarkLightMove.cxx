// Time of a light move, silhouette with and without the volume, beside vtkPolyDataSilhouette, whose
// viewpoint moves likewise. Full filter updates with polydata out.

#include "Measure.h"
#include "RealMeshes.h"
#include "ShadowPipeline.h"

#include <vtkPolyDataNormals.h>
#include <vtkPolyDataSilhouette.h>
#include <vtkSMPTools.h>
#include <vtkVersion.h>

#include <cmath>
#include <cstdio>

namespace
{
shadowtest::LightPosition lightAt(int step)
{
  const double angle = 0.05 * step;
  return { 3.0 * std::cos(angle), 3.0 * std::sin(angle), 2.0, 1.0 };
}

void print(const char* name, const benchmarks::Figure& f, double rival)
{
  std::printf("%-32s %8.2f %8.2f %8.2f %10.1f\n", name, f.median, f.least, f.most, rival / f.median);
}
}

int main()
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(shadowtest::bunny());
  normals->SetFeatureAngle(60.0);
  normals->Update();
  vtkPolyData* mesh = normals->GetOutput();

  vtkNew<vtkPolyDataSilhouette> rival;
  rival->SetInputData(mesh);
  rival->SetDirectionToSpecifiedOrigin();
  const benchmarks::Figure other = benchmarks::measure(
    [&](int i)
    {
      rival->SetOrigin(lightAt(i).data());
      rival->Update();
    });

  std::printf("bunny, %lld triangles; VTK %s, %s with %d threads; milliseconds of 15 light moves\n",
    static_cast<long long>(mesh->GetNumberOfCells()), vtkVersion::GetVTKVersion(),
    vtkSMPTools::GetBackend(), vtkSMPTools::GetEstimatedNumberOfThreads());
  std::printf("%-32s %8s %8s %8s %10s\n", "", "median", "least", "most", "rival/this");
  print("vtkPolyDataSilhouette", other, other.median);
  const char* names[] = { "discrete", "accurate", "smooth" };
  for (const int kind : shadowtest::AllKinds)
  {
    shadowtest::ShadowPipeline pipeline(mesh, lightAt(0), kind);
    print(names[kind],
      benchmarks::measure(
        [&](int i)
        {
          pipeline.setLight(lightAt(i));
          pipeline.silhouette();
        }),
      other.median);
    print((std::string(names[kind]) + " and its volume").c_str(),
      benchmarks::measure(
        [&](int i)
        {
          pipeline.setLight(lightAt(i + 1));
          pipeline.volume();
        }),
      other.median);
  }
  return 0;
}
