#include "ReceiverCells.h"

#include <glm/vec2.hpp>

namespace shadow
{
namespace
{
using Vec2 = glm::dvec2;

/// Of the largest coordinate: what is nearer to a line is on it. Points on edges, and distances
/// from lines, are off by a few roundings; cells are as good as convex as long as this is many
/// more.
constexpr double roundings = 64.0 * std::numeric_limits<double>::epsilon();

double cross(const Vec2& a, const Vec2& b)
{
  return a.x * b.y - a.y * b.x;
}

/// Signed, of a point from the line through a and b: positive on its left.
double distanceTo(const Vec2& a, const Vec2& b, const Vec2& point)
{
  return cross(b - a, point - a) / glm::length(b - a);
}
}

/// A cut in its triangle's plane, as seen along the coordinate axis that is nearest to its normal:
/// that takes no rounding.
class ReceiverCells::Line
{
public:
  Line(const CellCut& cut, const Vec3& normal)
    : Triangle(cut.triangle)
    , Marks(cut.marks)
  {
    const Vec3 size = glm::abs(normal);
    const glm::length_t along = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const bool turned = normal[along] < 0.0;
    this->First = (along + (turned ? 2 : 1)) % 3;
    this->Second = (along + (turned ? 1 : 2)) % 3;
    this->From = this->flat(cut.from);
    this->To = this->flat(cut.to);
  }

  Vec2 flat(const Vec3& point) const { return { point[this->First], point[this->Second] }; }
  Vec2 at(double share) const { return glm::mix(this->From, this->To, share); }
  double length() const { return glm::distance(this->From, this->To); }
  double distance(const Vec3& point) const
  {
    return distanceTo(this->From, this->To, this->flat(point));
  }

  Index Triangle;
  std::uint8_t Marks;

private:
  glm::length_t First;
  glm::length_t Second;
  Vec2 From;
  Vec2 To;
};

ReceiverCells::ReceiverCells(const ContourReceiver& receiver)
  : Receiver(receiver)
  , Edges(*receiver.mesh, *receiver.edges)
{
  const Box bounds = receiver.mesh->bounds();
  this->Error = roundings * std::max(largestComponent(bounds.low), largestComponent(bounds.high));
  this->Cells.reserve(receiver.mesh->triangles.size());
  for (std::size_t i = 0; i < receiver.mesh->triangles.size(); ++i)
  {
    this->Cells.push_back({ static_cast<Index>(i) });
  }
}

std::vector<CellSide> ReceiverCells::sidesOf(Index triangle) const
{
  const Triangle& t = this->Receiver.mesh->triangles[triangle];
  std::vector<CellSide> sides;
  for (unsigned k = 0; k < 3; ++k)
  {
    const Index edge = this->Receiver.edges->triangleEdges[triangle][k];
    sides.push_back({ edge, this->Edges.edge(edge).a == t[k] });
  }
  return sides;
}

std::vector<CellSide> ReceiverCells::sides(Index cell) const
{
  std::vector<CellSide> parts;
  const std::vector<CellSide>& kept = this->Cells[cell].sides;
  for (const CellSide& side : kept.empty() ? this->sidesOf(this->Cells[cell].triangle) : kept)
  {
    this->Edges.appendParts(side, parts);
  }
  return parts;
}

void ReceiverCells::mark(Index edge, const Line& line, double from, double to)
{
  const Vec2 a = line.flat(this->Edges.place(this->Edges.edge(edge).a));
  const Vec2 along = line.flat(this->Edges.place(this->Edges.edge(edge).b)) - a;
  const double squared = glm::dot(along, along);
  if (!(squared > 0.0))
  {
    return;
  }
  const double begin = glm::dot(line.at(from) - a, along) / squared;
  const double end = glm::dot(line.at(to) - a, along) / squared;
  const std::uint8_t turned =
    line.Marks == ShadowOnLeft && end < begin ? std::uint8_t(ShadowOnRight) : line.Marks;
  this->Edges.mark(edge, std::min(begin, end), std::max(begin, end), turned, this->Error);
}

bool ReceiverCells::clip(const Line& line, double& from, double& to)
{
  const Triangle& t = this->Receiver.mesh->triangles[line.Triangle];
  for (unsigned k = 0; k < 3; ++k)
  {
    const Vec2 a = line.flat(this->Receiver.mesh->points[t[k]]);
    const Vec2 b = line.flat(this->Receiver.mesh->points[t[next(k)]]);
    const double atFrom = distanceTo(a, b, line.at(from));
    const double atTo = distanceTo(a, b, line.at(to));
    if (std::max(std::fabs(atFrom), std::fabs(atTo)) <= this->Error)
    {
      this->mark(this->Receiver.edges->triangleEdges[line.Triangle][k], line, from, to);
      return false;
    }
    // Negated so that what is no number, in a triangle without area, is out.
    if (!(std::max(atFrom, atTo) > this->Error))
    {
      return false;
    }
    if (std::min(atFrom, atTo) < 0.0)
    {
      const double crossing = glm::mix(from, to, atFrom / (atFrom - atTo));
      (atFrom < 0.0 ? from : to) = crossing;
    }
  }
  return (to - from) * line.length() > this->Error;
}

void ReceiverCells::cut(const CellCut& cut)
{
  const Line line(cut, this->Receiver.mesh->areaNormal(cut.triangle));
  double from = 0.0;
  double to = 1.0;
  if (!(line.length() > this->Error) || !this->clip(line, from, to))
  {
    return;
  }
  std::vector<Part> waiting{ { this->whole(cut.triangle), from, to } };
  while (!waiting.empty())
  {
    const Part part = waiting.back();
    waiting.pop_back();
    if ((part.to - part.from) * line.length() <= this->Error)
    {
      continue;
    }
    const Cell& cell = this->Cells[part.cell];
    if (cell.halves == None)
    {
      this->halve(line, part);
      continue;
    }
    const EdgePart& chord = this->Edges.edge(cell.chord);
    const Vec2 a = line.flat(this->Edges.place(chord.a));
    const Vec2 b = line.flat(this->Edges.place(chord.b));
    const double atFrom = distanceTo(a, b, line.at(part.from));
    const double atTo = distanceTo(a, b, line.at(part.to));
    const double least = std::min(atFrom, atTo);
    const double most = std::max(atFrom, atTo);
    if (least >= -this->Error && most <= this->Error)
    {
      this->mark(cell.chord, line, part.from, part.to);
    }
    else if (least >= -this->Error)
    {
      waiting.push_back({ cell.halves, part.from, part.to });
    }
    else if (most <= this->Error)
    {
      waiting.push_back({ cell.halves + 1, part.from, part.to });
    }
    else
    {
      const double at = glm::mix(part.from, part.to, atFrom / (atFrom - atTo));
      const Index first = atFrom > 0.0 ? cell.halves : cell.halves + 1;
      const Index second = atFrom > 0.0 ? cell.halves + 1 : cell.halves;
      waiting.push_back({ first, part.from, at });
      waiting.push_back({ second, at, part.to });
    }
  }
}

/// Where the line leaves one side of itself, between the last point there and the first one on the
/// other side: a point of the cell that is on the line, or else a new one.
Index ReceiverCells::pointOn(const std::vector<CellSide>& sides,
  const std::vector<double>& distances, std::size_t last, std::size_t first)
{
  const std::size_t count = sides.size();
  std::size_t nearest = None;
  for (std::size_t i = (last + 1) % count; i != first; i = (i + 1) % count)
  {
    if (nearest == None || std::fabs(distances[i]) < std::fabs(distances[nearest]))
    {
      nearest = i;
    }
  }
  if (nearest != None)
  {
    return this->Edges.start(sides[nearest]);
  }
  const double share = distances[last] / (distances[last] - distances[first]);
  return this->Edges.split(sides[last].edge, sides[last].forward ? share : 1.0 - share);
}

void ReceiverCells::halve(const Line& line, const Part& part)
{
  std::vector<CellSide> sides = this->sides(part.cell);
  const std::size_t count = sides.size();
  std::vector<double> distances(count);
  std::vector<int> signs(count);
  std::size_t off = count; // a point off the line
  for (std::size_t i = 0; i < count; ++i)
  {
    distances[i] = line.distance(this->Edges.place(this->Edges.start(sides[i])));
    signs[i] = distances[i] > this->Error ? 1 : distances[i] < -this->Error ? -1 : 0;
    off = signs[i] != 0 ? i : off;
  }
  if (off == count)
  {
    return;
  }
  // Changes of sign on the way around: the points between which the line is crossed.
  std::vector<std::array<std::size_t, 2>> changes;
  std::size_t last = off;
  for (std::size_t step = 1; step <= count; ++step)
  {
    const std::size_t i = (off + step) % count;
    if (signs[i] != 0)
    {
      if (signs[i] != signs[last])
      {
        changes.push_back({ last, i });
      }
      last = i;
    }
  }
  // The line may run along the cell's rim. It never crosses it more than twice, as cells are convex
  // to within far less than the error.
  if (changes.size() != 2)
  {
    return;
  }
  const std::size_t down = signs[changes[0][0]] > 0 ? 0 : 1;
  const Index enters = this->pointOn(sides, distances, changes[down][0], changes[down][1]);
  const Index leaves = this->pointOn(sides, distances, changes[1 - down][0], changes[1 - down][1]);
  const Index chord = this->Edges.add(enters, leaves);
  sides = this->sides(part.cell);
  const auto from = [&](Index point) {
    return std::find_if(sides.begin(), sides.end(),
      [&](const CellSide& side) { return this->Edges.start(side) == point; });
  };
  std::rotate(sides.begin(), from(leaves), sides.end());
  const auto middle = from(enters);
  std::vector<CellSide> left(sides.begin(), middle);
  left.push_back({ chord, true });
  std::vector<CellSide> right(middle, sides.end());
  right.push_back({ chord, false });
  this->Cells[part.cell].halves = static_cast<Index>(this->Cells.size());
  this->Cells[part.cell].chord = chord;
  const Index triangle = this->Cells[part.cell].triangle;
  this->Cells.push_back({ triangle, None, None, std::move(left) });
  this->Cells.push_back({ triangle, None, None, std::move(right) });
  this->mark(chord, line, part.from, part.to);
}
}
