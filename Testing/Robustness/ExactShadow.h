/**
 * @brief What holds of every mesh and every light: silhouettes and volumes are closed, and the
 * discrete volume winds around a point as often as triangles stand between it and the light.
 */
#ifndef shadowtest_ExactShadow_h
#define shadowtest_ExactShadow_h

#include "MeshBuilder.h"
#include "ShadowPipeline.h"

namespace shadowtest
{
/// A point around the finite, used points of a mesh, of coordinates that no test's mesh has; not
/// finite if there are no such points. Any number of samples fills the space evenly.
Vec3 samplePoint(vtkPolyData* mesh, int sample);

/// Whether the light is a point on a triangle. From there some of the surface is seen edge-on from
/// no distance: which side of it the light is on is rounding, and what is behind an edge not
/// defined.
bool isOnSurface(vtkPolyData* mesh, const LightPosition& light);

/// Whether a closed mesh is around a point of space; a direction is outside.
bool isInside(vtkPolyData* closed, const LightPosition& at);

/// How much there was to be checked: ask for some, or for none.
struct ChainTotals
{
  vtkIdType Segments = 0;
  vtkIdType Triangles = 0;
  vtkIdType ZeroNormals = 0;    ///< points of silhouettes where the mesh has no normal
  int GreatestMultiplicity = 0; ///< of loops
};

/// Expects of all kinds of silhouettes good loops, and of their volumes with all caps that close
/// them: no open edge, Closed, finite numbers, and the parts that this kind and light can have.
ChainTotals expectClosedChains(vtkPolyData* mesh, const LightPosition& light);

/// The triangles of a mesh by what its parts are; either may be null.
struct CastingParts
{
  Mesh Closed; ///< of closed parts, wound outwards
  Mesh Others; ///< of all other parts
};

struct PointTotals
{
  int InShadow = 0; ///< something stands between point and light
  int Lit = 0;
  int Deepest = 0; ///< the greatest winding
};

/// Expects the discrete volume of the mesh to wind around points exactly as often as the cap says:
/// once for each triangle of an open part between point and light, once for each triangle of a
/// closed part that faces the light (lit caps) or faces away (dark ones). Outside of closed parts,
/// seen from outside, both are half of all, and so not 0 exactly if there is any.
PointTotals expectExactWinding(
  vtkPolyData* mesh, const LightPosition& light, const CastingParts& parts, int samples = 300);
}

#endif
