/// The edges' curves that have been asked for, kept over lights.
#pragma once

#include "EdgeCurve.h"
#include "RangeLoop.h"

#include <mutex>

namespace shadow
{
/// Safe to be used from several threads. No lock is held while curves are made: the loop may run
/// other work of the caller, which may come back here.
class EdgeCurveCache
{
public:
  /// The curves of these edges, in their order; made now where nobody asked before.
  std::vector<EdgeCurve> get(const TriangleMesh& mesh, const EdgeTable& edges,
    const std::vector<Index>& wanted, const RangeLoop& loop);

  std::size_t memory() const; ///< bytes

private:
  mutable std::mutex Guard;
  std::vector<Index> Place; ///< where each edge's curve is, None if it is not yet there
  std::vector<EdgeCurve> Curves;
};
}
