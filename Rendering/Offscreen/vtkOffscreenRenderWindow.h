/**
 * @class   vtkOffscreenRenderWindow
 * @brief   render window whose OpenGL context needs no display and no surface
 *
 * What vtkOffscreenEGLRenderWindow and vtkOffscreenOSMesaRenderWindow share. The window owns its
 * context, made at the first Render() or by InitializeContext(), and renders into VTK's own
 * framebuffers only. It works like any offscreen vtkRenderWindow: any size and number of samples,
 * resizing, reading of colour and depth, render passes, and several windows at a time. It never
 * shows anything and takes no events.
 *
 * Defaults: 300 x 300 pixels, offscreen rendering on (turning it off has no effect on what is
 * drawn), DeviceIndex -1.
 *
 * Errors: where no context can be made the first Render() (or Initialize()) reports why, once,
 * with vtkErrorMacro, and Render() does nothing from then on, until Finalize(). Reading from such
 * a window gives VTK_ERROR and leaves the caller's array as it was.
 *
 * A window belongs to the thread that renders with it. Calls of another window or of other code
 * in that thread may change the current context: MakeCurrent() before direct use of OpenGL.
 */

#ifndef vtkOffscreenRenderWindow_h
#define vtkOffscreenRenderWindow_h

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkRenderingOffscreenModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class OffscreenContext;

class VTKRENDERINGOFFSCREEN_EXPORT vtkOffscreenRenderWindow : public vtkGenericOpenGLRenderWindow
{
public:
  vtkAbstractTypeMacro(vtkOffscreenRenderWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Makes the context, loads OpenGL and draws a pixel as a test, unless that was done before.
   * Returns whether the window can render; if not, GetFailureReason() says why. Reports nothing.
   */
  bool InitializeContext();

  /**
   * Why InitializeContext() failed, with what was tried and what to install or set.
   * Empty if it did not fail.
   */
  std::string GetFailureReason();

  /**
   * The kind of context, for instance "EGL, surfaceless Mesa platform". Empty without a context.
   */
  std::string GetContextDescription();

  /// InitializeContext(), with failure reported once.
  void Initialize() override;

  /// Does nothing if no context can be made.
  void Render() override;

  /// Destroys the context and all that VTK has in it. The next Render() makes a new one.
  void Finalize() override;

  void MakeCurrent() override;
  bool IsCurrent() override;

  ///@{
  /**
   * MakeCurrent(), and back to the context that was current before.
   */
  void PushContext() override;
  void PopContext() override;
  ///@}

  /// 1 if a context of OpenGL 3.2 or later could be made.
  int SupportsOpenGL() override;

  /// What OpenGL tells of itself, or the reason for failure.
  const char* ReportCapabilities() override;

  ///@{
  /**
   * The depth buffer, as in vtkRenderWindow. The second form gives VTK_ERROR and leaves z as it
   * was if the window could not be initialised; the others are built on it.
   */
  using vtkGenericOpenGLRenderWindow::GetZbufferData;
  int GetZbufferData(int x1, int y1, int x2, int y2, float* z) override;
  ///@}

  void OpenGLInitContext() override;
  void OpenGLInitState() override;

protected:
  vtkOffscreenRenderWindow();
  ~vtkOffscreenRenderWindow() override;

  /// A new context of this window's kind, current, or nullptr with the reason.
  virtual std::unique_ptr<OffscreenContext> CreateContext(std::string& reason) = 0;

private:
  vtkOffscreenRenderWindow(const vtkOffscreenRenderWindow&) = delete;
  void operator=(const vtkOffscreenRenderWindow&) = delete;

  bool LoadOpenGL();
  void Fail(const std::string& reason);

  std::unique_ptr<OffscreenContext> Context;
  std::string FailureReason;
  bool FailureReported = false;
};

#endif
