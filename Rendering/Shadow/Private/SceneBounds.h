/**
 * The bounds that the plan is made from.
 */
#ifndef SceneBounds_h
#define SceneBounds_h

#include "ShadowPlan.h"

#include <array>
#include <vector>

class vtkPolyData;
class vtkProp;
class vtkRenderer;

/**
 * Whether the key RECEIVES_SHADOW lets a prop show shadows.
 */
bool MayReceive(vtkProp* prop);

/**
 * What may show a shadow of the visible props, and the bounds of all of them. A prop that does not
 * use its bounds, or whose bounds are not finite, makes the scene unbounded. `receivingProps` are
 * the props that the receivers' bounds belong to.
 */
PlanReceivers FindReceivers(vtkRenderer* renderer, std::vector<vtkProp*>& receivingProps);

/**
 * Bounds of a mesh's finite points; all zero if there are none.
 */
std::array<double, 6> FindFiniteBounds(vtkPolyData* mesh);

double FindDiagonal(const std::array<double, 6>& bounds);

/**
 * The bounds, wider by `room` on each side.
 */
std::array<double, 6> WithRoom(std::array<double, 6> bounds, double room);

#endif
