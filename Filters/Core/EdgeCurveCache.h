/// Edges' curves that have been asked for, kept over lights.
#pragma once

#include "EdgeCurve.h"
#include "RangeLoop.h"

#include <mutex>

namespace shadow
{
/// Keeps at most one curve for every 32 triangles, 9 bytes a triangle: a silhouette crosses about
/// the square root of their number. Each edge has one place to be kept at, which it takes from the
/// edge that was there.
///
/// Safe to be used from several threads. No lock is held while curves are made: the loop may run
/// other work of the caller, which may come back here.
class EdgeCurveCache
{
public:
  /// The curves of these edges, in their order; made now where they are not kept.
  std::vector<EdgeCurve> get(const TriangleMesh& mesh, const EdgeTable& edges,
    const std::vector<Index>& wanted, const RangeLoop& loop);

  std::size_t memory() const; ///< bytes

private:
  struct Entry
  {
    Index edge = None;
    EdgeCurve curve;
  };

  Entry& placeOf(Index edge);

  mutable std::mutex Guard;
  std::vector<Entry> Entries; ///< a power of two
};
}
