#include "OSMesaFunctions.h"

#include <dlfcn.h>

namespace
{
template <typename Pointer>
bool Lookup(const char* name, Pointer& pointer)
{
  pointer = reinterpret_cast<Pointer>(dlsym(RTLD_DEFAULT, name));
  return pointer != nullptr;
}

const void* LibraryOf(const char* name)
{
  Dl_info info{};
  void* address = dlsym(RTLD_DEFAULT, name);
  return address && dladdr(address, &info) ? info.dli_fbase : nullptr;
}

// VTK calls OpenGL 1.1 through the symbols of the process and everything later through
// pointers from glXGetProcAddressARB. Without both leading to OSMesa its calls would go to
// another library, which knows of no current context.
bool OpenGLIsOSMesa(const OSMesaFunctions& osmesa)
{
  OSMesaFunctions::Function (*getAddress)(const unsigned char*) = nullptr;
  if (LibraryOf("glGetString") != LibraryOf("OSMesaCreateContextAttribs") ||
    !Lookup("glXGetProcAddressARB", getAddress))
  {
    return false;
  }
  const char* name = "glCreateShader";
  return getAddress(reinterpret_cast<const unsigned char*>(name)) == osmesa.GetProcAddress(name);
}
}

bool OSMesaFunctions::IsInExecutable()
{
  return dlsym(RTLD_DEFAULT, "OSMesaCreateContextAttribs") != nullptr;
}

bool OSMesaFunctions::Find(std::string& reason)
{
  const char* remedy =
    "run the program's OSMesa twin, the executable whose name ends in -osmesa (for a program of "
    "your own: smoothshadow_add_osmesa_twin in CMake; Debian: libosmesa6-dev), or use the EGL "
    "window.";
  const bool found = Lookup("OSMesaCreateContextAttribs", this->CreateContextAttribs) &&
    Lookup("OSMesaDestroyContext", this->DestroyContext) &&
    Lookup("OSMesaMakeCurrent", this->MakeCurrent) &&
    Lookup("OSMesaGetCurrentContext", this->GetCurrentContext) &&
    Lookup("OSMesaGetProcAddress", this->GetProcAddress);
  if (!found)
  {
    reason = std::string("this executable does not carry OSMesa: ") + remedy;
    return false;
  }
  if (!OpenGLIsOSMesa(*this))
  {
    reason =
      std::string("this executable carries OSMesa, but its OpenGL is another library's: ") + remedy;
    return false;
  }
  return true;
}
