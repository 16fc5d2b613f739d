#include "OSMesaOffscreenContext.h"

#include "OSMesaFunctions.h"
#include "OffscreenContext.h"

#include <array>
#include <vector>

namespace
{
// From GL/osmesa.h and GL/gl.h, which need not be installed.
constexpr int FormatKey = 0x22;
constexpr int DepthBitsKey = 0x30;
constexpr int StencilBitsKey = 0x31;
constexpr int ProfileKey = 0x33;
constexpr int CoreProfile = 0x34;
constexpr int MajorVersionKey = 0x36;
constexpr int MinorVersionKey = 0x37;
constexpr int FormatRGBA = 0x1908;
constexpr unsigned int UnsignedByte = 0x1401;

class Context;
// OSMesa can name the current context, but to restore it its buffer is needed as well.
thread_local Context* CurrentOfThread = nullptr;

class Context : public OffscreenContext
{
public:
  Context(const OSMesaFunctions& osmesa, void* handle)
    : OSMesa(osmesa)
    , Handle(handle)
  {
  }

  ~Context() override
  {
    if (this->IsCurrent())
    {
      this->OSMesa.MakeCurrent(nullptr, nullptr, UnsignedByte, 0, 0);
    }
    if (CurrentOfThread == this)
    {
      CurrentOfThread = nullptr;
    }
    this->OSMesa.DestroyContext(this->Handle);
  }

  bool MakeCurrent() override
  {
    // VTK renders into framebuffers of its own: one pixel is enough for any window's size.
    if (!this->IsCurrent() &&
      !this->OSMesa.MakeCurrent(this->Handle, this->Pixel.data(), UnsignedByte, 1, 1))
    {
      return false;
    }
    CurrentOfThread = this;
    return true;
  }

  bool IsCurrent() const override { return this->OSMesa.GetCurrentContext() == this->Handle; }

  void PushCurrent() override
  {
    this->Stack.push_back(this->IsCurrent() ? nullptr : CurrentOfThread);
    this->MakeCurrent();
  }

  void PopCurrent() override
  {
    if (this->Stack.empty())
    {
      return;
    }
    Context* last = this->Stack.back();
    this->Stack.pop_back();
    if (last)
    {
      last->MakeCurrent();
    }
  }

  Function GetFunction(const char* name) const override
  {
    return this->OSMesa.GetProcAddress(name);
  }

  const char* GetDescription() const override { return "OSMesa"; }

private:
  OSMesaFunctions OSMesa;
  void* Handle;
  std::array<unsigned char, 4> Pixel{};
  std::vector<Context*> Stack;
};
}

std::unique_ptr<OffscreenContext> OSMesaOffscreenContext::Create(std::string& reason)
{
  OSMesaFunctions osmesa;
  if (!osmesa.Find(reason))
  {
    reason = "no OSMesa context: " + reason;
    return nullptr;
  }
  for (const int minor : { 3, 2 })
  {
    const int attributes[] = { FormatKey, FormatRGBA, DepthBitsKey, 24, StencilBitsKey, 8,
      ProfileKey, CoreProfile, MajorVersionKey, 3, MinorVersionKey, minor, 0, 0 };
    if (void* handle = osmesa.CreateContextAttribs(attributes, nullptr))
    {
      auto context = std::make_unique<Context>(osmesa, handle);
      if (context->MakeCurrent())
      {
        return context;
      }
    }
  }
  reason = "no OSMesa context: libOSMesa makes no OpenGL 3.2 core context. Needed: Mesa 17.1 or "
           "later, built with llvmpipe or softpipe.";
  return nullptr;
}
