/**
 * What casts in a renderer, whether or not the camera sees it: meshes, each with a matrix. An actor
 * is as many of them as its mapper draws, blocks or glyphs.
 */
#ifndef ShadowCasters_h
#define ShadowCasters_h

#include "Matrix4.h"

#include <array>
#include <vector>

class DataSetSurfaces;
class vtkPolyData;
class vtkProp;
class vtkRenderer;

struct ShadowCaster
{
  vtkPolyData* Mesh = nullptr;
  Matrix4 ToWorld{};
  Matrix4 ToMesh{};

  /**
   * What of the renderer's it belongs to.
   */
  vtkProp* Prop = nullptr;

  /**
   * The light in the mesh's coordinates. Directions come out with unit length, so that volumes
   * stay within the range of floats whatever the scale of the actor.
   */
  std::array<double, 4> MoveIntoMesh(const std::array<double, 4>& light) const;
};

/**
 * The meshes (see CollectCasterMeshes) of visible actors, parts of assemblies included, but for
 * those that the key CASTS_SHADOW excludes and for those that have been flattened by a singular
 * matrix.
 */
std::vector<ShadowCaster> CollectShadowCasters(vtkRenderer* renderer, DataSetSurfaces& surfaces);

#endif
