#ifndef ContextProbe_h
#define ContextProbe_h

#include <string>

namespace ContextProbe
{
/**
 * True if the current context is OpenGL 3.2 or later and fills a framebuffer object of one pixel,
 * with depth and stencil, in the colour asked for; else false with the reason. OpenGL's functions
 * must have been loaded. All state is left as found and no OpenGL error is left behind.
 */
bool Draws(std::string& reason);

/// Takes all pending OpenGL errors of the current context away.
void DrainErrors();
}

#endif
