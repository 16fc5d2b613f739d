#include "CasterMeshes.h"

#include "CompositeBlocks.h"
#include "DataSetSurfaces.h"
#include "GlyphInstances.h"

#include "vtkActor.h"
#include "vtkCompositeDataSet.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkCompositePolyDataMapper2.h"
#include "vtkDataSetMapper.h"
#include "vtkGlyph3DMapper.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSkybox.h"

#include <algorithm>

namespace
{
/**
 * These take a mesh for its points, and draw something else there.
 */
bool DrawsSplats(vtkMapper* mapper)
{
  return vtkPointGaussianMapper::SafeDownCast(mapper) ||
    vtkOpenGLSphereMapper::SafeDownCast(mapper) || vtkOpenGLStickMapper::SafeDownCast(mapper);
}

std::vector<CasterMesh> InPlace(const std::vector<vtkPolyData*>& meshes)
{
  std::vector<CasterMesh> result;
  for (vtkPolyData* mesh : meshes)
  {
    result.push_back({ mesh, Translation({ 0.0, 0.0, 0.0 }) });
  }
  return result;
}

std::vector<CasterMesh> CollectMeshes(vtkActor* actor, DataSetSurfaces& surfaces)
{
  vtkMapper* mapper = actor->GetMapper();
  auto* composite = vtkCompositePolyDataMapper2::SafeDownCast(mapper);
  if (composite && vtkCompositeDataSet::SafeDownCast(composite->GetInputDataObject(0, 0)))
  {
    return InPlace(CollectOpaqueBlocks(composite, actor));
  }
  if (actor->HasTranslucentPolygonalGeometry())
  {
    return {};
  }
  if (auto* simple = vtkPolyDataMapper::SafeDownCast(mapper))
  {
    return InPlace({ simple->GetInput() });
  }
  if (vtkCompositePolyDataMapper::SafeDownCast(mapper))
  {
    return InPlace(CollectBlocks(mapper->GetInputDataObject(0, 0)));
  }
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    return CollectGlyphs(glyphs);
  }
  if (auto* general = vtkDataSetMapper::SafeDownCast(mapper))
  {
    return InPlace({ surfaces.Get(general) });
  }
  return {};
}
}

std::vector<CasterMesh> CollectCasterMeshes(vtkActor* actor, DataSetSurfaces& surfaces)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0 || DrawsSplats(mapper) ||
    vtkSkybox::SafeDownCast(actor) || actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
  {
    return {};
  }
  if (!mapper->GetStatic())
  {
    mapper->Update();
  }
  std::vector<CasterMesh> meshes = CollectMeshes(actor, surfaces);
  meshes.erase(std::remove_if(meshes.begin(), meshes.end(),
                 [](const CasterMesh& caster) {
                   return !caster.Mesh ||
                     caster.Mesh->GetNumberOfPolys() + caster.Mesh->GetNumberOfStrips() == 0;
                 }),
    meshes.end());
  return meshes;
}
