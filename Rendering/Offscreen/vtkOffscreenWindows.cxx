#include "vtkOffscreenWindows.h"

#include "Private/ContextProbe.h"
#include "Private/EGLOffscreenContext.h"
#include "Private/OSMesaFunctions.h"
#include "Private/XServer.h"
#include "vtkObjectFactory.h"
#include "vtkOffscreenEGLRenderWindow.h"
#include "vtkOffscreenOSMesaRenderWindow.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkSmartPointer.h"

vtkStandardNewMacro(vtkOffscreenWindows);

namespace
{
thread_local std::string LastReason;

vtkSmartPointer<vtkRenderWindow> Checked(
  const vtkSmartPointer<vtkOffscreenRenderWindow>& window, std::string& reason)
{
  if (window->InitializeContext())
  {
    return window;
  }
  reason = window->GetFailureReason();
  return nullptr;
}

vtkSmartPointer<vtkRenderWindow> MakeEGL(std::string& reason)
{
  if (OSMesaFunctions::IsInExecutable())
  {
    reason = "all of this executable's OpenGL is OSMesa's: run the one without -osmesa";
    return nullptr;
  }
  return Checked(vtkSmartPointer<vtkOffscreenEGLRenderWindow>::New(), reason);
}

vtkSmartPointer<vtkRenderWindow> MakeNative(std::string& reason)
{
  if (OSMesaFunctions::IsInExecutable())
  {
    reason = "all of this executable's OpenGL is OSMesa's: run the one without -osmesa";
    return nullptr;
  }
  auto window = vtkSmartPointer<vtkRenderWindow>::Take(vtkRenderWindow::New());
  auto* opengl = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (!opengl)
  {
    reason = "VTK has no OpenGL window here: link VTK::RenderingOpenGL2 with vtk_module_autoinit";
    return nullptr;
  }
  // VTK's X window ends the process where it finds no X server with GLX.
  if (window->IsA("vtkXOpenGLRenderWindow") && !XServer::HasGLX(reason))
  {
    return nullptr;
  }
  // So it does where it cannot take the thread over from EGL.
  if (window->IsA("vtkXOpenGLRenderWindow") && EGLOffscreenContext::IsAnyCurrent())
  {
    reason = "an EGL window is current in this thread: delete it first, or use another thread";
    return nullptr;
  }
  window->SetOffScreenRendering(true);
  opengl->Initialize();
  if (!opengl->SupportsOpenGL())
  {
    reason = opengl->GetOpenGLSupportMessage();
    return nullptr;
  }
  opengl->MakeCurrent();
  return ContextProbe::Draws(reason) ? window : nullptr;
}
}

//------------------------------------------------------------------------------
vtkOffscreenWindows::vtkOffscreenWindows() = default;

//------------------------------------------------------------------------------
vtkOffscreenWindows::~vtkOffscreenWindows() = default;

//------------------------------------------------------------------------------
void vtkOffscreenWindows::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DefaultName: " << vtkOffscreenWindows::GetDefaultName() << "\n";
  os << indent << "LastReason: " << (LastReason.empty() ? "(none)" : LastReason) << "\n";
}

//------------------------------------------------------------------------------
vtkRenderWindow* vtkOffscreenWindows::NewWindow(const char* name)
{
  const std::string kind = name && *name ? name : vtkOffscreenWindows::GetDefaultName();
  std::string reason;
  vtkSmartPointer<vtkRenderWindow> window;
  if (kind == "egl")
  {
    window = MakeEGL(reason);
  }
  else if (kind == "osmesa")
  {
    window = Checked(vtkSmartPointer<vtkOffscreenOSMesaRenderWindow>::New(), reason);
  }
  else if (kind == "native")
  {
    window = MakeNative(reason);
  }
  else
  {
    reason = "no such kind of window; there are egl, osmesa and native";
  }
  LastReason = window ? "" : kind + ": " + reason;
  if (window)
  {
    window->Register(nullptr);
  }
  return window;
}

//------------------------------------------------------------------------------
std::string vtkOffscreenWindows::GetLastReason()
{
  return LastReason;
}

//------------------------------------------------------------------------------
const char* vtkOffscreenWindows::GetDefaultName()
{
  return OSMesaFunctions::IsInExecutable() ? "osmesa" : "egl";
}
