#include "Polylines.h"

Polyline3 PointsOf(vtkPolyData* data, vtkIdType count, const vtkIdType* ids)
{
  Polyline3 points(static_cast<std::size_t>(count));
  for (Vector3& point : points)
  {
    data->GetPoint(*ids++, point.data());
  }
  return points;
}

std::vector<Polyline3> LinesOf(vtkPolyData* data)
{
  std::vector<Polyline3> lines;
  ForEachLine(data,
    [&](vtkIdType count, const vtkIdType* ids) { lines.push_back(PointsOf(data, count, ids)); });
  return lines;
}

vtkSmartPointer<vtkPolyData> DataOf(const std::vector<Polyline3>& lines)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Polyline3& line : lines)
  {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const Vector3& point : line)
    {
      cells->InsertCellPoint(points->InsertNextPoint(point.data()));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

double LengthOf(const Polyline3& line)
{
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    length += Length(Along(line[i], -1.0, line[i - 1]));
  }
  return length;
}
