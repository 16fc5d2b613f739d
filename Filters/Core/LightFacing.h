/// The fields whose sign tells lit from dark.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// Whether the field that tells lit from dark has a value per face or per corner.
enum class FieldKind
{
  Face,
  Corner
};

/// normal . (l - w p) of a corner normal at its vertex.
inline double cornerField(const TriangleMesh& mesh, const Light& light, Index n)
{
  return glm::dot(mesh.normals[n], light.toward(mesh.points[mesh.normalVertex[n]]));
}

/// N . (l - w p) of a triangle, N its area normal and p its first corner.
inline double faceField(const TriangleMesh& mesh, const Light& light, Index t)
{
  return glm::dot(mesh.areaNormal(t), light.toward(mesh.points[mesh.triangles[t][0]]));
}

/// A light's field on a mesh, evaluated where it is asked for: a silhouette needs little of it.
/// Every value comes from the two functions above, so a sign is the same for all who ask.
class LightField
{
public:
  LightField() = default;
  LightField(const TriangleMesh& mesh, const Light& light, FieldKind kind)
    : Mesh(&mesh)
    , TheLight(light)
    , Kind(kind)
  {
  }

  FieldKind kind() const { return this->Kind; }

  /// Of a face or a corner normal. The mesh must still be there.
  double value(Index item) const
  {
    return this->Kind == FieldKind::Face ? faceField(*this->Mesh, this->TheLight, item)
                                         : cornerField(*this->Mesh, this->TheLight, item);
  }

  bool lit(Index item) const { return isLit(this->value(item)); }

private:
  const TriangleMesh* Mesh = nullptr;
  Light TheLight;
  FieldKind Kind = FieldKind::Corner;
};
}
