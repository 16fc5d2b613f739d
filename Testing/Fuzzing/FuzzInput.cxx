#include "FuzzInput.h"

#include "HostileMeshes.h"
#include "TestMeshes.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace shadowtest
{
namespace
{
using Doubles = std::numeric_limits<double>;
using Floats = std::numeric_limits<float>;

// Ends of ranges, and what is next to them; sizes up to which areas stay within doubles.
const double HostileNumbers[] = { Doubles::quiet_NaN(), Doubles::infinity(), -Doubles::infinity(),
  Doubles::max(), -Doubles::max(), Doubles::min(), -Doubles::min(), Doubles::denorm_min(),
  -Doubles::denorm_min(), Doubles::epsilon(), 1.0 + Doubles::epsilon(), -0.0, 1e80, -1e80, 1e-80,
  -1e-80, 1e154, -1e154, 1e-154, 1e-160, 1e300, -1e300, 1e-300, 1e-310, 1e7, 1e7 + 1.0, 1.0 / 3.0,
  1e15, 1e16 + 2.0, 1e-9, -1e-9, Floats::max(), Floats::min(), Floats::denorm_min(), 1e12, -1e12 };


vtkIdType hostileId(FuzzInput& input, vtkIdType points)
{
  const unsigned byte = input.byte();
  switch (byte)
  {
    case 255:
      return -1;
    case 254:
      return points;
    case 253:
      return std::numeric_limits<int>::max();
    case 252:
      return std::numeric_limits<int>::min();
    default:
      return points > 0 ? static_cast<vtkIdType>(byte) % points : 0;
  }
}

void insertCell(FuzzInput& input, vtkIdType points, unsigned size, vtkCellArray* cells)
{
  std::vector<vtkIdType> ids;
  for (unsigned i = 0; i < size; ++i)
  {
    ids.push_back(hostileId(input, points));
  }
  cells->InsertNextCell(static_cast<vtkIdType>(size), ids.data());
}

void addHostileCells(FuzzInput& input, vtkPolyData* mesh)
{
  constexpr unsigned kinds = 4;
  vtkSmartPointer<vtkCellArray> cells[kinds];
  for (auto& kind : cells)
  {
    kind = vtkSmartPointer<vtkCellArray>::New();
  }
  const vtkIdType points = mesh->GetNumberOfPoints();
  const unsigned count = input.below(33);
  for (unsigned i = 0; i < count; ++i)
  {
    const unsigned shape = input.byte();
    // Triangles half of the time.
    const unsigned kind = shape < 128 ? 0 : shape % kinds;
    insertCell(input, points, shape < 128 ? 3 : (shape / kinds) % 10, cells[kind]);
  }
  if (input.flag())
  {
    for (auto& kind : cells)
    {
      kind->ConvertTo32BitStorage();
    }
  }
  mesh->SetPolys(cells[0]);
  mesh->SetStrips(cells[1]);
  mesh->SetLines(cells[2]);
  mesh->SetVerts(cells[3]);
}

void addHostileNormals(FuzzInput& input, vtkPolyData* mesh)
{
  constexpr int types[] = { VTK_DOUBLE, VTK_FLOAT, VTK_SIGNED_CHAR, VTK_LONG_LONG };
  const unsigned shape = input.below(8);
  if (shape >= 6)
  {
    return;
  }
  auto normals = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(types[input.below(4)]));
  normals->SetNumberOfComponents(3);
  const vtkIdType points = mesh->GetNumberOfPoints();
  const bool wrongCount = shape == 5;
  normals->SetNumberOfTuples(wrongCount ? static_cast<vtkIdType>(input.below(32)) : points);
  const bool floating = normals->GetDataType() == VTK_DOUBLE || normals->GetDataType() == VTK_FLOAT;
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    normals->SetTuple(i, input.vector(floating ? Numbers::Hostile : Numbers::Grid).data());
  }
  mesh->GetPointData()->SetNormals(normals);
  if (shape == 4)
  {
    // Refused by SetNormals, but nothing keeps anyone from changing the array afterwards.
    normals->SetNumberOfComponents(static_cast<int>(input.below(5)));
  }
}

MeshBuilder body(unsigned which)
{
  MeshBuilder builder;
  switch (which)
  {
    case 0:
      return builder;
    case 1:
      builder.append(weldedBox(2.0, 2.0, 2.0));
      return builder;
    case 2:
      builder.append(quadBox(1.0, 3.0, 2.0));
      return builder;
    case 3:
      builder.append(box(1.0, 1.0, 2.0));
      return builder;
    case 4:
      builder.append(sphere(3, 5));
      return builder;
    case 5:
      builder.append(torus(5, 4));
      return builder;
    case 6:
      builder.append(moebiusStrip(5));
      return builder;
    case 7:
      builder.append(fin(5));
      return builder;
    case 8:
      builder.append(ground(0.0, 2.0, 2));
      return builder;
    default:
      builder.append(voxels(2, which));
      return builder;
  }
}

constexpr unsigned Bodies = 13;

template <class Values>
auto& drawn(FuzzInput& input, Values& values)
{
  return values[input.byte() % values.size()];
}

void changePoints(FuzzInput& input, Numbers numbers, MeshBuilder& mesh)
{
  const std::size_t before = mesh.Points.size();
  const unsigned added = input.below(before == 0 ? 16 : 5);
  for (unsigned i = 0; i < added; ++i)
  {
    mesh.addPoint(input.vector(numbers));
  }
  const unsigned movedPoints = mesh.Points.empty() ? 0 : input.below(9);
  for (unsigned i = 0; i < movedPoints; ++i)
  {
    Vec3& point = drawn(input, mesh.Points);
    point = input.vector(numbers);
  }
}

void changeCells(FuzzInput& input, MeshBuilder& mesh)
{
  const unsigned turned = mesh.Cells.empty() ? 0 : input.below(5);
  for (unsigned i = 0; i < turned; ++i)
  {
    std::vector<vtkIdType>& cell = drawn(input, mesh.Cells);
    std::swap(cell.front(), cell.back());
  }
  const unsigned removed = mesh.Cells.empty() ? 0 : input.below(5);
  for (unsigned i = 0; i < removed && !mesh.Cells.empty(); ++i)
  {
    std::swap(drawn(input, mesh.Cells), mesh.Cells.back());
    mesh.Cells.pop_back();
  }
  const unsigned added = mesh.Points.empty() ? 0 : input.below(mesh.Cells.empty() ? 24 : 9);
  for (unsigned i = 0; i < added; ++i)
  {
    std::vector<vtkIdType> ids(3 + (input.below(8) == 7 ? input.below(4) : 0));
    for (vtkIdType& id : ids)
    {
      id = static_cast<vtkIdType>(input.byte() % mesh.Points.size());
    }
    mesh.addPolygon(ids);
  }
}

void changeNormals(FuzzInput& input, Numbers numbers, MeshBuilder& mesh)
{
  switch (input.below(3))
  {
    case 0:
      mesh.Normals.clear();
      return;
    case 1:
      // The body's, and something for new points.
      mesh.Normals.resize(mesh.Points.size(), { 0.0, 0.0, 1.0 });
      return;
    default:
      mesh.Normals.resize(mesh.Points.size());
      for (Vec3& normal : mesh.Normals)
      {
        normal = input.vector(numbers);
      }
  }
}
}

FuzzInput::FuzzInput(const std::uint8_t* bytes, std::size_t size)
  : Bytes(bytes)
  , Size(size)
{
}

unsigned FuzzInput::byte()
{
  if (this->Size == 0)
  {
    return 0;
  }
  --this->Size;
  return *this->Bytes++;
}

double FuzzInput::number(Numbers numbers)
{
  const unsigned kind = numbers == Numbers::Hostile ? this->byte() : 0;
  constexpr unsigned special = 160;
  constexpr unsigned specials = sizeof(HostileNumbers) / sizeof(double);
  if (kind >= special + specials)
  {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i)
    {
      bits = bits << 8 | this->byte();
    }
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  if (kind >= special)
  {
    return HostileNumbers[kind - special];
  }
  if (numbers == Numbers::Float || kind >= special / 2)
  {
    const int high = static_cast<int>(this->byte());
    return (256 * high + static_cast<int>(this->byte()) - 32768) / 4096.0;
  }
  return static_cast<int>(this->below(9)) - 4;
}

Vec3 FuzzInput::vector(Numbers numbers)
{
  Vec3 result;
  for (double& component : result)
  {
    component = this->number(numbers);
  }
  return result;
}

std::array<double, 4> FuzzInput::light(Numbers numbers)
{
  const unsigned shape = this->below(4);
  const Vec3 place = this->vector(numbers);
  return { place[0], place[1], place[2],
    shape == 0       ? 0.0
      : shape == 1   ? 1.0
                     : this->number(numbers) };
}

Mesh hostileMesh(FuzzInput& input)
{
  constexpr int types[] = { VTK_DOUBLE, VTK_DOUBLE, VTK_FLOAT, VTK_INT };
  auto mesh = Mesh::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(types[input.below(4)]);
  const Numbers numbers =
    points->GetDataType() == VTK_INT ? Numbers::Grid : static_cast<Numbers>(input.below(3));
  points->SetNumberOfPoints(static_cast<vtkIdType>(input.below(25)));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, input.vector(numbers).data());
  }
  if (points->GetNumberOfPoints() > 0 || input.flag())
  {
    mesh->SetPoints(points);
  }
  addHostileCells(input, mesh);
  addHostileNormals(input, mesh);
  return mesh;
}

Mesh smallMesh(FuzzInput& input, Numbers numbers)
{
  MeshBuilder mesh = body(input.below(Bodies));
  changePoints(input, numbers, mesh);
  changeCells(input, mesh);
  changeNormals(input, numbers, mesh);
  return mesh.build();
}
}
