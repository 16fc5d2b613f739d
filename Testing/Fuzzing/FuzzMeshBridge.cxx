// Any bytes as a mesh and lights through vtkSmoothLightSilhouette: nothing crashes, what comes out
// is closed, and what is said of the mesh is true.

#include "ChainChecks.h"
#include "FuzzCheck.h"
#include "FuzzInput.h"
#include "ShadowPipeline.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
using namespace shadowtest;

bool isLight(const LightPosition& light)
{
  return std::all_of(light.begin(), light.end(), [](double x) { return std::isfinite(x); }) &&
    std::any_of(light.begin(), light.end(), [](double x) { return x != 0.0; });
}

bool isUsable(vtkPolyData* mesh, vtkIdType id)
{
  double p[3];
  if (id < 0 || id >= mesh->GetNumberOfPoints())
  {
    return false;
  }
  mesh->GetPoint(id, p);
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

// The greatest size whose areas are sure to stay within doubles.
constexpr double GreatestReach = 1e80;

struct CellCounts
{
  vtkIdType NonFinite = 0;
  vtkIdType Short = 0;
  vtkIdType Triangles = 0; ///< at most
  double Reach = 0.0;      ///< greatest coordinate of their points
};

double reachOf(vtkPolyData* mesh, vtkIdType id)
{
  double p[3];
  mesh->GetPoint(id, p);
  return std::max({ std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2]) });
}

CellCounts countCells(vtkPolyData* mesh)
{
  CellCounts counts;
  for (vtkCellArray* cells : { mesh->GetPolys(), mesh->GetStrips() })
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCellAtId(cell, size, ids);
      if (size < 3)
      {
        ++counts.Short;
      }
      else if (!std::all_of(ids, ids + size, [&](vtkIdType id) { return isUsable(mesh, id); }))
      {
        ++counts.NonFinite;
      }
      else
      {
        counts.Triangles += size - 2;
        std::for_each(ids, ids + size,
          [&](vtkIdType id) { counts.Reach = std::max(counts.Reach, reachOf(mesh, id)); });
      }
    }
  }
  return counts;
}

void requireBetween(vtkPolyData* silhouette, const char* name, double low, double high)
{
  const double value = fieldValue(silhouette, name);
  std::ostringstream message;
  message << name << " is " << value << ", not from " << low << " to " << high;
  require(value >= low && value <= high, message.str());
}

void checkFields(vtkPolyData* silhouette, const CellCounts& counts, int search)
{
  const auto nonFinite = static_cast<double>(counts.NonFinite);
  const auto triangles = static_cast<double>(counts.Triangles);
  const auto tooShort = static_cast<double>(counts.Short);
  requireBetween(silhouette, "NonFiniteCells", nonFinite, nonFinite);
  requireBetween(silhouette, "DegenerateCells", tooShort, tooShort + triangles);
  requireBetween(silhouette, "BoundaryEdges", 0.0, 3.0 * triangles);
  requireBetween(silhouette, "NonManifoldEdges", 0.0, triangles);
  requireBetween(silhouette, "InconsistentEdges", 0.0, 1.5 * triangles);
  requireBetween(silhouette, "EstimatedNormals", 0.0, 3.0 * triangles);
  requireBetween(
    silhouette, "FallbackNormals", 0.0, fieldValue(silhouette, "EstimatedNormals"));
  const bool complete = search <= vtkSmoothLightSilhouette::HIERARCHY;
  requireBetween(silhouette, "SearchComplete", complete ? 1.0 : 0.0, 1.0);
}

void checkSilhouette(vtkPolyData* silhouette, double reach)
{
  const LoopReport report = checkLoops(silhouette);
  std::ostringstream message;
  message << "loops: " << report;
  require(report.OpenLoops == 0 && report.ShortLoops == 0 && report.UnbalancedPoints == 0 &&
      report.BadMultiplicities == 0,
    message.str());
  require(report.NonFinitePoints == 0 || reach > GreatestReach, message.str());
  vtkDataArray* kinds = silhouette->GetCellData()->GetArray("Kind");
  for (vtkIdType cell = 0; cell < report.Loops; ++cell)
  {
    require(kinds->GetTuple1(cell) >= 0.0 && kinds->GetTuple1(cell) <= 3.0, "Kind");
  }
}

constexpr double Tolerances[] = { 1e-4, 1e-3, 1e-2, 0.3 };

void draw(FuzzInput& input, vtkSmoothLightSilhouette* silhouette)
{
  constexpr double angles[] = { 60.0, 0.0, 180.0, 30.0 };
  silhouette->SetKind(static_cast<int>(input.below(3)));
  silhouette->SetSearch(static_cast<int>(input.below(5)));
  silhouette->SetTolerance(Tolerances[input.below(4)]);
  silhouette->SetFeatureAngle(angles[input.below(4)]);
  silhouette->SetMergePoints(input.below(4) != 3);
  silhouette->SetSampleFraction(input.below(5) / 4.0);
  silhouette->SetSeed(static_cast<int>(input.below(4)));
}

// Tolerances in world units are shares of the mesh: what is far below would be a million points. So
// would shadows be that meet a receiver at a grazing angle. Bounds far around the mesh are met at
// none; others are for the smallest meshes.
void drawToleranceMode(
  FuzzInput& input, const CellCounts& counts, vtkSmoothLightSilhouette* silhouette)
{
  const int mode = static_cast<int>(input.below(4)) - 1;
  if (mode <= vtkSmoothLightSilhouette::RELATIVE || counts.Reach > GreatestReach)
  {
    return;
  }
  const double unit = counts.Reach > 1e-9 ? counts.Reach : 1.0;
  silhouette->SetToleranceMode(mode);
  silhouette->SetTolerance(unit * silhouette->GetTolerance());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  if (counts.Triangles > 2)
  {
    const double far = 16.0 * unit;
    points->InsertNextPoint(-far, -far, -far);
    points->InsertNextPoint(far, far, far);
  }
  const unsigned count = counts.Triangles > 2 ? 0 : 1 + input.below(3);
  for (unsigned i = 0; i < count; ++i)
  {
    const Vec3 point = unit * input.vector(Numbers::Grid);
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkPolyData> receiver;
  receiver->SetPoints(points);
  silhouette->SetInputData(1, receiver);
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  silenceVTK();
  FuzzInput input(bytes, size);
  vtkNew<vtkSmoothLightSilhouette> silhouette;
  ErrorWatch errors(silhouette);
  draw(input, silhouette);
  const unsigned lights = 1 + input.below(3);
  const Mesh mesh = hostileMesh(input);
  const CellCounts counts = countCells(mesh);
  silhouette->SetInputData(mesh);
  drawToleranceMode(input, counts, silhouette);
  // Further lights use what is kept of the mesh and of the last silhouette.
  for (unsigned i = 0; i < lights; ++i)
  {
    LightPosition light = input.light(Numbers::Hostile);
    silhouette->SetLightPosition(light.data());
    silhouette->Modified(); // the same bad light again is an error again
    silhouette->Update();
    const std::string error = errors.take();
    if (isLight(light))
    {
      require(error.empty(), error);
      checkSilhouette(silhouette->GetOutput(), counts.Reach);
      checkFields(silhouette->GetOutput(), counts, silhouette->GetSearch());
    }
    else
    {
      require(!error.empty(), "a bad light passes without an error");
      require(silhouette->GetOutput()->GetNumberOfPoints() == 0, "a bad light's silhouette");
    }
  }
  return 0;
}
