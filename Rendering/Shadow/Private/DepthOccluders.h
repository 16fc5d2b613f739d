/**
 * The props that the depth stage draws, and what its depths depend on.
 */
#ifndef DepthOccluders_h
#define DepthOccluders_h

#include "SceneRecord.h"

#include <vector>

class vtkProp;
class vtkRenderState;

/**
 * The state's props, but lines of which some are removed as hidden: what is seen behind those would
 * get their mask.
 */
std::vector<vtkProp*> FindOccluders(const vtkRenderState* state);

/**
 * All that the depths of these props depend on, but for the camera. Actors and assemblies of them
 * are known, and what has no depth; others (also actors of a kind of their own, as
 * vtkLODActor, that choose what they draw) may change unnoticed. Brings their pipelines up to date.
 */
SceneRecord RecordOccluders(const std::vector<vtkProp*>& props);

#endif
