/**
 * @class   vtkOffscreenOSMesaRenderWindow
 * @brief   offscreen render window on OSMesa, Mesa's software renderer without any driver
 *
 * See vtkOffscreenRenderWindow for what all offscreen windows have in common. The context is an
 * OpenGL core context of version 3.3, else 3.2.
 *
 * OSMesa is a property of the executable: all of OpenGL in the process must come from libOSMesa.
 * The CMake function smoothshadow_add_osmesa_twin makes such an executable. In any other one the
 * window reports that, as a failure like any other.
 *
 * Mesa 25.1 and later have no OSMesa: prefer vtkOffscreenEGLRenderWindow.
 */

#ifndef vtkOffscreenOSMesaRenderWindow_h
#define vtkOffscreenOSMesaRenderWindow_h

#include "vtkOffscreenRenderWindow.h"
#include "vtkRenderingOffscreenModule.h" // For export macro

class VTKRENDERINGOFFSCREEN_EXPORT vtkOffscreenOSMesaRenderWindow : public vtkOffscreenRenderWindow
{
public:
  static vtkOffscreenOSMesaRenderWindow* New();
  vtkTypeMacro(vtkOffscreenOSMesaRenderWindow, vtkOffscreenRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkOffscreenOSMesaRenderWindow();
  ~vtkOffscreenOSMesaRenderWindow() override;

  std::unique_ptr<OffscreenContext> CreateContext(std::string& reason) override;

private:
  vtkOffscreenOSMesaRenderWindow(const vtkOffscreenOSMesaRenderWindow&) = delete;
  void operator=(const vtkOffscreenOSMesaRenderWindow&) = delete;
};

#endif
