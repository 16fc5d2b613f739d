/// A hash table of numbers, each with a place.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// Numbers keys in order of appearance. Open addressing.
class IndexTable
{
public:
  /// Empty. Half full or less with so many keys, and there is room for nearly twice as many.
  void reset(std::size_t expected)
  {
    unsigned bits = 4;
    while ((std::size_t(1) << bits) < 2 * expected)
    {
      ++bits;
    }
    this->Shift = 32 - bits;
    this->Slots.assign(std::size_t(1) << bits, { None, None });
    this->Count = 0;
  }

  /// The key's place; a new key gets the next one.
  Index placeOf(Index key)
  {
    Slot& slot = this->Slots[this->slotOf(key)];
    if (slot.key == None)
    {
      slot = { key, this->Count++ };
    }
    return slot.place;
  }

  /// The key's place, or None.
  Index find(Index key) const
  {
    return this->Slots.empty() ? None : this->Slots[this->slotOf(key)].place;
  }

  Index count() const { return this->Count; }

private:
  struct Slot
  {
    Index key;
    Index place;
  };

  /// Where a key is, or the free slot that ends its search.
  std::size_t slotOf(Index key) const
  {
    // The high bits of a product with the golden ratio spread neighbouring numbers.
    std::size_t slot = std::uint32_t(key * 2654435769u) >> this->Shift;
    while (this->Slots[slot].key != None && this->Slots[slot].key != key)
    {
      slot = (slot + 1) & (this->Slots.size() - 1);
    }
    return slot;
  }

  std::vector<Slot> Slots; ///< a power of two, at most 2^32
  unsigned Shift = 28;
  Index Count = 0;
};
}
