// Arrays of a data set's field data.
#ifndef FieldArrays_h
#define FieldArrays_h

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <initializer_list>

// One tuple, of as many components as there are values.
template <class Array, class Value>
void addField(vtkPolyData* output, const char* name, std::initializer_list<Value> values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.size()));
  array->SetNumberOfTuples(1);
  int component = 0;
  for (const Value& value : values)
  {
    array->SetTypedComponent(0, component++, value);
  }
  output->GetFieldData()->AddArray(array);
}

inline void addLightPosition(vtkPolyData* output, const double light[4])
{
  addField<vtkDoubleArray>(
    output, "LightPosition", { light[0], light[1], light[2], light[3] });
}

inline void addCount(vtkPolyData* output, const char* name, std::size_t count)
{
  addField<vtkIdTypeArray>(output, name, { static_cast<vtkIdType>(count) });
}

#endif
