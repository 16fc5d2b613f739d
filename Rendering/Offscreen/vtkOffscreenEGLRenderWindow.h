/**
 * @class   vtkOffscreenEGLRenderWindow
 * @brief   offscreen render window on EGL, hardware or software, without any display
 *
 * See vtkOffscreenRenderWindow for what all offscreen windows have in common. The context is a
 * desktop OpenGL core context of version 4.5, else 3.3, else 3.2, without a surface.
 *
 * DeviceIndex (vtkRenderWindow), to be set before the first Render(), chooses the driver: below 0
 * the surfaceless Mesa platform, then every EGL device in the driver's order; from 0 on that EGL
 * device only. Default: the environment variable VTK_DEFAULT_EGL_DEVICE_INDEX, else -1.
 *
 * VTK's own vtkEGLRenderWindow needs a VTK that was built for EGL; this class also works in one
 * that was built for X11 only, such as Debian's.
 *
 * A thread can have the context of one window system at a time, and VTK's X window ends the process
 * where it finds EGL's: do not use windows of both in one thread but one after the other, the first
 * deleted.
 */

#ifndef vtkOffscreenEGLRenderWindow_h
#define vtkOffscreenEGLRenderWindow_h

#include "vtkOffscreenRenderWindow.h"
#include "vtkRenderingOffscreenModule.h" // For export macro

class VTKRENDERINGOFFSCREEN_EXPORT vtkOffscreenEGLRenderWindow : public vtkOffscreenRenderWindow
{
public:
  static vtkOffscreenEGLRenderWindow* New();
  vtkTypeMacro(vtkOffscreenEGLRenderWindow, vtkOffscreenRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkOffscreenEGLRenderWindow();
  ~vtkOffscreenEGLRenderWindow() override;

  std::unique_ptr<OffscreenContext> CreateContext(std::string& reason) override;

private:
  vtkOffscreenEGLRenderWindow(const vtkOffscreenEGLRenderWindow&) = delete;
  void operator=(const vtkOffscreenEGLRenderWindow&) = delete;
};

#endif
