/**
 * The actors of a renderer that cast, whether or not the camera sees them.
 */
#ifndef ShadowCasters_h
#define ShadowCasters_h

#include "Matrix4.h"

#include <array>
#include <vector>

class vtkPolyData;
class vtkRenderer;

struct ShadowCaster
{
  vtkPolyData* Mesh = nullptr;
  Matrix4 ToWorld{};
  Matrix4 ToMesh{};

  /**
   * The light in the mesh's coordinates. Directions come out with unit length, so that volumes
   * stay within the range of floats whatever the scale of the actor.
   */
  std::array<double, 4> MoveIntoMesh(const std::array<double, 4>& light) const;
};

/**
 * Visible opaque surfaces whose mapper is a vtkPolyDataMapper with data, parts of assemblies
 * included, but for those that the key CASTS_SHADOW excludes (on the part or the assembly) and for
 * those that have been flattened by a singular matrix. Brings their pipelines up to date.
 */
std::vector<ShadowCaster> CollectShadowCasters(vtkRenderer* renderer);

#endif
