/**
 * The bounds that the plan is made from.
 */
#ifndef SceneBounds_h
#define SceneBounds_h

#include "ShadowPlan.h"

class vtkPolyData;
class vtkProp;
class vtkRenderer;

/**
 * Whether the key RECEIVES_SHADOW lets a prop show shadows.
 */
bool MayReceive(vtkProp* prop);

/**
 * What may show a shadow of the visible props, and the bounds of all of them. A prop that does not use
 * its bounds, or whose bounds are not finite, makes the scene unbounded.
 */
PlanReceivers FindReceivers(vtkRenderer* renderer);

/**
 * Bounds of a mesh's finite points with room for a contour that may leave it: `deviation` is the greatest distance of
 * an edge from the smooth surface's.
 */
std::array<double, 6> BoundsWithContours(vtkPolyData* mesh, double deviation);

#endif
