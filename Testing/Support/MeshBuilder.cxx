#include "MeshBuilder.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <cmath>

namespace shadowtest
{
vtkIdType MeshBuilder::addPoint(const Vec3& point)
{
  this->Points.push_back(point);
  return this->pointCount() - 1;
}

vtkIdType MeshBuilder::addPoint(const Vec3& point, const Vec3& normal)
{
  this->Points.push_back(point);
  this->Normals.push_back(normal);
  return this->pointCount() - 1;
}

void MeshBuilder::addTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
{
  this->Cells.push_back({ a, b, c });
}

void MeshBuilder::addQuad(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType d)
{
  this->addTriangle(a, b, c);
  this->addTriangle(a, c, d);
}

void MeshBuilder::addPolygon(const std::vector<vtkIdType>& ids)
{
  this->Cells.push_back(ids);
}

vtkIdType MeshBuilder::append(vtkPolyData* mesh)
{
  const vtkIdType first = this->pointCount();
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Vec3 point;
    mesh->GetPoint(i, point.data());
    this->Points.push_back(point);
    if (normals)
    {
      Vec3 normal;
      normals->GetTuple(i, normal.data());
      this->Normals.push_back(normal);
    }
  }
  auto cell = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    std::vector<vtkIdType> shifted(ids, ids + size);
    for (vtkIdType& id : shifted)
    {
      id += first;
    }
    this->Cells.push_back(shifted);
  }
  return first;
}

Mesh MeshBuilder::build() const
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(this->pointCount());
  for (vtkIdType i = 0; i < this->pointCount(); ++i)
  {
    points->SetPoint(i, this->Points[static_cast<std::size_t>(i)].data());
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& ids : this->Cells)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  if (!this->Normals.empty())
  {
    vtkNew<vtkDoubleArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(this->pointCount());
    for (vtkIdType i = 0; i < this->pointCount(); ++i)
    {
      normals->SetTuple(i, this->Normals[static_cast<std::size_t>(i)].data());
    }
    mesh->GetPointData()->SetNormals(normals);
  }
  return mesh;
}

Vec3 operator+(const Vec3& a, const Vec3& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

Vec3 operator-(const Vec3& a, const Vec3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Vec3 operator*(double s, const Vec3& a)
{
  return { s * a[0], s * a[1], s * a[2] };
}

double dot(const Vec3& a, const Vec3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vec3 cross(const Vec3& a, const Vec3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Vec3 normalized(const Vec3& v)
{
  const double length = std::sqrt(dot(v, v));
  return length > 0.0 ? Vec3{ v[0] / length, v[1] / length, v[2] / length } : v;
}
}
