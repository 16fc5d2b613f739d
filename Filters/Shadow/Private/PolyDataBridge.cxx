#include "PolyDataBridge.h"

#include "VertexWelding.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
struct PointTriangle
{
  std::array<vtkIdType, 3> corners;
  vtkIdType cell; // of the input
};

std::vector<shadow::Vec3> readVectors(vtkDataArray* array)
{
  std::vector<shadow::Vec3> vectors(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < vectors.size(); ++i)
  {
    array->GetTuple(static_cast<vtkIdType>(i), &vectors[i].x);
  }
  return vectors;
}

// The triangles of all cells, over the input's points.
class TriangleReader
{
public:
  TriangleReader(
    vtkPolyData* input, const std::vector<shadow::Vec3>& points, ReadingDefects& defects)
    : Input(input)
    , Points(points)
    , Defects(defects)
  {
  }

  std::vector<PointTriangle> read()
  {
    // Cells are numbered by kind, in this order.
    this->Cell = this->Input->GetNumberOfVerts() + this->Input->GetNumberOfLines();
    this->forEachCell(this->Input->GetPolys(),
      [this](vtkIdType count, const vtkIdType* ids) { this->addPolygon(count, ids); });
    this->forEachCell(this->Input->GetStrips(),
      [this](vtkIdType count, const vtkIdType* ids) { this->addStrip(count, ids); });
    return std::move(this->Triangles);
  }

private:
  template <class Visit>
  void forEachCell(vtkCellArray* cells, const Visit& visit)
  {
    if (!cells)
    {
      return;
    }
    auto cell = vtk::TakeSmartPointer(cells->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
    {
      vtkIdType count;
      const vtkIdType* ids;
      cell->GetCurrentCell(count, ids);
      if (this->isUsable(count, ids))
      {
        visit(count, ids);
      }
      ++this->Cell;
    }
  }

  bool isUsable(vtkIdType count, const vtkIdType* ids)
  {
    if (count < 3)
    {
      this->Defects.degenerateCells.add(this->placeOf(count, ids));
      return false;
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (!this->isFinitePoint(ids[i]))
      {
        this->Defects.nonFiniteCells.add(this->placeOf(count, ids));
        return false;
      }
    }
    return true;
  }

  bool isFinitePoint(vtkIdType id) const
  {
    return id >= 0 && static_cast<std::size_t>(id) < this->Points.size() &&
      shadow::isFinite(this->Points[static_cast<std::size_t>(id)]);
  }

  shadow::Vec3 placeOf(vtkIdType count, const vtkIdType* ids) const
  {
    const vtkIdType* finite =
      std::find_if(ids, ids + count, [this](vtkIdType id) { return this->isFinitePoint(id); });
    return finite != ids + count ? this->Points[static_cast<std::size_t>(*finite)]
                                 : shadow::Occurrences().place;
  }

  void addTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    this->Triangles.push_back({ { a, b, c }, this->Cell });
  }

  void addPolygon(vtkIdType count, const vtkIdType* ids)
  {
    if (count == 3)
    {
      this->addTriangle(ids[0], ids[1], ids[2]);
      return;
    }
    this->Polygon->PointIds->SetNumberOfIds(count);
    this->Polygon->Points->SetNumberOfPoints(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      this->Polygon->PointIds->SetId(i, ids[i]);
      this->Polygon->Points->SetPoint(i, &this->Points[static_cast<std::size_t>(ids[i])].x);
    }
    if (this->Polygon->Triangulate(this->Corners))
    {
      for (vtkIdType i = 0; i + 2 < this->Corners->GetNumberOfIds(); i += 3)
      {
        this->addTriangle(ids[this->Corners->GetId(i)], ids[this->Corners->GetId(i + 1)],
          ids[this->Corners->GetId(i + 2)]);
      }
      return;
    }
    // Ear cutting gives up on polygons that cross themselves or have no area. A fan has the same
    // boundary, so a closed mesh stays closed.
    this->Defects.crossedPolygons.add(this->placeOf(count, ids));
    for (vtkIdType i = 2; i < count; ++i)
    {
      this->addTriangle(ids[0], ids[i - 1], ids[i]);
    }
  }

  void addStrip(vtkIdType count, const vtkIdType* ids)
  {
    for (vtkIdType i = 2; i < count; ++i)
    {
      const bool odd = i % 2 == 1;
      this->addTriangle(ids[odd ? i - 1 : i - 2], ids[odd ? i - 2 : i - 1], ids[i]);
    }
  }

  vtkPolyData* Input;
  const std::vector<shadow::Vec3>& Points;
  ReadingDefects& Defects;
  std::vector<PointTriangle> Triangles;
  vtkIdType Cell = 0; // the one that is read
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Corners;
};

// Of polygons or strips.
vtkIdType countTriangles(vtkCellArray* cells)
{
  vtkIdType count = 0;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    count += std::max<vtkIdType>(cells->GetCellSize(cell) - 2, 0);
  }
  return count;
}

// The points that triangles use, in order of first use, and the place of each there.
std::vector<vtkIdType> usedPoints(
  const std::vector<PointTriangle>& triangles, std::vector<shadow::Index>& place)
{
  std::vector<vtkIdType> used;
  for (const PointTriangle& t : triangles)
  {
    for (const vtkIdType id : t.corners)
    {
      shadow::Index& p = place[static_cast<std::size_t>(id)];
      if (p == shadow::None)
      {
        p = static_cast<shadow::Index>(used.size());
        used.push_back(id);
      }
    }
  }
  return used;
}

std::vector<shadow::Vec3> gather(
  const std::vector<shadow::Vec3>& vectors, const std::vector<vtkIdType>& ids)
{
  std::vector<shadow::Vec3> gathered;
  gathered.reserve(ids.size());
  for (const vtkIdType id : ids)
  {
    gathered.push_back(vectors[static_cast<std::size_t>(id)]);
  }
  return gathered;
}

shadow::Welding identity(std::size_t count)
{
  shadow::Welding welding;
  for (std::size_t i = 0; i < count; ++i)
  {
    welding.target.push_back(static_cast<shadow::Index>(i));
  }
  welding.first = welding.target;
  return welding;
}

void countUnusable(const std::vector<shadow::Vec3>& unitNormals,
  const std::vector<shadow::Vec3>& points, shadow::Occurrences& unusable)
{
  for (std::size_t i = 0; i < unitNormals.size(); ++i)
  {
    if (unitNormals[i] == shadow::Vec3(0.0))
    {
      unusable.add(points[i]);
    }
  }
}

// The welding of normals is empty where there are none.
void countRepeated(const std::vector<shadow::Vec3>& points, const shadow::Welding& vertices,
  const shadow::Welding& normals, shadow::Occurrences& repeated)
{
  const auto isFirst = [](const shadow::Welding& welding, std::size_t i)
  { return welding.first[welding.target[i]] == i; };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!isFirst(vertices, i) && (normals.target.empty() || !isFirst(normals, i)))
    {
      repeated.add(points[i]);
    }
  }
}

shadow::Triangle mapped(const PointTriangle& t, const std::vector<shadow::Index>& place,
  const std::vector<shadow::Index>& target)
{
  shadow::Triangle result;
  for (std::size_t k = 0; k < 3; ++k)
  {
    result[k] = target[place[static_cast<std::size_t>(t.corners[k])]];
  }
  return result;
}
}

BridgedMesh readMesh(vtkPolyData* input, bool mergePoints)
{
  BridgedMesh result;
  shadow::TriangleMesh& mesh = result.mesh;
  // Cells over no points at all are counted as those with some that do not exist.
  const std::vector<shadow::Vec3> allPoints =
    input->GetPoints() ? readVectors(input->GetPoints()->GetData()) : std::vector<shadow::Vec3>();
  const std::vector<PointTriangle> triangles =
    TriangleReader(input, allPoints, result.defects).read();
  std::vector<shadow::Index> place(allPoints.size(), shadow::None);
  const std::vector<vtkIdType> used = usedPoints(triangles, place);

  const std::vector<shadow::Vec3> points = gather(allPoints, used);
  const shadow::Welding vertices =
    mergePoints ? shadow::weldPoints(points) : identity(points.size());
  mesh.points.reserve(vertices.first.size());
  mesh.sources.reserve(vertices.first.size());
  for (const shadow::Index i : vertices.first)
  {
    mesh.points.push_back(points[i]);
    mesh.sources.push_back(static_cast<shadow::Index>(used[i]));
  }

  vtkDataArray* normalArray = input->GetPointData()->GetNormals();
  const bool hasNormals = normalArray && normalArray->GetNumberOfComponents() == 3 &&
    normalArray->GetNumberOfTuples() == input->GetNumberOfPoints();
  shadow::Welding normals;
  if (hasNormals)
  {
    std::vector<shadow::Vec3> given = gather(readVectors(normalArray), used);
    for (shadow::Vec3& normal : given)
    {
      // To equal one another: those that are no numbers are estimated later, like those of zero.
      normal = shadow::unitOrZero(normal);
    }
    countUnusable(given, points, result.defects.unusableNormals);
    normals = shadow::weldNormals(given, vertices.target);
    mesh.normals.reserve(normals.first.size());
    mesh.normalVertex.reserve(normals.first.size());
    for (const shadow::Index i : normals.first)
    {
      mesh.normals.push_back(given[i]);
      mesh.normalVertex.push_back(vertices.target[i]);
    }
  }
  countRepeated(points, vertices, normals, result.defects.repeatedPoints);
  mesh.triangles.reserve(triangles.size());
  result.cells.reserve(triangles.size());
  mesh.cornerNormals.reserve(hasNormals ? triangles.size() : 0);
  for (const PointTriangle& t : triangles)
  {
    const shadow::Triangle corners = mapped(t, place, vertices.target);
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
    {
      result.defects.degenerateCells.add(mesh.points[corners[0]]);
      continue;
    }
    mesh.triangles.push_back(corners);
    result.cells.push_back(t.cell);
    if (hasNormals)
    {
      mesh.cornerNormals.push_back(mapped(t, place, normals.target));
    }
  }
  return result;
}

bool isTooLarge(vtkPolyData* input)
{
  // Vertices and sides are numbered together in 32 bits.
  constexpr vtkIdType mostPoints = vtkIdType(1) << 30;
  constexpr vtkIdType mostSides = vtkIdType(1) << 31;
  const vtkIdType ids = input->GetPolys()->GetNumberOfConnectivityIds() +
    input->GetStrips()->GetNumberOfConnectivityIds();
  return input->GetNumberOfPoints() > mostPoints ||
    (3 * ids > mostSides &&
      3 * (countTriangles(input->GetPolys()) + countTriangles(input->GetStrips())) > mostSides);
}

std::string describeTooLarge(vtkPolyData* input)
{
  std::ostringstream message;
  message << "The mesh of " << input->GetNumberOfPoints() << " points and "
          << input->GetNumberOfCells()
          << " cells is too large: at most 2^30 points, and 2^31 corners of triangles.";
  return message.str();
}

bool readLight(const double position[4], shadow::Light& light)
{
  double largest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    if (!std::isfinite(position[i]))
    {
      return false;
    }
    largest = std::fmax(largest, std::fabs(position[i]));
  }
  const shadow::Vec3 place(position[0], position[1], position[2]);
  const shadow::Vec3 point = place / position[3];
  if (position[3] != 0.0 && shadow::isFinite(point))
  {
    light = { point, 1.0 };
    return true;
  }
  // By a power of two, so that ties stay ties. A point that is too far for doubles lies opposite to
  // its first three components where w is below zero.
  int exponent;
  std::frexp(largest, &exponent);
  const shadow::Vec3 toward = position[3] < 0.0 ? -place : place;
  light.position = shadow::Vec3(std::ldexp(toward.x, -exponent),
    std::ldexp(toward.y, -exponent), std::ldexp(toward.z, -exponent));
  light.w = 0.0;
  return light.position != shadow::Vec3(0.0);
}

std::string describeBadLight(const double position[4])
{
  std::ostringstream message;
  message << "LightPosition (" << position[0] << ", " << position[1] << ", " << position[2] << ", "
          << position[3] << ") is no light: its components must be finite and not all zero.";
  return message.str();
}
