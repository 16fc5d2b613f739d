#include "ChainWeights.h"

#include "DisjointSets.h"

namespace shadow
{
namespace
{
ChainWeight scaled(ChainWeight weight, int sign)
{
  return { static_cast<std::int8_t>(sign * weight.lit), static_cast<std::int8_t>(sign * weight.dark) };
}

/// Sum over a triangle's corners of normal times area normal: positive if they are on one side.
double agreement(const TriangleMesh& mesh, Index triangle)
{
  const Triangle& n = mesh.cornerNormals[triangle];
  return glm::dot(
    mesh.areaNormal(triangle), mesh.normals[n[0]] + mesh.normals[n[1]] + mesh.normals[n[2]]);
}

/// Numbers the parts in order of their first triangle.
std::vector<Index> connectedParts(const TriangleMesh& mesh, const EdgeTable& edges, Index& count)
{
  DisjointSets sets(mesh.triangles.size());
  for (std::size_t e = 0; e < edges.edges.size(); ++e)
  {
    for (Index i = edges.firstSide[e] + 1; i < edges.firstSide[e + 1]; ++i)
    {
      sets.unite(edges.sides[edges.firstSide[e]] / 3, edges.sides[i] / 3);
    }
  }
  return sets.number(count);
}
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
  result.part = connectedParts(mesh, edges, partCount);
  result.parts.resize(partCount);
  for (std::size_t e = 0; e < edges.edges.size(); ++e)
  {
    if (signSum(mesh, edges, static_cast<Index>(e)) != 0)
    {
      result.parts[result.part[edges.sides[edges.firstSide[e]] / 3]].closed = false;
    }
  }

  // Volumes are taken about a vertex of the mesh so that a distant origin costs no digits.
  const Vec3 origin = mesh.points.empty() ? Vec3(0.0) : mesh.points[0];
  std::vector<double> volume(partCount, 0.0);
  std::vector<double> agreements(partCount, 0.0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const Index t = static_cast<Index>(i);
    volume[result.part[t]] +=
      glm::dot(mesh.areaNormal(t), mesh.points[mesh.triangles[t][0]] - origin);
    agreements[result.part[t]] += agreement(mesh, t);
  }
  for (Index p = 0; p < partCount; ++p)
  {
    result.parts[p].outward = !(volume[p] < 0.0);
    result.parts[p].normalsAgree = !(agreements[p] < 0.0);
  }

  result.face.resize(mesh.triangles.size());
  result.corner.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const Index t = static_cast<Index>(i);
    const MeshPart& part = result.parts[result.part[t]];
    result.face[t] = part.closed ? ChainWeight{ 1, 0 } : ChainWeight{ 1, -1 };
    // Without a common orientation each triangle is measured by its own normals.
    const bool agree = part.closed ? part.normalsAgree : !(agreement(mesh, t) < 0.0);
    result.corner[t] = scaled(result.face[t], agree ? 1 : -1);
  }
  return result;
}
}
