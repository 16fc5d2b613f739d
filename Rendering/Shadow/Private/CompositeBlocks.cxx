#include "CompositeBlocks.h"

#include "vtkActor.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkCompositePolyDataMapper2.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

namespace
{
bool HasOpaqueScalars(vtkMapper* mapper, vtkPolyData* mesh)
{
  if (!mapper->GetScalarVisibility())
  {
    return true;
  }
  int unused;
  vtkDataArray* scalars = vtkAbstractMapper::GetScalars(mesh, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), unused);
  return mapper->GetLookupTable()->IsOpaque(
           scalars, mapper->GetColorMode(), mapper->GetArrayComponent()) != 0;
}

/**
 * `visible` and `opacity` are those of the block around.
 */
void AddOpaqueBlocks(vtkDataObject* block, bool visible, double opacity,
  vtkCompositePolyDataMapper2* mapper, std::vector<vtkPolyData*>& meshes)
{
  if (vtkCompositeDataDisplayAttributes* attributes = mapper->GetCompositeDataDisplayAttributes())
  {
    visible =
      attributes->HasBlockVisibility(block) ? attributes->GetBlockVisibility(block) : visible;
    opacity = attributes->HasBlockOpacity(block) ? attributes->GetBlockOpacity(block) : opacity;
  }
  if (auto* tree = vtkDataObjectTree::SafeDownCast(block))
  {
    for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::SkipEmptyNodes))
    {
      AddOpaqueBlocks(child, visible, opacity, mapper, meshes);
    }
    return;
  }
  vtkPolyData* mesh = vtkPolyData::SafeDownCast(block);
  if (mesh && visible && opacity >= 1.0 && HasOpaqueScalars(mapper, mesh))
  {
    meshes.push_back(mesh);
  }
}
}

std::vector<vtkPolyData*> CollectBlocks(vtkDataObject* data)
{
  std::vector<vtkPolyData*> meshes;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto blocks = vtk::TakeSmartPointer(composite->NewIterator());
    for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    {
      meshes.push_back(vtkPolyData::SafeDownCast(blocks->GetCurrentDataObject()));
    }
  }
  else
  {
    meshes.push_back(vtkPolyData::SafeDownCast(data));
  }
  return meshes;
}

std::vector<vtkPolyData*> CollectOpaqueBlocks(vtkCompositePolyDataMapper2* mapper, vtkActor* actor)
{
  std::vector<vtkPolyData*> meshes;
  if (!actor->GetTexture() || !actor->GetTexture()->IsTranslucent())
  {
    AddOpaqueBlocks(
      mapper->GetInputDataObject(0, 0), true, actor->GetProperty()->GetOpacity(), mapper, meshes);
  }
  return meshes;
}
