/// A box tree over planes in four dimensions: finds what a light sees from both sides without
/// looking at the rest.
#pragma once

#include "RangeLoop.h"

#include <glm/vec4.hpp>

namespace shadow
{
/// What a hierarchy is built over. A field's sign for the light (l, w) is that of q . (l, w) with
/// q = (N, -N . p), for faces and for corner normals, for points and for directions alike.
struct FacingItems
{
  /// The q of each field at unit length of N, in the frame of the ball around the mesh. Zero where
  /// it is unknown or out of range: such a field may have either sign.
  std::vector<glm::vec4> planes;
  unsigned arity = 2;        ///< fields of an item, 2 to 4
  std::vector<Index> fields; ///< of item after item; items with fewer ones repeat one
  std::vector<Index> ids;    ///< of each item, ascending
  Vec3 centre{ 0.0 };        ///< the ball
  double radius = 0.0;
};

/// The plane of a field N . (l - w p), as FacingItems wants it.
glm::vec4 facingPlane(const Vec3& normal, const Vec3& point, const Vec3& centre, double radius);

/// Halves the items by the medians of their planes along the longest axis until 32 to 64 are left;
/// these lie in a leaf with their distinct planes, once each, side by side. All planes and boxes
/// are floats: a bound on every rounding, the one of fields in double included, is added to each
/// decision, so nothing is missed.
///
/// Immutable; about 20 bytes an item. Building is O(n log n), a search in proportion to what is
/// found and what is near it: about the square root of n items on a smooth surface.
class FacingHierarchy
{
public:
  /// The same tree whatever the loop.
  FacingHierarchy(const FacingItems& items, const RangeLoop& loop);

  /// Ids, ascending, of the items whose fields may differ in sign, with all those whose fields in
  /// double do differ or are zero; adds to `tested` the number of items looked at.
  std::vector<Index> candidates(
    const Light& light, const RangeLoop& loop, std::size_t& tested) const;

  std::size_t memory() const; ///< bytes

private:
  struct Box
  {
    glm::vec4 low;
    glm::vec4 high;
  };

  /// The light in the frame of the ball, with the bound on what rounding adds to q . plane.
  struct Query
  {
    glm::vec4 plane;
    float margin;
  };

  class Builder;

  Query makeQuery(const Light& light) const;
  static bool hasOneSign(const Box& box, const Query& query);
  std::size_t firstItem(std::size_t leaf) const { return (leaf * this->Ids.size()) >> this->Depth; }
  std::vector<Index> leavesWithBothSigns(const Query& query) const;
  void searchLeaf(std::size_t leaf, const Query& query, std::vector<Index>& found) const;

  Vec3 Centre;
  double Radius;
  unsigned Arity;
  unsigned Depth = 0;                  ///< there are 2^Depth leaves
  std::vector<Box> Boxes;              ///< as a heap: the children of i are 2 i + 1 and 2 i + 2
  std::vector<Index> Ids;              ///< of items, leaf after leaf
  std::vector<std::uint8_t> Places;    ///< of each item's fields in its leaf
  std::vector<std::uint32_t> FirstPlane; ///< of each leaf, and the end; multiples of four
  std::vector<float> Planes; ///< four rows a leaf, one a component, over the leaf's planes
};
}
