#include "vtkOffscreenRenderWindow.h"

#include "Private/ContextProbe.h"
#include "Private/OffscreenContext.h"
#include "Private/OpenGLLoader.h"

//------------------------------------------------------------------------------
vtkOffscreenRenderWindow::vtkOffscreenRenderWindow()
{
  this->Size[0] = 300;
  this->Size[1] = 300;
  this->ShowWindow = false;
  this->UseOffScreenBuffers = true;
  // There is no default framebuffer that a frame could be copied to, whatever the two flags
  // above become.
  this->FrameBlitMode = NoBlit;
  this->DeviceIndex = -1;
  this->OwnContext = 0;
}

//------------------------------------------------------------------------------
vtkOffscreenRenderWindow::~vtkOffscreenRenderWindow()
{
  this->vtkOffscreenRenderWindow::Finalize();
}

//------------------------------------------------------------------------------
void vtkOffscreenRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Context: " << (this->Context ? this->GetContextDescription() : "(none)") << "\n";
  os << indent
     << "FailureReason: " << (this->FailureReason.empty() ? "(none)" : this->FailureReason) << "\n";
}

//------------------------------------------------------------------------------
std::string vtkOffscreenRenderWindow::GetFailureReason()
{
  return this->FailureReason;
}

//------------------------------------------------------------------------------
std::string vtkOffscreenRenderWindow::GetContextDescription()
{
  return this->Context ? this->Context->GetDescription() : "";
}

//------------------------------------------------------------------------------
void vtkOffscreenRenderWindow::Fail(const std::string& reason)
{
  this->Context.reset();
  this->Initialized = false;
  this->FailureReason = reason;
  this->FailureReported = false;
  this->SupportsOpenGLStatus = 0;
  // The superclass neither renders nor reads pixels without this.
  this->ReadyForRendering = false;
}

//------------------------------------------------------------------------------
bool vtkOffscreenRenderWindow::InitializeContext()
{
  if (this->Context)
  {
    return true;
  }
  if (!this->FailureReason.empty())
  {
    return false;
  }
  std::string reason;
  this->Context = this->CreateContext(reason);
  if (!this->Context)
  {
    this->Fail(reason);
    return false;
  }
#if SMOOTHSHADOW_OPENGL_GLAD
  this->SetOpenGLSymbolLoader(
    [](void* context, const char* name) -> VTKOpenGLAPIProc {
      return static_cast<OffscreenContext*>(context)->GetFunction(name);
    },
    this->Context.get());
#endif
  this->OpenGLInitContext();
  if (!this->Initialized || !ContextProbe::Draws(reason))
  {
    this->Fail(std::string(this->Context->GetDescription()) + ": " +
      (reason.empty() ? "OpenGL's functions could not be loaded" : reason));
    return false;
  }
  this->SupportsOpenGLStatus = 1;
  this->OpenGLInit();
  return true;
}

//------------------------------------------------------------------------------
void vtkOffscreenRenderWindow::Initialize()
{
  if (!this->InitializeContext() && !this->FailureReported)
  {
    this->FailureReported = true;
    vtkErrorMacro(<< this->FailureReason);
  }
}

//------------------------------------------------------------------------------
void vtkOffscreenRenderWindow::Render()
{
  this->Initialize();
  this->Superclass::Render();
}

//------------------------------------------------------------------------------
void vtkOffscreenRenderWindow::Finalize()
{
  if (this->Context)
  {
    this->Superclass::Finalize();
    this->Context.reset();
  }
  if (!this->FailureReason.empty())
  {
    this->FailureReason.clear();
    this->ReadyForRendering = true;
  }
}

//------------------------------------------------------------------------------
void vtkOffscreenRenderWindow::MakeCurrent()
{
  if (this->Context && !this->Context->MakeCurrent())
  {
    vtkErrorMacro(<< this->Context->GetDescription() << ": the context cannot be made current. "
                  << "Is it, or a context of another window system, current in this thread?");
  }
}

//------------------------------------------------------------------------------
bool vtkOffscreenRenderWindow::IsCurrent()
{
  return this->Context && this->Context->IsCurrent();
}

//------------------------------------------------------------------------------
void vtkOffscreenRenderWindow::PushContext()
{
  if (this->Context)
  {
    this->Context->PushCurrent();
  }
}

//------------------------------------------------------------------------------
void vtkOffscreenRenderWindow::PopContext()
{
  if (this->Context)
  {
    this->Context->PopCurrent();
  }
}

//------------------------------------------------------------------------------
int vtkOffscreenRenderWindow::SupportsOpenGL()
{
  return this->InitializeContext() ? 1 : 0;
}

//------------------------------------------------------------------------------
const char* vtkOffscreenRenderWindow::ReportCapabilities()
{
  return this->InitializeContext() ? this->Superclass::ReportCapabilities()
                                   : this->FailureReason.c_str();
}

//------------------------------------------------------------------------------
int vtkOffscreenRenderWindow::GetZbufferData(int x1, int y1, int x2, int y2, float* z)
{
  return this->Context ? this->Superclass::GetZbufferData(x1, y1, x2, y2, z) : VTK_ERROR;
}

//------------------------------------------------------------------------------
bool vtkOffscreenRenderWindow::LoadOpenGL()
{
#if SMOOTHSHADOW_OPENGL_GLAD
  this->Superclass::OpenGLInitContext();
  return this->Initialized;
#else
  // GLEW built for GLX loads all functions of OpenGL, then looks for GLX's own functions and an X
  // display. Where it misses only those it has all that is needed here.
  const GLenum result = glewInit();
  this->GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY ||
    result == GLEW_ERROR_GLX_VERSION_11_ONLY;
  return this->GlewInitValid;
#endif
}

//------------------------------------------------------------------------------
void vtkOffscreenRenderWindow::OpenGLInitContext()
{
  if (this->Initialized || !this->Context)
  {
    return;
  }
  this->ContextCreationTime.Modified();
  this->Initialized = this->LoadOpenGL();
  if (this->Initialized)
  {
    GLfloat range[2] = { 1.0f, 1.0f };
    glGetFloatv(
      this->LineSmoothing ? GL_SMOOTH_LINE_WIDTH_RANGE : GL_ALIASED_LINE_WIDTH_RANGE, range);
    this->MaximumHardwareLineWidth = range[1];
  }
}

//------------------------------------------------------------------------------
void vtkOffscreenRenderWindow::OpenGLInitState()
{
  this->Superclass::OpenGLInitState();
  // The superclass asks the default framebuffer, which does not exist here, for its bits: the
  // answer is an OpenGL error and no alpha. VTK's own framebuffers have eight bits of it.
  this->SetAlphaBitPlanes(8);
  ContextProbe::DrainErrors();
}
