/// A receiver's triangles, cut into convex cells.
#pragma once

#include "CellEdges.h"
#include "ReceiverView.h"

namespace shadow
{
/// A segment within a triangle's plane.
struct CellCut
{
  Index triangle;
  Vec3 from;
  Vec3 to;
  /// ShadowOnLeft for a contour, on whose left the shadow is in a triangle that faces the light, or
  /// CasterMeets.
  std::uint8_t marks;
};

/// Each triangle is a binary space partition: a cell through which a cut runs becomes two, along
/// the whole line of the cut; so cells stay convex, and a cut crosses none of them. Points are
/// common to all cells at an edge, those of neighbouring triangles too: there are no T-junctions,
/// but cells may have points in the middle of straight sides. Expected O(n log n) cells for n cuts
/// in random order.
class ReceiverCells
{
public:
  explicit ReceiverCells(const ContourReceiver& receiver);

  void cut(const CellCut& cut);

  /// Cells have numbers, in order of making; those that were cut have two others in their place.
  std::size_t count() const { return this->Cells.size(); }
  Index triangle(Index cell) const { return this->Cells[cell].triangle; }
  bool isCut(Index cell) const { return this->Cells[cell].halves != None; }
  /// The first of the two cells that a cell was cut to; the other one is the next.
  Index halves(Index cell) const { return this->Cells[cell].halves; }
  /// The cell that a triangle was.
  Index whole(Index triangle) const { return triangle; }

  /// Around a cell, as its triangle is wound.
  std::vector<CellSide> sides(Index cell) const;
  const CellEdges& edges() const { return this->Edges; }

private:
  struct Cell
  {
    Index triangle;
    Index halves = None;
    Index chord = None;            ///< the edge between them; the first is on its left
    std::vector<CellSide> sides{}; ///< none: those of the triangle
  };
  /// A part of a cut, by shares of its length, that is in a cell.
  struct Part
  {
    Index cell;
    double from;
    double to;
  };
  class Line;

  std::vector<CellSide> sidesOf(Index triangle) const;
  /// What of the cut is in the triangle, but not along a side of it.
  bool clip(const Line& line, double& from, double& to);
  void halve(const Line& line, const Part& part);
  Index pointOn(const std::vector<CellSide>& sides, const std::vector<double>& distances,
    std::size_t last, std::size_t first);
  void mark(Index edge, const Line& line, double from, double to);

  ContourReceiver Receiver;
  CellEdges Edges;
  double Error;
  std::vector<Cell> Cells;
};
}
