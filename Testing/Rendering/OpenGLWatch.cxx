#include "OpenGLWatch.h"

#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkRenderWindow.h>

#if __has_include(<vtk_glad.h>)
#include <vtk_glad.h>
#else
#include <vtk_glew.h>
#endif

#include <gtest/gtest.h>

#include <ostream>
#include <tuple>

namespace shadowtest
{
namespace
{
/// Names are handed out in order and used again, so all lie below this.
constexpr unsigned int MostNames = 1u << 14;

void GLAPIENTRY Note(
  GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message, const void* raised)
{
  if (type == GL_DEBUG_TYPE_ERROR)
  {
    auto* list = static_cast<std::vector<std::string>*>(const_cast<void*>(raised));
    list->emplace_back(message);
  }
}

void SetNote(const std::vector<std::string>* raised)
{
  if (!glDebugMessageCallback)
  {
    return;
  }
  glDebugMessageCallback(raised ? &Note : nullptr, raised);
  for (const GLenum capability : { GL_DEBUG_OUTPUT, GL_DEBUG_OUTPUT_SYNCHRONOUS })
  {
    raised ? glEnable(capability) : glDisable(capability);
  }
}
}

/**
 * Keeps what VTK has to say.
 */
class OpenGLWatch::Output : public vtkOutputWindow
{
public:
  static Output* New();
  vtkTypeMacro(Output, vtkOutputWindow);

  void DisplayText(const char* text) override { this->Lines.emplace_back(text); }

  std::vector<std::string> Lines;
};
vtkStandardNewMacro(OpenGLWatch::Output);

//------------------------------------------------------------------------------------------------
OpenGLWatch::OpenGLWatch(vtkRenderWindow* window)
  : Window(window)
  , Said(vtkSmartPointer<Output>::New())
{
  window->SupportsOpenGL(); // makes the context
  window->MakeCurrent();
  while (glGetError() != GL_NO_ERROR)
  {
  }
  SetNote(&this->Raised);
  vtkOutputWindow::SetInstance(this->Said);
}

OpenGLWatch::~OpenGLWatch()
{
  vtkOutputWindow::SetInstance(nullptr);
  this->Window->MakeCurrent();
  SetNote(nullptr);
}

std::vector<std::string> OpenGLWatch::Complaints() const
{
  std::vector<std::string> all = this->Said->Lines;
  all.insert(all.end(), this->Raised.begin(), this->Raised.end());
  this->Window->MakeCurrent();
  for (GLenum error = glGetError(); error != GL_NO_ERROR; error = glGetError())
  {
    all.push_back("OpenGL error " + std::to_string(error));
  }
  return all;
}

void ExpectQuiet(const OpenGLWatch& watch)
{
  for (const std::string& complaint : watch.Complaints())
  {
    ADD_FAILURE() << complaint;
  }
}

//------------------------------------------------------------------------------------------------
bool GraphicsObjects::operator==(const GraphicsObjects& other) const
{
  const auto all = [](const GraphicsObjects& objects) {
    return std::tie(objects.Textures, objects.Renderbuffers, objects.Framebuffers, objects.Buffers,
      objects.VertexArrays);
  };
  return all(*this) == all(other);
}

std::ostream& operator<<(std::ostream& out, const GraphicsObjects& objects)
{
  return out << objects.Textures << " textures, " << objects.Renderbuffers << " renderbuffers, "
             << objects.Framebuffers << " framebuffers, " << objects.Buffers << " buffers, "
             << objects.VertexArrays << " vertex arrays";
}

GraphicsObjects CountGraphicsObjects(vtkRenderWindow* window)
{
  window->MakeCurrent();
  GraphicsObjects objects;
  for (GLuint name = 1; name < MostNames; ++name)
  {
    objects.Textures += glIsTexture(name) == GL_TRUE;
    objects.Renderbuffers += glIsRenderbuffer(name) == GL_TRUE;
    objects.Framebuffers += glIsFramebuffer(name) == GL_TRUE;
    objects.Buffers += glIsBuffer(name) == GL_TRUE;
    objects.VertexArrays += glIsVertexArray(name) == GL_TRUE;
  }
  return objects;
}
}
