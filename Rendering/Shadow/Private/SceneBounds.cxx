#include "SceneBounds.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkStencilShadowPass.h"
#include "vtkVolume.h"

bool MayReceive(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  vtkInformationIntegerKey* key = vtkStencilShadowPass::RECEIVES_SHADOW();
  return !keys || !keys->Has(key) || keys->Get(key) != 0;
}

namespace
{
/**
 * False if it is certain that shadows on the prop are not drawn.
 */
bool CanShowShadows(vtkProp* prop)
{
  vtkActor* actor = vtkActor::SafeDownCast(prop);
  const bool isTranslucent =
    actor && !actor->GetForceOpaque() && actor->GetProperty()->GetOpacity() < 1.0;
  return MayReceive(prop) && !isTranslucent && !vtkVolume::SafeDownCast(prop);
}
}

PlanReceivers FindReceivers(vtkRenderer* renderer)
{
  PlanReceivers receivers;
  receivers.Bounded = true;
  vtkBoundingBox all;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    const double* bounds = prop->GetVisibility() ? prop->GetBounds() : nullptr;
    if (!bounds)
    {
      continue;
    }
    if (!prop->GetUseBounds())
    {
      receivers.Bounded = false;
    }
    else if (vtkMath::AreBoundsInitialized(bounds))
    {
      all.AddBounds(bounds);
      if (CanShowShadows(prop))
      {
        receivers.Bounds.emplace_back();
        std::copy_n(bounds, 6, receivers.Bounds.back().begin());
      }
    }
  }
  receivers.AllBounds = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  receivers.Bounded = receivers.Bounded && all.IsValid();
  if (all.IsValid())
  {
    all.GetBounds(receivers.AllBounds.data());
  }
  return receivers;
}

std::array<double, 6> BoundsWithContours(vtkPolyData* mesh, double deviation)
{
  constexpr double room = 0.1;
  std::array<double, 6> bounds;
  mesh->GetBounds(bounds.data());
  const double margin = room * mesh->GetLength() + 2.0 * deviation;
  for (std::size_t i = 0; i < 6; ++i)
  {
    bounds[i] += i % 2 == 0 ? -margin : margin;
  }
  return bounds;
}
