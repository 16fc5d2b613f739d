#include "DataSetSurfaces.h"

#include "vtkDataSetMapper.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkPolyData* DataSetSurfaces::Get(vtkDataSetMapper* mapper)
{
  vtkDataSet* data = mapper->GetInput();
  vtkPolyData* mesh = vtkPolyData::SafeDownCast(data);
  if (!data || mesh)
  {
    return mesh;
  }
  this->Surfaces.erase(std::remove_if(this->Surfaces.begin(), this->Surfaces.end(),
                         [](const Surface& surface) { return !surface.Mapper; }),
    this->Surfaces.end());
  auto found = std::find_if(this->Surfaces.begin(), this->Surfaces.end(),
    [&](const Surface& surface) { return surface.Mapper == mapper; });
  if (found == this->Surfaces.end())
  {
    this->Surfaces.push_back({ mapper, vtkSmartPointer<vtkDataSetSurfaceFilter>::New() });
    found = std::prev(this->Surfaces.end());
  }
  found->Filter->SetInputData(data);
  found->Filter->Update();
  return found->Filter->GetOutput();
}
