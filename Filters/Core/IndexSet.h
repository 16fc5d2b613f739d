/// A hash set of indices, for work that must not cost what the whole mesh costs.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// Keeps its items in order of insertion, so that it serves as a queue too. Open addressing; all
/// operations O(1) on average, memory in proportion to the items.
class IndexSet
{
public:
  struct Insertion
  {
    Index place; ///< of the item among items()
    bool isNew;
  };

  /// Room for so many items.
  void reserve(std::size_t count)
  {
    this->Items.reserve(count);
    this->rehash(2 * std::max(count, this->Items.size()));
  }

  Insertion insert(Index item)
  {
    if (2 * this->Items.size() >= this->Slots.size())
    {
      this->rehash(2 * this->Slots.size());
    }
    Slot& slot = this->Slots[this->slotOf(item)];
    if (slot.place != None)
    {
      return { slot.place, false };
    }
    slot = { item, static_cast<Index>(this->Items.size()) };
    this->Items.push_back(item);
    return { slot.place, true };
  }

  /// The item's place among items(), or None.
  Index find(Index item) const
  {
    return this->Slots.empty() ? None : this->Slots[this->slotOf(item)].place;
  }

  bool contains(Index item) const { return this->find(item) != None; }

  const std::vector<Index>& items() const { return this->Items; }
  std::size_t size() const { return this->Items.size(); }

  /// O(items at most so far).
  void clear()
  {
    this->Items.clear();
    this->Slots.assign(this->Slots.size(), Slot());
  }

private:
  struct Slot
  {
    Index item = None;
    Index place = None; ///< None where the slot is free
  };

  /// Where an item is, or the free slot that ends its search.
  std::size_t slotOf(Index item) const
  {
    // The high bits of a product with the golden ratio spread neighbouring numbers.
    std::size_t slot = std::uint32_t(item * 2654435769u) >> this->Shift;
    while (this->Slots[slot].place != None && this->Slots[slot].item != item)
    {
      slot = (slot + 1) & (this->Slots.size() - 1);
    }
    return slot;
  }

  void rehash(std::size_t slots)
  {
    unsigned bits = 6;
    while ((std::size_t(1) << bits) < slots && bits < 32)
    {
      ++bits;
    }
    this->Shift = 32 - bits;
    this->Slots.assign(std::size_t(1) << bits, Slot());
    for (std::size_t i = 0; i < this->Items.size(); ++i)
    {
      this->Slots[this->slotOf(this->Items[i])] = { this->Items[i], static_cast<Index>(i) };
    }
  }

  std::vector<Index> Items;
  std::vector<Slot> Slots; ///< a power of two of them, at most half taken
  unsigned Shift = 26;
};
}
