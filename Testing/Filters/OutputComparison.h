// Whether two outputs are the same, byte for byte.
#ifndef OutputComparison_h
#define OutputComparison_h

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cstring>
#include <string>

namespace shadowtest
{
inline bool sameBytes(vtkDataArray* first, vtkDataArray* second)
{
  if (!first || !second)
  {
    return first == second;
  }
  return first->GetDataType() == second->GetDataType() &&
    first->GetNumberOfComponents() == second->GetNumberOfComponents() &&
    first->GetNumberOfTuples() == second->GetNumberOfTuples() &&
    (first->GetNumberOfValues() == 0 ||
      std::memcmp(first->GetVoidPointer(0), second->GetVoidPointer(0),
        static_cast<std::size_t>(first->GetNumberOfValues() * first->GetDataTypeSize())) == 0);
}

/// The name of the first array that differs, or nothing.
inline std::string differingArray(
  vtkFieldData* first, vtkFieldData* second, const std::string& except = "")
{
  if (first->GetNumberOfArrays() != second->GetNumberOfArrays())
  {
    return "number of arrays";
  }
  for (int i = 0; i < first->GetNumberOfArrays(); ++i)
  {
    const std::string name = first->GetArrayName(i);
    if (name != except && !sameBytes(first->GetArray(i), second->GetArray(name.c_str())))
    {
      return name;
    }
  }
  return "";
}

/// What differs first between two silhouettes, how they were searched for aside; or nothing.
inline std::string difference(vtkPolyData* first, vtkPolyData* second)
{
  const bool bothHavePoints = first->GetPoints() && second->GetPoints();
  if (bothHavePoints && !sameBytes(first->GetPoints()->GetData(), second->GetPoints()->GetData()))
  {
    return "points";
  }
  if (first->GetNumberOfPoints() != second->GetNumberOfPoints() ||
    !sameBytes(first->GetLines()->GetConnectivityArray(), second->GetLines()->GetConnectivityArray()) ||
    !sameBytes(first->GetLines()->GetOffsetsArray(), second->GetLines()->GetOffsetsArray()))
  {
    return "lines";
  }
  std::string name = differingArray(first->GetPointData(), second->GetPointData());
  name = name.empty() ? differingArray(first->GetCellData(), second->GetCellData()) : name;
  return name.empty()
    ? differingArray(first->GetFieldData(), second->GetFieldData(), "EdgesTested")
    : name;
}
}

#endif
