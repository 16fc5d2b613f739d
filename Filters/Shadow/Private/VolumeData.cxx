#include "VolumeData.h"

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
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

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

void writeNearPoints(const shadow::ShadowVolume& volume, vtkPolyData* output)
{
  vtkNew<vtkIdTypeArray> near;
  near->SetName("NearPoints");
  near->SetNumberOfValues(static_cast<vtkIdType>(volume.points.size()));
  near->FillValue(-1);
  for (std::size_t i = 0; i < volume.origin.size(); ++i)
  {
    if (volume.origin[i] != shadow::None)
    {
      near->SetValue(static_cast<vtkIdType>(volume.firstEnd + i), volume.origin[i]);
    }
  }
  output->GetPointData()->AddArray(near);
}

void writeTriangles(const shadow::ShadowVolume& volume, vtkPolyData* output)
{
  const vtkIdType count = static_cast<vtkIdType>(volume.triangles.size());
  vtkNew<vtkTypeInt64Array> offsets;
  offsets->SetNumberOfValues(count + 1);
  vtkNew<vtkTypeInt64Array> connectivity;
  connectivity->SetNumberOfValues(3 * count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const shadow::VolumeTriangle& t = volume.triangles[static_cast<std::size_t>(i)];
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

// Strips come behind the triangles.
void writeCellData(const shadow::ShadowVolume& volume, vtkPolyData* output)
{
  const vtkIdType triangles = static_cast<vtkIdType>(volume.triangles.size());
  const vtkIdType strips = static_cast<vtkIdType>(volume.strips.size());
  vtkNew<vtkUnsignedCharArray> parts;
  parts->SetName("Part");
  parts->SetNumberOfValues(triangles + strips);
  vtkNew<vtkIntArray> multiplicities;
  multiplicities->SetName("Multiplicity");
  multiplicities->SetNumberOfValues(triangles + strips);
  const auto set = [&](vtkIdType cell, shadow::VolumePart part, int multiplicity)
  {
    parts->SetValue(cell, static_cast<unsigned char>(part));
    multiplicities->SetValue(cell, multiplicity);
  };
  for (vtkIdType i = 0; i < triangles; ++i)
  {
    const shadow::VolumeTriangle& t = volume.triangles[static_cast<std::size_t>(i)];
    set(i, t.part, t.multiplicity);
  }
  for (vtkIdType i = 0; i < strips; ++i)
  {
    set(triangles + i, shadow::VolumePart::Wall,
      volume.strips[static_cast<std::size_t>(i)].multiplicity);
  }
  output->GetCellData()->AddArray(parts);
  output->GetCellData()->AddArray(multiplicities);
}
}

void writeVolume(const shadow::ShadowVolume& volume, const shadow::Vec3& centre,
  const shadow::ShadowEnd& end, bool closed, vtkPolyData* output)
{
  writePoints(volume, centre, end.length, output);
  writeNearPoints(volume, output);
  writeTriangles(volume, output);
  writeStrips(volume, output);
  writeCellData(volume, output);
  const auto addInteger = [&](const char* name, int value)
  {
    vtkNew<vtkIntArray> array;
    array->SetName(name);
    array->InsertNextValue(value);
    output->GetFieldData()->AddArray(array);
  };
  addInteger("Closed", closed);
  addInteger("GreatestDepth", volume.greatestDepth);
  if (closed && end.extent != shadow::Extent::Infinite)
  {
    vtkNew<vtkDoubleArray> enclosed;
    enclosed->SetName("Volume");
    enclosed->InsertNextValue(shadow::enclosedVolume(volume, centre));
    output->GetFieldData()->AddArray(enclosed);
  }
}
