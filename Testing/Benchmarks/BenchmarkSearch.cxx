// What the methods of search cost and miss: time of a light move, full update with polydata out,
// and the share of the silhouette's length that is not found, against how much of the mesh is
// looked at. Then how fast brute force streams what it looks at, beside the machine's triad.

#include "Measure.h"
#include "PolylineDistance.h"
#include "RealMeshes.h"
#include "ShadowPipeline.h"

#include <vtkLoopSubdivisionFilter.h>
#include <vtkPolyDataNormals.h>
#include <vtkSMPTools.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace
{
constexpr int Moves = 50;

shadowtest::LightPosition lightAt(int step)
{
  const double angle = 0.02 * step;
  return { 4.0 * std::cos(angle), 4.0 * std::sin(angle), 3.0, 1.0 };
}

struct Method
{
  std::string Name;
  int Search;
  double Fraction;
};

std::vector<Method> methods()
{
  std::vector<Method> list = { { "brute force", vtkSmoothLightSilhouette::BRUTE_FORCE, 0.0 },
    { "hierarchy", vtkSmoothLightSilhouette::HIERARCHY, 0.0 },
    { "tracking", vtkSmoothLightSilhouette::TRACKING, 0.0 } };
  for (const double fraction : { 0.0001, 0.001, 0.01, 0.1 })
  {
    char name[32];
    std::snprintf(name, sizeof(name), "randomized %g", fraction);
    list.push_back({ name, vtkSmoothLightSilhouette::RANDOMIZED, fraction });
  }
  return list;
}

void compareMethods(const std::string& name, vtkPolyData* mesh)
{
  for (const int kind : { vtkSmoothLightSilhouette::DISCRETE, vtkSmoothLightSilhouette::SMOOTH })
  {
    std::printf("\n%s, %lld triangles, %s; %d light moves of 0.02 radians\n", name.c_str(),
      static_cast<long long>(mesh->GetNumberOfCells()),
      kind == vtkSmoothLightSilhouette::DISCRETE ? "discrete" : "smooth", Moves);
    std::printf("%-20s %9s %9s %9s %10s %10s\n", "", "median", "least", "most", "looked at",
      "missed");
    std::vector<double> whole;
    double everything = 0.0;
    for (const Method& method : methods())
    {
      vtkNew<vtkPolyData> own;
      own->ShallowCopy(mesh);
      shadowtest::ShadowPipeline pipeline(own, lightAt(0), kind);
      pipeline.Silhouette->SetSearch(method.Search);
      pipeline.Silhouette->SetSampleFraction(method.Fraction);
      double tested = 0.0;
      double missed = 0.0;
      const benchmarks::Figure time = benchmarks::measure(
        [&](int i)
        {
          pipeline.setLight(lightAt(i));
          pipeline.silhouette();
        },
        Moves);
      // The same moves again, for what the clock must not see.
      vtkNew<vtkPolyData> again;
      again->ShallowCopy(mesh);
      pipeline.Silhouette->SetInputData(again);
      for (int i = 0; i <= Moves; ++i)
      {
        pipeline.setLight(lightAt(i));
        const double length = shadowtest::lengthOfLines(pipeline.silhouette());
        tested += shadowtest::fieldValue(pipeline.silhouette(), "EdgesTested");
        if (method.Search == vtkSmoothLightSilhouette::BRUTE_FORCE)
        {
          whole.push_back(length);
          everything += shadowtest::fieldValue(pipeline.silhouette(), "EdgesTested");
        }
        missed += 1.0 - length / whole[static_cast<std::size_t>(i)];
      }
      std::printf("%-20s %9.3f %9.3f %9.3f %9.1f%% %9.2f%%\n", method.Name.c_str(), time.median,
        time.least, time.most, 100.0 * tested / everything, 100.0 * missed / (Moves + 1));
    }
  }
}

/// Bytes a second of a[i] = b[i] + c * d[i] over arrays far larger than the caches.
double triad()
{
  const std::size_t count = std::size_t(1) << 25;
  std::vector<double> a(count, 0.0);
  std::vector<double> b(count, 1.0);
  std::vector<double> d(count, 2.0);
  const benchmarks::Figure time = benchmarks::measure(
    [&](int i)
    {
      const double c = 0.5 * i;
      vtkSMPTools::For(0, static_cast<vtkIdType>(count), 1 << 16,
        [&](vtkIdType begin, vtkIdType end)
        {
          for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
          {
            a[k] = b[k] + c * d[k];
          }
        });
    },
    9);
  return 3.0 * sizeof(double) * static_cast<double>(count) / (1e-3 * time.median);
}

/// How fast brute force reads what the hierarchy does not.
void streamBruteForce()
{
  const double machine = triad();
  std::printf("\nbrute force as a stream: triad %.1f GB/s on the same threads\n", 1e-9 * machine);
  for (int level = 2; level <= 3; ++level)
  {
    vtkNew<vtkLoopSubdivisionFilter> loop;
    loop->SetInputData(shadowtest::bunny());
    loop->SetNumberOfSubdivisions(level);
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputConnection(loop->GetOutputPort());
    normals->SplittingOff();
    normals->Update();
    for (const int kind :
      { vtkSmoothLightSilhouette::DISCRETE, vtkSmoothLightSilhouette::ACCURATE })
    {
      const bool faces = kind == vtkSmoothLightSilhouette::DISCRETE;
      shadowtest::ShadowPipeline pipeline(normals->GetOutput(), lightAt(0), kind);
      const auto timeOf = [&](int search)
      {
        pipeline.Silhouette->SetSearch(search);
        return benchmarks::measure(
          [&](int i)
          {
            pipeline.setLight(lightAt(i));
            pipeline.silhouette();
          },
          15).median;
      };
      const double all = timeOf(vtkSmoothLightSilhouette::BRUTE_FORCE);
      const double tree = timeOf(vtkSmoothLightSilhouette::HIERARCHY);
      // Eight bytes a field: two an edge of faces, three a triangle of corners. What the hierarchy
      // leaves out is all that the two differ in.
      const double bytes = static_cast<double>(normals->GetOutput()->GetNumberOfCells()) *
        (faces ? 1.5 * 2 : 3.0) * 8.0;
      pipeline.Silhouette->SetSearch(vtkSmoothLightSilhouette::HIERARCHY);
      const double share = shadowtest::fieldValue(pipeline.silhouette(), "EdgesTested") /
        ((faces ? 1.5 : 1.0) * static_cast<double>(normals->GetOutput()->GetNumberOfCells()));
      const double rate = bytes * (1.0 - share) / (1e-3 * (all - tree));
      std::printf(
        "%9lld triangles, %-6s %7.3f ms, with the hierarchy %7.3f: %5.1f GB/s, %3.0f%% of "
        "the triad\n",
        static_cast<long long>(normals->GetOutput()->GetNumberOfCells()),
        faces ? "faces" : "corners", all, tree, 1e-9 * rate, 100.0 * rate / machine);
    }
  }
}
}

int main()
{
  std::printf("VTK with %s and %d threads; milliseconds\n", vtkSMPTools::GetBackend(),
    vtkSMPTools::GetEstimatedNumberOfThreads());
  compareMethods("bunny", shadowtest::standing(shadowtest::bunny(), 1));
  compareMethods("armadillo", shadowtest::standing(shadowtest::cgalMesh("armadillo"), 1));
  compareMethods("elephant", shadowtest::standing(shadowtest::cgalMesh("refined_elephant"), 1));
  streamBruteForce();
  return 0;
}
