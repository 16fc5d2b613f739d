#include "XServer.h"

#include <cstdlib>
#include <dlfcn.h>

namespace
{
// libX11 is looked up rather than linked: VTK may have been built without X.
struct Xlib
{
  void* Library = dlopen("libX11.so.6", RTLD_LAZY | RTLD_LOCAL);
  void* (*OpenDisplay)(const char*) = nullptr;
  int (*CloseDisplay)(void*) = nullptr;
  int (*QueryExtension)(void*, const char*, int*, int*, int*) = nullptr;

  bool Load()
  {
    return this->Library && this->Find("XOpenDisplay", this->OpenDisplay) &&
      this->Find("XCloseDisplay", this->CloseDisplay) &&
      this->Find("XQueryExtension", this->QueryExtension);
  }

private:
  template <typename Pointer>
  bool Find(const char* name, Pointer& pointer)
  {
    pointer = reinterpret_cast<Pointer>(dlsym(this->Library, name));
    return pointer != nullptr;
  }
};
}

bool XServer::HasGLX(std::string& reason)
{
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
  {
    reason = "DISPLAY is not set: there is no X server. Start one (xvfb-run), or use the EGL "
             "window";
    return false;
  }
  // Never closed: unloading Xlib would take away what VTK may be using.
  static Xlib xlib;
  static const bool loaded = xlib.Load();
  if (!loaded)
  {
    reason = "libX11.so.6 cannot be loaded";
    return false;
  }
  void* display = xlib.OpenDisplay(nullptr);
  if (!display)
  {
    reason = std::string("no X server answers at DISPLAY=") + name;
    return false;
  }
  int opcode = 0, event = 0, error = 0;
  const bool glx = xlib.QueryExtension(display, "GLX", &opcode, &event, &error) != 0;
  xlib.CloseDisplay(display);
  if (!glx)
  {
    reason = std::string("the X server at DISPLAY=") + name + " has no GLX extension";
  }
  return glx;
}
