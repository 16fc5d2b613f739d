#include "RegionData.h"

#include "FieldArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributesFieldList.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkSignedCharArray.h"

namespace
{
// Attributes without arrays that have too few tuples.
vtkSmartPointer<vtkDataSetAttributes> complete(vtkDataSetAttributes* attributes, vtkIdType count)
{
  auto copy = vtkSmartPointer<vtkDataSetAttributes>::New();
  copy->ShallowCopy(attributes);
  for (int i = copy->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (copy->GetAbstractArray(i)->GetNumberOfTuples() < count)
    {
      copy->RemoveArray(i);
    }
  }
  return copy;
}

// The attributes of several inputs: what all of them have.
class CommonArrays
{
public:
  CommonArrays(std::vector<vtkSmartPointer<vtkDataSetAttributes>> from, int how,
    vtkDataSetAttributes* to, vtkIdType count)
    : From(std::move(from))
    , To(to)
  {
    for (vtkDataSetAttributes* attributes : this->From)
    {
      this->List.IntersectFieldList(attributes);
    }
    if (!this->From.empty())
    {
      this->List.CopyAllocate(this->To, how, count, 0);
    }
  }

  void copy(std::size_t input, vtkIdType from, vtkIdType to)
  {
    this->List.CopyData(static_cast<int>(input), this->From[input], from, this->To, to);
  }

  void interpolate(std::size_t input, vtkIdList* ids, double* weights, vtkIdType to)
  {
    this->List.InterpolatePoint(
      static_cast<int>(input), this->From[input], ids, weights, this->To, to);
  }

private:
  std::vector<vtkSmartPointer<vtkDataSetAttributes>> From;
  vtkDataSetAttributes* To;
  vtkDataSetAttributesFieldList List;
};

void writePoints(const std::vector<shadow::LitRegions>& regions, const ContourInput& input,
  vtkPolyData* output)
{
  vtkIdType count = 0;
  std::vector<vtkSmartPointer<vtkDataSetAttributes>> attributes;
  for (std::size_t receiver = 0; receiver < regions.size(); ++receiver)
  {
    count += static_cast<vtkIdType>(regions[receiver].points.size());
    vtkPolyData* mesh = input.meshes[receiver];
    attributes.push_back(complete(mesh->GetPointData(), mesh->GetNumberOfPoints()));
  }
  CommonArrays arrays(attributes, vtkDataSetAttributes::INTERPOLATE, output->GetPointData(), count);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkIdList> ids;
  vtkIdType to = 0;
  for (std::size_t receiver = 0; receiver < regions.size(); ++receiver)
  {
    const std::vector<shadow::Index>& sources = input.receivers[receiver]->mesh.sources;
    for (const shadow::RegionPoint& point : regions[receiver].points)
    {
      points->SetPoint(to, &point.place.x);
      ids->Reset();
      for (const shadow::Index vertex : point.vertices)
      {
        if (vertex != shadow::None)
        {
          ids->InsertNextId(static_cast<vtkIdType>(sources[vertex]));
        }
      }
      shadow::Vec3 weights = point.weights;
      arrays.interpolate(receiver, ids, &weights.x, to);
      ++to;
    }
  }
  output->SetPoints(points);
}

void writePolygons(const std::vector<shadow::LitRegions>& regions, vtkPolyData* output)
{
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  offsets->InsertNextValue(0);
  vtkIdType firstPoint = 0;
  for (const shadow::LitRegions& one : regions)
  {
    const vtkIdType before = connectivity->GetNumberOfValues();
    for (const shadow::Index corner : one.corners)
    {
      connectivity->InsertNextValue(firstPoint + static_cast<vtkIdType>(corner));
    }
    for (std::size_t cell = 0; cell < one.triangles.size(); ++cell)
    {
      offsets->InsertNextValue(before + static_cast<vtkIdType>(one.first[cell + 1]));
    }
    firstPoint += static_cast<vtkIdType>(one.points.size());
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  output->SetPolys(cells);
}

template <class Array>
vtkSmartPointer<Array> namedArray(const char* name, vtkIdType count)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfValues(count);
  return array;
}

void writeCellData(const std::vector<shadow::LitRegions>& regions, const ContourInput& input,
  vtkPolyData* output)
{
  const vtkIdType count = output->GetNumberOfPolys();
  std::vector<vtkSmartPointer<vtkDataSetAttributes>> attributes;
  for (std::size_t receiver = 0; receiver < regions.size(); ++receiver)
  {
    vtkPolyData* mesh = input.meshes[receiver];
    attributes.push_back(complete(mesh->GetCellData(), mesh->GetNumberOfCells()));
  }
  CommonArrays arrays(attributes, vtkDataSetAttributes::COPYTUPLE, output->GetCellData(), count);
  // Unsigned ones would be taken for colours.
  const auto lit = namedArray<vtkSignedCharArray>("Lit", count);
  const auto turnedAway = namedArray<vtkSignedCharArray>("TurnedAway", count);
  const auto receivers = namedArray<vtkIntArray>("Receiver", count);
  const auto cells = namedArray<vtkIdTypeArray>("ReceiverCell", count);
  vtkIdType to = 0;
  for (std::size_t receiver = 0; receiver < regions.size(); ++receiver)
  {
    const shadow::LitRegions& one = regions[receiver];
    for (std::size_t i = 0; i < one.triangles.size(); ++i, ++to)
    {
      const vtkIdType cell = input.receivers[receiver]->cells[one.triangles[i]];
      lit->SetValue(to, one.illumination[i] == shadow::Illumination::Lit);
      turnedAway->SetValue(to, one.illumination[i] == shadow::Illumination::TurnedAway);
      receivers->SetValue(to, static_cast<int>(receiver));
      cells->SetValue(to, cell);
      arrays.copy(receiver, cell, to);
    }
  }
  output->GetCellData()->AddArray(turnedAway);
  output->GetCellData()->AddArray(receivers);
  output->GetCellData()->AddArray(cells);
  output->GetCellData()->AddArray(lit);
  output->GetCellData()->SetActiveScalars("Lit");
}

void writeAreas(const std::vector<shadow::LitRegions>& regions, vtkPolyData* output,
  const char* name, shadow::Illumination illumination)
{
  const auto areas = namedArray<vtkDoubleArray>(name, static_cast<vtkIdType>(regions.size()));
  for (std::size_t receiver = 0; receiver < regions.size(); ++receiver)
  {
    areas->SetValue(static_cast<vtkIdType>(receiver),
      regions[receiver].areas[static_cast<std::size_t>(illumination)]);
  }
  output->GetFieldData()->AddArray(areas);
}
}

void writeRegions(const std::vector<shadow::LitRegions>& regions, const ContourInput& input,
  vtkPolyData* output)
{
  writePoints(regions, input, output);
  writePolygons(regions, output);
  writeCellData(regions, input, output);
  writeAreas(regions, output, "LitArea", shadow::Illumination::Lit);
  writeAreas(regions, output, "ShadowedArea", shadow::Illumination::Shadowed);
  writeAreas(regions, output, "TurnedAwayArea", shadow::Illumination::TurnedAway);
  addLightPosition(output, input.light);
}
