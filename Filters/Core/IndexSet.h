/// A hash set of indices, for work that must not cost what the whole mesh costs.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// Keeps its items in order of insertion, so that it serves as a queue too. Open addressing over
/// their places; all operations O(1) on average, memory in proportion to the items.
class IndexSet
{
public:
  struct Insertion
  {
    Index place; ///< of the item among items()
    bool isNew;
  };

  Insertion insert(Index item)
  {
    if (2 * this->Items.size() >= this->Places.size())
    {
      this->grow();
    }
    Index& place = this->Places[this->slotOf(item)];
    if (place != None)
    {
      return { place, false };
    }
    place = static_cast<Index>(this->Items.size());
    this->Items.push_back(item);
    return { place, true };
  }

  bool contains(Index item) const
  {
    return !this->Places.empty() && this->Places[this->slotOf(item)] != None;
  }

  const std::vector<Index>& items() const { return this->Items; }
  std::size_t size() const { return this->Items.size(); }

  /// O(items at most so far).
  void clear()
  {
    this->Items.clear();
    this->Places.assign(this->Places.size(), None);
  }

private:
  /// Where an item's place is, or the free slot that ends its search.
  std::size_t slotOf(Index item) const
  {
    // The high bits of a product with the golden ratio spread neighbouring numbers.
    const std::uint32_t hash = item * 2654435769u;
    const std::size_t mask = this->Places.size() - 1;
    std::size_t slot = (std::uint64_t(hash) * this->Places.size()) >> 32;
    while (this->Places[slot] != None && this->Items[this->Places[slot]] != item)
    {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  void grow()
  {
    this->Places.assign(this->Places.empty() ? 64 : 2 * this->Places.size(), None);
    for (std::size_t i = 0; i < this->Items.size(); ++i)
    {
      this->Places[this->slotOf(this->Items[i])] = static_cast<Index>(i);
    }
  }

  std::vector<Index> Items;
  std::vector<Index> Places; ///< a power of two of slots, at most half of them taken
};
}
