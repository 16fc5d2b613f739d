/**
 * @class   vtkOffscreenWindows
 * @brief   offscreen render windows by name, or the reason why there is none
 *
 * - "egl": vtkOffscreenEGLRenderWindow, hardware or software, no display needed;
 * - "osmesa": vtkOffscreenOSMesaRenderWindow, only in executables made for OSMesa, and in those
 *   no other;
 * - "native": vtkRenderWindow::New() with offscreen rendering on, which is what VTK was built for:
 *   on Linux an X server at DISPLAY with GLX.
 *
 * Windows come out initialised and tested: OpenGL 3.2 or later, and a pixel drawn and read back.
 * Where a name gives no window nothing is reported; GetLastReason() says why, so that a caller
 * can try the next name.
 */

#ifndef vtkOffscreenWindows_h
#define vtkOffscreenWindows_h

#include "vtkObject.h"
#include "vtkRenderingOffscreenModule.h" // For export macro
#include "vtkWrappingHints.h"            // For VTK_NEWINSTANCE

#include <string> // For std::string

class vtkRenderWindow;

class VTKRENDERINGOFFSCREEN_EXPORT vtkOffscreenWindows : public vtkObject
{
public:
  static vtkOffscreenWindows* New();
  vtkTypeMacro(vtkOffscreenWindows, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * A new window of the kind "egl", "osmesa" or "native", which the caller owns, or nullptr.
   * A name that is null or empty stands for GetDefaultName().
   */
  VTK_NEWINSTANCE static vtkRenderWindow* NewWindow(const char* name);

  /**
   * Why the calling thread's last NewWindow() gave no window; empty if it gave one.
   */
  static std::string GetLastReason();

  /**
   * The name that fits the running executable: "osmesa" in one made for OSMesa, else "egl".
   */
  static const char* GetDefaultName();

protected:
  vtkOffscreenWindows();
  ~vtkOffscreenWindows() override;

private:
  vtkOffscreenWindows(const vtkOffscreenWindows&) = delete;
  void operator=(const vtkOffscreenWindows&) = delete;
};

#endif
