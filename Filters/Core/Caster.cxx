#include "Caster.h"

#include "VertexNormals.h"

#include <algorithm>

namespace shadow
{
Caster::Caster(TriangleMesh mesh, double featureAngle)
  : Mesh(std::move(mesh))
  , Edges(buildEdgeTable(this->Mesh))
{
  if (this->Mesh.normals.empty())
  {
    estimateCornerNormals(this->Mesh, this->Edges, featureAngle);
  }
  else
  {
    repairNormals(this->Mesh);
  }
  this->Weights = findChainWeights(this->Mesh, this->Edges);
  this->Defects = countEdgeDefects(this->Mesh, this->Edges);
  this->LinkEdges = findLinkEdges(this->Mesh, this->Edges, this->Weights);
  this->CurveOf.assign(this->Edges.edges.size(), None);
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

std::shared_ptr<const SilhouetteChain> Caster::silhouette(
  const Light& light, SilhouetteKind kind, const RangeLoop& loop)
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  if (!this->Last || !(this->Last->light == light) || this->Last->kind != kind)
  {
    this->Last =
      std::make_shared<const SilhouetteChain>(buildSilhouetteChain(*this, light, kind, loop));
  }
  return this->Last;
}

void Caster::ensureCurves(const std::vector<Index>& edgeList, const RangeLoop& loop)
{
  std::vector<Index> missing;
  for (const Index e : edgeList)
  {
    if (this->CurveOf[e] == None)
    {
      this->CurveOf[e] = static_cast<Index>(this->Curves.size() + missing.size());
      missing.push_back(e);
    }
  }
  const std::size_t first = this->Curves.size();
  this->Curves.resize(first + missing.size());
  loop(missing.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->Curves[first + i] = makeEdgeCurve(this->Mesh, this->Edges, missing[i]);
      }
    });
}
}
