/**
 * `smoothshadow render`: a picture of meshes and their shadows.
 */
#ifndef RenderCommand_h
#define RenderCommand_h

#include <functional>

namespace CLI
{
class App;
}

/// Adds the command; where it is the one given, `chosen` becomes its work.
void AddRenderCommand(CLI::App& app, std::function<void()>& chosen);

#endif
