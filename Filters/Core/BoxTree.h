/// A tree of boxes in space; what is in the boxes is the caller's.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// Over items with finite boxes, halved at the middle one along the longest axis. Built in
/// O(n log n); safe to be searched from several threads.
class BoxTree
{
public:
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Calls visit(item) for each item in leaves all of whose boxes, from the root on, are
  /// wanted(box): for more items than wanted, then, but never for fewer. Ends as soon as visit
  /// gives false.
  template <class Wanted, class Visit>
  void search(const Wanted& wanted, const Visit& visit) const
  {
    for (std::size_t n = 0; n < this->Nodes.size();)
    {
      const Node& node = this->Nodes[n];
      if (!wanted(node.box))
      {
        n = node.after;
        continue;
      }
      for (Index i = node.firstItem; i < node.endItem; ++i)
      {
        if (!visit(this->Items[i]))
        {
          return;
        }
      }
      ++n;
    }
  }

private:
  /// A node's children follow it, the first one at once.
  struct Node
  {
    Box box;
    Index firstItem; ///< of a leaf; as endItem for others
    Index endItem;
    Index after; ///< the node after all below this one
  };

  void build(const std::vector<Box>& boxes, Index first, Index end);

  std::vector<Node> Nodes;
  std::vector<Index> Items;
};
}
