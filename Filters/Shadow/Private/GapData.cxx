#include "GapData.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

bool readNormals(vtkPolyData* silhouette, std::vector<shadow::Vec3>& normals)
{
  const vtkIdType count = silhouette->GetNumberOfPoints();
  vtkDataArray* array = silhouette->GetPointData()->GetArray("Normals");
  if (count > 0 &&
    (!array || array->GetNumberOfComponents() != 3 || array->GetNumberOfTuples() != count))
  {
    return false;
  }
  normals.resize(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->GetTuple(i, &normals[static_cast<std::size_t>(i)].x);
  }
  return true;
}

void writeGap(const shadow::SilhouetteGap& gap, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < gap.points.size(); ++i)
  {
    points->InsertNextPoint(&gap.points[i].x);
    normals->InsertNextTuple(&gap.normals[i].x);
  }
  vtkNew<vtkCellArray> triangles;
  for (const shadow::Triangle& t : gap.triangles)
  {
    triangles->InsertNextCell({ t[0], t[1], t[2] });
  }
  output->SetPoints(points);
  output->GetPointData()->SetNormals(normals);
  output->SetPolys(triangles);
}
