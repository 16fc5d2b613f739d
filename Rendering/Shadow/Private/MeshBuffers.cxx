#include "MeshBuffers.h"

#include "OpenGLFunctions.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <vector>

MeshBuffers::MeshBuffers(vtkPolyData* mesh)
{
  this->FindBounds(mesh);
  std::vector<float> vertices;
  vertices.reserve(3 * static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double place[3];
    mesh->GetPoint(i, place);
    const std::array<float, 3> vertex = this->ToVertex(place);
    vertices.insert(vertices.end(), vertex.begin(), vertex.end());
  }
  this->UploadedBytes = vertices.size() * sizeof(float);
  glGenBuffers(1, &this->Vertices);
  glBindBuffer(GL_ARRAY_BUFFER, this->Vertices);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(this->UploadedBytes), vertices.data(),
    GL_STATIC_DRAW);
}

MeshBuffers::~MeshBuffers()
{
  glDeleteBuffers(1, &this->Vertices);
}

void MeshBuffers::FindBounds(vtkPolyData* mesh)
{
  // Cells may name points that do not exist, and points may be no numbers: these cast nothing.
  vtkBoundingBox bounds;
  for (vtkCellArray* cells : { mesh->GetPolys(), mesh->GetStrips() })
  {
    auto cell = vtk::TakeSmartPointer(cells->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
    {
      vtkIdType size;
      const vtkIdType* ids;
      cell->GetCurrentCell(size, ids);
      for (vtkIdType i = 0; i < size; ++i)
      {
        double place[3];
        if (ids[i] < 0 || ids[i] >= mesh->GetNumberOfPoints())
        {
          continue;
        }
        mesh->GetPoint(ids[i], place);
        if (std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]))
        {
          bounds.AddPoint(place);
        }
      }
    }
  }
  if (!bounds.IsValid())
  {
    return;
  }
  bounds.GetBounds(this->Bounds.data());
  bounds.GetCenter(this->Origin.data());
  const double half = 0.5 * bounds.GetMaxLength();
  this->Scale = half > 0.0 ? half : 1.0;
}

std::array<float, 3> MeshBuffers::ToVertex(const double place[3]) const
{
  std::array<float, 3> vertex;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    vertex[axis] = static_cast<float>((place[axis] - this->Origin[axis]) / this->Scale);
  }
  return vertex;
}
