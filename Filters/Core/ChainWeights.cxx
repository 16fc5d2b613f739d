#include "ChainWeights.h"

#include "DisjointSets.h"

#include <algorithm>

namespace shadow
{
namespace
{
/// Numbers the parts in order of their first triangle.
std::vector<Index> connectedParts(const TriangleMesh& mesh, const EdgeTable& edges, Index& count)
{
  DisjointSets sets(mesh.triangles.size());
  for (std::size_t i = 0; i < edges.edges.size(); ++i)
  {
    const Index e = static_cast<Index>(i);
    const Index first = edges.firstSide(e);
    for (Index side = first + 1; side < edges.firstSide(e + 1); ++side)
    {
      sets.unite(edges.sides[first] / 3, edges.sides[side] / 3);
    }
  }
  return sets.number(count);
}
}

double normalAgreement(const TriangleMesh& mesh, Index triangle)
{
  if (mesh.cornerNormals.empty())
  {
    return 0.0;
  }
  const Triangle& n = mesh.cornerNormals[triangle];
  return glm::dot(
    mesh.areaNormal(triangle), mesh.normals[n[0]] + mesh.normals[n[1]] + mesh.normals[n[2]]);
}

std::vector<bool> ChainWeights::capsOnDarkField(FieldKind kind, CapSide side) const
{
  std::vector<bool> onDark;
  for (const MeshPart& part : this->parts)
  {
    // Where the field's normals point inwards, what it calls lit is the side away from the light.
    const bool agree = kind == FieldKind::Face || part.normalsAgree;
    const bool fieldIsOutward = part.outward == agree;
    onDark.push_back(part.closed && (side == CapSide::Lit) != fieldIsOutward);
  }
  return onDark;
}

ChainWeights findChainWeights(const TriangleMesh& mesh, const EdgeTable& edges)
{
  ChainWeights result;
  Index partCount = 0;
  std::vector<Index> part = connectedParts(mesh, edges, partCount);
  result.parts.resize(partCount);
  for (std::size_t e = edges.regular; e < edges.edges.size(); ++e)
  {
    const Index edge = static_cast<Index>(e);
    if (signSum(mesh, edges, edge) != 0)
    {
      result.parts[part[edges.sides[edges.firstSide(edge)] / 3]].closed = false;
    }
  }

  // Volumes are taken about a vertex of the mesh so that a distant origin costs no digits.
  const Vec3 origin = mesh.points.empty() ? Vec3(0.0) : mesh.points[0];
  std::vector<double> volume(partCount, 0.0);
  std::vector<double> agreements(partCount, 0.0);
  std::vector<std::uint8_t> agreeing(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const Index t = static_cast<Index>(i);
    const double agrees = normalAgreement(mesh, t);
    volume[part[t]] += glm::dot(mesh.areaNormal(t), mesh.points[mesh.triangles[t][0]] - origin);
    agreements[part[t]] += agrees;
    agreeing[t] = !(agrees < 0.0);
  }
  for (Index p = 0; p < partCount; ++p)
  {
    result.parts[p].outward = !(volume[p] < 0.0);
    result.parts[p].normalsAgree = !(agreements[p] < 0.0);
  }
  // Without a common orientation each triangle is measured by its own normals.
  for (std::size_t t = 0; t < agreeing.size(); ++t)
  {
    const MeshPart& own = result.parts[part[t]];
    agreeing[t] = own.closed ? own.normalsAgree : agreeing[t];
  }
  if (std::find(agreeing.begin(), agreeing.end(), 0) != agreeing.end())
  {
    result.agreeing = std::move(agreeing);
  }
  if (partCount > 1)
  {
    result.parting = std::move(part);
  }
  return result;
}
}
