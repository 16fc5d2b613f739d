/// A mesh that casts, with everything that does not depend on the light.
#pragma once

#include "AcrossCorrections.h"
#include "EdgeCurve.h"
#include "PlaceIndex.h"
#include "SilhouetteChain.h"
#include "SilhouetteTracking.h"

#include <memory>
#include <mutex>

namespace shadow
{
/// How many of a mesh's corner normals are estimates, and how many of those are means of the
/// triangles around, where no jet could be fitted. Both are 0 for a mesh that came with normals.
struct NormalCounts
{
  std::size_t estimated = 0;
  std::size_t fallback = 0;
};

/// Built once for a mesh and shared; safe to be used from several threads. The index of a search is
/// built when first needed, one for face fields and one for corner fields.
class Caster
{
public:
  /// Takes a mesh with corner normals, or estimates them (normals empty), splitting edges whose
  /// triangles turn by more than featureAngle (radians). Vertices, normals and triangles get
  /// numbers of the caster's own.
  Caster(TriangleMesh mesh, double featureAngle, const RangeLoop& loop);

  const TriangleMesh& mesh() const { return this->Mesh; }
  const EdgeTable& edges() const { return this->Edges; }
  const ChainWeights& weights() const { return this->Weights; }
  const EdgeDefects& defects() const { return this->Defects; }
  const NormalCounts& normalCounts() const { return this->Normals; }

  /// Edges on which a corner field's silhouette can run.
  const std::vector<Index>& linkEdges() const { return this->LinkEdges; }

  /// Centre of the bounds and half their diagonal: a ball around the mesh.
  const Vec3& centre() const { return this->TheBall.centre; }
  double radius() const { return this->TheBall.radius; }

  bool hasPlainEdgesOnly() const { return this->EdgeKinds.empty(); }
  EdgeKind edgeKind(Index edge) const
  {
    return this->EdgeKinds.empty() ? EdgeKind::Plain : this->EdgeKinds[edge];
  }

  /// The curve of an edge. What it takes its triangles for is kept.
  EdgeCurve curve(Index edge);

  /// The greatest distance between an edge and its curve, by EdgeCurve::chordDeviation; 0
  /// without edges. Made once, in O(edges).
  double edgeDeviation(const RangeLoop& loop);

  /// The silhouette of a light. The last complete one is kept, and given whenever it was searched
  /// for as asked, Automatic being content with any. A light on a vertex is taken to be just above
  /// the surface there, by 1e-6 of the radius, as the rule takes it that calls a field of zero lit.
  /// Tracking and Randomized begin at what they found last for this caller, and leave there what
  /// they find; the other methods do not touch it.
  std::shared_ptr<const SilhouetteChain> silhouette(const Light& light, SilhouetteKind kind,
    SearchSettings settings, LastTracked& last, const RangeLoop& loop);

  SearchedMesh searched() const
  {
    return { this->Mesh, this->Edges, this->Weights, this->LinkEdges };
  }

  /// Bytes that are kept, without the last silhouette and what allocators add.
  std::size_t memory() const;

private:
  /// What is made when it is first asked for, while the lock is not held.
  template <class Value, class Make>
  std::shared_ptr<const Value> kept(std::shared_ptr<const Value>& place, const Make& make);

  TrackedResult search(const Light& light, FieldKind kind, const SearchSettings& settings,
    LastTracked& last, const RangeLoop& loop);
  Light offTheSurface(const Light& light);

  TriangleMesh Mesh;
  EdgeTable Edges;
  ChainWeights Weights;
  EdgeDefects Defects;
  NormalCounts Normals;
  std::vector<Index> LinkEdges;
  std::vector<EdgeKind> EdgeKinds; ///< of each edge; empty if all are plain
  Ball TheBall;

  AcrossCorrections Corrections;

  mutable std::mutex Guard; ///< of what follows; never held while something is made
  /// By kind of field.
  std::array<std::shared_ptr<const SearchIndex>, 2> Indices;
  std::array<std::shared_ptr<const TrackingSeeds>, 2> Seeds;
  std::shared_ptr<const PlaceIndex> Places;
  std::shared_ptr<const double> EdgeDeviation;
  Light LastLight;
  std::shared_ptr<const SilhouetteChain> Last;
};
}
