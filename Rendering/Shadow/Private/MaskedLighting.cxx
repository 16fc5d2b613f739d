#include "MaskedLighting.h"

#include "LightMaskDeclarations.h"
#include "ShadowFramebuffer.h"

#include <algorithm>
#include <cctype>

namespace
{
const std::string ColorName = "lightColor";
const std::string FetchName = "stencilShadowFetch();";

bool IsIdentifierPart(char character)
{
  return std::isalnum(static_cast<unsigned char>(character)) || character == '_';
}

/**
 * Whether the name at `position` is being declared: its statement begins with `uniform`.
 */
bool IsDeclared(const std::string& source, std::size_t position)
{
  const std::size_t before = source.find_last_of(";{}\n", position);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  return source.substr(begin, position - begin).find("uniform") != std::string::npos;
}

std::string MaskedColor(const std::string& color, int mask)
{
  static const char channels[] = "rgba";
  return "(stencilShadow[" + std::to_string(mask / ShadowFramebuffer::ChannelsPerLayer) + "]." +
    channels[mask % ShadowFramebuffer::ChannelsPerLayer] + " * " + color + ")";
}

/**
 * The source with its uses of colours replaced; `first` becomes the beginning of the line that
 * first names one.
 */
std::string ReplaceUses(const std::string& source, const LightMasks& masks, std::size_t& first)
{
  std::string result;
  std::size_t done = 0;
  first = std::string::npos;
  for (std::size_t begin = source.find(ColorName); begin != std::string::npos;
       begin = source.find(ColorName, begin + 1))
  {
    const std::size_t digits = begin + ColorName.size();
    std::size_t end = digits;
    while (end < source.size() && std::isdigit(static_cast<unsigned char>(source[end])))
    {
      ++end;
    }
    if (end == digits || (end < source.size() && IsIdentifierPart(source[end])) ||
      (begin > 0 && IsIdentifierPart(source[begin - 1])))
    {
      continue;
    }
    if (first == std::string::npos)
    {
      const std::size_t line = source.rfind('\n', begin);
      first = line == std::string::npos ? 0 : line + 1;
    }
    const auto mask = masks.find(std::stoi(source.substr(digits, end - digits)));
    if (mask == masks.end() || IsDeclared(source, begin))
    {
      continue;
    }
    result.append(source, done, begin - done);
    result += MaskedColor(source.substr(begin, end - begin), mask->second);
    done = end;
  }
  result.append(source, done, std::string::npos);
  return result;
}

std::string Declarations(const LightMasks& masks)
{
  int count = 0;
  for (const auto& mask : masks)
  {
    count = std::max(count, mask.second + 1);
  }
  const std::string layers = std::to_string(ShadowFramebuffer::LayersFor(count));
  const std::string placeholder = "LAYER_COUNT";
  std::string text = LightMaskDeclarations;
  for (std::size_t at = text.find(placeholder); at != std::string::npos;
       at = text.find(placeholder))
  {
    text.replace(at, placeholder.size(), layers);
  }
  return text;
}
}

void MaskLighting(std::string& fragmentShader, const LightMasks& masks)
{
  if (fragmentShader.find(FetchName) != std::string::npos)
  {
    return;
  }
  std::size_t first;
  std::string source = ReplaceUses(fragmentShader, masks, first);
  if (first == std::string::npos)
  {
    return;
  }
  const std::size_t main = source.find("void main", first);
  const std::size_t body = main == std::string::npos ? main : source.find('{', main);
  if (body == std::string::npos)
  {
    return;
  }
  // From the back, so that the earlier place stays where it is. Lights are declared before they
  // are used, so the line of the first of them is early enough for the masks.
  source.insert(body + 1, "\n  " + FetchName + "\n");
  source.insert(first, Declarations(masks));
  fragmentShader = std::move(source);
}
