#include "VolumeCounter.h"

#include "OpenGLFunctions.h"
#include "VolumeBuffers.h"

#include "ShadowCountsMaskFS.h"
#include "ShadowMaskFS.h"
#include "ShadowMaskVS.h"
#include "ShadowVolumeFS.h"
#include "ShadowVolumeVS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

bool VolumeCounter::Prepare(vtkOpenGLRenderWindow* window, std::string& error)
{
  if (this->CountProgram && this->MaskProgram && this->CountsMaskProgram)
  {
    return true;
  }
  this->Window = window;
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  this->MaskProgram = cache->ReadyShaderProgram(ShadowMaskVS, ShadowMaskFS, "");
  this->CountsMaskProgram = cache->ReadyShaderProgram(ShadowMaskVS, ShadowCountsMaskFS, "");
  this->CountProgram = cache->ReadyShaderProgram(ShadowVolumeVS, ShadowVolumeFS, "");
  const GLint attribute = this->CountProgram
    ? glGetAttribLocation(static_cast<GLuint>(this->CountProgram->GetHandle()), "homogeneous")
    : -1;
  if (!this->MaskProgram || !this->CountsMaskProgram || attribute < 0)
  {
    error = "the volumes' shaders do not compile";
    return false;
  }
  this->Attribute = static_cast<unsigned int>(attribute);
  glGenVertexArrays(1, &this->EmptyVertexArray);
  return true;
}

void VolumeCounter::Release()
{
  if (this->EmptyVertexArray)
  {
    glDeleteVertexArrays(1, &this->EmptyVertexArray);
  }
  *this = VolumeCounter();
}

void VolumeCounter::BeginCounting(vtkOpenGLState* state)
{
  this->Window->GetShaderCache()->ReadyShaderProgram(this->CountProgram);
  state->vtkglDepthMask(GL_FALSE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);

  // Without it the near and the far plane would cut the volumes open.
  glEnable(GL_DEPTH_CLAMP);
  glPolygonOffset(1.0f, 1.0f);
}

void VolumeCounter::BeginCountingInStencil(vtkOpenGLState* state)
{
  this->BeginCounting(state);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDepthFunc(GL_LESS);
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglStencilMask(~0u);
  state->vtkglStencilFunc(GL_ALWAYS, 0, ~0u);
  state->vtkglStencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
  state->vtkglStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
}

void VolumeCounter::BeginCountingInFloats(vtkOpenGLState* state)
{
  this->BeginCounting(state);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFunc(GL_ONE, GL_ONE);

  // What fails the stencil's test passes this one.
  state->vtkglDepthFunc(GL_GEQUAL);
}

void VolumeCounter::Count(const VolumeBuffers& volume, const Matrix4& toClip)
{
  // Wound as OpenGL expects it unless some matrix on the way mirrors. View to clip coordinates
  // always changes handedness, so the usual sign is negative.
  glFrontFace(vtkMatrix4x4::Determinant(toClip.data()) < 0.0 ? GL_CCW : GL_CW);

  // The origin goes into the matrix while that is still in double.
  const Matrix4 columns = Transposed(toClip * Translation(volume.GetOrigin()));
  std::array<float, 16> uniform;
  std::transform(columns.begin(), columns.end(), uniform.begin(),
    [](double value) { return static_cast<float>(value); });
  this->CountProgram->SetUniformMatrix4x4("volumeToClip", uniform.data());

  // A cap is as deep as the surface that it is part of. It must count as behind it: so a lit
  // surface is not in its own cap's shadow, and a dark one always is in that of its dark cap.
  glEnable(GL_POLYGON_OFFSET_FILL);
  volume.DrawCaps();
  glDisable(GL_POLYGON_OFFSET_FILL);
  volume.DrawSides();
}

void VolumeCounter::WriteMaskOfStencil(vtkOpenGLState* state)
{
  state->vtkglStencilFunc(GL_NOTEQUAL, 0, ~0u);
  state->vtkglStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  this->WriteMask(state, this->MaskProgram);
}

void VolumeCounter::WriteMaskOfFloats(vtkOpenGLState* state, unsigned int counts, int unit)
{
  state->vtkglDisable(GL_BLEND);
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(unit));
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  glBindTexture(GL_TEXTURE_2D, counts);
  this->Window->GetShaderCache()->ReadyShaderProgram(this->CountsMaskProgram);
  this->CountsMaskProgram->SetUniformi("counts", unit);
  this->WriteMask(state, this->CountsMaskProgram);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
}

void VolumeCounter::WriteMask(vtkOpenGLState* state, vtkShaderProgram* program)
{
  this->Window->GetShaderCache()->ReadyShaderProgram(program);

  // The triangle lies at depth 1: GREATER lets pass what is nearer than the background.
  glDisable(GL_DEPTH_CLAMP);
  glFrontFace(GL_CCW);
  state->vtkglDepthFunc(GL_GREATER);
  glBindVertexArray(this->EmptyVertexArray);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}
