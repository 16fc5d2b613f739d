#include "ContextProbe.h"

#include "OpenGLLoader.h"

#include <array>
#include <cmath>

namespace
{
const std::array<float, 4> Colour = { 0.2f, 0.4f, 0.6f, 1.0f };

std::array<unsigned char, 4> FillAndRead()
{
  const GLboolean scissor = glIsEnabled(GL_SCISSOR_TEST);
  GLboolean mask[4];
  glGetBooleanv(GL_COLOR_WRITEMASK, mask);
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

  std::array<unsigned char, 4> pixel{};
  glClearBufferfv(GL_COLOR, 0, Colour.data());
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());

  glColorMask(mask[0], mask[1], mask[2], mask[3]);
  if (scissor)
  {
    glEnable(GL_SCISSOR_TEST);
  }
  return pixel;
}

bool IsColour(const std::array<unsigned char, 4>& pixel)
{
  for (std::size_t i = 0; i < 4; ++i)
  {
    if (std::abs(static_cast<float>(pixel[i]) - 255.0f * Colour[i]) > 1.0f)
    {
      return false;
    }
  }
  return true;
}

bool DrawsIntoFramebuffer(std::string& reason)
{
  GLint drawBefore = 0, readBefore = 0, renderbufferBefore = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawBefore);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &readBefore);
  glGetIntegerv(GL_RENDERBUFFER_BINDING, &renderbufferBefore);

  GLuint framebuffer = 0;
  GLuint buffers[2] = { 0, 0 };
  glGenFramebuffers(1, &framebuffer);
  glGenRenderbuffers(2, buffers);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 1, 1);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
  glBindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, 1, 1);
  glFramebufferRenderbuffer(
    GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);

  bool good = true;
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
  {
    reason = "the driver makes no framebuffer with colour, depth and stencil";
    good = false;
  }
  else if (!IsColour(FillAndRead()))
  {
    reason = "the driver's picture is not what was drawn";
    good = false;
  }

  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawBefore));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(readBefore));
  glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(renderbufferBefore));
  glDeleteRenderbuffers(2, buffers);
  glDeleteFramebuffers(1, &framebuffer);
  return good;
}
}

bool ContextProbe::Draws(std::string& reason)
{
  const GLubyte* version = glGetString(GL_VERSION);
  if (!version)
  {
    reason = "OpenGL knows of no current context";
    return false;
  }
  GLint major = 0, minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  if (major < 3 || (major == 3 && minor < 2))
  {
    reason = std::string("OpenGL 3.2 is needed, this is ") + reinterpret_cast<const char*>(version);
    return false;
  }
  const bool good = DrawsIntoFramebuffer(reason);
  DrainErrors();
  return good;
}

void ContextProbe::DrainErrors()
{
  // Bounded: without a current context some libraries report an error for ever.
  for (int i = 0; i < 64 && glGetError() != GL_NO_ERROR; ++i)
  {
  }
}
