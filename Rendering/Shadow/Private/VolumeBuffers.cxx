#include "VolumeBuffers.h"

#include "OpenGLFunctions.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShadowVolumeExtruder.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace
{
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

void VolumeBuffers::PlaceVertices(vtkPolyData* volume, std::vector<float>& vertices)
{
  auto* near = vtkArrayDownCast<vtkIdTypeArray>(volume->GetPointData()->GetArray("NearPoints"));
  const vtkIdType count = volume->GetNumberOfPoints();
  vtkBoundingBox bounds;
  double place[3];
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (near->GetValue(i) < 0)
    {
      volume->GetPoint(i, place);
      bounds.AddPoint(place);
    }
  }
  bounds.GetBounds(this->Bounds.data());
  bounds.GetCenter(this->Origin.data());
  this->Scale = 0.5 * bounds.GetMaxLength();
  if (!(this->Scale > 0.0))
  {
    this->Scale = 1.0;
  }
  vertices.resize(4 * static_cast<std::size_t>(count) + 4, 0.0f);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType origin = near->GetValue(i);
    volume->GetPoint(origin < 0 ? i : origin, place);
    float* vertex = &vertices[4 * static_cast<std::size_t>(i)];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      vertex[axis] = static_cast<float>((place[axis] - this->Origin[axis]) / this->Scale);
    }
    vertex[3] = origin < 0 ? 0.0f : 1.0f;
  }
  // The apex of the far end: where the shadow of the middle ends.
  vertices.back() = 1.0f;
}

void VolumeBuffers::Upload(vtkPolyData* volume, unsigned int attribute)
{
  this->Release();
  const auto parts = AsInts(volume->GetCellData()->GetArray("Part"));
  const auto multiplicities = AsInts(volume->GetCellData()->GetArray("Multiplicity"));
  if (volume->GetNumberOfPolys() == 0 || !parts || !multiplicities)
  {
    return;
  }
  this->GreatestDepth =
    static_cast<int>(volume->GetFieldData()->GetArray("GreatestDepth")->GetComponent(0, 0));
  std::vector<float> vertices;
  this->PlaceVertices(volume, vertices);
  const auto apex = static_cast<GLuint>(vertices.size() / 4 - 1);

  std::vector<GLuint> caps;
  std::vector<GLuint> sides;
  std::vector<GLuint> far;
  std::vector<GLuint> fan;
  const auto isEnd = [&](vtkIdType point)
  { return vertices[4 * static_cast<std::size_t>(point) + 3] != 0.0f; };
  vtkIdType cell = 0;
  auto triangles = vtk::TakeSmartPointer(volume->GetPolys()->NewIterator());
  for (triangles->GoToFirstCell(); !triangles->IsDoneWithTraversal(); triangles->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    triangles->GetCurrentCell(size, ids);
    const std::array<GLuint, 3> corners = { static_cast<GLuint>(ids[0]),
      static_cast<GLuint>(ids[1]), static_cast<GLuint>(ids[2]) };
    const int part = parts->GetValue(cell);
    std::vector<GLuint>& indices = part == vtkShadowVolumeExtruder::CAP ? caps
      : part == vtkShadowVolumeExtruder::FAR_CAP                        ? far
                                                                        : sides;
    for (int repeat = multiplicities->GetValue(cell); repeat > 0; --repeat)
    {
      indices.insert(indices.end(), corners.begin(), corners.end());
      // Walls are written as (q, p, p's end), (q, p's end, q's end).
      if (part == vtkShadowVolumeExtruder::WALL && isEnd(ids[1]) && isEnd(ids[2]))
      {
        fan.insert(fan.end(), { apex, corners[2], corners[1] });
      }
    }
    ++cell;
  }
  if (far.empty())
  {
    far.swap(fan);
  }
  this->CapIndices = static_cast<int>(caps.size());
  this->SideIndices = static_cast<int>(sides.size());
  this->FarIndices = static_cast<int>(far.size());
  caps.insert(caps.end(), sides.begin(), sides.end());
  caps.insert(caps.end(), far.begin(), far.end());

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
  this->FarIndices = 0;
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
