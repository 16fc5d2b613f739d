#include "RestoredState.h"

#include "DepthBoundsTest.h"
#include "OpenGLFunctions.h"

#include "vtkOpenGLState.h"

namespace
{
constexpr std::array<GLenum, 5> Capabilities = { GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST,
  GL_SCISSOR_TEST, GL_STENCIL_TEST };
constexpr std::array<GLenum, 2> Faces = { GL_FRONT, GL_BACK };

// The queries of both faces, in the order of StencilFace.
constexpr std::array<std::array<GLenum, 7>, 2> StencilQueries = { {
  { GL_STENCIL_WRITEMASK, GL_STENCIL_FUNC, GL_STENCIL_REF, GL_STENCIL_VALUE_MASK, GL_STENCIL_FAIL,
    GL_STENCIL_PASS_DEPTH_FAIL, GL_STENCIL_PASS_DEPTH_PASS },
  { GL_STENCIL_BACK_WRITEMASK, GL_STENCIL_BACK_FUNC, GL_STENCIL_BACK_REF,
    GL_STENCIL_BACK_VALUE_MASK, GL_STENCIL_BACK_FAIL, GL_STENCIL_BACK_PASS_DEPTH_FAIL,
    GL_STENCIL_BACK_PASS_DEPTH_PASS },
} };

int GetInteger(GLenum name)
{
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

void SetEnabled(GLenum name, bool enabled)
{
  enabled ? glEnable(name) : glDisable(name);
}
}

RestoredState::RestoredState(vtkOpenGLState* state)
  : State(state)
{
  for (std::size_t i = 0; i < Capabilities.size(); ++i)
  {
    this->Enabled[i] = glIsEnabled(Capabilities[i]) == GL_TRUE;
  }
  glGetIntegerv(GL_VIEWPORT, this->Viewport.data());
  glGetIntegerv(GL_SCISSOR_BOX, this->Scissor.data());
  glGetBooleanv(GL_COLOR_WRITEMASK, this->ColorMask.data());
  this->BlendFunction = { GetInteger(GL_BLEND_SRC_RGB), GetInteger(GL_BLEND_DST_RGB),
    GetInteger(GL_BLEND_SRC_ALPHA), GetInteger(GL_BLEND_DST_ALPHA) };
  this->BlendEquation = { GetInteger(GL_BLEND_EQUATION_RGB), GetInteger(GL_BLEND_EQUATION_ALPHA) };
  glGetBooleanv(GL_DEPTH_WRITEMASK, &this->DepthMask);
  this->DepthFunction = GetInteger(GL_DEPTH_FUNC);
  this->ActiveTexture = GetInteger(GL_ACTIVE_TEXTURE);
  for (std::size_t face = 0; face < Faces.size(); ++face)
  {
    const auto& queries = StencilQueries[face];
    this->Stencil[face] = { GetInteger(queries[0]), GetInteger(queries[1]), GetInteger(queries[2]),
      GetInteger(queries[3]), GetInteger(queries[4]), GetInteger(queries[5]),
      GetInteger(queries[6]) };
  }
  this->DepthClamp = glIsEnabled(GL_DEPTH_CLAMP) == GL_TRUE;
  this->DepthBounds = DepthBoundsTest::GetRange();
  this->PolygonOffset = glIsEnabled(GL_POLYGON_OFFSET_FILL) == GL_TRUE;
  glGetFloatv(GL_POLYGON_OFFSET_FACTOR, &this->OffsetFactor);
  glGetFloatv(GL_POLYGON_OFFSET_UNITS, &this->OffsetUnits);
  this->FrontFace = GetInteger(GL_FRONT_FACE);
  this->VertexArray = GetInteger(GL_VERTEX_ARRAY_BINDING);
  this->ArrayBuffer = GetInteger(GL_ARRAY_BUFFER_BINDING);
  this->State->PushFramebufferBindings();
}

RestoredState::~RestoredState()
{
  this->State->PopFramebufferBindings();
  for (std::size_t i = 0; i < Capabilities.size(); ++i)
  {
    this->State->SetEnumState(Capabilities[i], this->Enabled[i]);
  }
  this->State->vtkglViewport(
    this->Viewport[0], this->Viewport[1], this->Viewport[2], this->Viewport[3]);
  this->State->vtkglScissor(this->Scissor[0], this->Scissor[1], this->Scissor[2], this->Scissor[3]);
  this->State->vtkglColorMask(
    this->ColorMask[0], this->ColorMask[1], this->ColorMask[2], this->ColorMask[3]);
  this->State->vtkglBlendFuncSeparate(static_cast<GLenum>(this->BlendFunction[0]),
    static_cast<GLenum>(this->BlendFunction[1]), static_cast<GLenum>(this->BlendFunction[2]),
    static_cast<GLenum>(this->BlendFunction[3]));
  this->State->vtkglBlendEquationSeparate(static_cast<GLenum>(this->BlendEquation[0]),
    static_cast<GLenum>(this->BlendEquation[1]));
  this->State->vtkglDepthMask(this->DepthMask);
  this->State->vtkglDepthFunc(static_cast<GLenum>(this->DepthFunction));
  this->State->vtkglActiveTexture(static_cast<GLenum>(this->ActiveTexture));
  for (std::size_t face = 0; face < Faces.size(); ++face)
  {
    const StencilFace& saved = this->Stencil[face];
    this->State->vtkglStencilMaskSeparate(Faces[face], static_cast<GLuint>(saved.WriteMask));
    this->State->vtkglStencilFuncSeparate(Faces[face], static_cast<GLenum>(saved.Function),
      saved.Reference, static_cast<GLuint>(saved.ValueMask));
    this->State->vtkglStencilOpSeparate(Faces[face], static_cast<GLenum>(saved.Fail),
      static_cast<GLenum>(saved.DepthFail), static_cast<GLenum>(saved.DepthPass));
  }
  SetEnabled(GL_DEPTH_CLAMP, this->DepthClamp);
  DepthBoundsTest::SetRange(this->DepthBounds);
  SetEnabled(GL_POLYGON_OFFSET_FILL, this->PolygonOffset);
  glPolygonOffset(this->OffsetFactor, this->OffsetUnits);
  glFrontFace(static_cast<GLenum>(this->FrontFace));
  glBindVertexArray(static_cast<GLuint>(this->VertexArray));
  glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(this->ArrayBuffer));
}
