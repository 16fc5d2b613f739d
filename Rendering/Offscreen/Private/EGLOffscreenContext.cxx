#include "EGLOffscreenContext.h"

#include "OffscreenContext.h"

// Keeps Xlib's macros out; no X display is ever passed to EGL here.
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstring>
#include <utility>
#include <vector>

namespace
{
struct Platform
{
  std::string Name;
  EGLDisplay Display = EGL_NO_DISPLAY;
};

struct Current
{
  EGLDisplay Display;
  EGLSurface Draw;
  EGLSurface Read;
  EGLContext Context;
};

std::string ErrorName(EGLint code)
{
  switch (code)
  {
    case EGL_SUCCESS:
      return "no error reported";
    case EGL_NOT_INITIALIZED:
      return "EGL_NOT_INITIALIZED";
    case EGL_BAD_ACCESS:
      return "EGL_BAD_ACCESS, a context of another window system is current in this thread";
    case EGL_BAD_ALLOC:
      return "EGL_BAD_ALLOC";
    case EGL_BAD_ATTRIBUTE:
      return "EGL_BAD_ATTRIBUTE";
    case EGL_BAD_CONFIG:
      return "EGL_BAD_CONFIG";
    case EGL_BAD_DISPLAY:
      return "EGL_BAD_DISPLAY";
    case EGL_BAD_MATCH:
      return "EGL_BAD_MATCH";
    case EGL_BAD_PARAMETER:
      return "EGL_BAD_PARAMETER";
    default:
      return "EGL error " + std::to_string(code);
  }
}

// Whole names only: EGL_KHR_surfaceless_context must not answer for a longer extension.
bool HasExtension(const char* list, const char* name)
{
  const std::size_t length = std::strlen(name);
  for (const char* at = list; at && (at = std::strstr(at, name)); at += length)
  {
    const bool begins = at == list || at[-1] == ' ';
    if (begins && (at[length] == ' ' || at[length] == '\0'))
    {
      return true;
    }
  }
  return false;
}

template <typename Pointer>
Pointer Load(const char* name)
{
  return reinterpret_cast<Pointer>(eglGetProcAddress(name));
}

std::vector<Platform> ListPlatforms(int device, std::string& reason)
{
  std::vector<Platform> platforms;
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto getDisplay = Load<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (!HasExtension(client, "EGL_EXT_platform_base") || !getDisplay)
  {
    reason += "EGL_EXT_platform_base: not there; ";
    return platforms;
  }

  if (device < 0)
  {
    if (HasExtension(client, "EGL_MESA_platform_surfaceless"))
    {
      platforms.push_back({ "surfaceless Mesa platform",
        getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr) });
    }
    else
    {
      reason += "EGL_MESA_platform_surfaceless: not there; ";
    }
  }

  const auto queryDevices = Load<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const bool canEnumerate = HasExtension(client, "EGL_EXT_device_enumeration") ||
    HasExtension(client, "EGL_EXT_device_base");
  if (!HasExtension(client, "EGL_EXT_platform_device") || !canEnumerate || !queryDevices)
  {
    reason += "EGL_EXT_platform_device: not there; ";
    return platforms;
  }
  EGLint count = 0;
  queryDevices(0, nullptr, &count);
  std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count > 0 ? count : 0));
  if (count <= 0 || !queryDevices(count, devices.data(), &count))
  {
    reason += "EGL devices: none; ";
    return platforms;
  }
  if (device >= count)
  {
    reason += "EGL device " + std::to_string(device) + ": there are only " + std::to_string(count) +
      ", counted from 0; ";
    return platforms;
  }
  for (int i = 0; i < count; ++i)
  {
    if (device < 0 || device == i)
    {
      platforms.push_back({ "EGL device " + std::to_string(i),
        getDisplay(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], nullptr) });
    }
  }
  return platforms;
}

EGLContext CreateCoreContext(EGLDisplay display, std::string& failure)
{
  const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
  if (!HasExtension(extensions, "EGL_KHR_surfaceless_context"))
  {
    failure = "EGL_KHR_surfaceless_context is not supported";
    return EGL_NO_CONTEXT;
  }
  if (!eglBindAPI(EGL_OPENGL_API))
  {
    failure = "no desktop OpenGL, eglBindAPI: " + ErrorName(eglGetError());
    return EGL_NO_CONTEXT;
  }
  // EGL_SURFACE_TYPE defaults to windows, which these platforms do not have.
  const EGLint wanted[] = { EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE };
  EGLConfig config = nullptr;
  EGLint found = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &found) || found < 1)
  {
    if (!HasExtension(extensions, "EGL_KHR_no_config_context"))
    {
      failure = "no config for desktop OpenGL";
      return EGL_NO_CONTEXT;
    }
    config = EGL_NO_CONFIG_KHR;
  }
  const EGLint versions[][2] = { { 4, 5 }, { 3, 3 }, { 3, 2 } };
  for (const auto& version : versions)
  {
    const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION, version[0], EGL_CONTEXT_MINOR_VERSION,
      version[1], EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
    if (context != EGL_NO_CONTEXT)
    {
      return context;
    }
  }
  failure = "no OpenGL 3.2 core context, eglCreateContext: " + ErrorName(eglGetError());
  return EGL_NO_CONTEXT;
}

class Context : public OffscreenContext
{
public:
  Context(EGLDisplay display, EGLContext handle, std::string name)
    : Display(display)
    , Handle(handle)
    , Description("EGL, " + std::move(name))
  {
  }

  // The display stays initialised until the process ends: EGL does not count initialisations,
  // so terminating it would take it from any other user of the same display in the process.
  ~Context() override
  {
    if (this->IsCurrent())
    {
      eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(this->Display, this->Handle);
  }

  bool MakeCurrent() override
  {
    return this->IsCurrent() ||
      eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, this->Handle) == EGL_TRUE;
  }

  bool IsCurrent() const override
  {
    // The bound API is per thread and decides which context eglGetCurrentContext speaks of.
    eglBindAPI(EGL_OPENGL_API);
    return eglGetCurrentContext() == this->Handle;
  }

  void PushCurrent() override
  {
    eglBindAPI(EGL_OPENGL_API);
    this->Stack.push_back({ eglGetCurrentDisplay(), eglGetCurrentSurface(EGL_DRAW),
      eglGetCurrentSurface(EGL_READ), eglGetCurrentContext() });
    this->MakeCurrent();
  }

  void PopCurrent() override
  {
    if (this->Stack.empty())
    {
      return;
    }
    const Current last = this->Stack.back();
    this->Stack.pop_back();
    // Where nothing was current this context stays so: some of VTK's clean-up needs one.
    if (last.Context != EGL_NO_CONTEXT && last.Context != this->Handle)
    {
      eglMakeCurrent(last.Display, last.Draw, last.Read, last.Context);
    }
  }

  Function GetFunction(const char* name) const override { return eglGetProcAddress(name); }

  const char* GetDescription() const override { return this->Description.c_str(); }

private:
  EGLDisplay Display;
  EGLContext Handle;
  std::string Description;
  std::vector<Current> Stack;
};
}

std::unique_ptr<OffscreenContext> EGLOffscreenContext::Create(int device, std::string& reason)
{
  std::string tried;
  for (const Platform& platform : ListPlatforms(device, tried))
  {
    std::string failure;
    EGLContext handle = EGL_NO_CONTEXT;
    if (platform.Display == EGL_NO_DISPLAY || !eglInitialize(platform.Display, nullptr, nullptr))
    {
      failure = "no driver, eglInitialize: " + ErrorName(eglGetError());
    }
    else
    {
      handle = CreateCoreContext(platform.Display, failure);
    }
    if (handle != EGL_NO_CONTEXT)
    {
      auto context = std::make_unique<Context>(platform.Display, handle, platform.Name);
      if (context->MakeCurrent())
      {
        return context;
      }
      failure = "eglMakeCurrent: " + ErrorName(eglGetError());
    }
    tried += platform.Name + ": " + failure + "; ";
  }
  reason = "no EGL context. Tried: " + tried +
    "what helps: install an EGL driver (Debian: libegl-mesa0 and libgl1-mesa-dri), unset "
    "__EGL_VENDOR_LIBRARY_FILENAMES or let it name an installed driver, set "
    "LIBGL_ALWAYS_SOFTWARE=1 to pass by a broken graphics card, "
    "VTK_DEFAULT_EGL_DEVICE_INDEX=n to choose an EGL device.";
  return nullptr;
}

bool EGLOffscreenContext::IsAnyCurrent()
{
  eglBindAPI(EGL_OPENGL_API);
  return eglGetCurrentContext() != EGL_NO_CONTEXT;
}
