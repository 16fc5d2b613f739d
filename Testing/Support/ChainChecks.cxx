#include "ChainChecks.h"

#include "Tolerances.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
#include <ostream>
#include <utility>
#include <vector>

namespace shadowtest
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
using Vec4 = std::array<double, 4>;

std::vector<Vec4> homogeneousPoints(vtkPolyData* mesh)
{
  vtkDataArray* homogeneous = mesh->GetPointData()->GetArray("Homogeneous");
  std::vector<Vec4> points(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Vec4& point = points[static_cast<std::size_t>(i)];
    if (homogeneous)
    {
      homogeneous->GetTuple(i, point.data());
    }
    else
    {
      mesh->GetPoint(i, point.data());
      point[3] = 1.0;
    }
  }
  return points;
}

struct WeightedCell
{
  std::vector<vtkIdType> Ids;
  vtkIdType Multiplicity;
};

// Cell data is ordered verts, lines, polys, strips; `offset` is the cell id of the array's first.
std::vector<WeightedCell> weightedCells(vtkPolyData* mesh, vtkCellArray* cells, vtkIdType offset)
{
  vtkDataArray* multiplicity = mesh->GetCellData()->GetArray("Multiplicity");
  std::vector<WeightedCell> result;
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    const vtkIdType id = offset + cell->GetCurrentCellId();
    const bool has = multiplicity && id < multiplicity->GetNumberOfTuples();
    result.push_back({ std::vector<vtkIdType>(ids, ids + size),
      has ? static_cast<vtkIdType>(multiplicity->GetTuple1(id)) : 1 });
  }
  return result;
}

// Strips are taken apart: every other triangle of one is wound the other way.
std::vector<WeightedCell> weightedPolygons(vtkPolyData* mesh)
{
  const vtkIdType first = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  std::vector<WeightedCell> polygons = weightedCells(mesh, mesh->GetPolys(), first);
  for (const WeightedCell& strip :
    weightedCells(mesh, mesh->GetStrips(), first + mesh->GetNumberOfPolys()))
  {
    for (std::size_t i = 2; i < strip.Ids.size(); ++i)
    {
      const std::size_t odd = i % 2;
      polygons.push_back({ { strip.Ids[i - 2 + odd], strip.Ids[i - 1 - odd], strip.Ids[i] },
        strip.Multiplicity });
    }
  }
  return polygons;
}

vtkIdType openEdges(vtkPolyData* mesh, const std::vector<vtkIdType>& point)
{
  std::vector<std::pair<std::pair<vtkIdType, vtkIdType>, vtkIdType>> edges;
  for (const WeightedCell& cell : weightedPolygons(mesh))
  {
    for (std::size_t i = 0; i < cell.Ids.size(); ++i)
    {
      const vtkIdType a = point[static_cast<std::size_t>(cell.Ids[i])];
      const vtkIdType b = point[static_cast<std::size_t>(cell.Ids[(i + 1) % cell.Ids.size()])];
      if (a != b)
      {
        edges.push_back({ std::minmax(a, b), a < b ? cell.Multiplicity : -cell.Multiplicity });
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  vtkIdType open = 0;
  for (std::size_t i = 0; i < edges.size();)
  {
    vtkIdType sum = 0;
    std::size_t end = i;
    for (; end < edges.size() && edges[end].first == edges[i].first; ++end)
    {
      sum += edges[end].second;
    }
    open += sum != 0;
    i = end;
  }
  return open;
}

struct Double3
{
  double X;
  double Y;
  double Z;
};

Double3 seenFrom(const Vec4& point, const double from[3])
{
  return { point[0] - point[3] * from[0], point[1] - point[3] * from[1],
    point[2] - point[3] * from[2] };
}

double dot(const Double3& a, const Double3& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}

double determinant(const Double3& a, const Double3& b, const Double3& c)
{
  return a.X * (b.Y * c.Z - b.Z * c.Y) - a.Y * (b.X * c.Z - b.Z * c.X) +
    a.Z * (b.X * c.Y - b.Y * c.X);
}

bool toUnit(Double3& v)
{
  const double length = std::sqrt(dot(v, v));
  if (!(length > 0.0))
  {
    return false;
  }
  v = { v.X / length, v.Y / length, v.Z / length };
  return true;
}

// Van Oosterom & Strackee 1983. For a point at infinity its direction is all that is needed, so a
// triangle with corners there needs no truncation.
double solidAngle(Double3 a, Double3 b, Double3 c)
{
  if (!toUnit(a) || !toUnit(b) || !toUnit(c))
  {
    return 0.0;
  }
  return 2.0 * std::atan2(determinant(a, b, c), 1.0 + dot(a, b) + dot(b, c) + dot(c, a));
}
}

vtkIdType openEdges(vtkPolyData* polygons)
{
  std::vector<vtkIdType> identity(static_cast<std::size_t>(polygons->GetNumberOfPoints()));
  for (std::size_t i = 0; i < identity.size(); ++i)
  {
    identity[i] = static_cast<vtkIdType>(i);
  }
  return openEdges(polygons, identity);
}

vtkIdType openEdgesByCoordinates(vtkPolyData* polygons)
{
  std::map<Vec4, vtkIdType> first;
  std::vector<vtkIdType> welded;
  for (Vec4 point : homogeneousPoints(polygons))
  {
    for (double& coordinate : point)
    {
      coordinate += 0.0; // -0 and 0 are one place
    }
    welded.push_back(first.emplace(point, static_cast<vtkIdType>(welded.size())).first->second);
  }
  return openEdges(polygons, welded);
}

bool LoopReport::good() const
{
  return this->OpenLoops == 0 && this->ShortLoops == 0 && this->NonFinitePoints == 0 &&
    this->UnbalancedPoints == 0 && this->BadMultiplicities == 0 && this->NormalError <= 1e-12;
}

std::ostream& operator<<(std::ostream& out, const LoopReport& report)
{
  return out << report.Loops << " loops, " << report.Segments << " segments; open "
             << report.OpenLoops << ", short " << report.ShortLoops << ", points not finite "
             << report.NonFinitePoints << ", unbalanced " << report.UnbalancedPoints
             << ", bad multiplicities " << report.BadMultiplicities << ", normals "
             << (report.HasNormals ? "off by " : "missing: ") << report.NormalError;
}

LoopReport checkLoops(vtkPolyData* silhouette)
{
  LoopReport report;
  std::map<vtkIdType, vtkIdType> balance;
  const auto loops =
    weightedCells(silhouette, silhouette->GetLines(), silhouette->GetNumberOfVerts());
  vtkDataArray* multiplicity = silhouette->GetCellData()->GetArray("Multiplicity");
  if (multiplicity && multiplicity->GetNumberOfTuples() != silhouette->GetNumberOfCells())
  {
    ++report.BadMultiplicities;
  }
  for (const WeightedCell& loop : loops)
  {
    ++report.Loops;
    report.BadMultiplicities += loop.Multiplicity < 1;
    report.ShortLoops += loop.Ids.size() < 3;
    report.OpenLoops += loop.Ids.empty() || loop.Ids.front() != loop.Ids.back();
    for (std::size_t i = 1; i < loop.Ids.size(); ++i)
    {
      ++report.Segments;
      balance[loop.Ids[i - 1]] -= loop.Multiplicity;
      balance[loop.Ids[i]] += loop.Multiplicity;
    }
  }
  report.UnbalancedPoints = std::count_if(
    balance.begin(), balance.end(), [](const auto& entry) { return entry.second != 0; });

  vtkDataArray* normals = silhouette->GetPointData()->GetArray("Normals");
  report.HasNormals = normals != nullptr;
  for (vtkIdType i = 0; i < silhouette->GetNumberOfPoints(); ++i)
  {
    double p[3];
    silhouette->GetPoint(i, p);
    report.NonFinitePoints += !(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
    if (normals)
    {
      double n[3];
      normals->GetTuple(i, n);
      const double error = std::abs(std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) - 1.0);
      // Not std::max: a NaN must not be lost.
      report.NormalError = error <= report.NormalError ? report.NormalError
        : std::isfinite(error)                         ? error
                                                       : std::numeric_limits<double>::infinity();
    }
  }
  return report;
}

vtkIdType nonFiniteNumbers(vtkPolyData* data)
{
  vtkIdType count = 0;
  const auto add = [&count](vtkDataArray* array) {
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        count += !std::isfinite(array->GetComponent(i, c));
      }
    }
  };
  add(data->GetPoints() ? data->GetPoints()->GetData() : nullptr);
  for (vtkFieldData* arrays : std::initializer_list<vtkFieldData*>{
         data->GetPointData(), data->GetCellData(), data->GetFieldData() })
  {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      add(arrays->GetArray(i));
    }
  }
  return count;
}

VolumeWinding::VolumeWinding(vtkPolyData* volume)
  : Points(homogeneousPoints(volume))
{
  for (const WeightedCell& cell : weightedPolygons(volume))
  {
    auto corner = [&](std::size_t i) { return static_cast<std::size_t>(cell.Ids[i]); };
    for (std::size_t i = 2; i < cell.Ids.size(); ++i)
    {
      this->Triangles.push_back(
        { { corner(0), corner(i - 1), corner(i) }, static_cast<double>(cell.Multiplicity) });
    }
  }
}

double VolumeWinding::around(const double point[3]) const
{
  double sum = 0.0;
  for (const WeightedTriangle& triangle : this->Triangles)
  {
    const auto corner = [&](std::size_t i) {
      return seenFrom(this->Points[triangle.Corners[i]], point);
    };
    sum += triangle.Multiplicity * solidAngle(corner(0), corner(1), corner(2));
  }
  return sum / (4.0 * Pi);
}

double windingNumber(vtkPolyData* volume, const double point[3])
{
  return VolumeWinding(volume).around(point);
}

double enclosedVolume(vtkPolyData* polygons)
{
  const std::vector<Vec4> points = homogeneousPoints(polygons);
  if (points.empty())
  {
    return 0.0;
  }
  // About a point of the mesh, so that a mesh far away keeps its digits.
  const double origin[3] = { points[0][0], points[0][1], points[0][2] };
  double sum = 0.0;
  for (const WeightedCell& cell : weightedPolygons(polygons))
  {
    auto corner = [&](std::size_t i) {
      return seenFrom(points[static_cast<std::size_t>(cell.Ids[i])], origin);
    };
    for (std::size_t i = 2; i < cell.Ids.size(); ++i)
    {
      sum +=
        static_cast<double>(cell.Multiplicity) * determinant(corner(0), corner(i - 1), corner(i));
    }
  }
  return sum / 6.0;
}

Blockers blockersTowards(vtkPolyData* mesh, const double point[3], const double light[4])
{
  const std::vector<Vec4> points = homogeneousPoints(mesh);
  const Double3 ray{ light[0] - light[3] * point[0], light[1] - light[3] * point[1],
    light[2] - light[3] * point[2] };
  Blockers blockers;
  for (const WeightedCell& cell : weightedPolygons(mesh))
  {
    for (std::size_t i = 2; i < cell.Ids.size(); ++i)
    {
      const Double3 a = seenFrom(points[static_cast<std::size_t>(cell.Ids[0])], point);
      const Double3 b = seenFrom(points[static_cast<std::size_t>(cell.Ids[i - 1])], point);
      const Double3 c = seenFrom(points[static_cast<std::size_t>(cell.Ids[i])], point);
      // Signed volumes of the ray with the triangle's edges: all of one sign where it hits.
      const double u = determinant(ray, b, c);
      const double v = determinant(ray, c, a);
      const double w = determinant(ray, a, b);
      const double sum = u + v + w;
      const double scale = std::sqrt(dot(ray, ray) * dot(a, a) * dot(b, b));
      if (std::abs(sum) <= tolerance::TooClose * scale)
      {
        continue; // edge-on or without area: it hides nothing
      }
      const double least = std::min({ u / sum, v / sum, w / sum });
      // a, b, c seen along the ray: at t the ray is in their plane; the light is at t = 1 / w.
      const double t = determinant(a, b, c) / sum;
      const double clearance = std::min(t, light[3] == 0.0 ? t : 1.0 - light[3] * t);
      const double margin = std::min(least, clearance);
      blockers.Margin = std::min(blockers.Margin, std::abs(margin));
      if (margin > 0.0)
      {
        ++blockers.Count;
        blockers.Signed += sum > 0.0 ? 1 : -1;
      }
    }
  }
  return blockers;
}
}
