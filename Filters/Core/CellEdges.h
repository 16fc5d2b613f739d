/// Edges that are split at points again and again, for all cells on them at once.
#pragma once

#include "EdgeTable.h"

namespace shadow
{
/// A point and the two earlier ones between which it is; a mesh's own vertices have none.
struct CellPoint
{
  Vec3 place;
  Index from = None;
  Index to = None;
  double share = 0.0; ///< of the way from one to the other
};

/// What runs along an edge.
enum EdgeMark : std::uint8_t
{
  ShadowOnLeft = 1, ///< a visible contour, its shadow on the left of the edge's way
  ShadowOnRight = 2,
  CasterMeets = 4 ///< a caster pierces or touches the receiver
};

/// An edge, or a part of one. An edge that is split is its two parts.
struct EdgePart
{
  Index a;
  Index b;
  Index parts = None; ///< the first of the two
  std::uint8_t marks = 0;
};

/// An edge on its way around a cell.
struct CellSide
{
  Index edge;
  bool forward; ///< from a to b
};

class CellEdges
{
public:
  /// The mesh's points and edges have the first numbers.
  CellEdges(const TriangleMesh& mesh, const EdgeTable& edges);

  const EdgePart& edge(Index edge) const { return this->Parts[edge]; }
  std::size_t edgeCount() const { return this->Parts.size(); }
  const std::vector<CellPoint>& points() const { return this->Points; }
  const Vec3& place(Index point) const { return this->Points[point].place; }

  Index start(const CellSide& side) const
  {
    return side.forward ? this->Parts[side.edge].a : this->Parts[side.edge].b;
  }

  /// An edge between two points.
  Index add(Index a, Index b);

  /// Splits an edge that has no parts yet. Gives the new point, at a share of the way from a to b.
  Index split(Index edge, double share);

  /// Appends the parts of a side that have no parts themselves, in the side's order.
  void appendParts(const CellSide& side, std::vector<CellSide>& parts) const;

  /// Marks an edge from one share of its way to another one, and splits it there; ends that are
  /// within `error` of points (both in world units) do not split it.
  void mark(Index edge, double from, double to, std::uint8_t marks, double error);

private:
  std::vector<CellPoint> Points;
  std::vector<EdgePart> Parts;
};
}
