// Any bytes as a small mesh, a light and settings, through silhouette and shadow volume: all
// searches that are complete find the same, and volumes are closed and finite.

#include "ChainChecks.h"
#include "FuzzCheck.h"
#include "FuzzInput.h"
#include "OutputComparison.h"
#include "ShadowPipeline.h"
#include "Tolerances.h"

#include <vtkCellData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
using namespace shadowtest;

void draw(FuzzInput& input, Numbers numbers, ShadowPipeline& pipeline)
{
  constexpr double tolerances[] = { 1e-2, 1e-3, 0.3 };
  pipeline.Silhouette->SetKind(static_cast<int>(input.below(3)));
  pipeline.Silhouette->SetSearch(static_cast<int>(input.below(5)));
  pipeline.Silhouette->SetTolerance(tolerances[input.below(3)]);
  pipeline.Silhouette->SetMergePoints(input.below(4) != 3);
  pipeline.Silhouette->SetSampleFraction(input.below(5) / 4.0);
  vtkShadowVolumeExtruder* extruder = pipeline.Extruder;
  extruder->SetCaps(static_cast<int>(input.below(4)));
  extruder->SetExtent(static_cast<int>(input.below(3)));
  extruder->SetWallStrips(input.flag());
  extruder->SetLength(std::fabs(input.number(numbers)));
  // Most often behind the mesh, where all rays come to it.
  Vec3 origin = input.vector(numbers);
  origin[2] -= input.flag() ? 16.0 : 0.0;
  extruder->SetPlaneOrigin(origin.data());
  Vec3 normal = input.vector(numbers);
  normal[2] += input.flag() ? 8.0 : 0.0;
  extruder->SetPlaneNormal(normal.data());
}

void checkLoopsOf(vtkPolyData* silhouette)
{
  const LoopReport report = checkLoops(silhouette);
  std::ostringstream message;
  message << "loops: " << report;
  require(report.OpenLoops == 0 && report.ShortLoops == 0 && report.UnbalancedPoints == 0 &&
      report.BadMultiplicities == 0 && report.NonFinitePoints == 0,
    message.str());
}

bool isComplete(ShadowPipeline& pipeline)
{
  return fieldValue(pipeline.silhouette(), "SearchComplete") == 1.0;
}

void checkSearches(vtkPolyData* mesh, ShadowPipeline& pipeline)
{
  if (!isComplete(pipeline))
  {
    return;
  }
  // Of the same mesh, which is prepared once; the silhouette is kept for the same search alone.
  const bool hierarchy = pipeline.Silhouette->GetSearch() == vtkSmoothLightSilhouette::HIERARCHY;
  vtkNew<vtkSmoothLightSilhouette> other;
  other->SetInputData(mesh);
  other->SetLightPosition(pipeline.Silhouette->GetLightPosition());
  other->SetKind(pipeline.Silhouette->GetKind());
  other->SetSearch(
    hierarchy ? vtkSmoothLightSilhouette::BRUTE_FORCE : vtkSmoothLightSilhouette::HIERARCHY);
  other->SetTolerance(pipeline.Silhouette->GetTolerance());
  other->SetMergePoints(pipeline.Silhouette->GetMergePoints());
  other->Update();
  const std::string differing = difference(other->GetOutput(), pipeline.silhouette());
  require(differing.empty(), "searches differ in " + differing);
}

// The greatest coordinate; NaN if one is not finite.
double reachOf(vtkPolyData* volume)
{
  double reach = 0.0;
  vtkDataArray* homogeneous = volume->GetPointData()->GetArray("Homogeneous");
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    double coordinates[7];
    volume->GetPoint(i, coordinates);
    homogeneous->GetTuple(i, coordinates + 3);
    require(coordinates[6] == 0.0 || coordinates[6] == 1.0, "w is neither 0 nor 1");
    for (const double c : coordinates)
    {
      require(std::isfinite(c), "a point of the volume is not finite");
      reach = std::max(reach, std::fabs(c));
    }
  }
  return reach;
}

// A search that cannot tell may have found the whole silhouette all the same.
void checkVolume(vtkPolyData* volume, bool capped, bool complete, bool finite)
{
  const double reach = reachOf(volume);
  const double closed = fieldValue(volume, "Closed");
  require(closed == 0.0 || closed == 1.0, "Closed is neither 0 nor 1");
  require(closed == 1.0 || !capped || !complete, "a complete volume is not closed");
  if (closed == 0.0)
  {
    return;
  }
  require(capped, "a volume without caps is closed");
  require(openEdges(volume) == 0, "a closed volume has open edges");
  if (finite)
  {
    const double told = fieldValue(volume, "Volume");
    const double error = std::fabs(told - enclosedVolume(volume));
    std::ostringstream message;
    message << "the volume is said to be " << told << ", off by " << error << " at a reach of "
            << reach;
    require(error <= tolerance::Volume * reach * reach * reach, message.str());
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  silenceVTK();
  FuzzInput input(bytes, size);
  const Numbers numbers = input.below(3) == 2 ? Numbers::Float : Numbers::Grid;
  const LightPosition light = input.light(numbers);
  if (light == LightPosition{ 0.0, 0.0, 0.0, 0.0 })
  {
    return 0;
  }
  const Mesh mesh = smallMesh(input, numbers);
  ShadowPipeline pipeline(mesh, light, vtkSmoothLightSilhouette::DISCRETE);
  draw(input, numbers, pipeline);
  ErrorWatch silhouetteErrors(pipeline.Silhouette);
  ErrorWatch volumeErrors(pipeline.Extruder);

  checkLoopsOf(pipeline.silhouette());
  checkSearches(mesh, pipeline);
  vtkPolyData* volume = pipeline.volume();
  const std::string silhouetteError = silhouetteErrors.take();
  require(silhouetteError.empty(), silhouetteError);
  const std::string error = volumeErrors.take();
  const int extent = pipeline.Extruder->GetExtent();
  if (!error.empty())
  {
    // Rays that do not come to the plane.
    require(extent == vtkShadowVolumeExtruder::PLANE, error);
    require(volume->GetNumberOfPoints() == 0, "a volume in spite of an error");
    return 0;
  }
  checkVolume(volume, pipeline.Extruder->GetCaps() != vtkShadowVolumeExtruder::NONE,
    isComplete(pipeline), extent != vtkShadowVolumeExtruder::INFINITE);
  return 0;
}
