#include "CellEdges.h"

namespace shadow
{
CellEdges::CellEdges(const TriangleMesh& mesh, const EdgeTable& edges)
{
  this->Points.reserve(mesh.points.size());
  for (const Vec3& point : mesh.points)
  {
    this->Points.push_back({ point });
  }
  this->Parts.reserve(edges.edges.size());
  for (const Edge& edge : edges.edges)
  {
    this->add(edge.a, edge.b);
  }
}

Index CellEdges::add(Index a, Index b)
{
  this->Parts.push_back({ a, b });
  return static_cast<Index>(this->Parts.size() - 1);
}

Index CellEdges::split(Index edge, double share)
{
  const EdgePart whole = this->Parts[edge];
  const Index point = static_cast<Index>(this->Points.size());
  this->Points.push_back(
    { glm::mix(this->place(whole.a), this->place(whole.b), share), whole.a, whole.b, share });
  this->Parts[edge].parts = this->add(whole.a, point);
  this->Parts[this->add(point, whole.b)].marks = whole.marks;
  this->Parts[this->Parts[edge].parts].marks = whole.marks;
  return point;
}

void CellEdges::appendParts(const CellSide& side, std::vector<CellSide>& parts) const
{
  std::vector<Index> waiting{ side.edge };
  while (!waiting.empty())
  {
    const Index edge = waiting.back();
    waiting.pop_back();
    const Index first = this->Parts[edge].parts;
    if (first == None)
    {
      parts.push_back({ edge, side.forward });
      continue;
    }
    waiting.push_back(side.forward ? first + 1 : first);
    waiting.push_back(side.forward ? first : first + 1);
  }
}

void CellEdges::mark(Index edge, double from, double to, std::uint8_t marks, double error)
{
  const Vec3 start = this->place(this->Parts[edge].a);
  const Vec3 along = this->place(this->Parts[edge].b) - start;
  const double length = glm::length(along);
  const auto shareOf = [&](Index point) {
    return glm::dot(this->place(point) - start, along) / (length * length);
  };
  const double least = error / length;
  std::vector<Index> waiting{ edge };
  while (!waiting.empty())
  {
    const Index part = waiting.back();
    waiting.pop_back();
    const EdgePart& whole = this->Parts[part];
    const double begin = shareOf(whole.a);
    const double end = shareOf(whole.b);
    if (!(std::min(end, to) - std::max(begin, from) > least))
    {
      continue;
    }
    if (whole.parts == None)
    {
      const double at = from - begin > least ? from : end - to > least ? to : end;
      if (at == end)
      {
        this->Parts[part].marks |= marks;
        continue;
      }
      this->split(part, (at - begin) / (end - begin));
    }
    waiting.push_back(this->Parts[part].parts);
    waiting.push_back(this->Parts[part].parts + 1);
  }
}
}
