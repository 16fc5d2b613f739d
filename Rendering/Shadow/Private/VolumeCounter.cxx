#include "VolumeCounter.h"

#include "DepthBoundsTest.h"
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
#include <cmath>

namespace
{
/**
 * By how many steps of depth walls are drawn behind where they are: a few roundings.
 */
constexpr float WallOffset = 4.0f;
}

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
    ? glGetAttribLocation(static_cast<GLuint>(this->CountProgram->GetHandle()), "vertex")
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
  glEnable(GL_POLYGON_OFFSET_FILL);
}

void VolumeCounter::BeginCountingInStencil(vtkOpenGLState* state)
{
  this->BeginCounting(state);
  this->InFloats = false;
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_STENCIL_TEST);
  state->vtkglStencilMask(~0u);
  state->vtkglStencilFunc(GL_ALWAYS, 0, ~0u);
}

void VolumeCounter::BeginCountingInFloats(vtkOpenGLState* state)
{
  this->BeginCounting(state);
  this->InFloats = true;
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_STENCIL_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendEquation(GL_FUNC_ADD);
  state->vtkglBlendFunc(GL_ONE, GL_ONE);
}

void VolumeCounter::SetMethod(vtkOpenGLState* state, bool zPass)
{
  if (this->InFloats)
  {
    // What fails z-fail's test in the stencil passes this one.
    state->vtkglDepthFunc(zPass ? GL_LESS : GL_GEQUAL);
    this->CountProgram->SetUniformf("frontCounts", zPass ? 1.0f : -1.0f);
    return;
  }
  state->vtkglDepthFunc(GL_LESS);
  if (zPass)
  {
    state->vtkglStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
    state->vtkglStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
  }
  else
  {
    state->vtkglStencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
    state->vtkglStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
  }
}

void VolumeCounter::EndCounting(vtkOpenGLState* state)
{
  state->vtkglDisable(GL_SCISSOR_TEST);
  DepthBoundsTest::SetRange({ 0.0, 1.0 });
}

namespace
{
/**
 * In the volume's coordinates, and no larger than 1, as the shader multiplies it.
 */
std::array<float, 4> ToVolume(const VolumeBuffers& volume, const std::array<double, 4>& light)
{
  std::array<double, 4> moved = light;
  double largest = std::abs(light[3]);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    moved[axis] = (light[axis] - light[3] * volume.GetMesh().GetOrigin()[axis]) / volume.GetMesh().GetScale();
    largest = std::max(largest, std::abs(moved[axis]));
  }
  std::array<float, 4> result;
  std::transform(moved.begin(), moved.end(), result.begin(),
    [&](double value) { return static_cast<float>(value / largest); });
  return result;
}

std::array<float, 4> PlaneToVolume(const VolumeBuffers& volume, const std::array<double, 4>& plane)
{
  const std::array<double, 3>& origin = volume.GetMesh().GetOrigin();
  const double height =
    plane[0] * origin[0] + plane[1] * origin[1] + plane[2] * origin[2] + plane[3];
  const double length = std::hypot(plane[0], plane[1], plane[2]);
  if (!(length > 0.0))
  {
    return {};
  }
  return { static_cast<float>(plane[0] / length), static_cast<float>(plane[1] / length),
    static_cast<float>(plane[2] / length),
    static_cast<float>(height / (length * volume.GetMesh().GetScale())) };
}
}

void VolumeCounter::Count(vtkOpenGLState* state, const VolumeBuffers& volume,
  const Placement& placement, bool zPass)
{
  this->SetMethod(state, zPass);
  DepthBoundsTest::SetRange(placement.DepthRange);

  // Wound as OpenGL expects it unless some matrix on the way mirrors. View to clip coordinates
  // always changes handedness, so the usual sign is negative.
  const bool mirrors = vtkMatrix4x4::Determinant(placement.ToClip.data()) >= 0.0;
  const GLenum front = mirrors ? GL_CW : GL_CCW;
  const GLenum back = mirrors ? GL_CCW : GL_CW;
  glFrontFace(front);

  // Origin and scale go into the matrix while that is still in double.
  Matrix4 toMesh = Translation(volume.GetMesh().GetOrigin());
  toMesh[0] = toMesh[5] = toMesh[10] = volume.GetMesh().GetScale();
  const Matrix4 columns = Transposed(placement.ToClip * toMesh);
  std::array<float, 16> uniform;
  std::transform(columns.begin(), columns.end(), uniform.begin(),
    [](double value) { return static_cast<float>(value); });
  this->CountProgram->SetUniformi("endsOnly", 0);
  this->CountProgram->SetUniformMatrix4x4("volumeToClip", uniform.data());
  this->CountProgram->SetUniform4f("light", ToVolume(volume, placement.Light).data());
  this->CountProgram->SetUniform4f("end", PlaneToVolume(volume, placement.End).data());

  if (!zPass)
  {
    // A cap is as deep as the surface that it is part of. It must count as behind it: so a lit
    // surface is not in its own cap's shadow, and a dark one always is in that of its dark cap.
    glPolygonOffset(1.0f, 1.0f);
    volume.DrawCaps();
    glFrontFace(back);
    this->DrawFarEnd(volume);
    glFrontFace(front);
  }
  // Walls begin on surfaces, too, where rounding may put them before or behind.
  glPolygonOffset(0.0f, WallOffset);
  volume.DrawGaps();
  volume.DrawWalls();
}

void VolumeCounter::DrawFarEnd(const VolumeBuffers& volume)
{
  if (volume.IsLightOutside())
  {
    volume.DrawEndFans();
    return;
  }
  this->CountProgram->SetUniformi("endsOnly", 1);
  volume.DrawCaps();
  volume.DrawGaps();
  this->CountProgram->SetUniformi("endsOnly", 0);
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

  glDisable(GL_POLYGON_OFFSET_FILL);

  // The triangle lies at depth 1: GREATER lets pass what is nearer than the background.
  glDisable(GL_DEPTH_CLAMP);
  glFrontFace(GL_CCW);
  state->vtkglDepthFunc(GL_GREATER);
  glBindVertexArray(this->EmptyVertexArray);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}
