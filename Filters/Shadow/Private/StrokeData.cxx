#include "StrokeData.h"

#include "FieldArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace
{
shadow::Vec3 vectorOf(vtkDataArray* array, vtkIdType id)
{
  shadow::Vec3 vector;
  array->GetTuple(id, &vector.x);
  return shadow::isFinite(vector) ? vector : shadow::Vec3(0.0);
}

vtkDataArray* vectorsNamed(vtkPolyData* input, const char* name)
{
  vtkDataArray* array = input->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == 3 &&
      array->GetNumberOfTuples() >= input->GetNumberOfPoints()
    ? array
    : nullptr;
}

class LineReader
{
public:
  LineReader(vtkPolyData* input, const shadow::StrokeView& view)
    : Input(input)
    , View(view)
    , Normals(vectorsNamed(input, "ReceiverNormals"))
    , Directions(vectorsNamed(input, "ShadowDirection"))
  {
  }

  // Changes the ids.
  void read(vtkIdType cell, std::vector<vtkIdType>& ids)
  {
    if (ids.empty())
    {
      return;
    }
    bool closed = ids.size() > 2 && this->same(ids.front(), ids.back());
    if (closed)
    {
      ids.pop_back();
      // From after a point that is left out, so that the rest is in one piece.
      const auto bad =
        std::find_if(ids.begin(), ids.end(), [this](vtkIdType id) { return !this->isDrawn(id); });
      if (bad != ids.end())
      {
        std::rotate(ids.begin(), bad, ids.end());
        closed = false;
      }
    }
    std::vector<vtkIdType> part;
    for (const vtkIdType id : ids)
    {
      if (this->isDrawn(id))
      {
        part.push_back(id);
        continue;
      }
      (this->isFinite(id) ? this->Found.hiddenPoints : this->Found.nonFinitePoints) += 1;
      if (!part.empty())
      {
        this->add(cell, part, false);
      }
      part.clear();
    }
    if (!part.empty())
    {
      this->add(cell, part, closed);
    }
  }

  StrokeInput& found() { return this->Found; }

private:
  shadow::Vec3 pointOf(vtkIdType id) const
  {
    shadow::Vec3 point;
    this->Input->GetPoint(id, &point.x);
    return point;
  }

  bool isFinite(vtkIdType id) const
  {
    return id >= 0 && id < this->Input->GetNumberOfPoints() && shadow::isFinite(this->pointOf(id));
  }

  bool isDrawn(vtkIdType id) const
  {
    return this->isFinite(id) && this->View.unit(this->pointOf(id)) > 0.0;
  }

  bool same(vtkIdType a, vtkIdType b) const
  {
    return a == b ||
      (this->isFinite(a) && this->isFinite(b) && this->pointOf(a) == this->pointOf(b));
  }

  void add(vtkIdType cell, const std::vector<vtkIdType>& part, bool closed)
  {
    shadow::StrokeLine line;
    std::vector<vtkIdType> ids;
    for (const vtkIdType id : part)
    {
      const shadow::Vec3 point = this->pointOf(id);
      if (line.points.empty() || line.points.back() != point)
      {
        line.points.push_back(point);
        ids.push_back(id);
      }
    }
    while (closed && ids.size() > 1 && line.points.back() == line.points.front())
    {
      line.points.pop_back();
      ids.pop_back();
    }
    if (ids.size() < 2)
    {
      ++this->Found.degenerateLines;
      return;
    }
    for (const vtkIdType id : ids)
    {
      if (this->Normals)
      {
        line.normals.push_back(vectorOf(this->Normals, id));
      }
      if (this->Directions)
      {
        line.directions.push_back(vectorOf(this->Directions, id));
      }
    }
    line.closed = closed && ids.size() > 2;
    line.number = this->Found.lines.size();
    this->Found.lines.push_back(std::move(line));
    this->Found.ids.push_back(std::move(ids));
    this->Found.cells.push_back(cell);
  }

  vtkPolyData* Input;
  const shadow::StrokeView& View;
  vtkDataArray* Normals;
  vtkDataArray* Directions;
  StrokeInput Found;
};

// Arrays that have values for all of them.
template <class Attributes>
vtkSmartPointer<Attributes> wholeArrays(Attributes* attributes, vtkIdType count)
{
  auto whole = vtkSmartPointer<Attributes>::New();
  whole->ShallowCopy(attributes);
  for (int i = whole->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (whole->GetAbstractArray(i)->GetNumberOfTuples() < count)
    {
      whole->RemoveArray(i);
    }
  }
  return whole;
}

void writePoints(
  const shadow::Strokes& strokes, const StrokeInput& lines, vtkPolyData* input, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(strokes.points.size()));
  vtkNew<vtkDoubleArray> across;
  across->SetName("Across");
  across->SetNumberOfValues(points->GetNumberOfPoints());
  vtkPointData* data = output->GetPointData();
  const auto from = wholeArrays(input->GetPointData(), input->GetNumberOfPoints());
  data->InterpolateAllocate(from, points->GetNumberOfPoints());
  for (std::size_t line = 0; line < lines.lines.size(); ++line)
  {
    for (std::size_t i = strokes.firstPoint[line]; i < strokes.firstPoint[line + 1]; ++i)
    {
      const shadow::StrokePoint& point = strokes.points[i];
      const auto id = static_cast<vtkIdType>(i);
      points->SetPoint(id, &point.at.x);
      across->SetValue(id, point.across);
      const vtkIdType begin = lines.ids[line][point.from];
      if (point.share == 0.0)
      {
        data->CopyData(from, begin, id);
      }
      else
      {
        data->InterpolateEdge(from, id, begin, lines.ids[line][point.to], point.share);
      }
    }
  }
  output->SetPoints(points);
  data->AddArray(across);
}

void writeTriangles(
  const shadow::Strokes& strokes, const StrokeInput& lines, vtkPolyData* input, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(strokes.triangles.size());
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(3 * count);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  offsets->SetValue(0, 0);
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("Line");
  numbers->SetNumberOfValues(count);
  // Of the input's cells vertices come before lines.
  const vtkIdType firstCell = input->GetNumberOfVerts();
  vtkCellData* data = output->GetCellData();
  const auto from = wholeArrays(input->GetCellData(), input->GetNumberOfCells());
  data->CopyAllocate(from, count);
  for (std::size_t line = 0; line < lines.lines.size(); ++line)
  {
    for (std::size_t i = strokes.firstTriangle[line]; i < strokes.firstTriangle[line + 1]; ++i)
    {
      const auto id = static_cast<vtkIdType>(i);
      for (int corner = 0; corner < 3; ++corner)
      {
        connectivity->SetValue(3 * id + corner,
          static_cast<vtkIdType>(strokes.triangles[i][static_cast<std::size_t>(corner)]));
      }
      offsets->SetValue(id + 1, 3 * (id + 1));
      numbers->SetValue(id, lines.cells[line]);
      data->CopyData(from, firstCell + lines.cells[line], id);
    }
  }
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(offsets, connectivity);
  output->SetPolys(triangles);
  data->AddArray(numbers);
}
}

StrokeInput readLines(vtkPolyData* input, const shadow::StrokeView& view)
{
  LineReader reader(input, view);
  vtkCellArray* lines = input->GetLines();
  std::vector<vtkIdType> line;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    lines->GetCellAtId(cell, count, ids);
    line.assign(ids, ids + count);
    reader.read(cell, line);
  }
  return std::move(reader.found());
}

void writeStrokes(
  const shadow::Strokes& strokes, const StrokeInput& lines, vtkPolyData* input, vtkPolyData* output)
{
  writePoints(strokes, lines, input, output);
  writeTriangles(strokes, lines, input, output);
  output->GetFieldData()->PassData(input->GetFieldData());
  addCount(output, "NonFinitePoints", static_cast<std::size_t>(lines.nonFinitePoints));
  addCount(output, "HiddenPoints", static_cast<std::size_t>(lines.hiddenPoints));
  addCount(output, "DegenerateLines", static_cast<std::size_t>(lines.degenerateLines));
}
