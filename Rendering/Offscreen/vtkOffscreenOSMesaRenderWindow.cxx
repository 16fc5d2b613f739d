#include "vtkOffscreenOSMesaRenderWindow.h"

#include "Private/OSMesaOffscreenContext.h"
#include "Private/OffscreenContext.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOffscreenOSMesaRenderWindow);

//------------------------------------------------------------------------------
vtkOffscreenOSMesaRenderWindow::vtkOffscreenOSMesaRenderWindow() = default;

//------------------------------------------------------------------------------
vtkOffscreenOSMesaRenderWindow::~vtkOffscreenOSMesaRenderWindow() = default;

//------------------------------------------------------------------------------
void vtkOffscreenOSMesaRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
std::unique_ptr<OffscreenContext> vtkOffscreenOSMesaRenderWindow::CreateContext(std::string& reason)
{
  return OSMesaOffscreenContext::Create(reason);
}
