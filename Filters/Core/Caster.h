/// A mesh that casts, with everything that does not depend on the light.
#pragma once

#include "EdgeCurveCache.h"
#include "SilhouetteChain.h"

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

/// Built once for a mesh and shared; safe to be used from several threads. Memory: about 150 bytes a
/// triangle, and 300 for each edge that a smooth contour has crossed so far.
class Caster
{
public:
  /// Takes a mesh with corner normals, or estimates them (normals empty), splitting edges whose
  /// triangles turn by more than featureAngle (radians).
  Caster(TriangleMesh mesh, double featureAngle, const RangeLoop& loop);

  const TriangleMesh& mesh() const { return this->Mesh; }
  const EdgeTable& edges() const { return this->Edges; }
  const ChainWeights& weights() const { return this->Weights; }
  const EdgeDefects& defects() const { return this->Defects; }
  const NormalCounts& normalCounts() const { return this->Normals; }

  /// Edges on which a corner field's silhouette can run.
  const std::vector<Index>& linkEdges() const { return this->LinkEdges; }

  /// Centre of the bounds and half their diagonal: a ball around the mesh.
  const Vec3& centre() const { return this->Centre; }
  double radius() const { return this->Radius; }

  /// The curves of these edges, in their order. They are kept.
  std::vector<EdgeCurve> curves(const std::vector<Index>& wanted, const RangeLoop& loop);

  /// The silhouette of a light; the last one is kept. A light on a vertex is taken to be just above
  /// the surface there, by 1e-6 of the radius, as the rule takes it that calls a field of zero lit.
  std::shared_ptr<const SilhouetteChain> silhouette(
    const Light& light, SilhouetteKind kind, const RangeLoop& loop);

private:
  Light offTheSurface(const Light& light) const;

  TriangleMesh Mesh;
  EdgeTable Edges;
  ChainWeights Weights;
  EdgeDefects Defects;
  NormalCounts Normals;
  std::vector<Index> LinkEdges;
  Vec3 Centre{ 0.0 };
  double Radius = 0.0;

  EdgeCurveCache EdgeCurves;

  std::mutex Guard; ///< of the last silhouette; never held while one is made
  Light LastLight;
  std::shared_ptr<const SilhouetteChain> Last;
};
}
