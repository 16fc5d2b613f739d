#include "Caster.h"

#include "JetNormals.h"
#include "VertexNormals.h"

#include <algorithm>

namespace shadow
{
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

Light Caster::offTheSurface(const Light& light) const
{
  if (light.isDirectional() || glm::length(light.toward(this->Centre)) > light.w * this->Radius)
  {
    return light;
  }
  for (std::size_t n = 0; n < this->Mesh.normals.size(); ++n)
  {
    if (light.toward(this->Mesh.points[this->Mesh.normalVertex[n]]) == Vec3(0.0))
    {
      Light above = light;
      above.position += 1e-6 * this->Radius * light.w * this->Mesh.normals[n];
      return above;
    }
  }
  return light;
}

std::shared_ptr<const SilhouetteChain> Caster::silhouette(
  const Light& light, SilhouetteKind kind, const RangeLoop& loop)
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (this->Last && this->LastLight == light && this->Last->kind == kind)
    {
      return this->Last;
    }
  }
  auto chain = std::make_shared<const SilhouetteChain>(
    buildSilhouetteChain(*this, this->offTheSurface(light), kind, loop));
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->LastLight = light;
  this->Last = chain;
  return chain;
}
}
