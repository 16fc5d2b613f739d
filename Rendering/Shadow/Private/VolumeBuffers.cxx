#include "VolumeBuffers.h"

#include "OpenGLFunctions.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"
#include "vtkShadowVolumeExtruder.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"

#include <utility>

VolumeBuffers::~VolumeBuffers()
{
  if (this->Vertices)
  {
    glDeleteVertexArrays(NumberOfVertexArrays, this->VertexArrays.data());
    glDeleteBuffers(1, &this->Vertices);
    glDeleteBuffers(1, &this->Indices);
  }
}

void VolumeBuffers::PlaceRims(vtkPolyData* end, std::vector<float>& vertices)
{
  this->RimFirst.clear();
  this->RimCount.clear();
  this->StripFirst.clear();
  this->StripCount.clear();
  auto* multiplicities =
    vtkIntArray::SafeDownCast(end->GetCellData()->GetArray("Multiplicity"));
  int next = 0;
  for (vtkIdType cell = 0; cell < end->GetNumberOfLines(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    end->GetLines()->GetCellAtId(cell, size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      double place[3];
      end->GetPoint(ids[i], place);
      const std::array<float, 3> vertex = this->Mesh->ToVertex(place);
      for (const float isPlace : { 1.0f, 0.0f })
      {
        vertices.insert(vertices.end(), vertex.begin(), vertex.end());
        vertices.push_back(isPlace);
      }
    }
    const int count = static_cast<int>(size);
    for (int repeat = multiplicities->GetValue(cell); repeat > 0; --repeat)
    {
      this->RimFirst.push_back(next);
      this->RimCount.push_back(count);
      this->StripFirst.push_back(2 * next);
      this->StripCount.push_back(2 * count);
    }
    next += count;
  }
}

void VolumeBuffers::PlacePoints(vtkPolyData* end, std::vector<float>& vertices)
{
  vtkBoundingBox bounds(this->Mesh->GetBounds().data());
  for (vtkIdType i = 0; i < end->GetNumberOfPoints(); ++i)
  {
    double place[3];
    end->GetPoint(i, place);
    bounds.AddPoint(place);
    const std::array<float, 3> vertex = this->Mesh->ToVertex(place);
    vertices.insert(vertices.end(), vertex.begin(), vertex.end());
  }
  bounds.GetBounds(this->Bounds.data());
}

std::size_t VolumeBuffers::Upload(
  vtkPolyData* end, std::shared_ptr<const MeshBuffers> mesh, unsigned int attribute)
{
  this->Mesh = std::move(mesh);
  auto* whole = vtkUnsignedIntArray::SafeDownCast(end->GetFieldData()->GetArray("CapTriangles"));
  auto* multiplicities =
    vtkIntArray::SafeDownCast(end->GetCellData()->GetArray("Multiplicity"));
  auto* parts = vtkUnsignedCharArray::SafeDownCast(end->GetCellData()->GetArray("Part"));
  if (!whole || !multiplicities || !parts)
  {
    // The extruder has refused the mesh.
    this->CapIndices = this->PartIndices = this->GapIndices = 0;
    this->RimFirst.clear();
    return 0;
  }
  const auto field = [&](const char* name)
  { return static_cast<int>(end->GetFieldData()->GetArray(name)->GetComponent(0, 0)); };
  this->GreatestDepth = field("GreatestDepth");
  this->LightOutside = field("LightOutside") != 0;

  std::vector<float> vertices;
  this->PlaceRims(end, vertices);
  const std::size_t points = vertices.size() * sizeof(float);
  this->PlacePoints(end, vertices);

  std::vector<GLuint> capParts;
  std::vector<GLuint> gaps;
  for (vtkIdType cell = 0; cell < end->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    end->GetPolys()->GetCellAtId(cell, size, ids);
    const vtkIdType number = end->GetNumberOfLines() + cell;
    std::vector<GLuint>& indices =
      parts->GetValue(number) == vtkShadowVolumeExtruder::CAP ? capParts : gaps;
    for (int repeat = multiplicities->GetValue(number); repeat > 0; --repeat)
    {
      indices.insert(indices.end(), ids, ids + size);
    }
  }
  this->CapIndices = static_cast<int>(whole->GetNumberOfValues());
  this->PartIndices = static_cast<int>(capParts.size());
  this->GapIndices = static_cast<int>(gaps.size());

  if (!this->Vertices)
  {
    glGenVertexArrays(NumberOfVertexArrays, this->VertexArrays.data());
    glGenBuffers(1, &this->Vertices);
    glGenBuffers(1, &this->Indices);
  }
  const std::size_t vertexBytes = vertices.size() * sizeof(float);
  glBindBuffer(GL_ARRAY_BUFFER, this->Vertices);
  glBufferData(
    GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertexBytes), vertices.data(), GL_STREAM_DRAW);
  this->Describe(Caps, this->Mesh->GetVertices(), attribute, 3, 3, 0);
  this->Describe(Parts, this->Vertices, attribute, 3, 3, points);
  this->Describe(Walls, this->Vertices, attribute, 4, 4, 0);
  this->Describe(Ends, this->Vertices, attribute, 4, 8, 4 * sizeof(float));

  // The index buffer is bound to the vertex array that is bound: to any of them.
  const std::pair<const GLuint*, int> pieces[] = { { whole->GetPointer(0), this->CapIndices },
    { capParts.data(), this->PartIndices }, { gaps.data(), this->GapIndices } };
  const std::size_t indexBytes = sizeof(GLuint) *
    (static_cast<std::size_t>(whole->GetNumberOfValues()) + capParts.size() + gaps.size());
  glBindVertexArray(this->VertexArrays[Caps]);
  glBufferData(
    GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indexBytes), nullptr, GL_STREAM_DRAW);
  GLintptr at = 0;
  for (const auto& [first, count] : pieces)
  {
    const auto bytes = static_cast<GLsizeiptr>(sizeof(GLuint)) * count;
    if (bytes > 0)
    {
      glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, at, bytes, first);
    }
    at += bytes;
  }
  glBindVertexArray(0);
  return vertexBytes + indexBytes;
}

void VolumeBuffers::Describe(VertexArray array, unsigned int vertices, unsigned int attribute,
  int size, std::size_t stride, std::size_t offset)
{
  glBindVertexArray(this->VertexArrays[array]);
  glBindBuffer(GL_ARRAY_BUFFER, vertices);
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(attribute, size, GL_FLOAT, GL_FALSE,
    static_cast<GLsizei>(stride * sizeof(float)), reinterpret_cast<const void*>(offset));
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->Indices);
}

void VolumeBuffers::DrawTriangles(VertexArray array, int first, int count) const
{
  if (count > 0)
  {
    const auto offset = static_cast<std::size_t>(first) * sizeof(GLuint);
    glBindVertexArray(this->VertexArrays[array]);
    glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
  }
}

void VolumeBuffers::DrawCaps() const
{
  this->DrawTriangles(Caps, 0, this->CapIndices);
  this->DrawTriangles(Parts, this->CapIndices, this->PartIndices);
}

void VolumeBuffers::DrawGaps() const
{
  this->DrawTriangles(Parts, this->CapIndices + this->PartIndices, this->GapIndices);
}

void VolumeBuffers::DrawWalls() const
{
  if (!this->RimFirst.empty())
  {
    glBindVertexArray(this->VertexArrays[Walls]);
    glMultiDrawArrays(GL_TRIANGLE_STRIP, this->StripFirst.data(), this->StripCount.data(),
      static_cast<GLsizei>(this->StripFirst.size()));
  }
}

void VolumeBuffers::DrawEndFans() const
{
  if (!this->RimFirst.empty())
  {
    glBindVertexArray(this->VertexArrays[Ends]);
    glMultiDrawArrays(GL_TRIANGLE_FAN, this->RimFirst.data(), this->RimCount.data(),
      static_cast<GLsizei>(this->RimFirst.size()));
  }
}
