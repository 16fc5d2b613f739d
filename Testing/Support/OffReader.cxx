#include "OffReader.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace shadowtest
{
namespace
{
// Numbers of a file, in lines: what follows the numbers of a record on its line is skipped
// (colours, normals), while a record may also go on in the next line.
class NumberReader
{
public:
  explicit NumberReader(const std::string& path)
    : Path(path)
    , File(path)
  {
    if (!this->File)
    {
      this->fail("cannot be opened");
    }
  }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw std::runtime_error("OFF file " + this->Path + ": " + what);
  }

  /// The next word, from a further line if this one is used up.
  bool word(std::string& out)
  {
    while (!(this->Line >> out))
    {
      std::string line;
      if (!std::getline(this->File, line))
      {
        return false;
      }
      this->Line = std::istringstream(line.substr(0, line.find('#')));
    }
    return true;
  }

  double number(const char* what)
  {
    std::string text;
    if (!this->word(text))
    {
      this->fail(std::string("ends where ") + what + " should be");
    }
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (*end != '\0')
    {
      this->fail("\"" + text + "\" where " + what + " should be");
    }
    return value;
  }

  void skipLine() { this->Line = std::istringstream(); }
  void put(const std::string& first) { this->Line = std::istringstream(first + this->rest()); }

private:
  std::string rest()
  {
    std::string text;
    std::getline(this->Line, text, '\0');
    return text;
  }

  std::string Path;
  std::ifstream File;
  std::istringstream Line;
};

// Whether each record has its own line, as the format says; some writers put all on one.
bool onePerLine(const std::string& path, vtkIdType records)
{
  std::ifstream file(path);
  std::string line;
  vtkIdType lines = 0;
  while (std::getline(file, line))
  {
    const auto first = line.find_first_not_of(" \t\r");
    lines += first != std::string::npos && line[first] != '#';
  }
  return lines > records;
}
}

vtkSmartPointer<vtkPolyData> readOff(const std::string& path)
{
  NumberReader reader(path);
  std::string keyword;
  if (!reader.word(keyword))
  {
    reader.fail("is empty");
  }
  if (std::isdigit(static_cast<unsigned char>(keyword[0])) && keyword.find("OFF") == keyword.npos)
  {
    reader.put(keyword);
  }
  else if (keyword != "OFF" && keyword != "COFF" && keyword != "NOFF" && keyword != "CNOFF" &&
    keyword != "STOFF")
  {
    reader.fail("starts with \"" + keyword + "\", not with OFF, COFF, NOFF, CNOFF or STOFF");
  }
  const auto pointCount = static_cast<vtkIdType>(reader.number("the number of points"));
  const auto faceCount = static_cast<vtkIdType>(reader.number("the number of faces"));
  if (pointCount < 0 || faceCount < 0)
  {
    reader.fail("has a negative count");
  }
  reader.skipLine(); // the number of edges, which many leave out
  const bool lines = onePerLine(path, pointCount + faceCount);

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < pointCount; ++i)
  {
    const double x = reader.number("a coordinate");
    const double y = reader.number("a coordinate");
    const double z = reader.number("a coordinate");
    points->InsertNextPoint(x, y, z);
    if (lines)
    {
      reader.skipLine();
    }
  }
  vtkNew<vtkCellArray> faces;
  std::vector<vtkIdType> ids;
  for (vtkIdType i = 0; i < faceCount; ++i)
  {
    const auto size = static_cast<vtkIdType>(reader.number("the number of a face's corners"));
    ids.clear();
    for (vtkIdType corner = 0; corner < size; ++corner)
    {
      const auto id = static_cast<vtkIdType>(reader.number("a point's number"));
      if (id < 0 || id >= pointCount)
      {
        reader.fail("face " + std::to_string(i) + " has the point " + std::to_string(id) + " of " +
          std::to_string(pointCount));
      }
      ids.push_back(id);
    }
    if (lines)
    {
      reader.skipLine();
    }
    if (ids.size() >= 3)
    {
      faces->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(faces);
  return mesh;
}
}
