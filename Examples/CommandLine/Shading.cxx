#include "Shading.h"

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkTriangleFilter.h>

#include <cmath>
#include <vector>

namespace
{
std::vector<bool> FinitePoints(vtkPolyData* mesh)
{
  std::vector<bool> finite(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t i = 0; i < finite.size(); ++i)
  {
    double x[3];
    mesh->GetPoint(static_cast<vtkIdType>(i), x);
    finite[i] = std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
  }
  return finite;
}

// Triangles whose points are all finite; returns how many others there were.
vtkIdType KeepFinite(vtkPolyData* mesh)
{
  const std::vector<bool> finite = FinitePoints(mesh);
  vtkCellArray* polys = mesh->GetPolys();
  const vtkIdType before = polys->GetNumberOfCells();
  vtkNew<vtkCellArray> kept;
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType cell = 0; cell < before; ++cell)
  {
    polys->GetCellAtId(cell, size, ids);
    bool keep = true;
    for (vtkIdType i = 0; i < size; ++i)
    {
      keep = keep && finite[static_cast<std::size_t>(ids[i])];
    }
    if (keep)
    {
      kept->InsertNextCell(size, ids);
    }
  }
  mesh->SetPolys(kept);
  return before - kept->GetNumberOfCells();
}
}

ShadedMesh PrepareForShading(vtkPolyData* mesh, double featureAngle)
{
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(mesh);
  triangulate->PassLinesOff();
  triangulate->PassVertsOff();
  triangulate->Update();
  vtkPolyData* triangles = triangulate->GetOutput();

  ShadedMesh shaded{ nullptr, KeepFinite(triangles), !mesh->GetPointData()->GetNormals() };

  // Normals are averaged over the faces of a point: equal points must be one before that. Points
  // of no face go too, as they would count in the bounds.
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(triangles);
  clean->SetPointMerging(shaded.NormalsComputed);
  clean->SetTolerance(0.0);
  clean->ConvertLinesToPointsOff();
  clean->ConvertPolysToLinesOff();
  clean->ConvertStripsToPolysOff();
  clean->Update();
  shaded.Data = clean->GetOutput();
  if (shaded.NormalsComputed)
  {
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputData(shaded.Data);
    normals->SetFeatureAngle(featureAngle);
    normals->SplittingOn();
    // The mesh's own orientation stays: turning faces would change which of them cast.
    normals->ConsistencyOff();
    normals->Update();
    shaded.Data = normals->GetOutput();
  }
  return shaded;
}
