#include "CheckReport.h"

#include <vtkTable.h>
#include <vtkVariant.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <vector>

namespace
{
constexpr std::size_t usualWidth = 100;
// Below it, words would stand one under the other.
constexpr std::size_t leastWidth = 40;

std::size_t Width()
{
  winsize size = {};
  const bool known = isatty(STDOUT_FILENO) != 0 &&
    ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? std::max<std::size_t>(size.ws_col, leastWidth) : usualWidth;
}

// Lines that begin with the indent; a word longer than a line stays whole.
std::string Wrapped(const std::string& text, const std::string& indent, std::size_t width)
{
  std::istringstream words(text);
  std::string lines;
  std::string line;
  for (std::string word; words >> word;)
  {
    if (!line.empty() && indent.size() + line.size() + 1 + word.size() > width)
    {
      lines += indent + line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return lines + indent + line + "\n";
}

Json Defects(vtkTable* found)
{
  Json defects = Json::array();
  for (vtkIdType row = 0; row < found->GetNumberOfRows(); ++row)
  {
    const auto text = [&](const char* column)
    { return std::string(found->GetValueByName(row, column).ToString()); };
    Json place = { found->GetValueByName(row, "X").ToDouble(),
      found->GetValueByName(row, "Y").ToDouble(), found->GetValueByName(row, "Z").ToDouble() };
    if (!std::isfinite(place[0].get<double>()))
    {
      place = nullptr;
    }
    defects.push_back({ { "defect", text("Defect") },
      { "count", found->GetValueByName(row, "Count").ToLongLong() },
      { "meaning", text("Meaning") }, { "shadow", text("Shadow") }, { "remedy", text("Remedy") },
      { "place", place } });
  }
  return defects;
}

// The gravest, whose defects come first.
std::string Verdict(const Json& defects)
{
  return defects.empty() ? "exact" : defects[0]["meaning"].get<std::string>();
}

std::string VerdictSentence(const std::string& verdict)
{
  if (verdict == "exact")
  {
    return "Its discrete shadow is exact.";
  }
  return verdict == "warned"
    ? "Some of its shadow is missing or likely to be wrong: see what is warned of."
    : "Its shadow is well defined; where it is not that of an ideal surface is said above.";
}

std::string Counted(const Json& count, const std::string& noun)
{
  return count.dump() + " " + noun + (count == 1 ? "" : "s");
}

std::string Summary(const Json& mesh)
{
  std::string line = Counted(mesh["triangles"], "triangle") + ", " +
    Counted(mesh["distinctPoints"], "distinct point") + ", " + Counted(mesh["parts"], "part");
  if (mesh["closed"])
  {
    return line + ", closed";
  }
  if (mesh["parts"] != 0)
  {
    line += ", " + (mesh["closedParts"] == 0 ? "not" : mesh["closedParts"].dump() + " of them") +
      " closed, both sides of " + Counted(mesh["twoSidedTriangles"], "triangle") + " cast";
  }
  return line;
}

std::string Place(const Json& place)
{
  if (place.is_null())
  {
    return "";
  }
  std::ostringstream text;
  text << "at " << place[0].get<double>() << ", " << place[1].get<double>() << ", "
       << place[2].get<double>();
  return text.str();
}

std::string Text(const Json& mesh, const Json& defects, const std::string& verdict)
{
  std::size_t longest = 0;
  for (const Json& defect : defects)
  {
    longest = std::max(longest, defect["defect"].get<std::string>().size());
  }
  const std::size_t width = Width();
  std::ostringstream text;
  text << Wrapped(mesh["file"].get<std::string>() + ": " + Summary(mesh), "", width);
  for (const Json& defect : defects)
  {
    text << "\n"
         << std::setw(8) << defect["count"].dump() << "  " << std::left
         << std::setw(static_cast<int>(longest)) << defect["defect"].get<std::string>() << "  ";
    const std::string meaning = defect["meaning"].get<std::string>();
    const std::string place = Place(defect["place"]);
    if (place.empty())
    {
      text << meaning;
    }
    else
    {
      text << std::setw(12) << meaning << "  " << place;
    }
    text << std::right << "\n"
         << Wrapped(defect["shadow"].get<std::string>() + " " + defect["remedy"].get<std::string>(),
              std::string(10, ' '), width);
  }
  text << "\n" << (defects.empty() ? "No defects. " : "") << VerdictSentence(verdict);
  return text.str();
}
}

CheckReport DescribeCheck(const Mesh& mesh, vtkTable* found)
{
  Json described = MeshStatistics(mesh);
  described["triangles"] = FieldValue(found, "Triangles");
  described["distinctPoints"] = FieldValue(found, "Points");
  described["parts"] = FieldValue(found, "Parts");
  described["closedParts"] = FieldValue(found, "ClosedParts");
  described["twoSidedTriangles"] = FieldValue(found, "TwoSidedTriangles");
  described["closed"] = described["triangles"] != 0 && described["twoSidedTriangles"] == 0;
  const Json defects = Defects(found);
  const std::string verdict = Verdict(defects);

  CheckReport report;
  report.Statistics["command"] = "check";
  report.Statistics["mesh"] = described;
  report.Statistics["shadow"] = verdict;
  report.Statistics["defects"] = defects;
  report.Text = Text(described, defects, verdict);
  return report;
}
