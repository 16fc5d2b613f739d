/// What a light sees from both sides, found among items that are ordered by how they face, without
/// looking at the rest.
#pragma once

#include "RangeLoop.h"

#include <glm/vec4.hpp>

namespace shadow
{
/// Items whose fields differ in sign.
struct FacingFound
{
  std::vector<Index> items;      ///< ascending
  std::vector<std::uint8_t> lit; ///< of each item, bit k: field k is lit
  std::size_t tested = 0;        ///< items that were looked at
};

/// Items of two to four fields each, as an edge has its two faces' and a triangle its three
/// corners'. A field's sign for the light (l, w) is that of q . (l, w), q the facing plane of the
/// field: one code for faces and corners, points and directions.
///
/// The planes are kept in integers of 16 bits, field by field in blocks of 32 items, over
/// which lies a tree of boxes in the four dimensions of q, eight to a node: what has one sign in
/// the box has it everywhere in there. A bound on all roundings, the one of the fields in double
/// included, is added to each decision. The few fields whose sign that leaves open are evaluated.
/// So the result is that of looking at every field in double.
///
/// Immutable; 8 bytes a field and a little over 1 an item. A search by the tree is in proportion to
/// what is found and what is near it: about the square root of the number of items on a smooth
/// surface.
class FacingHierarchy
{
public:
  FacingHierarchy() = default;

  /// planeOf(item, k) is the plane of the item's field k, as facingPlane gives it in the ball.
  /// Items should come in an order in which neighbours have similar planes.
  template <class PlaneOf>
  FacingHierarchy(unsigned arity, std::size_t count, const Ball& ball, const RangeLoop& loop,
    const PlaneOf& planeOf)
    : FacingHierarchy(arity, count, ball)
  {
    loop(this->Blocks, heavyGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t block = begin; block < end; ++block)
        {
          this->fillBlock(block, [&](std::size_t item, unsigned k)
            { return planeOf(static_cast<Index>(item), k); });
        }
      });
    this->joinBoxes();
  }

  /// What the light sees from both sides; isLit(item, k) is the field's sign in double. Without the
  /// tree all items are looked at.
  using IsLit = std::function<bool(Index item, unsigned k)>;
  FacingFound search(
    const Light& light, bool useTree, const IsLit& isLit, const RangeLoop& loop) const;

  std::size_t memory() const; ///< bytes

  static constexpr std::size_t blockSize = 32; ///< items

private:
  struct Box
  {
    glm::vec4 low{ std::numeric_limits<float>::max() };
    glm::vec4 high{ -std::numeric_limits<float>::max() };

    void add(const glm::vec4& lowest, const glm::vec4& highest)
    {
      this->low = glm::min(this->low, lowest);
      this->high = glm::max(this->high, highest);
    }
  };

  /// The light in the frame of the ball, as an integer plane's partner.
  struct Query
  {
    std::array<std::int16_t, 4> plane;
    std::int32_t margin;
  };

  FacingHierarchy(unsigned arity, std::size_t count, const Ball& ball);

  template <class PlaneOf>
  void fillBlock(std::size_t block, const PlaneOf& planeOf)
  {
    Box& box = this->Levels[0][block];
    for (unsigned k = 0; k < this->Arity; ++k)
    {
      std::int16_t* pairs = this->pairsOf(block, k);
      for (std::size_t i = 0; i < blockSize; ++i)
      {
        // What is left of the last block repeats its last item.
        const glm::vec4 q =
          quantized(planeOf(std::min(block * blockSize + i, this->Count - 1), k));
        box.add(q, q);
        for (int c = 0; c < 4; ++c)
        {
          const std::size_t place = static_cast<std::size_t>(c / 2) * 2 * blockSize + 2 * i;
          pairs[place + static_cast<std::size_t>(c % 2)] = static_cast<std::int16_t>(q[c]);
        }
      }
    }
  }

  std::int16_t* pairsOf(std::size_t block, unsigned k)
  {
    return this->Planes.data() + (block * this->Arity + k) * 4 * blockSize;
  }

  static glm::vec4 quantized(const Vec4& plane);
  void joinBoxes();
  Query makeQuery(const Light& light) const;
  std::vector<Index> blocksWithBothSigns(const Query& query) const;
  template <unsigned Arity>
  void searchBlock(
    std::size_t block, const Query& query, const IsLit& isLit, FacingFound& found) const;

  Ball TheBall;
  unsigned Arity = 2;
  std::size_t Count = 0;
  std::size_t Blocks = 0;
  std::vector<std::int16_t> Planes;     ///< block, field, (x, y) or (z, w), item
  std::vector<std::vector<Box>> Levels; ///< of the blocks, of eight blocks, and so on
};
}
