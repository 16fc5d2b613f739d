#include "VolumeBuffers.h"

#include "OpenGLFunctions.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShadowVolumeExtruder.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace
{
/**
 * The middle of the finite points' bounds.
 */
std::array<double, 3> FindMiddle(const double* points, vtkIdType count)
{
  std::array<double, 3> lower;
  std::array<double, 3> upper;
  lower.fill(std::numeric_limits<double>::max());
  upper.fill(std::numeric_limits<double>::lowest());
  bool any = false;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double* point = points + 4 * i;
    if (point[3] != 0.0)
    {
      any = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        lower[axis] = std::min(lower[axis], point[axis] / point[3]);
        upper[axis] = std::max(upper[axis], point[axis] / point[3]);
      }
    }
  }
  if (!any)
  {
    return {};
  }
  return { 0.5 * (lower[0] + upper[0]), 0.5 * (lower[1] + upper[1]), 0.5 * (lower[2] + upper[2]) };
}

/**
 * The array as ints, copied only if it is of another type.
 */
vtkSmartPointer<vtkIntArray> AsInts(vtkDataArray* array)
{
  vtkSmartPointer<vtkIntArray> ints = vtkArrayDownCast<vtkIntArray>(array);
  if (!ints && array)
  {
    ints = vtkSmartPointer<vtkIntArray>::New();
    ints->DeepCopy(array);
  }
  return ints;
}
}

void VolumeBuffers::Upload(vtkPolyData* volume, unsigned int attribute)
{
  this->Release();
  auto* homogeneous =
    vtkArrayDownCast<vtkDoubleArray>(volume->GetPointData()->GetArray("Homogeneous"));
  const auto parts = AsInts(volume->GetCellData()->GetArray("Part"));
  const auto multiplicities = AsInts(volume->GetCellData()->GetArray("Multiplicity"));
  if (!homogeneous || homogeneous->GetNumberOfTuples() == 0 || !parts || !multiplicities)
  {
    return;
  }

  this->GreatestDepth =
    static_cast<int>(volume->GetFieldData()->GetArray("GreatestDepth")->GetComponent(0, 0));
  const vtkIdType pointCount = homogeneous->GetNumberOfTuples();
  const double* points = homogeneous->GetPointer(0);
  this->Origin = FindMiddle(points, pointCount);
  std::vector<float> vertices(4 * static_cast<std::size_t>(pointCount));
  for (std::size_t i = 0; i < vertices.size(); i += 4)
  {
    const double w = points[i + 3];
    vertices[i] = static_cast<float>(points[i] - w * this->Origin[0]);
    vertices[i + 1] = static_cast<float>(points[i + 1] - w * this->Origin[1]);
    vertices[i + 2] = static_cast<float>(points[i + 2] - w * this->Origin[2]);
    vertices[i + 3] = static_cast<float>(w);
  }

  std::vector<GLuint> caps;
  std::vector<GLuint> sides;
  vtkIdType cell = 0;
  auto triangles = vtk::TakeSmartPointer(volume->GetPolys()->NewIterator());
  for (triangles->GoToFirstCell(); !triangles->IsDoneWithTraversal(); triangles->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    triangles->GetCurrentCell(size, ids);
    std::vector<GLuint>& part =
      parts->GetValue(cell) == vtkShadowVolumeExtruder::CAP ? caps : sides;
    for (int repeat = multiplicities->GetValue(cell); size == 3 && repeat > 0; --repeat)
    {
      part.insert(part.end(),
        { static_cast<GLuint>(ids[0]), static_cast<GLuint>(ids[1]), static_cast<GLuint>(ids[2]) });
    }
    ++cell;
  }
  this->CapIndices = static_cast<int>(caps.size());
  this->SideIndices = static_cast<int>(sides.size());
  caps.insert(caps.end(), sides.begin(), sides.end());

  glGenVertexArrays(1, &this->VertexArray);
  glGenBuffers(1, &this->Vertices);
  glGenBuffers(1, &this->Indices);
  glBindVertexArray(this->VertexArray);
  glBindBuffer(GL_ARRAY_BUFFER, this->Vertices);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(float)),
    vertices.data(), GL_STATIC_DRAW);
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(attribute, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->Indices);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(caps.size() * sizeof(GLuint)),
    caps.data(), GL_STATIC_DRAW);
  glBindVertexArray(0);
}

void VolumeBuffers::Release()
{
  if (this->VertexArray)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
    glDeleteBuffers(1, &this->Vertices);
    glDeleteBuffers(1, &this->Indices);
  }
  this->VertexArray = 0;
  this->Vertices = 0;
  this->Indices = 0;
  this->CapIndices = 0;
  this->SideIndices = 0;
  this->GreatestDepth = 0;
}

void VolumeBuffers::Draw(int first, int count) const
{
  if (count > 0)
  {
    const auto offset = static_cast<std::size_t>(first) * sizeof(GLuint);
    glBindVertexArray(this->VertexArray);
    glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
  }
}
