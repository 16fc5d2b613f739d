#include "ShadowLights.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
/**
 * Where the light is and where it shines to. False if it has no finite position, or its direction is
 * no direction.
 */
bool FindPlace(vtkLight* light, ShadowLight& result)
{
  double place[3];
  double focus[3];
  light->GetTransformedPosition(place);
  light->GetTransformedFocalPoint(focus);
  std::array<double, 3>& direction = result.Direction;
  direction = { focus[0] - place[0], focus[1] - place[1], focus[2] - place[2] };
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  const bool isDirection = std::isfinite(length) && length > 0.0;
  if (!light->GetPositional())
  {
    result.Position = { -direction[0], -direction[1], -direction[2], 0.0 };
    return isDirection;
  }
  result.Position = { place[0], place[1], place[2], 1.0 };
  if (isDirection)
  {
    for (double& component : direction)
    {
      component /= length;
    }
    result.ConeAngle = light->GetConeAngle();
  }
  return std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]);
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
      FindPlace(light, shadowLight))
    {
      result.push_back(shadowLight);
    }
  }
  return result;
}
