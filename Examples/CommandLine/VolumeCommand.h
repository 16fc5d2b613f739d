/**
 * `smoothshadow volume`: the shadow volume of a mesh as a VTP file.
 */
#ifndef VolumeCommand_h
#define VolumeCommand_h

#include <functional>

namespace CLI
{
class App;
}

/// Adds the command; where it is the one given, `chosen` becomes its work.
void AddVolumeCommand(CLI::App& app, std::function<void()>& chosen);

#endif
