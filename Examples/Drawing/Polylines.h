/**
 * The lines of polydata as points.
 */
#ifndef Polylines_h
#define Polylines_h

#include "Vectors.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

using Polyline3 = std::vector<Vector3>;

/// Calls visit(count, ids) for each line of the data, in their order.
template <class Visit>
void ForEachLine(vtkPolyData* data, const Visit& visit)
{
  for (vtkIdType line = 0; line < data->GetNumberOfLines(); ++line)
  {
    vtkIdType count;
    const vtkIdType* ids;
    data->GetLines()->GetCellAtId(line, count, ids);
    visit(count, ids);
  }
}

Polyline3 PointsOf(vtkPolyData* data, vtkIdType count, const vtkIdType* ids);
std::vector<Polyline3> LinesOf(vtkPolyData* data);

/// Points are double; lines share none.
vtkSmartPointer<vtkPolyData> DataOf(const std::vector<Polyline3>& lines);

double LengthOf(const Polyline3& line);

/// The lines for which keep(line number) holds, without data of their own, and all points.
template <class Keep>
vtkSmartPointer<vtkPolyData> LinesThat(vtkPolyData* data, const Keep& keep)
{
  vtkNew<vtkCellArray> cells;
  vtkIdType line = 0;
  ForEachLine(data, [&](vtkIdType count, const vtkIdType* ids) {
    if (keep(line++))
    {
      cells->InsertNextCell(count, ids);
    }
  });
  auto kept = vtkSmartPointer<vtkPolyData>::New();
  kept->SetPoints(data->GetPoints());
  kept->GetPointData()->ShallowCopy(data->GetPointData());
  kept->SetLines(cells);
  return kept;
}

#endif
