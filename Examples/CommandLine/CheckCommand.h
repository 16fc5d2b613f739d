/**
 * `smoothshadow check`: what is wrong with a mesh, and what each defect means for its shadow.
 */
#ifndef CheckCommand_h
#define CheckCommand_h

#include <functional>

namespace CLI
{
class App;
}

/// Adds the command; where it is the one given, `chosen` becomes its work.
void AddCheckCommand(CLI::App& app, std::function<void()>& chosen);

#endif
