/// A tree of boxes in the plane; what is in the boxes is the caller's.
#pragma once

#include "Geometry.h"

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace shadow
{
/// A box in the plane, as floats around what was given in double. Boxes meet where they touch.
struct Box2
{
  /// Least x and y, and greatest x and y with their signs turned: of two boxes the one around both
  /// is the least of these, and whether two meet is one comparison of four.
  alignas(16) std::array<float, 4> ends{ emptyEnd, emptyEnd, emptyEnd, emptyEnd };

  static constexpr float emptyEnd = std::numeric_limits<float>::infinity();

  void add(double x, double y);

  void add(const Box2& o)
  {
    for (std::size_t k = 0; k < 4; ++k)
    {
      this->ends[k] = std::min(this->ends[k], o.ends[k]);
    }
  }

  /// Half of the perimeter.
  float size() const
  {
    return -this->ends[2] - this->ends[0] - this->ends[3] - this->ends[1];
  }
};

/// How a tree's boxes are put in order.
enum class TreeBuilder
{
  Unsorted,     ///< as they come (after Barabas)
  ObjectMedian, ///< halved at the middle one along the longer axis, again and again
  Morton        ///< along a space-filling curve (Lauterbach et al. 2009)
};

/// What searches have cost.
struct TreeVisits
{
  std::size_t nodes = 0;  ///< boxes that were compared, those of leaves included
  std::size_t leaves = 0; ///< items that were given to the caller

  void add(const TreeVisits& o)
  {
    this->nodes += o.nodes;
    this->leaves += o.leaves;
  }
};

/// A complete binary tree over boxes, one in a leaf. The children of node i are 2 i + 1 and
/// 2 i + 2, so nothing but boxes is stored; all builders differ in the order of the leaves alone.
/// Built in O(n), by the median in O(n log n). Safe to be searched from several threads.
class BoundingTree2
{
public:
  BoundingTree2() = default;
  BoundingTree2(const std::vector<Box2>& boxes, TreeBuilder builder);

  std::size_t size() const { return this->Items.size(); }

  /// Calls visit(item) for each item whose box meets the given one, until visit gives false.
  template <class Visit>
  void search(const Box2& box, TreeVisits& visits, const Visit& visit) const
  {
    if (this->Items.empty())
    {
      return;
    }
    const Wanted wanted(box);
    const std::size_t inner = this->Items.size() - 1;
    // One waits on each level at most, and levels are as many as a number of nodes has bits.
    std::array<std::size_t, 65> waiting;
    std::size_t count = 0;
    std::size_t node = 0;
    ++visits.nodes;
    if (!wanted.meets(this->Nodes[0]))
    {
      return;
    }
    for (;;)
    {
      if (node >= inner)
      {
        ++visits.leaves;
        if (!visit(this->Items[node - inner]))
        {
          return;
        }
      }
      else
      {
        const std::size_t left = 2 * node + 1;
        visits.nodes += 2;
        const bool meetsLeft = wanted.meets(this->Nodes[left]);
        const bool meetsRight = wanted.meets(this->Nodes[left + 1]);
        if (meetsLeft && meetsRight)
        {
          waiting[count++] = left + 1;
        }
        if (meetsLeft || meetsRight)
        {
          node = meetsLeft ? left : left + 1;
          continue;
        }
      }
      if (count == 0)
      {
        return;
      }
      node = waiting[--count];
    }
  }

private:
  /// A box that is searched for, with its ends where those of the nodes are compared with them.
  class Wanted
  {
  public:
    explicit Wanted(const Box2& box)
      : Ends{ -box.ends[2], -box.ends[3], -box.ends[0], -box.ends[1] }
    {
#ifdef __SSE__
      this->Packed = _mm_loadu_ps(this->Ends.data());
#endif
    }

    bool meets(const Box2& node) const
    {
#ifdef __SSE__
      return _mm_movemask_ps(_mm_cmple_ps(_mm_load_ps(node.ends.data()), this->Packed)) == 15;
#else
      return node.ends[0] <= this->Ends[0] && node.ends[1] <= this->Ends[1] &&
        node.ends[2] <= this->Ends[2] && node.ends[3] <= this->Ends[3];
#endif
    }

  private:
    std::array<float, 4> Ends;
#ifdef __SSE__
    __m128 Packed;
#endif
  };

  std::vector<Box2> Nodes;
  std::vector<Index> Items; ///< of the leaves, in the order of their nodes
};

inline bool meet(const Box2& l, const Box2& r)
{
  return l.ends[0] <= -r.ends[2] && l.ends[1] <= -r.ends[3] && l.ends[2] <= -r.ends[0] &&
    l.ends[3] <= -r.ends[1];
}
}
