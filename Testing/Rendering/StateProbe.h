/**
 * @brief What state of OpenGL a render pass finds and leaves.
 */
#ifndef shadowtest_StateProbe_h
#define shadowtest_StateProbe_h

#include <vtkRenderPass.h>
#include <vtkSmartPointer.h>

#include <map>
#include <string>
#include <vector>

namespace shadowtest
{
/// Values by name.
using OpenGLValues = std::map<std::string, std::vector<int>>;

/// All that a pass may be tempted to set, of the context that is current.
OpenGLValues QueryState();

/**
 * Notes OpenGL's state before and after its delegate, and OpenGL's errors.
 */
class ProbePass : public vtkRenderPass
{
public:
  static ProbePass* New();
  vtkTypeMacro(ProbePass, vtkRenderPass);

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  vtkSmartPointer<vtkRenderPass> Delegate;

  /// Sets values before the delegate draws that nobody would leave behind by chance.
  bool SetOddValues = false;

  OpenGLValues Before;
  OpenGLValues After;
  unsigned int Error = 0;
};
}

#endif
