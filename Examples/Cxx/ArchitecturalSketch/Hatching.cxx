#include "Hatching.h"

#include "LineOfSight.h"
#include "SketchView.h"

#include <vtkCutter.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkStripper.h>

namespace
{
const Vector3 HatchNormal = { 0.62, -0.62, 0.48 }; // of the planes in which its lines are
constexpr double HatchSpacing = 0.016;             // metres, as what follows
constexpr double HatchStep = 0.004;                // shadows that are narrower may be missed
constexpr double ShortestHatch = 0.008;

// Lines of a surface in parallel planes.
std::vector<Polyline3> LinesInPlanes(vtkPolyData* surface)
{
  vtkNew<vtkPlane> plane;
  Vector3 normal = HatchNormal;
  plane->SetNormal(normal.data());
  vtkNew<vtkCutter> cutter;
  cutter->SetInputData(surface);
  cutter->SetCutFunction(plane);
  cutter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  cutter->GenerateTrianglesOff();
  const int planes = static_cast<int>(6.0 / HatchSpacing);
  cutter->GenerateValues(planes, -3.0, -3.0 + (planes - 1) * HatchSpacing);
  vtkNew<vtkStripper> joined;
  joined->SetInputConnection(cutter->GetOutputPort());
  joined->JoinContiguousSegmentsOn();
  joined->SetMaximumLength(100000);
  joined->Update();
  return LinesOf(joined->GetOutput());
}
}

std::vector<Polyline3> Hatching(const Model& model)
{
  const LineOfSight sight(model.All());
  std::vector<Polyline3> hatching;
  for (vtkPolyData* surface : model.All())
  {
    for (const Polyline3& line : LinesInPlanes(surface))
    {
      const auto isDark = [&](std::size_t i, double share) {
        const Vector3& a = line[i];
        const Vector3& b = line[i + 1];
        return !sight.IsFree({ a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]),
                               a[2] + share * (b[2] - a[2]) },
          Sun);
      };
      const auto steps = [&](std::size_t i) {
        return 1 + static_cast<int>(LengthOf({ line[i], line[i + 1] }) / HatchStep);
      };
      for (const Polyline3& part : PartsOf(line, isDark, steps))
      {
        if (LengthOf(part) > ShortestHatch)
        {
          hatching.push_back(part);
        }
      }
    }
  }
  return hatching;
}
