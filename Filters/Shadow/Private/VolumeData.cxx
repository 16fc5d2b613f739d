#include "VolumeData.h"

#include "FieldArrays.h"
#include "IndexSet.h"
#include "SMPRangeLoop.h"
#include "VolumeDepth.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedIntArray.h"

namespace
{
void writePoints(const shadow::ShadowVolume& volume, const shadow::Vec3& centre, double length,
  vtkPolyData* output)
{
  const vtkIdType count = static_cast<vtkIdType>(volume.points.size());
  vtkNew<vtkDoubleArray> homogeneous;
  homogeneous->SetName("Homogeneous");
  homogeneous->SetNumberOfComponents(4);
  homogeneous->SetNumberOfTuples(count);
  vtkNew<vtkPoints> shown;
  shown->SetDataTypeToDouble();
  shown->SetNumberOfPoints(count);
  double* toHomogeneous = homogeneous->GetPointer(0);
  double* toShown = static_cast<double*>(shown->GetVoidPointer(0));
  for (std::size_t i = 0; i < volume.points.size(); ++i)
  {
    const shadow::Vec4& p = volume.points[i];
    shadow::Vec3 place(p);
    if (p.w == 0.0)
    {
      const shadow::Index origin = volume.origin[i - volume.firstEnd];
      const shadow::Vec3 from =
        origin == shadow::None ? centre : shadow::Vec3(volume.points[origin]);
      place = from + length * shadow::unitOrZero(place);
    }
    for (int c = 0; c < 4; ++c)
    {
      *toHomogeneous++ = p[c];
    }
    for (int c = 0; c < 3; ++c)
    {
      *toShown++ = place[c];
    }
  }
  output->SetPoints(shown);
  output->GetPointData()->AddArray(homogeneous);
}

void writeTriangles(const std::vector<shadow::VolumeTriangle>& triangles, vtkPolyData* output)
{
  const vtkIdType count = static_cast<vtkIdType>(triangles.size());
  vtkNew<vtkTypeInt64Array> offsets;
  offsets->SetNumberOfValues(count + 1);
  vtkNew<vtkTypeInt64Array> connectivity;
  connectivity->SetNumberOfValues(3 * count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const shadow::VolumeTriangle& t = triangles[static_cast<std::size_t>(i)];
    offsets->SetValue(i, 3 * i);
    for (unsigned k = 0; k < 3; ++k)
    {
      connectivity->SetValue(3 * i + k, t.points[k]);
    }
  }
  offsets->SetValue(count, 3 * count);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  output->SetPolys(cells);
}

void writeStrips(const shadow::ShadowVolume& volume, vtkPolyData* output)
{
  vtkNew<vtkCellArray> cells;
  for (const shadow::WallStrip& strip : volume.strips)
  {
    cells->InsertNextCell(static_cast<int>(strip.points.size()));
    for (const shadow::Index point : strip.points)
    {
      cells->InsertCellPoint(point);
    }
  }
  output->SetStrips(cells);
}

// Part and Multiplicity of cells, in their order.
class CellDataWriter
{
public:
  explicit CellDataWriter(std::size_t cells)
  {
    this->Parts->SetName("Part");
    this->Parts->SetNumberOfValues(static_cast<vtkIdType>(cells));
    this->Multiplicities->SetName("Multiplicity");
    this->Multiplicities->SetNumberOfValues(static_cast<vtkIdType>(cells));
  }

  void add(shadow::VolumePart part, int multiplicity)
  {
    this->Parts->SetValue(this->Next, static_cast<unsigned char>(part));
    this->Multiplicities->SetValue(this->Next, multiplicity);
    ++this->Next;
  }

  void add(const std::vector<shadow::VolumeTriangle>& triangles)
  {
    for (const shadow::VolumeTriangle& t : triangles)
    {
      this->add(t.part, t.multiplicity);
    }
  }

  void write(vtkPolyData* output) const
  {
    output->GetCellData()->AddArray(this->Parts);
    output->GetCellData()->AddArray(this->Multiplicities);
  }

private:
  vtkNew<vtkUnsignedCharArray> Parts;
  vtkNew<vtkIntArray> Multiplicities;
  vtkIdType Next = 0;
};

// Gives the nodes that are used numbers of their own.
class UsedNodes
{
public:
  shadow::Index number(shadow::Index node) { return this->Nodes.insert(node).place; }

  void write(const shadow::NearEnd& end, vtkPolyData* output) const
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(static_cast<vtkIdType>(this->Nodes.size()));
    vtkIdType next = 0;
    for (const shadow::Index node : this->Nodes.items())
    {
      const shadow::Vec3 place = end.place(node);
      points->SetPoint(next++, &place.x);
    }
    output->SetPoints(points);
  }

private:
  shadow::IndexSet Nodes;
};

void writeRims(const std::vector<shadow::VolumeRim>& rims, UsedNodes& nodes, CellDataWriter& data,
  vtkPolyData* output)
{
  vtkNew<vtkCellArray> cells;
  for (const shadow::VolumeRim& rim : rims)
  {
    cells->InsertNextCell(static_cast<int>(rim.points.size()) + 1);
    for (const shadow::Index point : rim.points)
    {
      cells->InsertCellPoint(nodes.number(point));
    }
    cells->InsertCellPoint(nodes.number(rim.points.front()));
    data.add(shadow::VolumePart::Wall, rim.multiplicity);
  }
  output->SetLines(cells);
}

// The triangles over the nodes' own numbers.
std::vector<shadow::VolumeTriangle> numberedTriangles(
  const shadow::NearEnd& end, UsedNodes& nodes)
{
  std::vector<shadow::VolumeTriangle> triangles;
  if (end.cap)
  {
    for (const shadow::NearCap::Part& part : end.cap->parts())
    {
      triangles.push_back({ part.nodes, shadow::VolumePart::Cap, 1 });
    }
  }
  triangles.insert(triangles.end(), end.triangles.begin(), end.triangles.end());
  for (shadow::VolumeTriangle& t : triangles)
  {
    for (shadow::Index& point : t.points)
    {
      point = nodes.number(point);
    }
  }
  return triangles;
}

void writeCapTriangles(const shadow::NearEnd& end, vtkPolyData* output)
{
  static_assert(sizeof(shadow::Triangle) == 3 * sizeof(unsigned int), "written as such an array");
  vtkNew<vtkUnsignedIntArray> array;
  array->SetName("CapTriangles");
  array->SetNumberOfComponents(3);
  if (end.cap)
  {
    end.cap->writeWhole(smpRangeLoop,
      [&](std::size_t count)
      {
        array->SetNumberOfTuples(static_cast<vtkIdType>(count));
        return reinterpret_cast<shadow::Triangle*>(array->GetPointer(0));
      });
  }
  output->GetFieldData()->AddArray(array);
}
}

void writeVolume(const shadow::ShadowVolume& volume, const shadow::Vec3& centre,
  const shadow::ShadowEnd& end, bool closed, vtkPolyData* output)
{
  writePoints(volume, centre, end.length, output);
  writeTriangles(volume.triangles, output);
  writeStrips(volume, output);
  CellDataWriter data(volume.triangles.size() + volume.strips.size());
  data.add(volume.triangles);
  for (const shadow::WallStrip& strip : volume.strips)
  {
    data.add(shadow::VolumePart::Wall, strip.multiplicity);
  }
  data.write(output);
  addField<vtkIntArray>(output, "Closed", { closed ? 1 : 0 });
  addField<vtkIntArray>(output, "GreatestDepth", { volume.greatestDepth });
  if (closed && end.extent != shadow::Extent::Infinite)
  {
    addField<vtkDoubleArray>(output, "Volume", { shadow::enclosedVolume(volume, centre) });
  }
}

void writeNearEnd(const shadow::NearEnd& end, vtkPolyData* output)
{
  UsedNodes nodes;
  const std::vector<shadow::VolumeTriangle> triangles = numberedTriangles(end, nodes);
  CellDataWriter data(end.rims.size() + triangles.size());
  writeRims(end.rims, nodes, data, output);
  writeTriangles(triangles, output);
  data.add(triangles);
  data.write(output);
  nodes.write(end, output);
  writeCapTriangles(end, output);
  addField<vtkIntArray>(output, "GreatestDepth", { shadow::greatestDepth(end) });
  addField<vtkIntArray>(output, "LightOutside", { end.lightIsOutside ? 1 : 0 });
}
