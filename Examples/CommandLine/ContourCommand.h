/**
 * `smoothshadow contour`: where shadows of meshes begin on others, as a VTP file or a drawing
 * (SVG).
 */
#ifndef ContourCommand_h
#define ContourCommand_h

#include <functional>

namespace CLI
{
class App;
}

/// Adds the command; where it is the one given, `chosen` becomes its work.
void AddContourCommand(CLI::App& app, std::function<void()>& chosen);

#endif
