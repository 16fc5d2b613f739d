#include "StateProbe.h"

#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>

#if __has_include(<vtk_glad.h>)
#include <vtk_glad.h>
#else
#include <vtk_glew.h>
#endif

#include <utility>

namespace shadowtest
{
OpenGLValues QueryState()
{
  static const std::vector<std::pair<const char*, GLenum>> switches = { { "blend", GL_BLEND },
    { "cull face", GL_CULL_FACE }, { "depth test", GL_DEPTH_TEST },
    { "scissor test", GL_SCISSOR_TEST }, { "stencil test", GL_STENCIL_TEST },
    { "offset fill", GL_POLYGON_OFFSET_FILL }, { "depth clamp", GL_DEPTH_CLAMP },
    { "multisample", GL_MULTISAMPLE } };
  static const std::vector<std::pair<const char*, GLenum>> integers = { { "viewport", GL_VIEWPORT },
    { "scissor", GL_SCISSOR_BOX }, { "color mask", GL_COLOR_WRITEMASK },
    { "depth mask", GL_DEPTH_WRITEMASK }, { "depth function", GL_DEPTH_FUNC },
    { "stencil mask", GL_STENCIL_WRITEMASK }, { "stencil function", GL_STENCIL_FUNC },
    { "stencil reference", GL_STENCIL_REF }, { "stencil fail", GL_STENCIL_FAIL },
    { "stencil depth fail", GL_STENCIL_PASS_DEPTH_FAIL },
    { "stencil pass", GL_STENCIL_PASS_DEPTH_PASS },
    { "back depth fail", GL_STENCIL_BACK_PASS_DEPTH_FAIL },
    { "back function", GL_STENCIL_BACK_FUNC }, { "stencil clear", GL_STENCIL_CLEAR_VALUE },
    { "front face", GL_FRONT_FACE }, { "offset factor", GL_POLYGON_OFFSET_FACTOR },
    { "offset units", GL_POLYGON_OFFSET_UNITS }, { "draw buffers", GL_DRAW_FRAMEBUFFER_BINDING },
    { "read buffers", GL_READ_FRAMEBUFFER_BINDING }, { "draw buffer", GL_DRAW_BUFFER },
    { "renderbuffer", GL_RENDERBUFFER_BINDING }, { "active texture", GL_ACTIVE_TEXTURE },
    { "array texture", GL_TEXTURE_BINDING_2D_ARRAY }, { "blend source", GL_BLEND_SRC_RGB },
    { "blend destination", GL_BLEND_DST_RGB },
    { "blend source alpha", GL_BLEND_SRC_ALPHA }, { "blend destination alpha", GL_BLEND_DST_ALPHA },
    { "blend equation", GL_BLEND_EQUATION_RGB }, { "blend equation alpha", GL_BLEND_EQUATION_ALPHA },
    { "depth clear", GL_DEPTH_CLEAR_VALUE },
    { "color clear", GL_COLOR_CLEAR_VALUE }, { "pack alignment", GL_PACK_ALIGNMENT } };
  OpenGLValues state;
  for (const auto& query : switches)
  {
    state[query.first] = { glIsEnabled(query.second) };
  }
  for (const auto& query : integers)
  {
    GLint values[4] = { 0, 0, 0, 0 };
    glGetIntegerv(query.second, values);
    state[query.first] = { values[0], values[1], values[2], values[3] };
  }
  return state;
}

//------------------------------------------------------------------------------------------------
vtkStandardNewMacro(ProbePass);

void ProbePass::Render(const vtkRenderState* state)
{
  while (glGetError() != GL_NO_ERROR)
  {
  }
  if (this->SetOddValues)
  {
    vtkOpenGLState* known =
      vtkOpenGLRenderWindow::SafeDownCast(state->GetRenderer()->GetRenderWindow())->GetState();
    known->vtkglDepthFunc(GL_NOTEQUAL);
    known->vtkglStencilMask(0x3c);
    known->vtkglStencilFunc(GL_ALWAYS, 5, 0x7e);
    known->vtkglStencilOp(GL_INVERT, GL_INCR, GL_REPLACE);
    known->vtkglEnable(GL_CULL_FACE);
    known->vtkglBlendFuncSeparate(GL_DST_COLOR, GL_ONE_MINUS_DST_ALPHA, GL_ZERO, GL_SRC_ALPHA);
    known->vtkglBlendEquationSeparate(GL_FUNC_REVERSE_SUBTRACT, GL_MAX);
    known->vtkglEnable(GL_STENCIL_TEST);
    glFrontFace(GL_CW);
    glPolygonOffset(0.5f, 3.0f);
    glClearStencil(9);
  }
  this->Before = QueryState();
  this->Delegate->Render(state);
  this->Error = glGetError();
  this->After = QueryState();
}

void ProbePass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Delegate->ReleaseGraphicsResources(window);
}
}
