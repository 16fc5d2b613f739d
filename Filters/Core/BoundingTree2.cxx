#include "BoundingTree2.h"

#include <cstring>
#include <numeric>

namespace shadow
{
namespace
{
/// The float before another one, as std::nextafter gives it, which is a call for each.
float before(float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  bits = value > 0.0f ? bits - 1 : value < 0.0f ? bits + 1 : 0x80000001u;
  std::memcpy(&value, &bits, sizeof(bits));
  return value;
}

/// The greatest float that is not greater.
float below(double value)
{
  const float nearest = static_cast<float>(value);
  return static_cast<double>(nearest) > value ? before(nearest) : nearest;
}

/// Twice the centre of a box, on an axis.
float middle(const Box2& box, std::size_t axis)
{
  return box.ends[axis] - box.ends[axis + 2];
}

/// What the first subtree of a complete tree over so many leaves has of them: its levels are full
/// but the last, which fills from the left.
std::size_t leavesOnTheLeft(std::size_t count)
{
  std::size_t full = 1;
  while (2 * full <= count)
  {
    full *= 2;
  }
  const std::size_t half = full / 2;
  return half + std::min(half, count - full);
}

void halve(const std::vector<Box2>& boxes, Index* begin, Index* end)
{
  const std::size_t count = static_cast<std::size_t>(end - begin);
  if (count < 2)
  {
    return;
  }
  std::array<float, 2> low{ Box2::emptyEnd, Box2::emptyEnd };
  std::array<float, 2> high{ -Box2::emptyEnd, -Box2::emptyEnd };
  for (const Index* i = begin; i != end; ++i)
  {
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      const float at = middle(boxes[*i], axis);
      low[axis] = std::min(low[axis], at);
      high[axis] = std::max(high[axis], at);
    }
  }
  const std::size_t axis = high[0] - low[0] >= high[1] - low[1] ? 0 : 1;
  Index* const split = begin + leavesOnTheLeft(count);
  std::nth_element(begin, split, end,
    [&](Index l, Index r)
    {
      const float left = middle(boxes[l], axis);
      const float right = middle(boxes[r], axis);
      return left != right ? left < right : l < r;
    });
  halve(boxes, begin, split);
  halve(boxes, split, end);
}

constexpr unsigned mortonBits = 11;
constexpr Index mortonCells = Index(1) << mortonBits;

/// The bits of a number below 2^16, each followed by a zero.
Index spread(Index bits)
{
  bits = (bits | (bits << 8)) & 0x00ff00ffu;
  bits = (bits | (bits << 4)) & 0x0f0f0f0fu;
  bits = (bits | (bits << 2)) & 0x33333333u;
  return (bits | (bits << 1)) & 0x55555555u;
}

std::vector<Index> mortonCodes(const std::vector<Box2>& boxes)
{
  Box2 middles;
  for (const Box2& box : boxes)
  {
    const std::array<float, 2> at{ middle(box, 0), middle(box, 1) };
    for (std::size_t k = 0; k < 2; ++k)
    {
      middles.ends[k] = std::min(middles.ends[k], at[k]);
      middles.ends[k + 2] = std::min(middles.ends[k + 2], -at[k]);
    }
  }
  std::array<float, 2> scale;
  for (std::size_t k = 0; k < 2; ++k)
  {
    const float extent = -middles.ends[k + 2] - middles.ends[k];
    scale[k] = extent > 0.0f ? static_cast<float>(mortonCells) / extent : 0.0f;
  }
  std::vector<Index> codes(boxes.size());
  std::transform(boxes.begin(), boxes.end(), codes.begin(),
    [&](const Box2& box)
    {
      const auto cell = [&](std::size_t k)
      {
        const float at = (middle(box, k) - middles.ends[k]) * scale[k];
        // What is no number, of boxes without an end, comes first.
        return at > 0.0f ? static_cast<Index>(std::min(at, static_cast<float>(mortonCells - 1)))
                         : Index(0);
      };
      return spread(cell(0)) | (spread(cell(1)) << 1);
    });
  return codes;
}

/// Into ascending order of their codes, which stays the order they have where codes are equal.
std::vector<Index> sortedByCode(std::vector<Index> items, const std::vector<Index>& codes)
{
  std::vector<Index> sorted(items.size());
  for (unsigned shift = 0; shift < 2 * mortonBits; shift += mortonBits)
  {
    std::array<Index, mortonCells + 1> start{};
    const auto digit = [&](Index item) { return (codes[item] >> shift) & (mortonCells - 1); };
    for (const Index item : items)
    {
      ++start[digit(item) + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (const Index item : items)
    {
      sorted[start[digit(item)]++] = item;
    }
    items.swap(sorted);
  }
  return items;
}

std::vector<Index> leafOrder(const std::vector<Box2>& boxes, TreeBuilder builder)
{
  std::vector<Index> order(boxes.size());
  std::iota(order.begin(), order.end(), Index(0));
  switch (builder)
  {
    case TreeBuilder::ObjectMedian:
      halve(boxes, order.data(), order.data() + order.size());
      return order;
    case TreeBuilder::Morton:
      return sortedByCode(std::move(order), mortonCodes(boxes));
    default:
      return order;
  }
}
}

void Box2::add(double x, double y)
{
  this->ends[0] = std::min(this->ends[0], below(x));
  this->ends[1] = std::min(this->ends[1], below(y));
  this->ends[2] = std::min(this->ends[2], below(-x));
  this->ends[3] = std::min(this->ends[3], below(-y));
}

BoundingTree2::BoundingTree2(const std::vector<Box2>& boxes, TreeBuilder builder)
{
  const std::size_t count = boxes.size();
  if (count == 0)
  {
    return;
  }
  const std::vector<Index> order = leafOrder(boxes, builder);
  const std::size_t inner = count - 1;
  this->Nodes.resize(inner + count);
  this->Items.resize(count);
  // From left to right the leaves of the last level come first, though their numbers are last.
  std::size_t lastLevel = 0;
  while (2 * lastLevel + 1 < this->Nodes.size())
  {
    lastLevel = 2 * lastLevel + 1;
  }
  std::size_t node = lastLevel;
  for (const Index item : order)
  {
    this->Nodes[node] = boxes[item];
    this->Items[node - inner] = item;
    node = node + 1 < this->Nodes.size() ? node + 1 : inner;
  }
  for (std::size_t i = inner; i-- > 0;)
  {
    this->Nodes[i] = this->Nodes[2 * i + 1];
    this->Nodes[i].add(this->Nodes[2 * i + 2]);
  }
}
}
