#include "DepthOccluders.h"

#include "Matrix4.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkAlgorithmOutput.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCommand.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper2.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkUniforms.h"
#include "vtkVolume.h"

#include <algorithm>
#include <initializer_list>
#include <string>

namespace
{
/**
 * Whether the object is of one of these classes itself, not of one that is derived from them.
 */
bool IsOneOf(vtkObject* object, std::initializer_list<std::string> classes)
{
  return std::find(classes.begin(), classes.end(), object->GetClassName()) != classes.end();
}

/**
 * Of a class that draws its mapper where its matrix says, and nothing else.
 */
bool IsPlainActor(vtkActor* actor)
{
  return IsOneOf(actor, { "vtkActor", "vtkOpenGLActor", "vtkFollower" });
}

/**
 * Of a class that draws by what its settings, its inputs and what is recorded below say.
 */
bool IsPlainMapper(vtkMapper* mapper)
{
  return IsOneOf(mapper,
    { "vtkPolyDataMapper", "vtkOpenGLPolyDataMapper", "vtkCompositePolyDataMapper",
      "vtkCompositePolyDataMapper2", "vtkDataSetMapper", "vtkGlyph3DMapper",
      "vtkOpenGLGlyph3DMapper" });
}

bool HasNoDepth(vtkProp* prop)
{
  return vtkActor2D::SafeDownCast(prop) || vtkVolume::SafeDownCast(prop);
}

void AddObject(vtkObject* object, SceneRecord& record)
{
  record.Add(object, object ? object->GetMTime() : 0);
}

/**
 * Where a texture is transparent mappers draw nothing.
 */
void RecordTexture(vtkTexture* texture, SceneRecord& record)
{
  AddObject(texture, record);
  if (texture && texture->GetNumberOfInputConnections(0) > 0)
  {
    vtkAlgorithmOutput* source = texture->GetInputConnection(0, 0);
    source->GetProducer()->Update(source->GetIndex());
    record.AddData(texture->GetInputDataObject(0, 0));
  }
}

void RecordProperty(vtkProperty* property, SceneRecord& record)
{
  AddObject(property, record);
  if (property)
  {
    for (const auto& texture : property->GetAllTextures())
    {
      RecordTexture(texture.second, record);
    }
  }
}

/**
 * Of replacements in shaders and of the values of their uniforms.
 */
void RecordShader(vtkShaderProperty* shader, SceneRecord& record)
{
  AddObject(shader, record);
  if (shader)
  {
    AddObject(shader->GetVertexCustomUniforms(), record);
    AddObject(shader->GetGeometryCustomUniforms(), record);
    AddObject(shader->GetFragmentCustomUniforms(), record);
  }
}

void RecordMapper(vtkMapper* mapper, SceneRecord& record)
{
  // Whoever observes this may set other values with every frame.
  if (!IsPlainMapper(mapper) || mapper->HasObserver(vtkCommand::UpdateShaderEvent))
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
  // Settings of blocks have a time of their own.
  if (auto* composite = vtkCompositePolyDataMapper2::SafeDownCast(mapper))
  {
    AddObject(composite->GetCompositeDataDisplayAttributes(), record);
  }
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    AddObject(glyphs->GetBlockAttributes(), record);
  }
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    vtkCollectionSimpleIterator iterator;
    planes->InitTraversal(iterator);
    while (vtkPlane* plane = planes->GetNextPlane(iterator))
    {
      AddObject(plane, record);
    }
  }
}

void RecordActor(vtkActor* actor, const Matrix4& matrix, SceneRecord& record)
{
  // A part of an assembly.
  if (!actor->GetVisibility())
  {
    return;
  }
  if (!IsPlainActor(actor))
  {
    record.AddUnknown();
    return;
  }
  // Not the actor's own time: an assembly modifies its parts when it draws them.
  record.Add(actor, 0);
  record.Add(matrix);
  record.Add(static_cast<vtkTypeUInt64>(actor->GetForceOpaque()));
  record.Add(static_cast<vtkTypeUInt64>(actor->GetForceTranslucent()));
  RecordProperty(actor->GetProperty(), record);
  RecordProperty(actor->GetBackfaceProperty(), record);
  RecordShader(actor->GetShaderProperty(), record);
  RecordTexture(actor->GetTexture(), record);
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
  if (!vtkActor::SafeDownCast(prop) && !IsOneOf(prop, { "vtkAssembly" }))
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
  record.Add(vtkMapper::GetResolveCoincidentTopologyZShift());
  record.Add(
    static_cast<vtkTypeUInt64>(vtkMapper::GetResolveCoincidentTopologyPolygonOffsetFaces()));
  for (vtkProp* prop : props)
  {
    RecordProp(prop, record);
  }
  return record;
}
