#include "FacingHierarchy.h"

#include <cstring>
#include <numeric>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace shadow
{
namespace
{
/// 1 as an integer: products of two planes, whose sum is at most 2, stay within 31 bits.
constexpr double one = 32000.0;

/// Boxes under a node.
constexpr std::size_t fan = 8;

/// A bit beside those of the fields: one of them has no sign that is certain.
constexpr unsigned uncertain = 16;

using Signs = std::array<std::int32_t, FacingHierarchy::blockSize>;

/// Adds a bit to the sign of each item whose field is lit for certain, and the bit of uncertain
/// where that is open. The planes' pairs are multiplied and added with the light's.
#ifdef __SSE2__
void addSigns(const std::int16_t* pairs, const std::array<std::int16_t, 4>& light,
  std::int32_t margin, unsigned bit, Signs& signs)
{
  const auto pair = [&](std::size_t k)
  {
    const std::uint32_t low = static_cast<std::uint16_t>(light[k]);
    const std::uint32_t high = static_cast<std::uint16_t>(light[k + 1]);
    return _mm_set1_epi32(static_cast<std::int32_t>(low | (high << 16)));
  };
  const __m128i xy = pair(0);
  const __m128i zw = pair(2);
  const __m128i most = _mm_set1_epi32(margin);
  const __m128i least = _mm_set1_epi32(-margin);
  const __m128i litBit = _mm_set1_epi32(static_cast<std::int32_t>(bit));
  const __m128i openBit = _mm_set1_epi32(static_cast<std::int32_t>(uncertain));
  const auto* first = reinterpret_cast<const __m128i*>(pairs);
  const __m128i* second = first + signs.size() / 4;
  auto* sums = reinterpret_cast<__m128i*>(signs.data());
  for (std::size_t i = 0; i < signs.size() / 4; ++i)
  {
    const __m128i value = _mm_add_epi32(_mm_madd_epi16(_mm_loadu_si128(first + i), xy),
      _mm_madd_epi16(_mm_loadu_si128(second + i), zw));
    const __m128i lit = _mm_cmpgt_epi32(value, most);
    const __m128i known = _mm_or_si128(lit, _mm_cmplt_epi32(value, least));
    const __m128i bits =
      _mm_or_si128(_mm_and_si128(lit, litBit), _mm_andnot_si128(known, openBit));
    _mm_storeu_si128(sums + i, _mm_or_si128(_mm_loadu_si128(sums + i), bits));
  }
}
#else
void addSigns(const std::int16_t* pairs, const std::array<std::int16_t, 4>& light,
  std::int32_t margin, unsigned bit, Signs& signs)
{
  const std::int16_t* second = pairs + 2 * signs.size();
  for (std::size_t i = 0; i < signs.size(); ++i)
  {
    const std::int32_t value = pairs[2 * i] * light[0] + pairs[2 * i + 1] * light[1] +
      second[2 * i] * light[2] + second[2 * i + 1] * light[3];
    const unsigned open = value <= margin && value >= -margin ? uncertain : 0;
    signs[i] |= static_cast<std::int32_t>((value > margin ? bit : 0) | open);
  }
}
#endif

/// Sizes whose products with areas stay far from the ends of the range of doubles.
bool isInRange(double size)
{
  return size > 1e-100 && size < 1e100;
}
}

FacingHierarchy::FacingHierarchy(unsigned arity, std::size_t count, const Ball& ball)
  : TheBall(ball)
  , Arity(arity)
  , Count(count)
  , Blocks((count + blockSize - 1) / blockSize)
  , Planes(Blocks * arity * 4 * blockSize)
{
  for (std::size_t size = this->Blocks; size > 0; size = size > fan ? (size + fan - 1) / fan : 0)
  {
    this->Levels.emplace_back(size);
  }
}

glm::vec4 FacingHierarchy::quantized(const Vec4& plane)
{
  return glm::vec4(
    std::lrint(plane.x * one), std::lrint(plane.y * one), std::lrint(plane.z * one),
    std::lrint(plane.w * one));
}

void FacingHierarchy::joinBoxes()
{
  for (std::size_t level = 1; level < this->Levels.size(); ++level)
  {
    const std::vector<Box>& below = this->Levels[level - 1];
    for (std::size_t i = 0; i < below.size(); ++i)
    {
      this->Levels[level][i / fan].add(below[i].low, below[i].high);
    }
  }
}

/// Let s be the larger of |l - w c| and w R, so that q . (l, w) is the field by |N| s. In units of
/// one^2 it is off by at most 2.74 / one: half an integer for each component of either plane, whose
/// components sum up to at most the square root of 3, and 1. The field in double is off by a few
/// units of 2^-53 of |N| (|l| + w |p|), which counts where the mesh is far from the origin.
FacingHierarchy::Query FacingHierarchy::makeQuery(const Light& light) const
{
  const Vec3 place = light.position - light.w * this->TheBall.centre;
  const double reach = light.w * this->TheBall.radius;
  const double scale = std::fmax(glm::length(place), reach);
  if (!isInRange(this->TheBall.radius) || !isInRange(scale))
  {
    return { {}, std::numeric_limits<std::int32_t>::max() }; // nothing is certain
  }
  const double magnitude = glm::length(light.position) +
    light.w * (glm::length(this->TheBall.centre) + this->TheBall.radius);
  const double margin = 3.0 / one + std::ldexp(64.0, -53) * magnitude / scale;
  const glm::vec4 q = quantized(Vec4(place, reach) / scale);
  Query query;
  for (int c = 0; c < 4; ++c)
  {
    query.plane[static_cast<std::size_t>(c)] = static_cast<std::int16_t>(q[c]);
  }
  query.margin = static_cast<std::int32_t>(
    std::fmin(margin * one * one, std::numeric_limits<std::int32_t>::max()));
  return query;
}

std::vector<Index> FacingHierarchy::blocksWithBothSigns(const Query& query) const
{
  const glm::vec4 light(query.plane[0], query.plane[1], query.plane[2], query.plane[3]);
  // Sums of products in float are off by less than 2^-21 of at most 8 one^2.
  const float margin = static_cast<float>(query.margin) + 4096.0f;
  const auto hasOneSign = [&](const Box& box)
  {
    const glm::vec4 a = box.low * light;
    const glm::vec4 b = box.high * light;
    const glm::vec4 low = glm::min(a, b);
    const glm::vec4 high = glm::max(a, b);
    return (low.x + low.y) + (low.z + low.w) > margin ||
      (high.x + high.y) + (high.z + high.w) < -margin;
  };
  std::vector<Index> alive;
  std::vector<Index> next;
  for (std::size_t level = this->Levels.size(); level-- > 0;)
  {
    const std::vector<Box>& boxes = this->Levels[level];
    next.clear();
    const auto test = [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        if (!hasOneSign(boxes[i]))
        {
          next.push_back(static_cast<Index>(i));
        }
      }
    };
    if (level + 1 == this->Levels.size())
    {
      test(0, boxes.size());
    }
    for (const Index node : alive)
    {
      test(fan * node, std::min(fan * node + fan, boxes.size()));
    }
    alive.swap(next);
  }
  return alive;
}

template <unsigned Arity>
void FacingHierarchy::searchBlock(
  std::size_t block, const Query& query, const IsLit& isLit, FacingFound& found) const
{
  std::array<std::int32_t, blockSize> signs = {};
  for (unsigned k = 0; k < Arity; ++k)
  {
    addSigns(this->Planes.data() + (block * Arity + k) * 4 * blockSize, query.plane, query.margin,
      1u << k, signs);
  }
  std::uint8_t codes[blockSize];
  for (std::size_t i = 0; i < blockSize; ++i)
  {
    codes[i] = static_cast<std::uint8_t>(signs[i]);
  }

  constexpr unsigned all = (1u << Arity) - 1;
  const std::size_t first = block * blockSize;
  const std::size_t count = std::min(blockSize, this->Count - first);
  found.tested += count;
  for (std::size_t word = 0; word < count; word += 8)
  {
    std::uint64_t eight;
    std::memcpy(&eight, codes + word, 8);
    if (eight == 0 || eight == all * 0x0101010101010101ull)
    {
      continue;
    }
    for (std::size_t i = word; i < std::min(count, word + 8); ++i)
    {
      unsigned lit = codes[i];
      const Index item = static_cast<Index>(first + i);
      if (lit & uncertain)
      {
        lit = 0;
        for (unsigned k = 0; k < Arity; ++k)
        {
          lit |= isLit(item, k) ? 1u << k : 0u;
        }
      }
      if (lit != 0 && lit != all)
      {
        found.items.push_back(item);
        found.lit.push_back(static_cast<std::uint8_t>(lit));
      }
    }
  }
}

FacingFound FacingHierarchy::search(
  const Light& light, bool useTree, const IsLit& isLit, const RangeLoop& loop) const
{
  const Query query = this->makeQuery(light);
  std::vector<Index> blocks;
  if (useTree)
  {
    blocks = this->blocksWithBothSigns(query);
  }
  else
  {
    blocks.resize(this->Blocks);
    std::iota(blocks.begin(), blocks.end(), Index(0));
  }
  constexpr std::size_t chunk = 256;
  std::vector<FacingFound> parts((blocks.size() + chunk - 1) / chunk);
  loop(parts.size(), 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t part = begin; part < end; ++part)
      {
        const auto searchThem = [&](auto arity)
        {
          for (std::size_t i = part * chunk; i < std::min((part + 1) * chunk, blocks.size()); ++i)
          {
            this->searchBlock<arity>(blocks[i], query, isLit, parts[part]);
          }
        };
        switch (this->Arity)
        {
          case 2:
            searchThem(std::integral_constant<unsigned, 2>());
            break;
          case 3:
            searchThem(std::integral_constant<unsigned, 3>());
            break;
          default:
            searchThem(std::integral_constant<unsigned, 4>());
            break;
        }
      }
    });
  FacingFound found = parts.empty() ? FacingFound() : std::move(parts[0]);
  for (std::size_t part = 1; part < parts.size(); ++part)
  {
    found.items.insert(found.items.end(), parts[part].items.begin(), parts[part].items.end());
    found.lit.insert(found.lit.end(), parts[part].lit.begin(), parts[part].lit.end());
    found.tested += parts[part].tested;
  }
  return found;
}

std::size_t FacingHierarchy::memory() const
{
  std::size_t total = this->Planes.capacity() * sizeof(std::int16_t);
  for (const std::vector<Box>& level : this->Levels)
  {
    total += level.capacity() * sizeof(Box);
  }
  return total;
}
}
