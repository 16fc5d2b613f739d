#include "ShadowCasters.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSkybox.h"
#include "vtkStencilShadowPass.h"

#include <cmath>

namespace
{
bool MayCast(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  vtkInformationIntegerKey* key = vtkStencilShadowPass::CASTS_SHADOW();
  return !keys || !keys->Has(key) || keys->Get(key) != 0;
}

vtkPolyData* FindMesh(vtkActor* actor)
{
  vtkPolyDataMapper* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0 || vtkSkybox::SafeDownCast(actor) ||
    actor->GetProperty()->GetRepresentation() != VTK_SURFACE ||
    actor->HasTranslucentPolygonalGeometry())
  {
    return nullptr;
  }
  if (!mapper->GetStatic())
  {
    mapper->Update();
  }
  vtkPolyData* mesh = mapper->GetInput();
  return mesh && mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0 ? mesh : nullptr;
}
}

std::array<double, 4> ShadowCaster::MoveIntoMesh(const std::array<double, 4>& light) const
{
  std::array<double, 4> moved;
  vtkMatrix4x4::MultiplyPoint(this->ToMesh.data(), light.data(), moved.data());
  if (light[3] == 0.0)
  {
    const double length = std::hypot(moved[0], moved[1], moved[2]);
    return { moved[0] / length, moved[1] / length, moved[2] / length, 0.0 };
  }
  return moved;
}

std::vector<ShadowCaster> CollectShadowCasters(vtkRenderer* renderer)
{
  std::vector<ShadowCaster> result;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (!prop->GetVisibility() || !MayCast(prop))
    {
      continue;
    }
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkAssemblyNode* node = path->GetLastNode();
      vtkActor* actor = vtkActor::SafeDownCast(node->GetViewProp());
      if (!actor || !actor->GetVisibility() || !MayCast(actor))
      {
        continue;
      }
      vtkPolyData* mesh = FindMesh(actor);
      if (!mesh)
      {
        continue;
      }
      ShadowCaster caster;
      caster.Mesh = mesh;
      // A path is kept until its props are modified, but a follower turns without being modified.
      caster.ToWorld = ToMatrix4(actor == prop ? actor->GetMatrix() : node->GetMatrix());
      const double volume = vtkMatrix4x4::Determinant(caster.ToWorld.data());
      if (!std::isfinite(volume) || volume == 0.0)
      {
        continue;
      }
      vtkMatrix4x4::Invert(caster.ToWorld.data(), caster.ToMesh.data());
      result.push_back(caster);
    }
  }
  return result;
}
