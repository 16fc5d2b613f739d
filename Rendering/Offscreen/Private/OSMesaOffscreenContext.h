#ifndef OSMesaOffscreenContext_h
#define OSMesaOffscreenContext_h

#include <memory>
#include <string>

class OffscreenContext;

namespace OSMesaOffscreenContext
{
/**
 * Makes an OSMesa core context (3.3, else 3.2) with a buffer of one pixel.
 * Returns nullptr on failure, with the reason.
 */
std::unique_ptr<OffscreenContext> Create(std::string& reason);
}

#endif
