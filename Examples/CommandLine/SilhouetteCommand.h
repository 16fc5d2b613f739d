/**
 * `smoothshadow silhouette`: the silhouette of a mesh as a VTP file.
 */
#ifndef SilhouetteCommand_h
#define SilhouetteCommand_h

#include <functional>

namespace CLI
{
class App;
}

/// Adds the command; where it is the one given, `chosen` becomes its work.
void AddSilhouetteCommand(CLI::App& app, std::function<void()>& chosen);

#endif
