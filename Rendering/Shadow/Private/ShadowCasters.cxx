#include "ShadowCasters.h"

#include "CasterMeshes.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkStencilShadowPass.h"

#include <algorithm>
#include <cmath>

namespace
{
bool MayCast(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  vtkInformationIntegerKey* key = vtkStencilShadowPass::CASTS_SHADOW();
  return !keys || !keys->Has(key) || keys->Get(key) != 0;
}

/**
 * False if the matrix is singular, or not finite, or nearly so that its inverse is not.
 */
bool Invert(const Matrix4& matrix, Matrix4& inverse)
{
  const double volume = vtkMatrix4x4::Determinant(matrix.data());
  if (!std::isfinite(volume) || volume == 0.0)
  {
    return false;
  }
  vtkMatrix4x4::Invert(matrix.data(), inverse.data());
  return std::all_of(
    inverse.begin(), inverse.end(), [](double value) { return std::isfinite(value); });
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

std::vector<ShadowCaster> CollectShadowCasters(vtkRenderer* renderer, DataSetSurfaces& surfaces)
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
      if (!actor || !actor->GetVisibility())
      {
        continue;
      }
      // A path is kept until its props are modified, but a follower turns without being modified.
      const Matrix4 toWorld = ToMatrix4(actor == prop ? actor->GetMatrix() : node->GetMatrix());
      for (const CasterMesh& mesh : CollectCasterMeshes(actor, surfaces))
      {
        ShadowCaster caster;
        caster.Mesh = mesh.Mesh;
        caster.Prop = prop;
        caster.ToWorld = toWorld * mesh.ToActor;
        if (Invert(caster.ToWorld, caster.ToMesh))
        {
          result.push_back(caster);
        }
      }
    }
  }
  return result;
}
