#include "CellIllumination.h"

#include <optional>
#include <queue>
#include <tuple>

namespace shadow
{
namespace
{
/// Of the area. A cell without area has its middle between its points.
Vec3 middleOf(const std::vector<CellSide>& sides, const CellEdges& edges)
{
  const Vec3 normal = areaNormal(sides, edges);
  const Vec3& origin = edges.place(edges.start(sides.front()));
  Vec3 moments(0.0);
  Vec3 sum(0.0);
  double areas = 0.0;
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const Vec3 a = edges.place(edges.start(sides[i])) - origin;
    const Vec3 b = edges.place(edges.start(sides[(i + 1) % sides.size()])) - origin;
    const double area = glm::dot(normal, glm::cross(a, b));
    moments += area * (a + b) / 3.0;
    areas += area;
    sum += a;
  }
  const Vec3 middle = origin + moments / areas;
  return areas > 0.0 && isFinite(middle) ? middle
                                         : origin + sum / static_cast<double>(sides.size());
}

/// Settles cells about which rays do not tell.
class UnclearCells
{
public:
  /// The states of cells that are known, and nothing for those that are to be settled.
  UnclearCells(const ReceiverCells& cells, std::vector<std::optional<Illumination>>& states)
    : Cells(cells)
    , States(states)
    , Neighbours(cells.edges().edgeCount())
    , Sides(cells.count())
    , Middles(cells.count())
  {
    for (std::size_t i = 0; i < cells.count(); ++i)
    {
      const Index cell = static_cast<Index>(i);
      if (cells.isCut(cell))
      {
        continue;
      }
      this->Sides[i] = cells.sides(cell);
      this->Middles[i] = middleOf(this->Sides[i], cells.edges());
      for (const CellSide& side : this->Sides[i])
      {
        this->Neighbours[side.edge].push_back(cell);
      }
    }
  }

  void settle()
  {
    for (std::size_t i = 0; i < this->Cells.count(); ++i)
    {
      const Index cell = static_cast<Index>(i);
      if (this->isOpen(cell))
      {
        this->States[i] = this->byContours(cell);
      }
    }
    for (std::size_t i = 0; i < this->Cells.count(); ++i)
    {
      if (this->isKnown(static_cast<Index>(i)))
      {
        this->passOn(static_cast<Index>(i), 0.0);
      }
    }
    while (!this->Waiting.empty())
    {
      const auto [distance, cell, state] = this->Waiting.top();
      this->Waiting.pop();
      if (this->isOpen(cell))
      {
        this->States[cell] = state;
        this->passOn(cell, distance);
      }
    }
  }

private:
  using Reached = std::tuple<double, Index, Illumination>;

  bool isOpen(Index cell) const { return !this->Cells.isCut(cell) && !this->States[cell]; }
  bool isKnown(Index cell) const
  {
    return !this->Cells.isCut(cell) && this->States[cell] &&
      *this->States[cell] != Illumination::TurnedAway;
  }

  std::optional<Illumination> byContours(Index cell) const
  {
    const CellEdges& edges = this->Cells.edges();
    double shadowed = 0.0;
    double lit = 0.0;
    for (const CellSide& side : this->Sides[cell])
    {
      const EdgePart& part = edges.edge(side.edge);
      const double length = glm::distance(edges.place(part.a), edges.place(part.b));
      shadowed += (part.marks & (side.forward ? ShadowOnLeft : ShadowOnRight)) != 0 ? length : 0.0;
      lit += (part.marks & (side.forward ? ShadowOnRight : ShadowOnLeft)) != 0 ? length : 0.0;
    }
    return shadowed > lit ? std::optional(Illumination::Shadowed)
      : lit > shadowed    ? std::optional(Illumination::Lit)
                          : std::nullopt;
  }

  void passOn(Index cell, double distance)
  {
    for (const CellSide& side : this->Sides[cell])
    {
      if (this->Cells.edges().edge(side.edge).marks != 0)
      {
        continue;
      }
      for (const Index other : this->Neighbours[side.edge])
      {
        if (this->isOpen(other))
        {
          this->Waiting.emplace(
            distance + glm::distance(this->Middles[cell], this->Middles[other]), other,
            *this->States[cell]);
        }
      }
    }
  }

  const ReceiverCells& Cells;
  std::vector<std::optional<Illumination>>& States;
  std::vector<std::vector<Index>> Neighbours; ///< cells at each edge
  std::vector<std::vector<CellSide>> Sides;
  std::vector<Vec3> Middles;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>> Waiting;
};
}

Vec3 areaNormal(const std::vector<CellSide>& sides, const CellEdges& edges)
{
  const Vec3& origin = edges.place(edges.start(sides.front()));
  Vec3 normal(0.0);
  for (std::size_t i = 1; i + 1 < sides.size(); ++i)
  {
    normal += glm::cross(edges.place(edges.start(sides[i])) - origin,
      edges.place(edges.start(sides[i + 1])) - origin);
  }
  return normal;
}

std::vector<Illumination> illuminate(const ReceiverCells& cells, const ReceiverView& receiver,
  const ContourBlockers* blockers, const RangeLoop& loop)
{
  std::vector<std::optional<Illumination>> states(cells.count(), Illumination::Lit);
  loop(cells.count(), heavyGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Index cell = static_cast<Index>(i);
        if (!receiver.isLit(cells.triangle(cell)))
        {
          states[i] = Illumination::TurnedAway;
        }
        else if (blockers && !cells.isCut(cell))
        {
          const Obstruction found =
            blockers->obstructionOf(middleOf(cells.sides(cell), cells.edges()));
          states[i] = found == Obstruction::None ? std::optional(Illumination::Lit)
            : found == Obstruction::Other        ? std::optional(Illumination::Shadowed)
                                                 : std::nullopt;
        }
      }
    });
  const auto isUnclear = [](const std::optional<Illumination>& state) { return !state; };
  if (std::any_of(states.begin(), states.end(), isUnclear))
  {
    UnclearCells(cells, states).settle();
  }
  std::vector<Illumination> result;
  result.reserve(states.size());
  for (const std::optional<Illumination>& state : states)
  {
    result.push_back(state.value_or(Illumination::Shadowed));
  }
  return result;
}
}
