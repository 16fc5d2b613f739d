#include "DepthOccluders.h"

#include "Matrix4.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAssembly.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCommand.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper2.h"
#include "vtkMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkVolume.h"

#include <algorithm>
#include <string>

namespace
{
/**
 * Of a class that draws its mapper where its matrix says, and nothing else.
 */
bool IsPlainActor(vtkActor* actor)
{
  static const char* const names[] = { "vtkActor", "vtkOpenGLActor", "vtkFollower" };
  const std::string name = actor->GetClassName();
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool HasNoDepth(vtkProp* prop)
{
  return vtkActor2D::SafeDownCast(prop) || vtkVolume::SafeDownCast(prop);
}

void RecordMapper(vtkMapper* mapper, SceneRecord& record)
{
  // Whoever observes this may set other values with every frame.
  if (mapper->HasObserver(vtkCommand::UpdateShaderEvent))
  {
    record.AddUnknown();
  }
  if (!mapper->GetStatic())
  {
    mapper->Update();
  }
  record.Add(mapper, mapper->GetMTime());
  for (int port = 0; port < mapper->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < mapper->GetNumberOfInputConnections(port); ++i)
    {
      record.AddData(mapper->GetInputDataObject(port, i));
    }
  }
  if (auto* composite = vtkCompositePolyDataMapper2::SafeDownCast(mapper))
  {
    vtkCompositeDataDisplayAttributes* attributes = composite->GetCompositeDataDisplayAttributes();
    record.Add(attributes, attributes ? attributes->GetMTime() : 0);
  }
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    vtkCollectionSimpleIterator iterator;
    planes->InitTraversal(iterator);
    while (vtkPlane* plane = planes->GetNextPlane(iterator))
    {
      record.Add(plane, plane->GetMTime());
    }
  }
}

void RecordActor(vtkActor* actor, const Matrix4& matrix, SceneRecord& record)
{
  if (!IsPlainActor(actor))
  {
    record.AddUnknown();
    return;
  }
  // Not the actor's own time: an assembly modifies its parts when it draws them.
  const auto add = [&](vtkObject* part) { record.Add(part, part ? part->GetMTime() : 0); };
  record.Add(actor, 0);
  record.Add(matrix);
  record.Add(static_cast<vtkTypeUInt64>(actor->GetVisibility()));
  record.Add(static_cast<vtkTypeUInt64>(actor->GetForceOpaque()));
  record.Add(static_cast<vtkTypeUInt64>(actor->GetForceTranslucent()));
  add(actor->GetProperty());
  add(actor->GetBackfaceProperty());
  add(actor->GetShaderProperty());
  add(actor->GetTexture());
  if (vtkTexture* texture = actor->GetTexture())
  {
    record.AddData(texture->GetInputDataObject(0, 0));
  }
  if (actor->GetMapper())
  {
    RecordMapper(actor->GetMapper(), record);
  }
}

void RecordProp(vtkProp* prop, SceneRecord& record)
{
  if (HasNoDepth(prop))
  {
    return;
  }
  if (!vtkActor::SafeDownCast(prop) && !vtkAssembly::SafeDownCast(prop))
  {
    record.AddUnknown();
    return;
  }
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkAssemblyNode* node = path->GetLastNode();
    vtkActor* actor = vtkActor::SafeDownCast(node->GetViewProp());
    if (!actor)
    {
      record.AddUnknown();
      continue;
    }
    // A path is kept until its props are modified, but a follower turns without being modified.
    RecordActor(
      actor, ToMatrix4(actor == prop ? actor->GetMatrix() : node->GetMatrix()), record);
  }
}
}

std::vector<vtkProp*> FindOccluders(const vtkRenderState* state)
{
  std::vector<vtkProp*> props;
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = state->GetPropArray()[i];
    vtkActor* actor = vtkActor::SafeDownCast(prop);
    if (!actor || !state->GetRenderer()->GetUseHiddenLineRemoval() ||
      actor->GetProperty()->GetRepresentation() != VTK_WIREFRAME)
    {
      props.push_back(prop);
    }
  }
  return props;
}

SceneRecord RecordOccluders(const std::vector<vtkProp*>& props)
{
  SceneRecord record;
  // What coincides is moved in depth by settings of all mappers.
  record.Add(static_cast<vtkTypeUInt64>(vtkMapper::GetResolveCoincidentTopology()));
  double factor;
  double units;
  vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(factor, units);
  record.Add(std::array<double, 2>{ factor, units });
  vtkMapper::GetResolveCoincidentTopologyLineOffsetParameters(factor, units);
  record.Add(std::array<double, 2>{ factor, units });
  vtkMapper::GetResolveCoincidentTopologyPointOffsetParameter(units);
  record.Add(units);
  for (vtkProp* prop : props)
  {
    RecordProp(prop, record);
  }
  return record;
}
