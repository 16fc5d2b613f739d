/**
 * The render passes that props know of, by their property keys.
 */
#ifndef RenderPassKeys_h
#define RenderPassKeys_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkInformation;
class vtkObjectBase;
class vtkOpenGLRenderPass;
class vtkRenderState;

/**
 * Adds the pass to the props of the state, or takes it off. vtkOpenGLRenderPass::PreRender adds it
 * once a prop, twice to keys that two props share, and PostRender then leaves a reference too
 * many; here it is added once to each keys.
 */
void JoinProps(const vtkRenderState* state, vtkOpenGLRenderPass* pass);
void LeaveProps(const vtkRenderState* state, vtkOpenGLRenderPass* pass);

/**
 * Makes one pass the only one that the props know of, and sets the others back in its destructor.
 *
 * Passes around take part in each drawing of the props that they have joined. vtkSSAOPass for one
 * then sets the draw buffers of its framebuffer, which is not the one that the depth stage draws
 * into.
 */
class LoneRenderPass
{
public:
  LoneRenderPass(const vtkRenderState* state, vtkOpenGLRenderPass* pass);
  ~LoneRenderPass();

  LoneRenderPass(const LoneRenderPass&) = delete;
  LoneRenderPass& operator=(const LoneRenderPass&) = delete;

private:
  struct Saved
  {
    vtkSmartPointer<vtkInformation> Keys;
    std::vector<vtkSmartPointer<vtkObjectBase>> Passes;
  };

  std::vector<Saved> All;
};

#endif
