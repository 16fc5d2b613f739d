#include "CheckCommand.h"
#include "ContourCommand.h"
#include "Failure.h"
#include "Messages.h"
#include "RenderCommand.h"
#include "SilhouetteCommand.h"
#include "VolumeCommand.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <new>

namespace
{
enum ExitCode
{
  DONE = 0,
  BAD_INPUT = 1,
  WRONG_USAGE = 2
};

int Fail(const std::string& message, int code)
{
  std::cerr << "smoothshadow: error: " << message << std::endl;
  return code;
}

// Backwards, as CLI11 wants them. A vector may start with a minus and is then no option: it is
// tied to the option before it.
std::vector<std::string> Arguments(int argc, char* argv[])
{
  const std::vector<std::string> vectors = { "--light", "--eye", "--at", "--up" };
  std::vector<std::string> arguments;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const bool vector = std::find(vectors.begin(), vectors.end(), argument) != vectors.end();
    if (vector && i + 1 < argc)
    {
      arguments.push_back(argument + "=" + argv[++i]);
    }
    else
    {
      arguments.push_back(argument);
    }
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

std::string HelpHint(const CLI::App& app)
{
  std::string command;
  for (const CLI::App* subcommand : app.get_subcommands())
  {
    command = " " + subcommand->get_name();
  }
  return ", see smoothshadow" + command + " --help";
}

// The first argument where it should be a command and is none.
std::string UnknownCommand(const CLI::App& app, int argc, char* argv[])
{
  const std::string first = argc > 1 ? argv[1] : "";
  bool known = first.empty() || first[0] == '-';
  for (const CLI::App* command : app.get_subcommands({}))
  {
    known = known || command->check_name(first);
  }
  return known ? "" : first;
}

int Perform(const std::function<void()>& command)
{
  try
  {
    command();
  }
  catch (const UsageError& error)
  {
    return Fail(error.what(), WRONG_USAGE);
  }
  catch (const std::bad_alloc&)
  {
    return Fail("there is not enough memory, give a smaller mesh or picture", BAD_INPUT);
  }
  catch (const std::exception& error)
  {
    return Fail(error.what(), BAD_INPUT);
  }
  return DONE;
}
}

int main(int argc, char* argv[])
{
  CatchMessages();

  std::function<void()> command;
  CLI::App app(
    "Shadows with the edges of the smooth surface that a mesh stands for", "smoothshadow");
  app.set_version_flag("--version", SMOOTHSHADOW_VERSION);
  app.require_subcommand(1);
  app.footer("Meshes: .ply .stl .obj .vtp .vtk .gltf .glb .3ds\n"
             "Exit codes: 0 done, 1 bad input or failure, 2 wrong usage\n\n"
             "  smoothshadow render bunny.obj --ground -o bunny.png\n"
             "  smoothshadow silhouette bunny.obj --light 2,4,3 -o silhouette.vtp\n"
             "  smoothshadow volume bunny.obj --light 0,1,0,0 -o volume.vtp --json\n"
             "  smoothshadow contour --caster bunny.obj --receiver ground.obj --light 2,4,3 "
             "-o bunny.svg\n"
             "  smoothshadow check bunny.obj");
  AddRenderCommand(app, command);
  AddSilhouetteCommand(app, command);
  AddVolumeCommand(app, command);
  AddContourCommand(app, command);
  AddCheckCommand(app, command);
  const std::string unknown = UnknownCommand(app, argc, argv);
  if (!unknown.empty())
  {
    return Fail(unknown + ": no such command" + HelpHint(app), WRONG_USAGE);
  }
  try
  {
    app.parse(Arguments(argc, argv));
  }
  catch (const CLI::Success& help)
  {
    return app.exit(help);
  }
  catch (const CLI::ParseError& error)
  {
    return Fail(error.what() + HelpHint(app), WRONG_USAGE);
  }
  catch (const UsageError& error)
  {
    return Fail(error.what() + HelpHint(app), WRONG_USAGE);
  }
  return Perform(command);
}
