#include "SilhouetteFollower.h"

#include <algorithm>

namespace shadow
{
namespace
{
/// A triangle's sign is asked for from each of its corners' fans: this many are remembered.
constexpr std::size_t rememberedSigns = 1024;
}

SilhouetteFollower::SilhouetteFollower(
  const SearchedMesh& searched, const Light& light, FieldKind kind)
  : Searched(searched)
  , Field(searched.mesh, light, kind)
  , BearsLinks(kind == FieldKind::Face || !searched.linkEdges.empty())
  , Signs(rememberedSigns, Sign{ None, false })
  , Fan(searched.mesh, searched.edges)
{
}

bool SilhouetteFollower::lit(Index item)
{
  Sign& sign = this->Signs[item % rememberedSigns];
  if (sign.item != item)
  {
    sign = { item, this->Field.lit(item) };
  }
  return sign.lit;
}

bool SilhouetteFollower::isMixed(Index triangle)
{
  return shadow::isMixed(
    this->Searched.mesh, [this](Index n) { return this->lit(n); }, triangle);
}

/// Of what lies on an edge next to one of its ends, from a to b.
int SilhouetteFollower::multiplicityAt(Index edge, Index vertex)
{
  ++this->Tested;
  const auto isLit = [this](Index item) { return this->lit(item); };
  if (this->Field.kind() == FieldKind::Face)
  {
    return faceMultiplicity(this->Searched, isLit, edge);
  }
  const EdgePieces pieces = findEdgePieces(this->Searched, isLit, edge, [](Index) {});
  return vertex == this->Searched.edges.edges[edge].a ? pieces.atA : pieces.atB;
}

Index SilhouetteFollower::takeFaceEdge(Index edge, int multiplicity)
{
  const IndexSet::Insertion taken = this->Edges.insert(edge);
  if (taken.isNew)
  {
    this->Taken.push_back({ multiplicity, true, { true, true } });
  }
  return taken.place;
}

/// Takes an edge of a corner field with all triangles that cross it.
Index SilhouetteFollower::takeEdge(Index edge)
{
  const IndexSet::Insertion taken = this->Edges.insert(edge);
  if (taken.isNew)
  {
    const EdgePieces pieces = findEdgePieces(
      this->Searched, [this](Index item) { return this->lit(item); }, edge,
      [this](Index triangle) { this->Triangles.insert(triangle); });
    this->Taken.push_back({ 0, pieces.any(), { pieces.atA != 0, pieces.atB != 0 } });
    ++this->Tested;
  }
  return taken.place;
}

void SilhouetteFollower::followChord(Index triangle)
{
  ++this->Tested;
  const Triangle& n = this->Searched.mesh.cornerNormals[triangle];
  const std::array<bool, 3> lit{ this->lit(n[0]), this->lit(n[1]), this->lit(n[2]) };
  for (unsigned k = 0; k < 3; ++k)
  {
    if (lit[k] == lit[next(k)])
    {
      continue;
    }
    const EdgeTable& edges = this->Searched.edges;
    const Index edge = edges.triangleEdges[triangle][k];
    if (this->BearsLinks)
    {
      this->takeEdge(edge);
      continue;
    }
    // Where no edge bears links the sides of each share their normals: all of them cross.
    for (Index i = edges.firstSide(edge); i < edges.firstSide(edge + 1); ++i)
    {
      this->Triangles.insert(edges.sides[i] / 3);
    }
  }
}

void SilhouetteFollower::followFan(Index edge, Index vertex)
{
  for (const Index e : this->Fan.edgesAround(edge, vertex))
  {
    const int multiplicity = this->multiplicityAt(e, vertex);
    if (multiplicity != 0)
    {
      const Index place = this->Field.kind() == FieldKind::Face
        ? this->takeFaceEdge(e, multiplicity)
        : this->takeEdge(e);
      const bool isFirst = vertex == this->Searched.edges.edges[e].a;
      this->Taken[place].open[isFirst ? 0 : 1] = false;
    }
  }
}

void SilhouetteFollower::followEnds(Index place)
{
  const Index edge = this->Edges.items()[place];
  const Edge ends = this->Searched.edges.edges[edge];
  if (this->Taken[place].open[0])
  {
    this->followFan(edge, ends.a);
  }
  if (this->Taken[place].open[1])
  {
    this->followFan(edge, ends.b);
  }
}

void SilhouetteFollower::follow()
{
  while (this->NextTriangle < this->Triangles.size() || this->NextEdge < this->Edges.size())
  {
    if (this->NextTriangle < this->Triangles.size())
    {
      this->followChord(this->Triangles.items()[this->NextTriangle++]);
    }
    else
    {
      this->followEnds(static_cast<Index>(this->NextEdge++));
    }
  }
}

/// Takes an edge if anything lies on it, or crosses it where another sign is at the other end.
bool SilhouetteFollower::tryEdge(Index edge)
{
  ++this->Tested;
  if (this->Edges.contains(edge))
  {
    return true;
  }
  const auto isLit = [this](Index item) { return this->lit(item); };
  if (this->Field.kind() == FieldKind::Face)
  {
    const int multiplicity = faceMultiplicity(this->Searched, isLit, edge);
    if (multiplicity != 0)
    {
      this->takeFaceEdge(edge, multiplicity);
    }
    return multiplicity != 0;
  }
  bool anyCrossed = false;
  const EdgePieces pieces =
    findEdgePieces(this->Searched, isLit, edge, [&anyCrossed](Index) { anyCrossed = true; });
  if (anyCrossed || pieces.any())
  {
    this->takeEdge(edge);
    return true;
  }
  return false;
}

bool SilhouetteFollower::startOn(Index edge)
{
  const bool found = this->tryEdge(edge);
  this->follow();
  return found;
}

bool SilhouetteFollower::startAt(Index triangle)
{
  bool found = false;
  if (this->Field.kind() == FieldKind::Corner)
  {
    ++this->Tested;
    found = this->Triangles.contains(triangle) || this->isMixed(triangle);
    if (found)
    {
      this->Triangles.insert(triangle);
    }
  }
  if (this->BearsLinks)
  {
    for (const Index edge : this->Searched.edges.triangleEdges[triangle])
    {
      found = this->tryEdge(edge) || found;
    }
  }
  this->follow();
  return found;
}

SearchResult SilhouetteFollower::result() const
{
  SearchResult result;
  result.tested = this->Tested;
  result.triangles = this->Triangles.items();
  std::sort(result.triangles.begin(), result.triangles.end());
  for (const Index t : result.triangles)
  {
    result.litCorners.push_back(litCornersOf(this->Searched.mesh, this->Field, t));
  }
  std::vector<std::pair<Index, int>> bearing;
  bearing.reserve(this->Edges.size());
  for (std::size_t i = 0; i < this->Edges.size(); ++i)
  {
    if (this->Taken[i].bears)
    {
      bearing.emplace_back(this->Edges.items()[i], this->Taken[i].multiplicity);
    }
  }
  std::sort(bearing.begin(), bearing.end());
  result.edges.reserve(bearing.size());
  for (const auto& [edge, multiplicity] : bearing)
  {
    result.edges.push_back(edge);
    if (this->Field.kind() == FieldKind::Face)
    {
      result.multiplicities.push_back(multiplicity);
    }
  }
  return result;
}
}
