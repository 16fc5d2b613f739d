// Cast contours against what else finds where walls of shadow meet a receiver: CGAL's AABB tree
// over the receiver's triangles, all pairs and their segments, and vtkIntersectionPolyDataFilter
// with the walls as a mesh. One thread; silhouettes are made before. Then the three builders.

#include "Measure.h"
#include "Random.h"
#include "RealMeshes.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"

#include <vtkCastShadowContour.h>
#include <vtkCellArray.h>
#include <vtkIntersectionPolyDataFilter.h>
#include <vtkSMPTools.h>
#include <vtkTrivialProducer.h>

#ifdef SMOOTHSHADOW_HAS_CGAL
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace
{
using shadowtest::Mesh;
using shadowtest::Vec3;

constexpr int Runs = 9;
const shadowtest::LightPosition Light{ 0.3, 0.2, 1.0, 0.0 };
/// Length of the walls for those rivals that need them to end: beyond all receivers.
constexpr double WallLength = 8.0;

/// A bumpy square field of 2 cells^2 triangles.
Mesh bumpyField(int cells)
{
  shadowtest::MeshBuilder mesh;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      const double x = 2.5 * (2.0 * i / cells - 1.0);
      const double y = 2.5 * (2.0 * j / cells - 1.0);
      mesh.addPoint({ x, y, -1.3 + 0.1 * std::sin(5.0 * x) * std::cos(4.0 * y) });
    }
  }
  for (int j = 0; j < cells; ++j)
  {
    for (int i = 0; i < cells; ++i)
    {
      const int at = j * (cells + 1) + i;
      mesh.addQuad(at, at + 1, at + cells + 2, at + cells + 1);
    }
  }
  return mesh.build();
}

Mesh silhouetteOf(vtkPolyData* caster)
{
  vtkNew<vtkSmoothLightSilhouette> silhouette;
  silhouette->SetInputData(caster);
  silhouette->SetKind(vtkSmoothLightSilhouette::DISCRETE);
  silhouette->SetLightPosition(Light.data());
  silhouette->Update();
  return silhouette->GetOutput();
}

struct Wall
{
  Vec3 a;
  Vec3 b;
};

std::vector<Wall> wallsOf(vtkPolyData* silhouette)
{
  std::vector<Wall> walls;
  for (vtkIdType line = 0; line < silhouette->GetNumberOfLines(); ++line)
  {
    vtkIdType count;
    const vtkIdType* ids;
    silhouette->GetLines()->GetCellAtId(line, count, ids);
    for (vtkIdType i = 0; i + 1 < count; ++i)
    {
      Wall wall;
      silhouette->GetPoint(ids[i], wall.a.data());
      silhouette->GetPoint(ids[i + 1], wall.b.data());
      walls.push_back(wall);
    }
  }
  return walls;
}

Vec3 farEnd(const Vec3& p)
{
  using shadowtest::operator-;
  using shadowtest::operator*;
  return p - WallLength * Vec3{ Light[0], Light[1], Light[2] };
}

#ifdef SMOOTHSHADOW_HAS_CGAL
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 toPoint(const Vec3& p)
{
  return { p[0], p[1], p[2] };
}

Triangles trianglesOf(vtkPolyData* mesh)
{
  shadowtest::MeshBuilder read;
  read.append(mesh);
  Triangles triangles;
  for (const auto& cell : read.Cells)
  {
    triangles.emplace_back(toPoint(read.Points[static_cast<std::size_t>(cell[0])]),
      toPoint(read.Points[static_cast<std::size_t>(cell[1])]),
      toPoint(read.Points[static_cast<std::size_t>(cell[2])]));
  }
  return triangles;
}

/// The number of segments found.
std::size_t intersectByCgal(const Triangles& triangles, const std::vector<Wall>& walls)
{
  const Tree tree(triangles.begin(), triangles.end());
  std::vector<Triangles::const_iterator> found;
  std::size_t segments = 0;
  for (const Wall& wall : walls)
  {
    const Kernel::Point_3 a = toPoint(wall.a);
    const Kernel::Point_3 b = toPoint(wall.b);
    const Kernel::Point_3 c = toPoint(farEnd(wall.b));
    const Kernel::Point_3 d = toPoint(farEnd(wall.a));
    for (const Kernel::Triangle_3& half :
      { Kernel::Triangle_3(a, b, c), Kernel::Triangle_3(a, c, d) })
    {
      found.clear();
      tree.all_intersected_primitives(half, std::back_inserter(found));
      for (const auto& triangle : found)
      {
        const auto common = CGAL::intersection(half, *triangle);
        segments += common && boost::get<Kernel::Segment_3>(&*common) ? 1 : 0;
      }
    }
  }
  return segments;
}
#endif

Mesh meshOf(const std::vector<Wall>& walls)
{
  shadowtest::MeshBuilder mesh;
  for (const Wall& wall : walls)
  {
    const vtkIdType first = mesh.addPoint(wall.a);
    mesh.addPoint(wall.b);
    mesh.addPoint(farEnd(wall.b));
    mesh.addPoint(farEnd(wall.a));
    mesh.addQuad(first, first + 1, first + 2, first + 3);
  }
  return mesh.build();
}

struct ContourFigure
{
  benchmarks::Figure whole; ///< tree, contours and their joining, without polydata
  benchmarks::Figure hidden;
  double nodes;
  double leaves;
  vtkIdType points;
};

ContourFigure contourFigure(vtkPolyData* silhouette, vtkPolyData* caster, vtkPolyData* receiver,
  int builder)
{
  vtkNew<vtkCastShadowContour> filter;
  filter->SetInputData(0, silhouette);
  filter->SetInputData(1, receiver);
  if (caster)
  {
    filter->SetInputData(2, caster);
  }
  filter->SetBuilder(builder);
  filter->KeepHiddenOn();
  std::vector<double> whole;
  std::vector<double> hidden;
  for (int run = 0; run <= Runs; ++run)
  {
    filter->Modified();
    filter->Update();
    if (run > 0)
    {
      vtkPolyData* output = filter->GetOutput();
      whole.push_back(1e3 * (shadowtest::fieldValue(output, "BuildSeconds") +
        shadowtest::fieldValue(output, "QuerySeconds")));
      hidden.push_back(1e3 * shadowtest::fieldValue(output, "HiddenSeconds"));
    }
  }
  std::sort(whole.begin(), whole.end());
  std::sort(hidden.begin(), hidden.end());
  vtkPolyData* output = filter->GetOutput();
  return { { whole[Runs / 2], whole.front(), whole.back() },
    { hidden[Runs / 2], hidden.front(), hidden.back() },
    shadowtest::fieldValue(output, "NodesVisited"), shadowtest::fieldValue(output, "LeavesTested"),
    output->GetNumberOfPoints() };
}

void compare(const char* name, vtkPolyData* caster, bool withVtk)
{
  const Mesh silhouette = silhouetteOf(caster);
  const std::vector<Wall> walls = wallsOf(silhouette);
  std::printf("\n%s, %lld triangles, silhouette of %zu segments\n", name,
    static_cast<long long>(caster->GetNumberOfCells()), walls.size());
  std::printf("%10s %9s %17s %9s %9s %9s %9s\n", "receiver", "ms", "least-most", "hidden", "CGAL",
    "ratio", "VTK");
  for (const int cells : { 50, 100, 200, 400 })
  {
    const Mesh receiver = bumpyField(cells);
    const ContourFigure own =
      contourFigure(silhouette, caster, receiver, vtkCastShadowContour::MORTON);
    double cgal = std::nan("");
#ifdef SMOOTHSHADOW_HAS_CGAL
    const Triangles triangles = trianglesOf(receiver);
    std::size_t segments = 0;
    cgal = benchmarks::measure([&](int) { segments = intersectByCgal(triangles, walls); }, Runs)
             .median;
#endif
    double vtk = std::nan("");
    if (withVtk && cells == 50)
    {
      const Mesh wallMesh = meshOf(walls);
      vtkNew<vtkIntersectionPolyDataFilter> filter;
      filter->SetInputData(0, receiver);
      filter->SetInputData(1, wallMesh);
      filter->SplitFirstOutputOff();
      filter->SplitSecondOutputOff();
      vtk = benchmarks::measure(
        [&](int)
        {
          filter->Modified();
          filter->Update();
        },
        2)
              .median;
    }
    std::printf("%10lld %9.2f %8.2f-%8.2f %9.2f %9.1f %9.1f %9.0f\n",
      static_cast<long long>(receiver->GetNumberOfCells()), own.whole.median, own.whole.least,
      own.whole.most, own.hidden.median, cgal, cgal / own.whole.median, vtk);
  }
}

/// The builders, as Barabas' table has them: on a double ellipsoid of about as many faces.
void compareBuilders(const char* name, vtkPolyData* caster)
{
  const Mesh receiver = shadowtest::merged(
    { shadowtest::moved(shadowtest::ellipsoid(20, 28), 2.0, { -1.0, 0.0, -2.5 }),
      shadowtest::moved(shadowtest::ellipsoid(20, 28), 2.0, { 1.0, 0.0, -2.5 }) });
  const Mesh silhouette = silhouetteOf(caster);
  std::printf("%-12s %9lld %9zu %9lld", name, static_cast<long long>(caster->GetNumberOfCells()),
    wallsOf(silhouette).size(), static_cast<long long>(receiver->GetNumberOfCells()));
  for (const int builder : { vtkCastShadowContour::UNSORTED, vtkCastShadowContour::OBJECT_MEDIAN,
         vtkCastShadowContour::MORTON })
  {
    const ContourFigure figure = contourFigure(silhouette, nullptr, receiver, builder);
    std::printf(" %8.2f %9.0f", figure.whole.median, figure.nodes);
  }
  std::printf("\n");
}
}

int main()
{
  vtkSMPTools::SetBackend("Sequential");
  const Mesh dragon = shadowtest::standing(shadowtest::cgalMesh("ChineseDragon-10kv"), 1);
  const Mesh armadillo = shadowtest::standing(shadowtest::cgalMesh("armadillo"), 1);
  compare("dragon", dragon, true);
  compare("armadillo", armadillo, false);
  compare("bunny", shadowtest::standing(shadowtest::bunny(), 1), false);

  std::printf("\nBuilders: milliseconds and nodes visited\n%-12s %9s %9s %9s %18s %18s %18s\n", "",
    "triangles", "segments", "receiver", "unsorted", "median", "Morton");
  compareBuilders("armadillo", armadillo);
  compareBuilders("dragon", dragon);
  compareBuilders("lion", shadowtest::standing(shadowtest::cgalMesh("lion-head"), 1));
  compareBuilders("elephant", shadowtest::standing(shadowtest::cgalMesh("refined_elephant"), 1));
  return EXIT_SUCCESS;
}
