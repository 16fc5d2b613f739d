/**
 * @brief What VTK and OpenGL complain about, and what is kept on the graphics card.
 */
#ifndef shadowtest_OpenGLWatch_h
#define shadowtest_OpenGLWatch_h

#include <vtkSmartPointer.h>

#include <iosfwd>
#include <string>
#include <vector>

class vtkRenderWindow;

namespace shadowtest
{
/**
 * Takes down all that VTK says and all errors that OpenGL raises in a window's context, while it
 * lives. Passes of VTK fetch errors and drop them, so these are asked of OpenGL's debug output,
 * where there is such.
 */
class OpenGLWatch
{
public:
  explicit OpenGLWatch(vtkRenderWindow* window);
  ~OpenGLWatch();
  OpenGLWatch(const OpenGLWatch&) = delete;
  OpenGLWatch& operator=(const OpenGLWatch&) = delete;

  /// Since the beginning.
  std::vector<std::string> Complaints() const;

private:
  class Output;

  vtkRenderWindow* Window;
  vtkSmartPointer<Output> Said;
  std::vector<std::string> Raised;
};

/// Expects no complaints.
void ExpectQuiet(const OpenGLWatch& watch);

/// How many objects of each kind a context has.
struct GraphicsObjects
{
  int Textures = 0;
  int Renderbuffers = 0;
  int Framebuffers = 0;
  int Buffers = 0;
  int VertexArrays = 0;

  bool operator==(const GraphicsObjects& other) const;
  bool operator!=(const GraphicsObjects& other) const { return !(*this == other); }
};

std::ostream& operator<<(std::ostream& out, const GraphicsObjects& objects);

/// Of the window's context.
GraphicsObjects CountGraphicsObjects(vtkRenderWindow* window);
}

#endif
