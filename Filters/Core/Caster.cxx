#include "Caster.h"

#include "FacingOrder.h"
#include "JetNormals.h"
#include "VertexNormals.h"

#include <algorithm>

namespace shadow
{
namespace
{
/// Triangles from which on a search by hierarchy beats looking at all.
constexpr std::size_t worthATree = 2000;

template <class Value>
std::size_t bytes(const std::vector<Value>& values)
{
  return values.capacity() * sizeof(Value);
}
}

Caster::Caster(TriangleMesh mesh, double featureAngle, const RangeLoop& loop)
  : Mesh(std::move(mesh))
{
  if (this->Mesh.normals.empty())
  {
    const EdgeTable edges = buildEdgeTable(this->Mesh);
    estimateCornerNormals(this->Mesh, edges, featureAngle);
    this->Normals.estimated = this->Mesh.normals.size();
    this->Normals.fallback = fitJetNormals(this->Mesh, loop);
  }
  else
  {
    repairNormals(this->Mesh);
  }
  orderTriangles(this->Mesh, loop);
  this->Edges = buildEdgeTable(this->Mesh);
  orderEdges(this->Mesh, this->Edges, loop);
  this->Weights = findChainWeights(this->Mesh, this->Edges);
  this->Defects = countEdgeDefects(this->Mesh, this->Edges);
  this->EdgeKinds = findEdgeKinds(this->Mesh, this->Edges);
  this->LinkEdges = findLinkEdges(this->Mesh, this->Edges, this->Weights, this->EdgeKinds);
  this->TheBall = this->Mesh.ball();
}

EdgeCurve Caster::curve(Index edge)
{
  return makeEdgeCurve(this->Mesh, this->Edges, edge, this->edgeKind(edge),
    [&](const EdgeCurve& curve)
    {
      return this->Corrections.get(this->Edges.regular, edge,
        [&] { return makeCorrection(this->Mesh, this->Edges, edge, curve); });
    });
}

std::shared_ptr<const SearchIndex> Caster::searchIndex(FieldKind kind, const RangeLoop& loop)
{
  std::shared_ptr<const SearchIndex>& kept = this->Indices[static_cast<std::size_t>(kind)];
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (kept)
    {
      return kept;
    }
  }
  auto index =
    std::make_shared<const SearchIndex>(buildSearchIndex(this->searched(), kind, loop));
  const std::lock_guard<std::mutex> lock(this->Guard);
  kept = index;
  return index;
}

SearchResult Caster::search(
  const Light& light, FieldKind kind, SearchMethod method, const RangeLoop& loop)
{
  return shadow::search(
    this->searched(), *this->searchIndex(kind, loop), light, method, loop);
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
  const Ball& ball = this->TheBall;
  if (light.isDirectional() || glm::length(light.toward(ball.centre)) > light.w * ball.radius)
  {
    return light;
  }
  const Index normal = this->normalAt(light, method);
  Light above = light;
  if (normal != None)
  {
    above.position += 1e-6 * ball.radius * light.w * this->Mesh.normals[normal];
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
  if (method == SearchMethod::Automatic)
  {
    method = this->Mesh.triangles.size() < worthATree ? SearchMethod::BruteForce
                                                      : SearchMethod::Hierarchy;
  }
  auto chain = std::make_shared<const SilhouetteChain>(
    buildSilhouetteChain(*this, this->offTheSurface(light, method), kind, method, loop));
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->LastLight = light;
  this->Last = chain;
  return chain;
}

std::size_t Caster::memory() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  std::size_t total = bytes(this->Mesh.points) + bytes(this->Mesh.triangles) +
    bytes(this->Mesh.normals) + bytes(this->Mesh.normalVertex) + bytes(this->Mesh.cornerNormals) +
    bytes(this->Edges.edges) + bytes(this->Edges.firstOther) + bytes(this->Edges.sides) +
    bytes(this->Edges.triangleEdges) + bytes(this->Weights.parts) + bytes(this->Weights.parting) +
    bytes(this->Weights.agreeing) + bytes(this->LinkEdges) + bytes(this->EdgeKinds) +
    this->Corrections.memory();
  for (const auto& index : this->Indices)
  {
    total += index ? index->memory() : 0;
  }
  return total + (this->Places ? this->Places->memory() : 0);
}
}
