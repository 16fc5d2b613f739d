/**
 * The options of the commands that look at a scene.
 */
#ifndef ViewOptions_h
#define ViewOptions_h

#include "Scene.h"

namespace CLI
{
class App;
}

/// Adds --eye, --at, --up, --angle and --size.
void AddViewOptions(CLI::App& command, SceneOptions& scene);

#endif
