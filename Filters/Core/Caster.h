/// A mesh that casts, with everything that does not depend on the light.
#pragma once

#include "EdgeCurve.h"
#include "SilhouetteChain.h"

#include <memory>
#include <mutex>

namespace shadow
{
/// Built once for a mesh and shared; safe to be used from several threads.
class Caster
{
public:
  /// Takes a mesh with corner normals, or estimates them (normals empty), splitting edges whose
  /// triangles turn by more than featureAngle (radians).
  Caster(TriangleMesh mesh, double featureAngle);

  const TriangleMesh& mesh() const { return this->Mesh; }
  const EdgeTable& edges() const { return this->Edges; }
  const ChainWeights& weights() const { return this->Weights; }
  const EdgeDefects& defects() const { return this->Defects; }

  /// Edges on which a corner field's silhouette can run.
  const std::vector<Index>& linkEdges() const { return this->LinkEdges; }

  /// Centre of the bounds and half their diagonal: a ball around the mesh.
  const Vec3& centre() const { return this->Centre; }
  double radius() const { return this->Radius; }

  /// The silhouette of a light; the last one is kept.
  std::shared_ptr<const SilhouetteChain> silhouette(
    const Light& light, SilhouetteKind kind, const RangeLoop& loop);

  /// Makes the curves of these edges, for those that have none yet. Only for the building of a
  /// chain, which silhouette() guards.
  void ensureCurves(const std::vector<Index>& edgeList, const RangeLoop& loop);

  /// An edge's curve, made before.
  const EdgeCurve& curve(Index edge) const { return this->Curves[this->CurveOf[edge]]; }

private:
  TriangleMesh Mesh;
  EdgeTable Edges;
  ChainWeights Weights;
  EdgeDefects Defects;
  std::vector<Index> LinkEdges;
  Vec3 Centre{ 0.0 };
  double Radius = 0.0;

  std::mutex Guard;
  std::shared_ptr<const SilhouetteChain> Last;
  std::vector<Index> CurveOf; ///< where each edge's curve is, None if not yet made
  std::vector<EdgeCurve> Curves;
};
}
