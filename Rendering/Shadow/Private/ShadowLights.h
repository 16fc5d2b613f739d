/**
 * The lights of a renderer that cast, and what the shaders need to know of them.
 */
#ifndef ShadowLights_h
#define ShadowLights_h

#include "vtkWeakPointer.h"

#include <array>
#include <vector>

class vtkLight;
class vtkRenderer;

struct ShadowLight
{
  vtkLight* Light = nullptr;

  /**
   * The N of the mappers' `lightColorN`: the light's number among those that are on.
   */
  int Number = 0;

  /**
   * Homogeneous, in world coordinates; for a directional light the direction towards it, w = 0.
   */
  std::array<double, 4> Position{};

  /**
   * From the light along the axis of its cone, of unit length, and the angle between that and the
   * cone's side in degrees; 90 or more if it shines in all directions.
   */
  std::array<double, 3> Direction{};
  double ConeAngle = 180.0;
};

/**
 * Lights that the user kept from casting. Forgets lights that are gone.
 */
class LightSwitches
{
public:
  /**
   * Returns whether this changed anything.
   */
  bool Set(vtkLight* light, bool casts);
  bool Casts(vtkLight* light) const;

private:
  std::vector<vtkWeakPointer<vtkLight>> Off;
};

/**
 * The casting lights in the renderer's order; their place in the result is their mask's number.
 * Expects the lights' transforms to be up to date with the camera.
 */
std::vector<ShadowLight> CollectShadowLights(vtkRenderer* renderer, const LightSwitches& switches);

#endif
