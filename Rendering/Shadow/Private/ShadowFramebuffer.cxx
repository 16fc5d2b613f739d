#include "ShadowFramebuffer.h"

#include "OpenGLFunctions.h"

#include "vtkImageData.h"
#include "vtkOpenGLState.h"

namespace
{
constexpr int MinimumStencilBits = 8;

std::string DescribeStatus(GLenum status)
{
  switch (status)
  {
    case GL_FRAMEBUFFER_UNSUPPORTED:
      return "this combination of buffers is not supported";
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
      return "a buffer could not be attached";
    default:
      return "framebuffer status " + std::to_string(status);
  }
}

/**
 * Looks at the framebuffer that is bound.
 */
bool Check(std::string& error)
{
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE)
  {
    error = DescribeStatus(status);
    return false;
  }
  GLint bits = 0;
  glGetFramebufferAttachmentParameteriv(
    GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE, &bits);
  if (bits < MinimumStencilBits)
  {
    error = "the stencil buffer has " + std::to_string(bits) + " bits, 8 are needed";
    return false;
  }
  return true;
}
}

bool ShadowFramebuffer::Fits(int width, int height, int masks) const
{
  return this->DepthTarget && this->Width == width && this->Height == height &&
    this->Layers == LayersFor(masks);
}

bool ShadowFramebuffer::Allocate(
  vtkOpenGLState* state, int width, int height, int masks, std::string& error)
{
  if (this->Fits(width, height, masks))
  {
    return true;
  }
  this->Release();
  this->Width = width;
  this->Height = height;
  this->Layers = LayersFor(masks);

  state->PushFramebufferBindings();
  const bool created = this->Create(state, error);
  state->PopFramebufferBindings();
  if (!created)
  {
    this->Release();
  }
  return created;
}

bool ShadowFramebuffer::Create(vtkOpenGLState* state, std::string& error)
{
  GLint boundRenderbuffer = 0;
  glGetIntegerv(GL_RENDERBUFFER_BINDING, &boundRenderbuffer);
  glGenRenderbuffers(1, &this->DepthStencil);
  glBindRenderbuffer(GL_RENDERBUFFER, this->DepthStencil);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, this->Width, this->Height);
  glBindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(boundRenderbuffer));

  GLint boundTexture = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D_ARRAY, &boundTexture);
  glGenTextures(1, &this->Masks);
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Masks);
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA8, this->Width, this->Height, this->Layers, 0,
    GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D_ARRAY, static_cast<GLuint>(boundTexture));

  glGenFramebuffers(1, &this->DepthTarget);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->DepthTarget);
  glFramebufferRenderbuffer(
    GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, this->DepthStencil);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  if (!Check(error))
  {
    return false;
  }

  glGenFramebuffers(1, &this->MaskTarget);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->MaskTarget);
  glFramebufferRenderbuffer(
    GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, this->DepthStencil);
  glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->Masks, 0, 0);
  glDrawBuffer(GL_COLOR_ATTACHMENT0);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  return Check(error);
}

void ShadowFramebuffer::Release()
{
  // Names that are 0 are skipped by OpenGL, but without a context its functions may be missing.
  if (this->DepthTarget)
  {
    glDeleteFramebuffers(1, &this->DepthTarget);
  }
  if (this->MaskTarget)
  {
    glDeleteFramebuffers(1, &this->MaskTarget);
  }
  this->ReleaseCounts();
  if (this->Masks)
  {
    glDeleteTextures(1, &this->Masks);
  }
  if (this->DepthStencil)
  {
    glDeleteRenderbuffers(1, &this->DepthStencil);
  }
  *this = ShadowFramebuffer();
}

void ShadowFramebuffer::ReleaseCounts()
{
  if (this->CountTarget)
  {
    glDeleteFramebuffers(1, &this->CountTarget);
    glDeleteTextures(1, &this->Counts);
  }
  this->CountTarget = 0;
  this->Counts = 0;
}

void ShadowFramebuffer::BeginDepth(vtkOpenGLState* state)
{
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->DepthTarget);
  state->vtkglViewport(0, 0, this->Width, this->Height);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglStencilMask(~0u);
  glClearBufferfi(GL_DEPTH_STENCIL, 0, 1.0f, 0);
}

void ShadowFramebuffer::BeginMask(vtkOpenGLState* state, int mask)
{
  const int layer = mask / ChannelsPerLayer;
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->MaskTarget);
  state->vtkglViewport(0, 0, this->Width, this->Height);
  state->vtkglDisable(GL_SCISSOR_TEST);
  glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->Masks, 0, layer);
  if (mask % ChannelsPerLayer == 0)
  {
    const float visible[4] = { 1.0f, 1.0f, 1.0f, 1.0f };
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearBufferfv(GL_COLOR, 0, visible);
  }
  const int none = 0;
  state->vtkglStencilMask(~0u);
  glClearBufferiv(GL_STENCIL, 0, &none);
}

bool ShadowFramebuffer::BeginCounts(vtkOpenGLState* state, std::string& error)
{
  if (!this->CountTarget && !this->CreateCounts(state, error))
  {
    return false;
  }
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->CountTarget);
  const float none[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearBufferfv(GL_COLOR, 0, none);
  return true;
}

bool ShadowFramebuffer::CreateCounts(vtkOpenGLState* state, std::string& error)
{
  GLint boundTexture = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &boundTexture);
  glGenTextures(1, &this->Counts);
  glBindTexture(GL_TEXTURE_2D, this->Counts);
  glTexImage2D(
    GL_TEXTURE_2D, 0, GL_R32F, this->Width, this->Height, 0, GL_RED, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(boundTexture));

  glGenFramebuffers(1, &this->CountTarget);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->CountTarget);
  glFramebufferRenderbuffer(
    GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, this->DepthStencil);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, this->Counts, 0);
  glDrawBuffer(GL_COLOR_ATTACHMENT0);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  if (!Check(error))
  {
    this->ReleaseCounts();
    return false;
  }
  return true;
}

void ShadowFramebuffer::OpenMask(vtkOpenGLState* state, int mask)
{
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->MaskTarget);
  const int channel = mask % ChannelsPerLayer;
  state->vtkglColorMask(channel == 0, channel == 1, channel == 2, channel == 3);
}

void ShadowFramebuffer::BindMasks(vtkOpenGLState* state, int unit) const
{
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, this->Masks);
}

void ShadowFramebuffer::UnbindMasks(vtkOpenGLState* state, int unit)
{
  state->vtkglActiveTexture(GL_TEXTURE0 + static_cast<unsigned int>(unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
}

vtkSmartPointer<vtkImageData> ShadowFramebuffer::ReadMask(vtkOpenGLState* state, int mask) const
{
  if (!this->MaskTarget || mask / ChannelsPerLayer >= this->Layers)
  {
    return nullptr;
  }
  static const GLenum channels[ChannelsPerLayer] = { GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA };
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(this->Width, this->Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);

  GLint packBuffer = 0;
  glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &packBuffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->MaskTarget);
  glFramebufferTextureLayer(
    GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, this->Masks, 0, mask / ChannelsPerLayer);
  GLint alignment = 0;
  glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, this->Width, this->Height, channels[mask % ChannelsPerLayer], GL_UNSIGNED_BYTE,
    image->GetScalarPointer());
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, alignment);
  state->PopFramebufferBindings();
  glBindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(packBuffer));
  return image;
}
