#include "ShadowLights.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
/**
 * False for a light that has no finite position, or whose direction is no direction.
 */
bool FindPosition(vtkLight* light, std::array<double, 4>& position)
{
  double place[3];
  light->GetTransformedPosition(place);
  if (light->GetPositional())
  {
    position = { place[0], place[1], place[2], 1.0 };
    return std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]);
  }
  double focus[3];
  light->GetTransformedFocalPoint(focus);
  position = { place[0] - focus[0], place[1] - focus[1], place[2] - focus[2], 0.0 };
  const double length = std::hypot(position[0], position[1], position[2]);
  return std::isfinite(length) && length > 0.0;
}
}

bool LightSwitches::Set(vtkLight* light, bool casts)
{
  this->Off.erase(std::remove(this->Off.begin(), this->Off.end(), nullptr), this->Off.end());
  if (this->Casts(light) == casts)
  {
    return false;
  }
  if (casts)
  {
    this->Off.erase(std::remove(this->Off.begin(), this->Off.end(), light), this->Off.end());
  }
  else
  {
    this->Off.emplace_back(light);
  }
  return true;
}

bool LightSwitches::Casts(vtkLight* light) const
{
  return std::find(this->Off.begin(), this->Off.end(), light) == this->Off.end();
}

std::vector<ShadowLight> CollectShadowLights(vtkRenderer* renderer, const LightSwitches& switches)
{
  std::vector<ShadowLight> result;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  int number = 0;
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    ShadowLight shadowLight;
    shadowLight.Light = light;
    shadowLight.Number = number++;
    if (!light->LightTypeIsHeadlight() && switches.Casts(light) &&
      FindPosition(light, shadowLight.Position))
    {
      result.push_back(shadowLight);
    }
  }
  return result;
}
