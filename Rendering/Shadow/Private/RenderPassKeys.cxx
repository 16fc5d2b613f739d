#include "RenderPassKeys.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProp.h"
#include "vtkRenderState.h"

namespace
{
/**
 * The place of the pass in the keys, or -1.
 */
int FindPass(vtkInformation* keys, vtkOpenGLRenderPass* pass)
{
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  for (int place = keys->Length(passes) - 1; place >= 0; --place)
  {
    if (keys->Get(passes, place) == pass)
    {
      return place;
    }
  }
  return -1;
}

/**
 * One by one: removing the key as a whole would leave the passes with a reference too many.
 */
void RemoveAll(vtkInformation* keys)
{
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  for (int place = keys->Length(passes) - 1; place >= 0; --place)
  {
    keys->Remove(passes, place);
  }
}
}

void JoinProps(const vtkRenderState* state, vtkOpenGLRenderPass* pass)
{
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = state->GetPropArray()[i];
    if (!prop->GetPropertyKeys())
    {
      prop->SetPropertyKeys(vtkNew<vtkInformation>());
    }
    if (FindPass(prop->GetPropertyKeys(), pass) < 0)
    {
      prop->GetPropertyKeys()->Append(vtkOpenGLRenderPass::RenderPasses(), pass);
    }
  }
}

void LeaveProps(const vtkRenderState* state, vtkOpenGLRenderPass* pass)
{
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    vtkInformation* keys = state->GetPropArray()[i]->GetPropertyKeys();
    const int place = keys ? FindPass(keys, pass) : -1;
    if (place >= 0)
    {
      keys->Remove(passes, place);
      if (keys->Length(passes) == 0)
      {
        keys->Remove(passes);
      }
    }
  }
}

LoneRenderPass::LoneRenderPass(const vtkRenderState* state, vtkOpenGLRenderPass* pass)
{
  vtkInformationObjectBaseVectorKey* passes = vtkOpenGLRenderPass::RenderPasses();
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    vtkInformation* keys = state->GetPropArray()[i]->GetPropertyKeys();
    const int count = keys ? keys->Length(passes) : 0;
    if (count < 2)
    {
      continue;
    }
    Saved saved;
    saved.Keys = keys;
    for (int place = 0; place < count; ++place)
    {
      saved.Passes.emplace_back(keys->Get(passes, place));
    }
    RemoveAll(keys);
    keys->Append(passes, pass);
    this->All.push_back(std::move(saved));
  }
}

LoneRenderPass::~LoneRenderPass()
{
  for (const Saved& saved : this->All)
  {
    RemoveAll(saved.Keys);
    for (const auto& pass : saved.Passes)
    {
      saved.Keys->Append(vtkOpenGLRenderPass::RenderPasses(), pass);
    }
  }
}
