#include "FacingHierarchy.h"

#include <algorithm>

namespace shadow
{
namespace
{
constexpr std::size_t mostItems = 64;   ///< in a leaf: 64 items of 4 fields are numbered by a byte
constexpr std::size_t mostPlanes = 256;

/// Signs that a field can have, as bits: an item whose fields together have both is a candidate.
constexpr unsigned mayBeLit = 1;
constexpr unsigned mayBeDark = 2;
constexpr unsigned bothSigns = mayBeLit | mayBeDark;

/// Sizes whose products with areas stay far from the ends of the range of doubles.
bool isInRange(double size, double exponent)
{
  return size > std::pow(10.0, -exponent) && size < std::pow(10.0, exponent);
}
}

glm::vec4 facingPlane(const Vec3& normal, const Vec3& point, const Vec3& centre, double radius)
{
  const double length = glm::length(normal);
  if (!(length > 1e-150 && length < 1e150))
  {
    return glm::vec4(0.0f);
  }
  const Vec3 n = normal / length;
  const double offset = -glm::dot(n, (point - centre) / radius);
  // In the ball it is at most 1; what is not has a ball that rounding made meaningless.
  if (!(std::fabs(offset) < 1.001) || !isFinite(n))
  {
    return glm::vec4(0.0f);
  }
  return { static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z),
    static_cast<float>(offset) };
}

class FacingHierarchy::Builder
{
public:
  Builder(FacingHierarchy& tree, const FacingItems& items, const RangeLoop& loop)
    : Tree(tree)
    , Items(items)
    , Loop(loop)
    , Leaves(std::size_t(1) << tree.Depth)
  {
  }

  void build()
  {
    this->placeEntries();
    for (unsigned level = 0; level < this->Tree.Depth; ++level)
    {
      this->splitLevel(level);
    }
    this->listPlanes();
    this->copyPlanes();
    this->joinBoxes();
  }

private:
  /// An item by the middle of its planes' box.
  struct Entry
  {
    glm::vec4 middle;
    Index item;
  };

  const Index* fieldsOf(std::size_t item) const
  {
    return this->Items.fields.data() + item * this->Items.arity;
  }

  void placeEntries()
  {
    this->Entries.resize(this->Items.ids.size());
    this->Loop(this->Entries.size(), lightGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          const Index* fields = this->fieldsOf(i);
          glm::vec4 low = this->Items.planes[fields[0]];
          glm::vec4 high = low;
          for (unsigned k = 1; k < this->Items.arity; ++k)
          {
            low = glm::min(low, this->Items.planes[fields[k]]);
            high = glm::max(high, this->Items.planes[fields[k]]);
          }
          this->Entries[i] = { 0.5f * (low + high), static_cast<Index>(i) };
        }
      });
  }

  void splitLevel(unsigned level)
  {
    const std::size_t width = this->Leaves >> level;
    this->Loop(std::size_t(1) << level, 1,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t node = begin; node < end; ++node)
        {
          this->split(this->Tree.firstItem(node * width),
            this->Tree.firstItem(node * width + width / 2), this->Tree.firstItem((node + 1) * width));
        }
      });
  }

  void split(std::size_t begin, std::size_t middle, std::size_t end)
  {
    glm::vec4 low = this->Entries[begin].middle;
    glm::vec4 high = low;
    for (std::size_t i = begin + 1; i < end; ++i)
    {
      low = glm::min(low, this->Entries[i].middle);
      high = glm::max(high, this->Entries[i].middle);
    }
    const glm::vec4 extent = high - low;
    int axis = 0;
    for (int k = 1; k < 4; ++k)
    {
      axis = extent[k] > extent[axis] ? k : axis;
    }
    const auto at = [&](std::size_t i)
    { return this->Entries.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end),
      [axis](const Entry& l, const Entry& r) { return l.middle[axis] < r.middle[axis]; });
  }

  /// Ids, places, and of each leaf its distinct fields: in Distinct, from its first item's on.
  void listPlanes()
  {
    const std::size_t arity = this->Items.arity;
    this->Tree.Ids.resize(this->Entries.size());
    this->Tree.Places.resize(this->Entries.size() * arity);
    this->Distinct.resize(this->Entries.size() * arity);
    this->Counts.resize(this->Leaves);
    this->Loop(this->Leaves, heavyGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t leaf = begin; leaf < end; ++leaf)
        {
          this->listLeaf(leaf);
        }
      });
    // Rows of whole vectors.
    this->Tree.FirstPlane.push_back(0);
    for (const std::uint32_t count : this->Counts)
    {
      this->Tree.FirstPlane.push_back(this->Tree.FirstPlane.back() + (count + 3) / 4 * 4);
    }
  }

  void listLeaf(std::size_t leaf)
  {
    const std::size_t arity = this->Items.arity;
    const std::size_t first = this->Tree.firstItem(leaf);
    const std::size_t end = this->Tree.firstItem(leaf + 1);
    Index* const distinct = this->Distinct.data() + first * arity;
    Index* last = distinct;
    for (std::size_t i = first; i < end; ++i)
    {
      last = std::copy_n(this->fieldsOf(this->Entries[i].item), arity, last);
    }
    std::sort(distinct, last);
    last = std::unique(distinct, last);
    for (std::size_t i = first; i < end; ++i)
    {
      const Index item = this->Entries[i].item;
      this->Tree.Ids[i] = this->Items.ids[item];
      for (std::size_t k = 0; k < arity; ++k)
      {
        this->Tree.Places[i * arity + k] = static_cast<std::uint8_t>(
          std::lower_bound(distinct, last, this->fieldsOf(item)[k]) - distinct);
      }
    }
    this->Counts[leaf] = static_cast<std::uint32_t>(last - distinct);
  }

  void copyPlanes()
  {
    this->Tree.Planes.resize(std::size_t(4) * this->Tree.FirstPlane.back());
    this->Tree.Boxes.resize(2 * this->Leaves - 1);
    this->Loop(this->Leaves, heavyGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t leaf = begin; leaf < end; ++leaf)
        {
          this->copyLeaf(leaf);
        }
      });
  }

  /// What is left of a row repeats the leaf's last plane.
  void copyLeaf(std::size_t leaf)
  {
    const std::size_t first = this->Tree.FirstPlane[leaf];
    const std::size_t row = this->Tree.FirstPlane[leaf + 1] - first;
    const Index* distinct = this->Distinct.data() + this->Tree.firstItem(leaf) * this->Items.arity;
    float* planes = this->Tree.Planes.data() + 4 * first;
    Box box{ this->Items.planes[*distinct], this->Items.planes[*distinct] };
    for (std::size_t i = 0; i < row; ++i)
    {
      const glm::vec4& q =
        this->Items.planes[distinct[std::min<std::size_t>(i, this->Counts[leaf] - 1)]];
      box = { glm::min(box.low, q), glm::max(box.high, q) };
      for (int k = 0; k < 4; ++k)
      {
        planes[static_cast<std::size_t>(k) * row + i] = q[k];
      }
    }
    this->Tree.Boxes[this->Leaves - 1 + leaf] = box;
  }

  void joinBoxes()
  {
    std::vector<Box>& boxes = this->Tree.Boxes;
    for (std::size_t i = this->Leaves - 1; i-- > 0;)
    {
      const Box& l = boxes[2 * i + 1];
      const Box& r = boxes[2 * i + 2];
      boxes[i] = { glm::min(l.low, r.low), glm::max(l.high, r.high) };
    }
  }

  FacingHierarchy& Tree;
  const FacingItems& Items;
  const RangeLoop& Loop;
  const std::size_t Leaves;
  std::vector<Entry> Entries;
  std::vector<Index> Distinct;
  std::vector<std::uint32_t> Counts; ///< of distinct fields in each leaf
};

FacingHierarchy::FacingHierarchy(const FacingItems& items, const RangeLoop& loop)
  : Centre(items.centre)
  , Radius(items.radius)
  , Arity(items.arity)
{
  if (items.ids.empty())
  {
    return;
  }
  while ((items.ids.size() >> this->Depth) >= mostItems)
  {
    ++this->Depth;
  }
  this->Ids.resize(items.ids.size());
  Builder(*this, items, loop).build();
}

/// Let s be the larger of |l - w c| and w R, so that q . plane is the field by |N| s. Its rounding in
/// floats is below 20 units of 2^-24: each of four products of at most 1 has three roundings, and
/// there are three sums. The field in double is off by a few units of 2^-53 of |N| (|l| + w |p|),
/// which counts where the mesh is far from the origin.
FacingHierarchy::Query FacingHierarchy::makeQuery(const Light& light) const
{
  const Vec3 place = light.position - light.w * this->Centre;
  const double reach = light.w * this->Radius;
  const double scale = std::fmax(glm::length(place), reach);
  if (!isInRange(this->Radius, 100.0) || !isInRange(scale, 100.0))
  {
    return { glm::vec4(0.0f), 1.0f };
  }
  const Vec3 direction = place / scale;
  const double magnitude =
    glm::length(light.position) + light.w * (glm::length(this->Centre) + this->Radius);
  const double margin = std::ldexp(32.0, -24) + std::ldexp(32.0, -53) * magnitude / scale;
  return { { static_cast<float>(direction.x), static_cast<float>(direction.y),
             static_cast<float>(direction.z), static_cast<float>(reach / scale) },
    static_cast<float>(std::fmin(2.0 * margin, 1e30)) };
}

bool FacingHierarchy::hasOneSign(const Box& box, const Query& query)
{
  const glm::vec4 a = box.low * query.plane;
  const glm::vec4 b = box.high * query.plane;
  const glm::vec4 low = glm::min(a, b);
  const glm::vec4 high = glm::max(a, b);
  return (low.x + low.y) + (low.z + low.w) > query.margin ||
    (high.x + high.y) + (high.z + high.w) < -query.margin;
}

std::vector<Index> FacingHierarchy::leavesWithBothSigns(const Query& query) const
{
  std::vector<Index> found;
  const std::size_t firstLeaf = (std::size_t(1) << this->Depth) - 1;
  std::vector<std::size_t> open;
  if (!this->Ids.empty())
  {
    open.push_back(0);
  }
  while (!open.empty())
  {
    const std::size_t node = open.back();
    open.pop_back();
    if (hasOneSign(this->Boxes[node], query))
    {
      continue;
    }
    if (node >= firstLeaf)
    {
      found.push_back(static_cast<Index>(node - firstLeaf));
      continue;
    }
    open.push_back(2 * node + 2);
    open.push_back(2 * node + 1);
  }
  return found;
}

void FacingHierarchy::searchLeaf(
  std::size_t leaf, const Query& query, std::vector<Index>& found) const
{
  const std::size_t row = this->FirstPlane[leaf + 1] - this->FirstPlane[leaf];
  const float* x = this->Planes.data() + std::size_t(4) * this->FirstPlane[leaf];
  const float* y = x + row;
  const float* z = y + row;
  const float* w = z + row;
  std::array<std::uint8_t, mostPlanes> signs;
  for (std::size_t i = 0; i < row; ++i)
  {
    const float value = (x[i] * query.plane.x + y[i] * query.plane.y) +
      (z[i] * query.plane.z + w[i] * query.plane.w);
    signs[i] = static_cast<std::uint8_t>((value >= -query.margin ? mayBeLit : 0u) |
      (value <= query.margin ? mayBeDark : 0u));
  }
  const std::uint8_t* places = this->Places.data() + this->firstItem(leaf) * this->Arity;
  for (std::size_t i = this->firstItem(leaf); i < this->firstItem(leaf + 1); ++i)
  {
    unsigned together = 0;
    for (unsigned k = 0; k < this->Arity; ++k)
    {
      together |= signs[*places++];
    }
    if (together == bothSigns)
    {
      found.push_back(this->Ids[i]);
    }
  }
}

std::vector<Index> FacingHierarchy::candidates(
  const Light& light, const RangeLoop& loop, std::size_t& tested) const
{
  const Query query = this->makeQuery(light);
  const std::vector<Index> leaves = this->leavesWithBothSigns(query);
  constexpr std::size_t blockSize = 64;
  const std::size_t blocks = (leaves.size() + blockSize - 1) / blockSize;
  std::vector<std::vector<Index>> parts(blocks);
  loop(blocks, 16,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin * blockSize; i < std::min(end * blockSize, leaves.size()); ++i)
      {
        this->searchLeaf(leaves[i], query, parts[i / blockSize]);
      }
    });
  std::vector<Index> found;
  for (const std::vector<Index>& part : parts)
  {
    found.insert(found.end(), part.begin(), part.end());
  }
  for (const Index leaf : leaves)
  {
    tested += this->firstItem(leaf + 1) - this->firstItem(leaf);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::size_t FacingHierarchy::memory() const
{
  return sizeof(*this) + this->Boxes.capacity() * sizeof(Box) +
    this->Ids.capacity() * sizeof(Index) + this->Places.capacity() +
    this->FirstPlane.capacity() * sizeof(std::uint32_t) + this->Planes.capacity() * sizeof(float);
}
}
