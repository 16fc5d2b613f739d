#include "Caster.h"

#include "JetNormals.h"
#include "VertexNormals.h"

#include <algorithm>

namespace shadow
{
namespace
{
/// Triangles from which on a search by hierarchy beats looking at all.
constexpr std::size_t worthATree = 50000;

template <class Value>
std::size_t bytes(const std::vector<Value>& values)
{
  return values.capacity() * sizeof(Value);
}
}

Caster::Caster(TriangleMesh mesh, double featureAngle, const RangeLoop& loop)
  : Mesh(std::move(mesh))
  , Edges(buildEdgeTable(this->Mesh))
{
  if (this->Mesh.normals.empty())
  {
    estimateCornerNormals(this->Mesh, this->Edges, featureAngle);
    this->Normals.estimated = this->Mesh.normals.size();
    this->Normals.fallback = fitJetNormals(this->Mesh, loop);
  }
  else
  {
    repairNormals(this->Mesh);
  }
  this->Weights = findChainWeights(this->Mesh, this->Edges);
  this->Defects = countEdgeDefects(this->Mesh, this->Edges);
  this->LinkEdges = findLinkEdges(this->Mesh, this->Edges, this->Weights);
  if (!this->Mesh.points.empty())
  {
    Vec3 low = this->Mesh.points[0];
    Vec3 high = low;
    for (const Vec3& p : this->Mesh.points)
    {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    this->Centre = 0.5 * (low + high);
    this->Radius = 0.5 * glm::length(high - low);
  }
}

std::vector<EdgeCurve> Caster::curves(const std::vector<Index>& wanted, const RangeLoop& loop)
{
  return this->EdgeCurves.get(this->Mesh, this->Edges, wanted, loop);
}

SearchMethod Caster::chooseMethod(FieldKind kind) const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  const bool lightMoves = this->Searches[static_cast<std::size_t>(kind)] > 0;
  return lightMoves && this->Mesh.triangles.size() >= worthATree ? SearchMethod::Hierarchy
                                                                 : SearchMethod::BruteForce;
}

std::shared_ptr<const SearchTree> Caster::searchTree(FieldKind kind, const RangeLoop& loop)
{
  std::shared_ptr<const SearchTree>& kept = this->Trees[static_cast<std::size_t>(kind)];
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (kept)
    {
      return kept;
    }
  }
  auto tree = std::make_shared<const SearchTree>(
    buildSearchTree(this->searched(), kind, this->Centre, this->Radius, loop));
  const std::lock_guard<std::mutex> lock(this->Guard);
  kept = tree;
  return tree;
}

SearchResult Caster::search(
  const Light& light, FieldKind kind, SearchMethod method, const RangeLoop& loop)
{
  return method == SearchMethod::Hierarchy
    ? shadow::searchTree(this->searched(), *this->searchTree(kind, loop), light, kind, loop)
    : searchAll(this->searched(), light, kind, loop);
}

Index Caster::normalAt(const Light& light, SearchMethod method)
{
  if (method == SearchMethod::Hierarchy && light.w == 1.0)
  {
    std::shared_ptr<const PlaceIndex> places;
    {
      const std::lock_guard<std::mutex> lock(this->Guard);
      places = this->Places;
    }
    if (!places)
    {
      places = std::make_shared<const PlaceIndex>(this->Mesh);
      const std::lock_guard<std::mutex> lock(this->Guard);
      this->Places = places;
    }
    return places->firstNormalAt(this->Mesh, light.position);
  }
  for (std::size_t n = 0; n < this->Mesh.normals.size(); ++n)
  {
    if (light.toward(this->Mesh.points[this->Mesh.normalVertex[n]]) == Vec3(0.0))
    {
      return static_cast<Index>(n);
    }
  }
  return None;
}

Light Caster::offTheSurface(const Light& light, SearchMethod method)
{
  if (light.isDirectional() || glm::length(light.toward(this->Centre)) > light.w * this->Radius)
  {
    return light;
  }
  const Index normal = this->normalAt(light, method);
  Light above = light;
  if (normal != None)
  {
    above.position += 1e-6 * this->Radius * light.w * this->Mesh.normals[normal];
  }
  return above;
}

std::shared_ptr<const SilhouetteChain> Caster::silhouette(
  const Light& light, SilhouetteKind kind, SearchMethod method, const RangeLoop& loop)
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (this->Last && this->LastLight == light && this->Last->kind == kind &&
      (method == SearchMethod::Automatic || this->Last->method == method))
    {
      return this->Last;
    }
  }
  const FieldKind field = kind == SilhouetteKind::Discrete ? FieldKind::Face : FieldKind::Corner;
  if (method == SearchMethod::Automatic)
  {
    method = this->chooseMethod(field);
  }
  auto chain = std::make_shared<const SilhouetteChain>(
    buildSilhouetteChain(*this, this->offTheSurface(light, method), kind, method, loop));
  const std::lock_guard<std::mutex> lock(this->Guard);
  ++this->Searches[static_cast<std::size_t>(field)];
  this->LastLight = light;
  this->Last = chain;
  return chain;
}

std::size_t Caster::memory() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  std::size_t total = bytes(this->Mesh.points) + bytes(this->Mesh.triangles) +
    bytes(this->Mesh.normals) + bytes(this->Mesh.normalVertex) + bytes(this->Mesh.cornerNormals) +
    bytes(this->Edges.edges) + bytes(this->Edges.firstSide) + bytes(this->Edges.sides) +
    bytes(this->Edges.triangleEdges) + bytes(this->Weights.parts) + bytes(this->Weights.part) +
    bytes(this->Weights.face) + bytes(this->Weights.corner) + bytes(this->LinkEdges) +
    this->EdgeCurves.memory();
  for (const auto& tree : this->Trees)
  {
    total += tree ? tree->memory() : 0;
  }
  return total + (this->Places ? this->Places->memory() : 0);
}
}
