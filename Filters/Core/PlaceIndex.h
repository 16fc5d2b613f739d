/// Which corner normal is at a place.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// Four bytes a normal; built in O(n log n).
class PlaceIndex
{
public:
  explicit PlaceIndex(const TriangleMesh& mesh);

  /// The first of the mesh's normals whose vertex is exactly there, or None. O(log n).
  Index firstNormalAt(const TriangleMesh& mesh, const Vec3& place) const;

  std::size_t memory() const { return this->Normals.capacity() * sizeof(Index); }

private:
  std::vector<Index> Normals; ///< ascending by place, then by number
};
}
