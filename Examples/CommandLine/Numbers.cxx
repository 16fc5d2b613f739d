#include "Numbers.h"

#include "Failure.h"

#include <charconv>
#include <cmath>
#include <vector>

namespace
{
[[noreturn]] void Refuse(
  const std::string& option, const std::string& text, const std::string& reason)
{
  throw UsageError(option + " " + text + ": " + reason);
}

// Locale plays no part: a comma always parts two numbers, a full stop its decimals.
bool Read(const std::string& text, double& value)
{
  const char* begin = text.data() + (text.size() > 1 && text[0] == '+' ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc() && stop == end;
}

std::vector<double> ParseList(const std::string& option, const std::string& text)
{
  std::vector<double> values;
  for (std::size_t begin = 0; begin <= text.size();)
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string item = text.substr(begin, end - begin);
    double value = 0.0;
    if (!Read(item, value))
    {
      Refuse(option, text, "'" + item + "' is not a number");
    }
    if (!std::isfinite(value))
    {
      Refuse(option, text, "'" + item + "' is not finite");
    }
    values.push_back(value);
    begin = end + 1;
  }
  return values;
}
}

double ParseNumber(const std::string& option, const std::string& text)
{
  const std::vector<double> values = ParseList(option, text);
  if (values.size() != 1)
  {
    Refuse(option, text, "one number is wanted");
  }
  return values[0];
}

double ParsePositive(const std::string& option, const std::string& text)
{
  const double value = ParseNumber(option, text);
  if (value <= 0.0)
  {
    Refuse(option, text, "a number above 0 is wanted");
  }
  return value;
}

int ParseCount(const std::string& option, const std::string& text, int largest)
{
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || value < 1 || value > largest)
  {
    Refuse(option, text, "a whole number from 1 to " + std::to_string(largest) + " is wanted");
  }
  return value;
}

Vector3 ParseVector(const std::string& option, const std::string& text)
{
  const std::vector<double> values = ParseList(option, text);
  if (values.size() != 3)
  {
    Refuse(option, text, "three numbers x,y,z are wanted");
  }
  return { values[0], values[1], values[2] };
}

Vector3 ParseDirection(const std::string& option, const std::string& text)
{
  const Vector3 direction = ParseVector(option, text);
  if (direction == Vector3{ 0.0, 0.0, 0.0 })
  {
    Refuse(option, text, "a direction cannot be zero");
  }
  return direction;
}

Homogeneous ParseLight(const std::string& option, const std::string& text)
{
  const std::vector<double> values = ParseList(option, text);
  if (values.size() != 3 && values.size() != 4)
  {
    Refuse(option, text, "three or four numbers x,y,z[,w] are wanted");
  }
  Homogeneous light = { values[0], values[1], values[2], values.size() == 4 ? values[3] : 1.0 };
  if (light == Homogeneous{ 0.0, 0.0, 0.0, 0.0 })
  {
    Refuse(option, text, "a light cannot be all zero");
  }
  if (light[3] != 0.0)
  {
    for (double& coordinate : light)
    {
      coordinate /= light[3];
      if (!std::isfinite(coordinate))
      {
        Refuse(option, text, "x/w, y/w and z/w must be finite; w = 0 is a light at infinity");
      }
    }
    light[3] = 1.0;
  }
  return light;
}

std::array<int, 2> ParseSize(const std::string& option, const std::string& text)
{
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos)
  {
    Refuse(option, text, "WIDTHxHEIGHT is wanted, as in 1024x768");
  }
  // What every OpenGL of the last ten years can draw.
  const int largest = 16384;
  return { ParseCount(option, text.substr(0, cross), largest),
    ParseCount(option, text.substr(cross + 1), largest) };
}
