#include "CellIllumination.h"

#include <optional>
#include <queue>
#include <tuple>

namespace shadow
{
namespace
{
/// Narrower than this share of the scene a part of a triangle is as its neighbours are: rays do not
/// count what is that near.
constexpr double narrowShare = 1e-8;

/// Whether a cell's area over its perimeter is less than that.
bool isNarrow(const std::vector<CellSide>& sides, const CellEdges& edges, double width)
{
  double perimeter = 0.0;
  for (const CellSide& side : sides)
  {
    const EdgePart& part = edges.edge(side.edge);
    perimeter += glm::distance(edges.place(part.a), edges.place(part.b));
  }
  return 0.5 * glm::length(areaNormal(sides, edges)) < width * perimeter;
}

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

/// What is known of a cell that was not cut further.
enum class CellState : std::uint8_t
{
  Known,
  Open,  ///< contours and neighbours are to tell
  Narrow ///< neighbours alone are
};

/// Settles cells about which rays do not tell.
class UnclearCells
{
public:
  UnclearCells(const ReceiverCells& cells, std::vector<CellState>& states,
    std::vector<Illumination>& illumination)
    : Cells(cells)
    , States(states)
    , Lights(illumination)
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
      if (!this->Cells.isCut(cell) && this->States[i] == CellState::Open)
      {
        if (const std::optional<Illumination> side = this->byContours(cell))
        {
          this->States[i] = CellState::Known;
          this->Lights[i] = *side;
        }
      }
    }
    for (std::size_t i = 0; i < this->Cells.count(); ++i)
    {
      if (!this->Cells.isCut(static_cast<Index>(i)) && this->States[i] == CellState::Known &&
        this->Lights[i] != Illumination::TurnedAway)
      {
        this->passOn(static_cast<Index>(i), 0.0);
      }
    }
    while (!this->Waiting.empty())
    {
      const auto [distance, cell, light] = this->Waiting.top();
      this->Waiting.pop();
      if (this->States[cell] != CellState::Known)
      {
        this->States[cell] = CellState::Known;
        this->Lights[cell] = light;
        this->passOn(cell, distance);
      }
    }
    this->settleNarrow();
  }

private:
  using Reached = std::tuple<double, Index, Illumination>;

  /// Lengths of what is lit and what is in shadow.
  struct Lengths
  {
    double lit = 0.0;
    double shadowed = 0.0;

    std::optional<Illumination> greater() const
    {
      return shadowed > lit ? std::optional(Illumination::Shadowed)
        : lit > shadowed    ? std::optional(Illumination::Lit)
                            : std::nullopt;
    }
  };

  std::optional<Illumination> byContours(Index cell) const
  {
    Lengths lengths;
    for (const CellSide& side : this->Sides[cell])
    {
      const std::uint8_t marks = this->Cells.edges().edge(side.edge).marks;
      const double length = this->lengthOf(side);
      lengths.shadowed +=
        (marks & (side.forward ? ShadowOnLeft : ShadowOnRight)) != 0 ? length : 0.0;
      lengths.lit += (marks & (side.forward ? ShadowOnRight : ShadowOnLeft)) != 0 ? length : 0.0;
    }
    return lengths.greater();
  }

  /// To all that can be reached without crossing a contour or a caster.
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
        if (this->States[other] == CellState::Open)
        {
          this->Waiting.emplace(distance + glm::distance(this->Middles[cell], this->Middles[other]),
            other, this->Lights[cell]);
        }
      }
    }
  }

  /// What is narrow may be on either side of what is at its rim: it is as most of what is around
  /// it.
  void settleNarrow()
  {
    std::vector<Index> narrow;
    for (std::size_t i = 0; i < this->Cells.count(); ++i)
    {
      if (this->States[i] == CellState::Narrow)
      {
        narrow.push_back(static_cast<Index>(i));
      }
    }
    for (std::size_t before = narrow.size() + 1; narrow.size() < before;)
    {
      before = narrow.size();
      std::vector<std::pair<Index, Illumination>> settled;
      for (const Index cell : narrow)
      {
        if (const std::optional<Illumination> around = this->byNeighbours(cell))
        {
          settled.emplace_back(cell, *around);
        }
      }
      for (const auto& [cell, light] : settled)
      {
        this->States[cell] = CellState::Known;
        this->Lights[cell] = light;
      }
      narrow.erase(std::remove_if(narrow.begin(), narrow.end(),
                     [&](Index cell) { return this->States[cell] == CellState::Known; }),
        narrow.end());
    }
  }

  std::optional<Illumination> byNeighbours(Index cell) const
  {
    Lengths lengths;
    for (const CellSide& side : this->Sides[cell])
    {
      for (const Index other : this->Neighbours[side.edge])
      {
        if (this->States[other] == CellState::Known &&
          this->Lights[other] != Illumination::TurnedAway)
        {
          (this->Lights[other] == Illumination::Lit ? lengths.lit : lengths.shadowed) +=
            this->lengthOf(side);
        }
      }
    }
    return lengths.greater();
  }

  double lengthOf(const CellSide& side) const
  {
    const CellEdges& edges = this->Cells.edges();
    const EdgePart& part = edges.edge(side.edge);
    return glm::distance(edges.place(part.a), edges.place(part.b));
  }

  const ReceiverCells& Cells;
  std::vector<CellState>& States;
  std::vector<Illumination>& Lights;
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
    normal += glm::cross(
      edges.place(edges.start(sides[i])) - origin, edges.place(edges.start(sides[i + 1])) - origin);
  }
  return normal;
}

std::vector<Illumination> illuminate(const ReceiverCells& cells, const ReceiverView& receiver,
  const ContourBlockers* blockers, const RangeLoop& loop)
{
  std::vector<CellState> states(cells.count(), CellState::Known);
  std::vector<Illumination> illumination(cells.count(), Illumination::Lit);
  const double narrow = narrowShare * receiver.frame().size();
  loop(cells.count(), heavyGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      const Index cell = static_cast<Index>(i);
      if (!receiver.isReceiving(cells.triangle(cell)))
      {
        illumination[i] = Illumination::TurnedAway;
      }
      else if (blockers && !cells.isCut(cell))
      {
        const std::vector<CellSide> sides = cells.sides(cell);
        const bool isPart = cell != cells.whole(cells.triangle(cell));
        const Obstruction found = blockers->obstructionOf(middleOf(sides, cells.edges()));
        // In shadow where there is no neighbour to ask.
        illumination[i] = found == Obstruction::None ? Illumination::Lit : Illumination::Shadowed;
        states[i] = isPart && isNarrow(sides, cells.edges(), narrow) ? CellState::Narrow
          : found == Obstruction::Around                             ? CellState::Open
                                                                     : CellState::Known;
      }
    }
  });
  if (std::any_of(
        states.begin(), states.end(), [](CellState state) { return state != CellState::Known; }))
  {
    UnclearCells(cells, states, illumination).settle();
  }
  return illumination;
}
}
