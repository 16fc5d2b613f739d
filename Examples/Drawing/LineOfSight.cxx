#include "LineOfSight.h"

#include <vtkBoundingBox.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Bias = 1e-5;
constexpr int Halvings = 12;
}

LineOfSight::LineOfSight(const std::vector<vtkPolyData*>& meshes)
{
  vtkBoundingBox bounds;
  for (vtkPolyData* mesh : meshes)
  {
    // Without its lines, which hide nothing.
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(mesh->GetPoints());
    surface->SetPolys(mesh->GetPolys());
    auto locator = vtkSmartPointer<vtkStaticCellLocator>::New();
    locator->SetDataSet(surface);
    locator->BuildLocator();
    this->Locators.push_back(locator);
    bounds.AddBounds(mesh->GetBounds());
  }
  bounds.GetBounds(this->Bounds);
  this->Size = bounds.GetDiagonalLength();
}

bool LineOfSight::IsFree(const Vector3& point, const Homogeneous& eye) const
{
  const Vector3 towards = { eye[0] - eye[3] * point[0], eye[1] - eye[3] * point[1],
    eye[2] - eye[3] * point[2] };
  const double distance = Length(towards);
  // An eye at infinity is beyond all that could block.
  const Vector3 away = { point[0] - this->Bounds[0], point[1] - this->Bounds[2],
    point[2] - this->Bounds[4] };
  const double reach = eye[3] != 0.0 ? distance : 2.0 * (this->Size + Length(away));
  Vector3 start = Along(point, Bias * this->Size / distance, towards);
  Vector3 end = Along(point, reach / distance, towards);
  return std::none_of(
    this->Locators.begin(), this->Locators.end(), [&](vtkStaticCellLocator* locator) {
      double at;
      Vector3 hit;
      double parametric[3];
      int part;
      vtkIdType cell;
      return locator->IntersectWithLine(
               start.data(), end.data(), 0.0, at, hit.data(), parametric, part, cell) != 0;
    });
}

std::vector<Polyline3> PartsOf(
  const Polyline3& line, const PartTest& isIn, const std::function<int(std::size_t segment)>& steps)
{
  std::vector<Polyline3> parts;
  bool in = line.size() > 1 && isIn(0, 0.0);
  if (in)
  {
    parts.push_back({ line[0] });
  }
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    const Vector3 way = Along(line[i + 1], -1.0, line[i]);
    const int count = steps(i);
    for (int step = 1; step <= count; ++step)
    {
      double before = static_cast<double>(step - 1) / count;
      double after = static_cast<double>(step) / count;
      if (isIn(i, after) == in)
      {
        continue;
      }
      for (int halving = 0; halving < Halvings; ++halving)
      {
        const double middle = 0.5 * (before + after);
        (isIn(i, middle) == in ? before : after) = middle;
      }
      if (in)
      {
        parts.back().push_back(Along(line[i], before, way));
      }
      else
      {
        parts.push_back({ Along(line[i], after, way) });
      }
      in = !in;
    }
    if (in)
    {
      parts.back().push_back(line[i + 1]);
    }
  }
  return parts;
}
