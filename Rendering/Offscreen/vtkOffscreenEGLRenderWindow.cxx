#include "vtkOffscreenEGLRenderWindow.h"

#include "Private/EGLOffscreenContext.h"
#include "Private/OffscreenContext.h"
#include "vtkObjectFactory.h"

#include <cstdlib>

vtkStandardNewMacro(vtkOffscreenEGLRenderWindow);

//------------------------------------------------------------------------------
vtkOffscreenEGLRenderWindow::vtkOffscreenEGLRenderWindow()
{
  const char* index = std::getenv("VTK_DEFAULT_EGL_DEVICE_INDEX");
  if (index && *index)
  {
    this->DeviceIndex = std::atoi(index);
  }
}

//------------------------------------------------------------------------------
vtkOffscreenEGLRenderWindow::~vtkOffscreenEGLRenderWindow() = default;

//------------------------------------------------------------------------------
void vtkOffscreenEGLRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
std::unique_ptr<OffscreenContext> vtkOffscreenEGLRenderWindow::CreateContext(std::string& reason)
{
  return EGLOffscreenContext::Create(this->DeviceIndex, reason);
}
