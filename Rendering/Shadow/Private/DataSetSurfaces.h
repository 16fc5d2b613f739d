/**
 * The surfaces that vtkDataSetMappers draw.
 *
 * The mapper has a surface of its own, but makes it only when it draws: an actor that the camera
 * does not see has none, or an old one. So it is extracted once more, by the same filter.
 */
#ifndef DataSetSurfaces_h
#define DataSetSurfaces_h

#include "vtkDataSetSurfaceFilter.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <vector>

class vtkDataSetMapper;
class vtkPolyData;

class DataSetSurfaces
{
public:
  /**
   * The same object as long as the mapper lives; extracted anew when its input has changed. If the
   * input is a mesh already it is that. Null without input. Forgets mappers that are gone.
   */
  vtkPolyData* Get(vtkDataSetMapper* mapper);

private:
  struct Surface
  {
    vtkWeakPointer<vtkDataSetMapper> Mapper;
    vtkSmartPointer<vtkDataSetSurfaceFilter> Filter;
  };

  std::vector<Surface> Surfaces;
};

#endif
