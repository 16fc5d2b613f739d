#include "ConcaveContour.h"

namespace shadow
{
namespace
{
/// The field's change in a triangle, on which it is linear, over the light's ray projected there;
/// times the square of the area normal's length.
double changeTowardLight(const TriangleMesh& mesh, const LightField& field, const Light& light,
  Index triangle)
{
  const Triangle& t = mesh.triangles[triangle];
  const Triangle& n = mesh.cornerNormals[triangle];
  const Vec3 e1 = mesh.points[t[1]] - mesh.points[t[0]];
  const Vec3 e2 = mesh.points[t[2]] - mesh.points[t[0]];
  const Vec3 normal = glm::cross(e1, e2);
  const Vec3 ray = light.toward(mesh.points[t[0]]);
  const double at0 = field.value(n[0]);
  return (field.value(n[1]) - at0) * glm::dot(normal, glm::cross(ray, e2)) +
    (field.value(n[2]) - at0) * glm::dot(normal, glm::cross(e1, ray));
}
}

ConcaveContour::ConcaveContour(const Caster& caster, const SilhouetteChain& chain)
  : VertexCount(caster.mesh().points.size())
  , Ends(chain.crossings.size(), false)
  , First(chain.crossings.size(), None)
{
  if (chain.kind == SilhouetteKind::Discrete)
  {
    return;
  }
  const TriangleMesh& mesh = caster.mesh();
  for (const Piece& piece : chain.pieces)
  {
    if (!piece.isChord)
    {
      continue;
    }
    const double outward = caster.weights().cornersPointOutward(piece.source) ? 1.0 : -1.0;
    if (outward * changeTowardLight(mesh, chain.field, chain.light, piece.source) >= 0.0)
    {
      continue;
    }
    const double side = normalAgreement(mesh, piece.source);
    const double facing = faceField(mesh, chain.light, piece.source);
    this->Ends[piece.from - this->VertexCount] = true;
    this->Ends[piece.to - this->VertexCount] = true;
    Index& first = this->First[piece.from - this->VertexCount];
    this->Next.push_back(first);
    first = static_cast<Index>(this->Chords.size());
    this->Chords.push_back(
      { piece.from, piece.to, piece.source, outward * side * facing < 0.0 });
  }
}

const ConcaveChord* ConcaveContour::find(Index from, Index to) const
{
  if (from < this->VertexCount)
  {
    return nullptr;
  }
  for (Index i = this->First[from - this->VertexCount]; i != None; i = this->Next[i])
  {
    if (this->Chords[i].to == to)
    {
      return &this->Chords[i];
    }
  }
  return nullptr;
}
}
