#include "StrokeLines.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadowtest
{
namespace
{
double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 way = b - a;
  const double share = std::clamp(dot(p - a, way) / dot(way, way), 0.0, 1.0);
  return lengthOf(p - a - share * way);
}
}

vtkSmartPointer<vtkPolyData> linesOf(const std::vector<Line>& lines, bool closed)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Line& line : lines)
  {
    std::vector<vtkIdType> ids;
    for (const Vec3& point : line)
    {
      ids.push_back(points->InsertNextPoint(point.data()));
    }
    if (closed)
    {
      ids.push_back(ids.front());
    }
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

Vec3 pointOf(vtkPolyData* data, vtkIdType id)
{
  Vec3 point;
  data->GetPoint(id, point.data());
  return point;
}

double lengthOf(const Vec3& v)
{
  return std::sqrt(dot(v, v));
}

double distanceToLine(const Vec3& p, const Line& line, bool closed)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i)
  {
    nearest = std::min(nearest, distanceToSegment(p, line[i], line[(i + 1) % line.size()]));
  }
  return nearest;
}

std::vector<double> doubleAreas(vtkPolyData* ribbons)
{
  std::vector<double> areas;
  for (vtkIdType cell = 0; cell < ribbons->GetNumberOfPolys(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    ribbons->GetPolys()->GetCellAtId(cell, count, ids);
    EXPECT_EQ(count, 3);
    const Vec3 a = pointOf(ribbons, ids[0]);
    areas.push_back(cross(pointOf(ribbons, ids[1]) - a, pointOf(ribbons, ids[2]) - a)[2]);
  }
  return areas;
}

bool covers(vtkPolyData* ribbons, const Vec3& p)
{
  for (vtkIdType cell = 0; cell < ribbons->GetNumberOfPolys(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    ribbons->GetPolys()->GetCellAtId(cell, count, ids);
    bool inside = true;
    for (int i = 0; i < 3 && inside; ++i)
    {
      const Vec3 a = pointOf(ribbons, ids[i]);
      inside = cross(pointOf(ribbons, ids[(i + 1) % 3]) - a, p - a)[2] >= 0.0;
    }
    if (inside)
    {
      return true;
    }
  }
  return false;
}

std::vector<End> endsOf(vtkPolyData* ribbon, const Line& segment)
{
  std::vector<End> ends(2);
  EXPECT_EQ(ribbon->GetNumberOfPoints(), 6);
  EXPECT_EQ(ribbon->GetNumberOfPolys(), 4);
  for (std::size_t i = 0; i < 2; ++i)
  {
    ends[i].middle = segment[i];
    for (vtkIdType id = 0; id < ribbon->GetNumberOfPoints(); ++id)
    {
      const Vec3 offset = pointOf(ribbon, id) - segment[i];
      if (lengthOf(offset) < lengthOf(pointOf(ribbon, id) - segment[1 - i]) &&
        offset != Vec3{ 0.0, 0.0, 0.0 })
      {
        ends[i].offsets.push_back(offset);
      }
    }
    EXPECT_EQ(ends[i].offsets.size(), 2u);
  }
  return ends;
}

Vec3 randomPoint(Random& random, double half)
{
  return { random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half) };
}

Line zigzag(Random& random, int corners)
{
  Line line{ { 0.0, 0.0, 0.0 } };
  double heading = 0.0;
  for (int i = 0; i < corners; ++i)
  {
    heading += random.uniform(-3.1, 3.1);
    const double step = random.chance(0.3) ? random.uniform(0.01, 0.1) : random.uniform(0.5, 3.0);
    line.push_back(line.back() + Vec3{ step * std::cos(heading), step * std::sin(heading), 0.0 });
  }
  return line;
}

Line circle(int count, double radius)
{
  Line line;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / count;
    line.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0.0 });
  }
  return line;
}

vtkNew<vtkContourStrokes> strokesOf(vtkPolyData* lines, double width)
{
  vtkNew<vtkContourStrokes> strokes;
  strokes->SetInputData(lines);
  strokes->SetWidth(width);
  strokes->SetLift(0.0);
  return strokes;
}

vtkSmartPointer<vtkPolyData> update(vtkContourStrokes* strokes)
{
  strokes->Update();
  return strokes->GetOutput();
}

Line middlesOf(vtkPolyData* ribbon)
{
  Line middles;
  vtkDataArray* across = ribbon->GetPointData()->GetArray("Across");
  for (vtkIdType id = 0; id < ribbon->GetNumberOfPoints(); ++id)
  {
    if (across->GetComponent(id, 0) == 0.0)
    {
      middles.push_back(pointOf(ribbon, id));
    }
  }
  return middles;
}
}
