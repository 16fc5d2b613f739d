#ifndef XServer_h
#define XServer_h

#include <string>

namespace XServer
{
/**
 * True if the X server that DISPLAY names answers and has the GLX extension; else false with the
 * reason. VTK's X window ends the process where this is false.
 */
bool HasGLX(std::string& reason);
}

#endif
