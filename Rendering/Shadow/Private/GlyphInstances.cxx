#include "GlyphInstances.h"

#include "CompositeBlocks.h"

#include "vtkBitArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkQuaternion.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
/**
 * The mapper's arrays for one data set; null where it uses none. Only the mapper itself knows how
 * it finds them, and keeps that to its subclasses.
 */
class GlyphArrays : public vtkGlyph3DMapper
{
public:
  GlyphArrays() = delete;

  struct Found
  {
    vtkDataArray* Scale;
    vtkDataArray* Orientation;
    vtkDataArray* Source;
    vtkBitArray* Mask;
  };

  static Found Find(vtkGlyph3DMapper* mapper, vtkDataSet* points)
  {
    return { (mapper->*(&GlyphArrays::GetScaleArray))(points),
      (mapper->*(&GlyphArrays::GetOrientationArray))(points),
      (mapper->*(&GlyphArrays::GetSourceIndexArray))(points),
      vtkArrayDownCast<vtkBitArray>((mapper->*(&GlyphArrays::GetMaskArray))(points)) };
  }
};

double NormOf(vtkDataArray* array, vtkIdType point)
{
  return vtkMath::Norm(array->GetTuple(point), array->GetNumberOfComponents());
}

/**
 * The length of the range that data are mapped into, as a divisor.
 */
double RangeOf(vtkGlyph3DMapper* mapper)
{
  const double* range = mapper->GetRange();
  return range[1] == range[0] ? 1.0 : range[1] - range[0];
}

std::array<double, 3> FindScale(vtkGlyph3DMapper* mapper, vtkDataArray* array, vtkIdType point)
{
  std::array<double, 3> scale = { 1.0, 1.0, 1.0 };
  if (!mapper->GetScaling())
  {
    return scale;
  }
  const int mode = mapper->GetScaleMode();
  if (array && mode == vtkGlyph3DMapper::SCALE_BY_MAGNITUDE)
  {
    scale.fill(NormOf(array, point));
  }
  else if (array && mode == vtkGlyph3DMapper::SCALE_BY_COMPONENTS &&
    array->GetNumberOfComponents() == 3)
  {
    array->GetTuple(point, scale.data());
  }
  const double* range = mapper->GetRange();
  for (double& value : scale)
  {
    if (array && mapper->GetClamping() && mode != vtkGlyph3DMapper::NO_DATA_SCALING)
    {
      value = (std::max(range[0], std::min(range[1], value)) - range[0]) / RangeOf(mapper);
    }
    value *= mapper->GetScaleFactor();

    // What the mapper does in order that normals have an inverse.
    value = value == 0.0 ? 1.0e-10 : value;
  }
  return scale;
}

vtkQuaterniond FindOrientation(vtkGlyph3DMapper* mapper, vtkDataArray* array, vtkIdType point)
{
  vtkQuaterniond result;
  result.ToIdentity();
  if (!array)
  {
    return result;
  }
  const bool isQuaternion = mapper->GetOrientationMode() == vtkGlyph3DMapper::QUATERNION;
  if (array->GetNumberOfComponents() != (isQuaternion ? 4 : 3))
  {
    return result;
  }
  double value[4];
  array->GetTuple(point, value);
  if (isQuaternion)
  {
    result.Set(value);
  }
  else if (mapper->GetOrientationMode() == vtkGlyph3DMapper::ROTATION)
  {
    vtkQuaterniond turns[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double half = 0.5 * vtkMath::RadiansFromDegrees(value[axis]);
      turns[axis].Set(0.0, 0.0, 0.0, 0.0);
      turns[axis][0] = std::cos(half);
      turns[axis][axis + 1] = std::sin(half);
    }
    result = turns[2] * turns[0] * turns[1];
  }
  else if (value[1] != 0.0 || value[2] != 0.0)
  {
    // Half a turn about the middle between the x axis and the direction.
    double middle[3] = { value[0] + vtkMath::Norm(value), value[1], value[2] };
    vtkMath::Normalize(middle);
    result.Set(0.0, middle[0], middle[1], middle[2]);
  }
  else if (value[0] < 0.0)
  {
    result.Set(0.0, 0.0, 1.0, 0.0);
  }
  return result;
}

Matrix4 FindMatrix(
  vtkGlyph3DMapper* mapper, vtkDataSet* points, const GlyphArrays::Found& arrays, vtkIdType point)
{
  double rotation[3][3];
  FindOrientation(mapper, arrays.Orientation, point).ToMatrix3x3(rotation);
  const std::array<double, 3> scale = FindScale(mapper, arrays.Scale, point);
  std::array<double, 3> place;
  points->GetPoint(point, place.data());
  Matrix4 matrix = Translation(place);
  for (std::size_t row = 0; row < 3; ++row)
  {
    for (std::size_t column = 0; column < 3; ++column)
    {
      matrix[4 * row + column] = rotation[row][column] * scale[column];
    }
  }
  return matrix;
}

/**
 * By number of the source, the meshes that it consists of.
 */
std::vector<std::vector<vtkPolyData*>> CollectSources(vtkGlyph3DMapper* mapper)
{
  std::vector<std::vector<vtkPolyData*>> sources;
  if (!mapper->GetUseSourceTableTree())
  {
    for (int i = 0; i < mapper->GetNumberOfInputConnections(1); ++i)
    {
      sources.push_back(CollectBlocks(mapper->GetSource(i)));
    }
  }
  else if (vtkDataObjectTree* table = mapper->GetSourceTableTree())
  {
    for (vtkDataObject* source : vtk::Range(table, vtk::DataObjectTreeOptions::SkipEmptyNodes))
    {
      sources.push_back(CollectBlocks(source));
    }
  }
  return sources;
}

/**
 * The source of a point without an index is the first one. The mapper's range is for scaling alone.
 */
std::size_t FindSource(vtkDataArray* array, vtkIdType point, std::size_t count)
{
  if (!array)
  {
    return 0;
  }
  const double place = NormOf(array, point);
  return static_cast<std::size_t>(std::max(0.0, std::min(place, static_cast<double>(count - 1))));
}

void AddGlyphs(vtkGlyph3DMapper* mapper, vtkDataSet* points,
  const std::vector<std::vector<vtkPolyData*>>& sources, std::vector<CasterMesh>& glyphs)
{
  const GlyphArrays::Found arrays = GlyphArrays::Find(mapper, points);
  for (vtkIdType point = 0; point < points->GetNumberOfPoints(); ++point)
  {
    if (arrays.Mask && arrays.Mask->GetValue(point) == 0)
    {
      continue;
    }
    const Matrix4 matrix = FindMatrix(mapper, points, arrays, point);
    for (vtkPolyData* mesh : sources[FindSource(arrays.Source, point, sources.size())])
    {
      glyphs.push_back({ mesh, matrix });
    }
  }
}
}

std::vector<CasterMesh> CollectGlyphs(vtkGlyph3DMapper* mapper)
{
  std::vector<CasterMesh> glyphs;
  const std::vector<std::vector<vtkPolyData*>> sources = CollectSources(mapper);
  if (sources.empty())
  {
    return glyphs;
  }
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  if (auto* points = vtkDataSet::SafeDownCast(input))
  {
    AddGlyphs(mapper, points, sources, glyphs);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    vtkCompositeDataDisplayAttributes* attributes = mapper->GetBlockAttributes();
    const auto blocks = vtk::TakeSmartPointer(composite->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      auto* block = vtkDataSet::SafeDownCast(blocks->GetCurrentDataObject());
      const bool hidden = attributes && attributes->HasBlockVisibility(block) &&
        !attributes->GetBlockVisibility(block);
      if (block && !hidden)
      {
        AddGlyphs(mapper, block, sources, glyphs);
      }
    }
  }
  return glyphs;
}
