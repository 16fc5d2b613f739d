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

#include <algorithm>
#include <cmath>

bool MayReceive(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  vtkInformationIntegerKey* key = vtkStencilShadowPass::RECEIVES_SHADOW();
  return !keys || !keys->Has(key) || keys->Get(key) != 0;
}

namespace
{
bool IsFinite(double value)
{
  return std::isfinite(value);
}

std::array<double, 6> BoundsOfFinitePoints(vtkPolyData* mesh)
{
  vtkBoundingBox box;
  double point[3];
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    mesh->GetPoint(i, point);
    if (std::all_of(point, point + 3, IsFinite))
    {
      box.AddPoint(point);
    }
  }
  std::array<double, 6> bounds{};
  if (box.IsValid())
  {
    box.GetBounds(bounds.data());
  }
  return bounds;
}

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
    if (!prop->GetUseBounds() || !std::all_of(bounds, bounds + 6, IsFinite))
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
  if (!std::all_of(bounds.begin(), bounds.end(), IsFinite))
  {
    bounds = BoundsOfFinitePoints(mesh);
  }
  const double diagonal =
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
  const double margin = room * diagonal + 2.0 * deviation;
  for (std::size_t i = 0; i < 6; ++i)
  {
    bounds[i] += i % 2 == 0 ? -margin : margin;
  }
  return bounds;
}
