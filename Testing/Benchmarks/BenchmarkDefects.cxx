// What each defect of a mesh costs: triangles of the shadow volume, the update when the light
// moves, and a frame. A closed mesh has dark caps; with one hole in it both sides of all of it
// cast.

#include "BenchmarkWindow.h"
#include "HostileMeshes.h"
#include "Measure.h"
#include "Random.h"
#include "RealMeshes.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkStencilShadowPass.h>

#include <cmath>
#include <cstdio>

namespace
{
using namespace shadowtest;

constexpr int Size = 768;

LightPosition lightAt(int step)
{
  const double angle = 0.6 + 0.05 * step;
  return { 2.0 * std::cos(angle), 2.0 * std::sin(angle), 4.0, 0.0 };
}

/// Without its last triangle.
Mesh withOneHole(vtkPolyData* mesh)
{
  MeshBuilder builder;
  builder.append(mesh);
  builder.Cells.pop_back();
  return builder.build();
}

/// Fins on the first edges of `count` triangles: three faces there.
Mesh finned(vtkPolyData* mesh, int count)
{
  MeshBuilder builder;
  builder.append(mesh);
  for (int i = 0; i < count; ++i)
  {
    const std::vector<vtkIdType> cell = builder.Cells[static_cast<std::size_t>(97 * i)];
    const auto at = [&](std::size_t k)
    { return builder.Points[static_cast<std::size_t>(cell[k])]; };
    const Vec3 out = normalized(cross(at(1) - at(0), at(2) - at(0)));
    const Vec3 tip = 0.5 * (at(0) + at(1)) + 0.01 * out;
    builder.addTriangle(cell[0], cell[1], builder.addPoint(tip));
  }
  return builder.build();
}

struct Frame
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkLight> Light;
  vtkNew<vtkStencilShadowPass> Pass;
  vtkSmartPointer<vtkRenderWindow> Window;

  explicit Frame(vtkPolyData* mesh)
  {
    double bounds[6];
    mesh->GetBounds(bounds);
    for (const Mesh& shown : { Mesh(mesh), ground(bounds[4], 4.0, 8) })
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(shown);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      this->Renderer->AddActor(actor);
    }
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->AddLight(this->Light);
    this->Renderer->SetPass(this->Pass);
    this->Pass->SetKindToDiscrete();
    benchmarks::lookAtTheGround(this->Renderer);
    this->Window = benchmarks::openWindow(Size, this->Renderer);
  }

  double milliseconds()
  {
    return benchmarks::measure(
      [&](int i)
      {
        const LightPosition light = lightAt(i);
        this->Light->SetPosition(light[0], light[1], light[2]);
        this->Window->Render();
        static_cast<vtkOpenGLRenderWindow*>(this->Window.Get())->WaitForCompletion();
      },
      9)
      .median;
  }
};

vtkIdType countPart(vtkPolyData* volume, int part)
{
  vtkDataArray* parts = volume->GetCellData()->GetArray("Part");
  vtkDataArray* multiplicities = volume->GetCellData()->GetArray("Multiplicity");
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < parts->GetNumberOfTuples(); ++i)
  {
    count += parts->GetComponent(i, 0) == part
      ? static_cast<vtkIdType>(multiplicities->GetComponent(i, 0))
      : 0;
  }
  return count;
}

void report(const char* name, const Mesh& mesh)
{
  ShadowPipeline pipeline(mesh, lightAt(0), vtkSmoothLightSilhouette::DISCRETE);
  vtkPolyData* volume = pipeline.volume();
  const vtkIdType caps = countPart(volume, vtkShadowVolumeExtruder::CAP);
  const vtkIdType walls = countPart(volume, vtkShadowVolumeExtruder::WALL);
  const auto depth = static_cast<int>(fieldValue(volume, "GreatestDepth"));
  const double silhouette = benchmarks::measure(
    [&](int i)
    {
      pipeline.setLight(lightAt(i + 1));
      pipeline.silhouette();
    })
                              .median;
  const double both = benchmarks::measure(
    [&](int i)
    {
      pipeline.setLight(lightAt(i + 1));
      pipeline.volume();
    })
                        .median;
  std::printf("%-34s %9lld %9lld %9lld %6d %9.2f %9.2f %9.1f\n", name,
    static_cast<long long>(mesh->GetNumberOfPolys()), static_cast<long long>(caps),
    static_cast<long long>(walls), depth, silhouette, both, Frame(mesh).milliseconds());
  std::fflush(stdout);
}
}

int main()
{
  const Mesh mesh = standing(bunny(), 1);
  std::printf("discrete shadows of the bunny under a directional light, %d x %d; triangles counted with "
              "their\nmultiplicity; milliseconds of a light's move, medians of 15 (frames 9)\n"
              "%-34s %9s %9s %9s %6s %9s %9s %9s\n",
    Size, Size, "", "triangles", "caps", "walls", "depth", "contour", "+ volume", "frame");
  report("closed: dark caps", mesh);
  report("turned inside out: dark caps", misoriented(mesh, 1.0, 1));
  report("1% without area", degenerated(mesh, 0.01, 5));
  report("one triangle missing", withOneHole(mesh));
  report("1% missing", opened(mesh, 0.01, 2));
  report("30% missing", opened(mesh, 0.3, 2));
  report("1% turned over", misoriented(mesh, 0.01, 3));
  report("30% turned over", misoriented(mesh, 0.3, 3));
  report("1% given twice", duplicated(mesh, 0.01, 4));
  report("100 fins", finned(mesh, 100));
  return 0;
}
