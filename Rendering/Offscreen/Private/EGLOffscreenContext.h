#ifndef EGLOffscreenContext_h
#define EGLOffscreenContext_h

#include <memory>
#include <string>

class OffscreenContext;

namespace EGLOffscreenContext
{
/**
 * Makes a desktop OpenGL core context (4.5, else 3.3, else 3.2) that needs no surface.
 *
 * With device < 0 the surfaceless Mesa platform is tried first, then every EGL device in the
 * driver's order; with device >= 0 only that EGL device. Returns nullptr on failure, with all
 * that was tried, and how each failed, in reason.
 */
std::unique_ptr<OffscreenContext> Create(int device, std::string& reason);

/// True if an OpenGL context of EGL, anybody's, is current in the calling thread.
bool IsAnyCurrent();
}

#endif
