#include "ContourData.h"

#include "FieldArrays.h"
#include "SilhouetteChain.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace
{
vtkSmartPointer<vtkDoubleArray> vectorArray(
  const char* name, const std::vector<shadow::Vec3>& vectors)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(vectors.size()));
  double* to = array->GetPointer(0);
  for (const shadow::Vec3& v : vectors)
  {
    *to++ = v.x;
    *to++ = v.y;
    *to++ = v.z;
  }
  return array;
}

template <class Value>
void addCellArray(vtkPolyData* output, const char* name, const shadow::CastContours& contours,
  const Value& value)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(contours.lines.size()));
  std::transform(contours.lines.begin(), contours.lines.end(), array->GetPointer(0), value);
  output->GetCellData()->AddArray(array);
}

void writeLines(const shadow::CastContours& contours, vtkPolyData* output)
{
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  offsets->InsertNextValue(0);
  for (std::size_t line = 0; line < contours.lines.size(); ++line)
  {
    for (std::size_t i = contours.first[line]; i < contours.first[line + 1]; ++i)
    {
      connectivity->InsertNextValue(static_cast<vtkIdType>(i));
    }
    if (contours.lines[line].closed)
    {
      connectivity->InsertNextValue(static_cast<vtkIdType>(contours.first[line]));
    }
    offsets->InsertNextValue(connectivity->GetNumberOfValues());
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  output->SetLines(cells);
}
}

void addSilhouette(vtkPolyData* silhouette, int number, ContourInput& contours)
{
  vtkCellArray* lines = silhouette->GetLines();
  vtkDataArray* kind = silhouette->GetFieldData()->GetArray("SilhouetteKind");
  const bool isOfEdges = !kind || kind->GetNumberOfTuples() < 1 ||
    kind->GetComponent(0, 0) == static_cast<int>(shadow::SilhouetteKind::Discrete);
  vtkDataArray* onMesh = silhouette->GetPointData()->GetArray("MeshPoints");
  const bool hasMeshPoints = onMesh && onMesh->GetNumberOfComponents() == 3;
  std::vector<shadow::Vec3> points;
  std::vector<shadow::Vec3> meshPoints;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    lines->GetCellAtId(cell, count, ids);
    points.clear();
    meshPoints.clear();
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (ids[i] >= 0 && ids[i] < silhouette->GetNumberOfPoints())
      {
        shadow::Vec3 point;
        silhouette->GetPoint(ids[i], &point.x);
        shadow::Vec3 meshPoint = point;
        if (hasMeshPoints)
        {
          onMesh->GetTuple(ids[i], &meshPoint.x);
        }
        if (shadow::isFinite(point) && shadow::isFinite(meshPoint))
        {
          points.push_back(point);
          meshPoints.push_back(meshPoint);
        }
      }
    }
    if (count < 2 || points.size() != static_cast<std::size_t>(count))
    {
      continue;
    }
    const bool closed = points.front() == points.back();
    if (closed)
    {
      points.pop_back();
      meshPoints.pop_back();
    }
    if (points.size() < 2)
    {
      continue;
    }
    contours.scene.loops.add(points, meshPoints, closed, isOfEdges);
    contours.input.push_back(number);
    contours.cell.push_back(static_cast<int>(cell));
  }
}

namespace
{
// Homogeneous: any positive multiple is the same.
bool isSameLight(const double a[4], const double b[4])
{
  const auto largest = [](const double light[4]) {
    return std::max({ std::abs(light[0]), std::abs(light[1]), std::abs(light[2]),
      std::abs(light[3]) });
  };
  const double scaleA = largest(a);
  const double scaleB = largest(b);
  constexpr double roundings = 4.0 * std::numeric_limits<double>::epsilon();
  return std::equal(a, a + 4, b, [&](double x, double y) {
    return std::abs(x / scaleA - y / scaleB) <= roundings;
  });
}
}

SilhouetteLight lightOf(const std::vector<vtkPolyData*>& silhouettes, double light[4])
{
  SilhouetteLight found = SilhouetteLight::None;
  for (vtkPolyData* silhouette : silhouettes)
  {
    vtkDataArray* array = silhouette->GetFieldData()->GetArray("LightPosition");
    if (!array || array->GetNumberOfComponents() != 4 || array->GetNumberOfTuples() < 1)
    {
      continue;
    }
    double own[4];
    array->GetTuple(0, own);
    if (found == SilhouetteLight::None)
    {
      std::copy_n(own, 4, light);
      found = SilhouetteLight::Same;
    }
    else if (!isSameLight(own, light))
    {
      return SilhouetteLight::Different;
    }
  }
  return found;
}

shadow::CastContours onGrid(const shadow::CastContours& contours, double spacing)
{
  shadow::CastContours moved;
  for (std::size_t line = 0; line < contours.lines.size(); ++line)
  {
    const std::size_t start = moved.points.size();
    const auto takeBack = [&](std::size_t count)
    {
      for (auto* vectors : { &moved.points, &moved.normals, &moved.directions, &moved.casters })
      {
        vectors->resize(count);
      }
    };
    for (std::size_t i = contours.first[line]; i < contours.first[line + 1]; ++i)
    {
      // A spacing may be too small to divide by.
      const shadow::Vec3 rounded = spacing * glm::round(contours.points[i] / spacing);
      const shadow::Vec3 at = shadow::isFinite(rounded) ? rounded : contours.points[i];
      if (moved.points.size() > start && moved.points.back() == at)
      {
        continue;
      }
      moved.points.push_back(at);
      moved.normals.push_back(contours.normals[i]);
      moved.directions.push_back(contours.directions[i]);
      moved.casters.push_back(contours.casters[i]);
    }
    const bool closed = contours.lines[line].closed;
    if (closed && moved.points.size() > start + 1 && moved.points[start] == moved.points.back())
    {
      takeBack(moved.points.size() - 1);
    }
    if (moved.points.size() < start + (closed ? 3 : 2))
    {
      takeBack(start);
      continue;
    }
    moved.first.push_back(moved.points.size());
    moved.lines.push_back(contours.lines[line]);
  }
  return moved;
}

void writeContours(const shadow::CastContours& contours, const ContourInput& input,
  const shadow::ContourReport& report, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(vectorArray("Points", contours.points));
  output->SetPoints(points);
  output->GetPointData()->AddArray(vectorArray("ReceiverNormals", contours.normals));
  output->GetPointData()->AddArray(vectorArray("ShadowDirection", contours.directions));
  output->GetPointData()->AddArray(vectorArray("CasterPoints", contours.casters));
  writeLines(contours, output);
  using Line = shadow::ContourLine;
  addCellArray(output, "Receiver", contours,
    [](const Line& line) { return static_cast<int>(line.receiver); });
  addCellArray(
    output, "Caster", contours, [&](const Line& line) { return input.input[line.loop]; });
  addCellArray(output, "Loop", contours, [&](const Line& line) { return input.cell[line.loop]; });
  addCellArray(output, "Visible", contours, [](const Line& line) { return line.visible ? 1 : 0; });
  addCellArray(output, "Closed", contours, [](const Line& line) { return line.closed ? 1 : 0; });
  addLightPosition(output, input.light);
  addCount(output, "LooseEnds", report.loose);
  addCount(output, "NodesVisited", report.visits.nodes);
  addCount(output, "LeavesTested", report.visits.leaves);
  addField<vtkDoubleArray>(output, "BuildSeconds", { report.seconds.build });
  addField<vtkDoubleArray>(output, "QuerySeconds", { report.seconds.query });
  addField<vtkDoubleArray>(output, "HiddenSeconds", { report.seconds.hidden });
}
