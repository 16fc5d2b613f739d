#include "BoxTree.h"

#include <numeric>

namespace shadow
{
namespace
{
/// Boxes in a leaf: so few that looking at them all costs less than further nodes.
constexpr Index leafSize = 4;

/// Twice the centre.
double middle(const Box& box, glm::length_t axis)
{
  return box.low[axis] + box.high[axis];
}
}

BoxTree::BoxTree(const std::vector<Box>& boxes)
  : Items(boxes.size())
{
  std::iota(this->Items.begin(), this->Items.end(), Index(0));
  if (!boxes.empty())
  {
    this->Nodes.reserve(boxes.size());
    this->build(boxes, 0, static_cast<Index>(boxes.size()));
  }
}

void BoxTree::build(const std::vector<Box>& boxes, Index first, Index end)
{
  const std::size_t self = this->Nodes.size();
  Box around;
  Box middles;
  for (Index i = first; i < end; ++i)
  {
    const Box& box = boxes[this->Items[i]];
    around.add(box);
    middles.add(box.low + box.high);
  }
  const bool isLeaf = end - first <= leafSize;
  this->Nodes.push_back({ around, isLeaf ? first : end, end, 0 });
  if (!isLeaf)
  {
    const Vec3 size = middles.high - middles.low;
    const glm::length_t axis =
      size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const Index half = first + (end - first) / 2;
    const auto begin = this->Items.begin();
    std::nth_element(begin + first, begin + half, begin + end,
      [&](Index l, Index r)
      {
        const double left = middle(boxes[l], axis);
        const double right = middle(boxes[r], axis);
        return left != right ? left < right : l < r;
      });
    this->build(boxes, first, half);
    this->build(boxes, half, end);
  }
  this->Nodes[self].after = static_cast<Index>(this->Nodes.size());
}
}
