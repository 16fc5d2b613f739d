#include "LightMoves.h"

#include <CLI/CLI.hpp>

void AddRepeatOption(CLI::App& command, int& repeat)
{
  command
    .add_option_function<std::string>(
      "--repeat",
      [&repeat](const std::string& text) { repeat = ParseCount("--repeat", text, 100000); },
      "take the time of so many moves of the light and report the median [1]")
    ->type_name("N");
}
