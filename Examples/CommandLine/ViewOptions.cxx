#include "ViewOptions.h"

#include "Failure.h"
#include "Numbers.h"

#include <CLI/CLI.hpp>

void AddViewOptions(CLI::App& command, SceneOptions& scene)
{
  using TextHandler = std::function<void(const std::string&)>;
  const auto add = [&command](const char* name, const char* type, const char* help,
                     const TextHandler& handler) {
    command.add_option_function<std::string>(name, handler, help)->type_name(type);
  };
  add("--eye", "x,y,z", "where the camera is [where meshes and shadows fill the picture]",
    [&scene](const std::string& text) { scene.Eye = ParseVector("--eye", text); });
  add("--at", "x,y,z", "what it looks at",
    [&scene](const std::string& text) { scene.At = ParseVector("--at", text); });
  add("--up", "x,y,z", "what is up, for camera and ground [0,1,0]",
    [&scene](const std::string& text) { scene.Up = ParseDirection("--up", text); });
  add("--angle", "DEGREES", "the camera's vertical angle of view [30]",
    [&scene](const std::string& text) {
      scene.Angle = ParsePositive("--angle", text);
      if (scene.Angle >= 180.0)
      {
        throw UsageError("--angle " + text + ": an angle below 180 is wanted");
      }
    });
  add("--size", "WxH", "the picture's size in pixels [1024x768]",
    [&scene](const std::string& text) { scene.Size = ParseSize("--size", text); });
}
