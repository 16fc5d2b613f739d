#ifndef OSMesaFunctions_h
#define OSMesaFunctions_h

#include <string>

/**
 * OSMesa's entry points as the running executable provides them.
 *
 * The library does not link OSMesa and includes none of its headers: only an executable that
 * links libOSMesa first (see SmoothShadowOSMesa.cmake) has OpenGL resolved to it, and Mesa 25.1
 * and later have no OSMesa at all.
 */
struct OSMesaFunctions
{
  using Function = void (*)();

  void* (*CreateContextAttribs)(const int* attributes, void* share) = nullptr;
  void (*DestroyContext)(void* context) = nullptr;
  unsigned char (*MakeCurrent)(
    void* context, void* buffer, unsigned int type, int width, int height) = nullptr;
  void* (*GetCurrentContext)() = nullptr;
  Function (*GetProcAddress)(const char* name) = nullptr;

  /// True if the executable carries libOSMesa, whether or not OpenGL resolves to it.
  static bool IsInExecutable();

  /// All functions, if OpenGL itself resolves to OSMesa; else false with the reason.
  bool Find(std::string& reason);
};

#endif
