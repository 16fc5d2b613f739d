#include "VertexFan.h"

namespace shadow
{
/// The other edge that a triangle has at the vertex.
Index VertexFan::across(Index triangle, Index edge, Index vertex) const
{
  const Triangle& t = this->Mesh.triangles[triangle];
  const Triangle& e = this->Edges.triangleEdges[triangle];
  const unsigned corner = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
  const Index leaving = e[corner];
  return leaving == edge ? e[next(next(corner))] : leaving;
}

/// Goes round the vertex, through the triangle of a side first.
VertexFan::End VertexFan::turn(Index edge, Index vertex, Side through)
{
  for (;;)
  {
    const Index triangle = through / 3;
    edge = this->across(triangle, edge, vertex);
    if (edge == this->Around[0])
    {
      return End::Start;
    }
    this->Around.push_back(edge);
    const Index sides = this->Edges.sideCount(edge);
    if (sides != 2)
    {
      return sides == 1 ? End::Border : End::Branch;
    }
    const Side* const both = &this->Edges.sides[this->Edges.firstSide(edge)];
    through = both[0] / 3 == triangle ? both[1] : both[0];
  }
}

/// For fans that branch.
void VertexFan::collect(Index edge, Index vertex)
{
  this->Collected.clear();
  this->Collected.insert(edge);
  for (std::size_t i = 0; i < this->Collected.size(); ++i)
  {
    const Index e = this->Collected.items()[i];
    for (Index s = this->Edges.firstSide(e); s < this->Edges.firstSide(e + 1); ++s)
    {
      this->Collected.insert(this->across(this->Edges.sides[s] / 3, e, vertex));
    }
  }
}

const std::vector<Index>& VertexFan::edgesAround(Index edge, Index vertex)
{
  this->Around.assign(1, edge);
  const Index first = this->Edges.firstSide(edge);
  const Index sides = this->Edges.sideCount(edge);
  End end = sides > 2 ? End::Branch : this->turn(edge, vertex, this->Edges.sides[first]);
  if (end == End::Border && sides == 2)
  {
    end = this->turn(edge, vertex, this->Edges.sides[first + 1]);
  }
  if (end != End::Branch)
  {
    return this->Around;
  }
  this->collect(edge, vertex);
  return this->Collected.items();
}
}
