#include "SvgDrawing.h"

#include <charconv>
#include <fstream>

namespace
{
// Nine digits, whatever the locale.
std::string Text(double value)
{
  char text[32];
  // No "-0".
  const double number = value == 0.0 ? 0.0 : value;
  const auto end = std::to_chars(text, text + sizeof text, number, std::chars_format::general, 9);
  return std::string(text, end.ptr);
}

// What XML cannot have in an attribute.
std::string Escaped(const std::string& text)
{
  std::string escaped;
  for (const char character : text)
  {
    switch (character)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += character;
    }
  }
  return escaped;
}

// SVG's y axis points downwards.
std::string PathOf(const DrawnLine& line)
{
  std::string path;
  for (const std::vector<Point2>& piece : line)
  {
    if (piece.size() < 2)
    {
      continue;
    }
    const bool closed = piece.size() > 2 && piece.front() == piece.back();
    const std::size_t count = closed ? piece.size() - 1 : piece.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      path += i == 0 ? "M" : i == 1 ? "L" : " ";
      path += Text(piece[i][0]) + "," + Text(-piece[i][1]);
    }
    path += closed ? "Z" : "";
  }
  return path;
}
}

SvgDrawing::SvgDrawing(
  double width, double height, double shownWidth, double shownHeight, std::string unit)
  : Width(width)
  , Height(height)
  , ShownWidth(shownWidth)
  , ShownHeight(shownHeight)
  , Unit(std::move(unit))
{
}

bool SvgDrawing::Write(const std::string& path) const
{
  std::ofstream file(path);
  file << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
       << "<svg xmlns=\"http://www.w3.org/2000/svg\"\n"
       << "     xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
       << "     width=\"" << Text(this->ShownWidth) << this->Unit << "\" height=\""
       << Text(this->ShownHeight) << this->Unit << "\"\n"
       << "     viewBox=\"" << Text(-0.5 * this->Width) << " " << Text(-0.5 * this->Height) << " "
       << Text(this->Width) << " " << Text(this->Height) << "\">\n";
  const double unit = 1e-3 * this->Height;
  for (const Layer& layer : this->Layers)
  {
    file << "<g id=\"" << Escaped(layer.Id) << "\" inkscape:groupmode=\"layer\" inkscape:label=\""
         << Escaped(layer.Label) << "\" fill=\"none\" stroke=\"" << Escaped(layer.Colour)
         << "\" stroke-width=\"" << Text(layer.LineWidth * unit)
         << "\" stroke-linejoin=\"round\" stroke-linecap=\"round\"";
    if (layer.Dashed)
    {
      file << " stroke-dasharray=\"" << Text(6.0 * unit) << " " << Text(4.0 * unit) << "\"";
    }
    file << ">\n";
    for (const DrawnLine& line : layer.Lines)
    {
      const std::string data = PathOf(line);
      if (!data.empty())
      {
        file << "<path d=\"" << data << "\"/>\n";
      }
    }
    file << "</g>\n";
  }
  file << "</svg>\n";
  file.close();
  return !file.fail();
}
