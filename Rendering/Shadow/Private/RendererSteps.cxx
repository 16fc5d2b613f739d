#include "RendererSteps.h"

#include "vtkCameraPass.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOverlayPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkTranslucentPass.h"
#include "vtkVolumetricPass.h"

namespace
{
template <typename... Passes>
vtkSmartPointer<vtkRenderPassCollection> MakeCollection()
{
  auto passes = vtkSmartPointer<vtkRenderPassCollection>::New();
  (passes->AddItem(vtkNew<Passes>()), ...);
  return passes;
}

/**
 * The renderer's own drawing of its props. Within passes that have a framebuffer of their own, as
 * vtkSSAAPass, it is the plain one: the renderer blends translucent geometry with a depth buffer
 * that has the format of the window's, and VTK cannot copy another format into it.
 */
class GeometryPass : public vtkRenderPass
{
public:
  static GeometryPass* New();
  vtkTypeMacro(GeometryPass, vtkRenderPass);

  void Render(const vtkRenderState* state) override
  {
    if (state->GetFrameBuffer())
    {
      this->Plain->Render(state);
      this->NumberOfRenderedProps = this->Plain->GetNumberOfRenderedProps();
      return;
    }
    this->UpdateGeometry(state->GetRenderer());
    this->NumberOfRenderedProps = state->GetRenderer()->GetNumberOfPropsRendered();
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Plain->ReleaseGraphicsResources(window);
  }

private:
  GeometryPass()
  {
    this->Plain->SetPasses(
      MakeCollection<vtkOpaquePass, vtkTranslucentPass, vtkVolumetricPass, vtkOverlayPass>());
  }

  vtkNew<vtkSequencePass> Plain;
};
vtkStandardNewMacro(GeometryPass);
}

vtkSmartPointer<vtkRenderPass> MakeRendererSteps()
{
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(MakeCollection<vtkLightsPass, GeometryPass>());
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(sequence);
  return camera;
}
