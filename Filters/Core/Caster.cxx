#include "Caster.h"

#include "FacingOrder.h"
#include "JetNormals.h"
#include "VertexNormals.h"

#include <algorithm>
#include <atomic>

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
  this->TheBall = this->Mesh.ball();
  orderEdges(this->Mesh, this->Edges, this->TheBall, loop);
  this->Weights = findChainWeights(this->Mesh, this->Edges);
  this->Defects = countEdgeDefects(this->Mesh, this->Edges);
  this->EdgeKinds = findEdgeKinds(this->Mesh, this->Edges);
  this->LinkEdges = findLinkEdges(this->Mesh, this->Edges, this->Weights, this->EdgeKinds);
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

template <class Value, class Make>
std::shared_ptr<const Value> Caster::kept(std::shared_ptr<const Value>& place, const Make& make)
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (place)
    {
      return place;
    }
  }
  auto made = std::make_shared<const Value>(make());
  const std::lock_guard<std::mutex> lock(this->Guard);
  place = made;
  return made;
}

double Caster::edgeDeviation(const RangeLoop& loop)
{
  const auto greatest = [&]
  {
    std::atomic<double> most{ 0.0 };
    loop(this->Edges.edges.size(), lightGrain,
      [&](std::size_t begin, std::size_t end)
      {
        double own = 0.0;
        for (std::size_t e = begin; e < end; ++e)
        {
          const Index edge = static_cast<Index>(e);
          // What the triangles at it tell bends the normals, not the curve.
          own = std::max(own,
            makeUncorrectedCurve(this->Mesh, this->Edges, edge, this->edgeKind(edge))
              .chordDeviation());
        }
        double before = most.load();
        while (before < own && !most.compare_exchange_weak(before, own))
        {
        }
      });
    return most.load();
  };
  return *this->kept(this->EdgeDeviation, greatest);
}

TrackedResult Caster::search(const Light& light, FieldKind kind, const SearchSettings& settings,
  LastTracked& last, const RangeLoop& loop)
{
  const std::size_t k = static_cast<std::size_t>(kind);
  const SearchedMesh searched = this->searched();
  if (settings.method == SearchMethod::BruteForce || settings.method == SearchMethod::Hierarchy)
  {
    const auto index = this->kept(
      this->Indices[k], [&] { return buildSearchIndex(searched, kind, this->TheBall, loop); });
    const bool useTree = settings.method == SearchMethod::Hierarchy;
    return { shadow::search(searched, *index, light, useTree, loop), true };
  }
  std::optional<SearchResult>& before = last.found[k];
  const SearchResult* start = before ? &*before : nullptr;
  TrackedResult result;
  if (settings.method == SearchMethod::Tracking)
  {
    const auto seeds =
      this->kept(this->Seeds[k], [&] { return findTrackingSeeds(searched, kind); });
    result = trackSilhouette(searched, *seeds, light, kind, start);
  }
  else
  {
    result = sampleSilhouette(
      searched, light, kind, settings.sampleFraction, settings.seed, start, loop);
  }
  before = result.found;
  return result;
}

Light Caster::offTheSurface(const Light& light)
{
  const Ball& ball = this->TheBall;
  // A vertex can be on the ball, or by rounding a little outside of it.
  if (light.isDirectional() ||
    glm::length(light.toward(ball.centre)) > 1.001 * light.w * ball.radius)
  {
    return light;
  }
  const auto places = this->kept(this->Places, [&] { return PlaceIndex(this->Mesh); });
  const Index normal = places->firstNormalAt(this->Mesh, light.position / light.w);
  Light above = light;
  if (normal != None)
  {
    above.position += 1e-6 * ball.radius * light.w * this->Mesh.normals[normal];
  }
  return above;
}

std::shared_ptr<const SilhouetteChain> Caster::silhouette(const Light& light, SilhouetteKind kind,
  SearchSettings settings, LastTracked& last, const RangeLoop& loop)
{
  const bool anyDoes = settings.method == SearchMethod::Automatic;
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (this->Last && this->LastLight == light && this->Last->kind == kind &&
      (anyDoes || this->Last->search == settings))
    {
      return this->Last;
    }
  }
  if (anyDoes)
  {
    settings.method = this->Mesh.triangles.size() < worthATree ? SearchMethod::BruteForce
                                                               : SearchMethod::Hierarchy;
  }
  const Light seen = this->offTheSurface(light);
  const TrackedResult result = this->search(seen, fieldKind(kind), settings, last, loop);
  SilhouetteChain built = buildSilhouetteChain(*this, seen, kind, result.found, loop);
  built.search = settings;
  built.complete = result.complete;
  auto chain = std::make_shared<const SilhouetteChain>(std::move(built));
  if (chain->complete)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->LastLight = light;
    this->Last = chain;
  }
  return chain;
}

std::size_t Caster::memory() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  std::size_t total = bytes(this->Mesh.points) + bytes(this->Mesh.triangles) +
    bytes(this->Mesh.normals) + bytes(this->Mesh.normalVertex) + bytes(this->Mesh.cornerNormals) +
    bytes(this->Mesh.sources) +
    bytes(this->Edges.edges) + bytes(this->Edges.firstOther) + bytes(this->Edges.sides) +
    bytes(this->Edges.triangleEdges) + bytes(this->Weights.parts) + bytes(this->Weights.parting) +
    bytes(this->Weights.agreeing) + bytes(this->LinkEdges) + bytes(this->EdgeKinds) +
    this->Corrections.memory();
  for (const auto& index : this->Indices)
  {
    total += index ? index->memory() : 0;
  }
  for (const auto& seeds : this->Seeds)
  {
    total += seeds ? bytes(seeds->starts) + bytes(seeds->borders) : 0;
  }
  return total + (this->Places ? this->Places->memory() : 0);
}
}
