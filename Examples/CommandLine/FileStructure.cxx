#include "FileStructure.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <vector>

namespace
{
struct PlyProperty
{
  bool IsList;
  std::string CountType; // of a list
  std::string Type;
};

struct PlyElement
{
  std::string Name;
  long long Count;
  std::vector<PlyProperty> Properties;
};

struct PlyHeader
{
  std::string Format;
  std::vector<PlyElement> Elements;
};

// Bytes of a PLY type; 0 for one that is not known.
std::size_t TypeSize(const std::string& type)
{
  static const std::map<std::string, std::size_t> sizes = { { "char", 1 }, { "uchar", 1 },
    { "int8", 1 }, { "uint8", 1 }, { "short", 2 }, { "ushort", 2 }, { "int16", 2 }, { "uint16", 2 },
    { "int", 4 }, { "uint", 4 }, { "int32", 4 }, { "uint32", 4 }, { "float", 4 }, { "float32", 4 },
    { "double", 8 }, { "float64", 8 } };
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

std::string ReadElement(std::istringstream& words, PlyHeader& header)
{
  PlyElement element;
  if (!(words >> element.Name >> element.Count) || element.Count < 0)
  {
    return "the PLY header has an element without a count";
  }
  header.Elements.push_back(element);
  return {};
}

std::string ReadProperty(std::istringstream& words, PlyHeader& header)
{
  PlyProperty property;
  std::string name;
  words >> property.Type;
  property.IsList = property.Type == "list";
  if (property.IsList)
  {
    words >> property.CountType >> property.Type;
  }
  if (!(words >> name) || header.Elements.empty() || TypeSize(property.Type) == 0 ||
    (property.IsList && TypeSize(property.CountType) == 0))
  {
    return "the PLY header has a property that is not understood";
  }
  header.Elements.back().Properties.push_back(property);
  return {};
}

// Leaves the stream at the first byte of data.
std::string ReadHeader(std::istream& stream, PlyHeader& header)
{
  std::string line;
  while (std::getline(stream, line))
  {
    std::istringstream words(line);
    std::string keyword;
    std::string defect;
    words >> keyword;
    if (keyword == "end_header")
    {
      return header.Format.empty() ? "the PLY header names no format" : "";
    }
    if (keyword == "format")
    {
      words >> header.Format;
    }
    else if (keyword == "element")
    {
      defect = ReadElement(words, header);
    }
    else if (keyword == "property")
    {
      defect = ReadProperty(words, header);
    }
    if (!defect.empty())
    {
      return defect;
    }
  }
  return "the PLY header does not end";
}

std::string CutShort(const PlyElement& element, long long present)
{
  return "the file ends after " + std::to_string(present) + " of " + std::to_string(element.Count) +
    " " + element.Name + " elements";
}

// Each element is a line of its own.
std::string AsciiDefect(std::istream& stream, const PlyHeader& header)
{
  std::string line;
  for (const PlyElement& element : header.Elements)
  {
    for (long long i = 0; i < element.Count; ++i)
    {
      if (!std::getline(stream, line))
      {
        return CutShort(element, i);
      }
      std::istringstream words(line);
      std::string word;
      for (const PlyProperty& property : element.Properties)
      {
        long long count = 1;
        if (property.IsList && (!(words >> count) || count < 0))
        {
          return CutShort(element, i);
        }
        for (long long k = 0; k < count; ++k)
        {
          if (!(words >> word))
          {
            return CutShort(element, i);
          }
        }
      }
    }
  }
  return {};
}

// The number that starts a list, in either byte order.
bool ReadListCount(std::istream& stream, const std::string& type, bool bigEndian, long long& count)
{
  std::array<unsigned char, 8> bytes = {};
  const std::size_t size = TypeSize(type);
  if (!stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
  {
    return false;
  }
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::uint64_t byte = bytes[bigEndian ? size - 1 - i : i];
    value |= byte << (8 * i);
  }
  count = static_cast<long long>(value);
  return true;
}

std::string BinaryDefect(std::istream& stream, const PlyHeader& header)
{
  const bool bigEndian = header.Format == "binary_big_endian";
  for (const PlyElement& element : header.Elements)
  {
    for (long long i = 0; i < element.Count; ++i)
    {
      for (const PlyProperty& property : element.Properties)
      {
        long long count = 1;
        if (property.IsList && !ReadListCount(stream, property.CountType, bigEndian, count))
        {
          return CutShort(element, i);
        }
        const long long bytes = count * static_cast<long long>(TypeSize(property.Type));
        stream.ignore(bytes);
        if (stream.gcount() != bytes)
        {
          return CutShort(element, i);
        }
      }
    }
  }
  return {};
}
}

std::string PlyDefect(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string magic;
  if (!std::getline(stream, magic) || magic.compare(0, 3, "ply") != 0)
  {
    return "not a PLY file";
  }
  PlyHeader header;
  const std::string defect = ReadHeader(stream, header);
  if (!defect.empty())
  {
    return defect;
  }
  if (header.Format == "ascii")
  {
    return AsciiDefect(stream, header);
  }
  if (header.Format == "binary_little_endian" || header.Format == "binary_big_endian")
  {
    return BinaryDefect(stream, header);
  }
  return "PLY format '" + header.Format + "' is not known";
}

std::string StlDefect(const std::string& file)
{
  // 80 bytes of anything, the number of triangles, 50 bytes for each.
  const std::size_t headerSize = 84;
  std::ifstream stream(file, std::ios::binary);
  std::string head(headerSize, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(headerSize));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  const bool text = head.find('\0') == std::string::npos && head.compare(0, 5, "solid") == 0;
  if (text)
  {
    return {};
  }
  if (head.size() < headerSize)
  {
    return "not an STL file";
  }
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    count |= static_cast<std::uint64_t>(static_cast<unsigned char>(head[80 + i])) << (8 * i);
  }
  stream.clear();
  stream.seekg(0, std::ios::end);
  const auto present = (static_cast<std::uint64_t>(stream.tellg()) - headerSize) / 50;
  return present < count ? "the file ends after " + std::to_string(present) + " of " +
      std::to_string(count) + " triangles"
                         : "";
}

std::string ObjDefect(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  for (long long number = 1; std::getline(stream, line); ++number)
  {
    line.erase(std::min(line.find('#'), line.size())); // a comment
    const bool coordinates = line.compare(0, 2, "v ") == 0 || line.compare(0, 3, "vn ") == 0;
    if (coordinates && line.find_first_not_of("+-.0123456789eE \t\r", 2) != std::string::npos)
    {
      return "line " + std::to_string(number) + " holds a coordinate that is no finite number";
    }
  }
  return {};
}
