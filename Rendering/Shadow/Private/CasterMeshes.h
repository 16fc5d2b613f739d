/**
 * The meshes that an actor's mapper draws as opaque surfaces.
 */
#ifndef CasterMeshes_h
#define CasterMeshes_h

#include "Matrix4.h"

#include <vector>

class DataSetSurfaces;
class vtkActor;
class vtkPolyData;

/**
 * A mesh that stays the mapper's own, so that it is known again in the next frame, and where it is
 * in the actor's coordinates.
 */
struct CasterMesh
{
  vtkPolyData* Mesh = nullptr;
  Matrix4 ToActor{};
};

/**
 * Of a vtkPolyDataMapper its input; of composite mappers the blocks that are visible and opaque; of
 * a vtkGlyph3DMapper the source of each glyph; of a vtkDataSetMapper the data's surface. Of other
 * mappers none, nor of those that draw splats, wireframes or points. Meshes without polygons or
 * strips are left out. Brings the mapper's pipeline up to date.
 */
std::vector<CasterMesh> CollectCasterMeshes(vtkActor* actor, DataSetSurfaces& surfaces);

#endif
