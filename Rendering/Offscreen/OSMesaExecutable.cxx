// Part of an executable that renders through OSMesa (see SmoothShadowOSMesa.cmake). GLEW, which
// VTK loads OpenGL with, asks GLX for every function; the executable's definitions come before
// libGLX's, so that here it gets OSMesa's.

extern "C" {
using Function = void (*)();

Function OSMesaGetProcAddress(const char* name);

__attribute__((visibility("default"))) Function glXGetProcAddressARB(const unsigned char* name)
{
  const char* text = reinterpret_cast<const char*>(name);
  // Mesa makes up an entry point for any name that begins with gl. GLX there is none.
  const bool isGLX = text[0] == 'g' && text[1] == 'l' && text[2] == 'X';
  return isGLX ? nullptr : OSMesaGetProcAddress(text);
}

__attribute__((visibility("default"))) Function glXGetProcAddress(const unsigned char* name)
{
  return glXGetProcAddressARB(name);
}
}
