#include "SilhouetteGap.h"

namespace shadow
{
namespace
{
/// Of a closed part that is inside out: its normals may point inwards. Where no crossing tells,
/// they are taken as they are.
bool pointsInwards(const NearEnd& end, const SilhouetteInput& silhouette, std::size_t loop)
{
  const std::size_t vertices = end.caster.mesh().points.size();
  for (std::size_t at = silhouette.first[loop]; at < silhouette.first[loop + 1]; ++at)
  {
    const Index node = silhouette.nodes[silhouette.loopPoints[at]];
    if (node != None && node >= vertices)
    {
      const Crossing& crossing = end.chain.crossings[node - vertices];
      return !end.caster.weights().cornersPointOutward(crossing.side / 3);
    }
  }
  return false;
}

std::vector<Vec3> turnedOutwards(
  const NearEnd& end, const SilhouetteInput& silhouette, std::vector<Vec3> normals)
{
  for (std::size_t loop = 0; loop < silhouette.multiplicity.size(); ++loop)
  {
    if (pointsInwards(end, silhouette, loop))
    {
      for (std::size_t at = silhouette.first[loop]; at < silhouette.first[loop + 1]; ++at)
      {
        Vec3& normal = normals[silhouette.loopPoints[at]];
        normal = -normal;
      }
    }
  }
  return normals;
}

class GapBuilder
{
public:
  GapBuilder(const NearEnd& end, const SilhouetteInput& silhouette, std::vector<Vec3> normals)
    : End(end)
    , VertexCount(end.caster.mesh().points.size())
    , NodeCount(this->VertexCount + end.chain.crossings.size())
    , Normals(std::move(normals))
  {
    this->First.reserve(silhouette.nodes.size());
    for (std::size_t i = 0; i < silhouette.nodes.size(); ++i)
    {
      if (silhouette.nodes[i] != None && this->First.insert(silhouette.nodes[i]).isNew)
      {
        this->PointOfNode.push_back(static_cast<Index>(i));
      }
    }
  }

  SilhouetteGap build()
  {
    for (const VolumeTriangle& t : this->End.triangles)
    {
      if (t.part == VolumePart::Gap && this->facesLight(t.points))
      {
        this->Gap.triangles.push_back(
          { this->add(t.points[0]), this->add(t.points[1]), this->add(t.points[2]) });
      }
    }
    return std::move(this->Gap);
  }

private:
  bool facesLight(const Triangle& t) const
  {
    const Vec3 origin = this->End.place(t[0]);
    const Vec3 normal = glm::cross(this->End.place(t[1]) - origin, this->End.place(t[2]) - origin);
    return glm::dot(normal, this->End.chain.light.toward(origin)) > 0.0;
  }

  Index add(Index node)
  {
    const IndexSet::Insertion added = this->Used.insert(node);
    if (added.isNew)
    {
      this->Gap.points.push_back(this->End.place(node));
      this->Gap.normals.push_back(this->normalAt(node));
    }
    return added.place;
  }

  Vec3 normalAt(Index node) const
  {
    if (node >= this->NodeCount)
    {
      return this->Normals[this->End.origins[node - this->NodeCount]];
    }
    const Vec3& onSurface = this->Normals[this->PointOfNode[this->First.find(node)]];
    return node < this->VertexCount
      ? onSurface
      : this->shadingNormal(this->End.chain.crossings[node - this->VertexCount], onSurface);
  }

  /// As it is interpolated on the mesh when that is drawn: where a gap begins in sight its shade
  /// goes on.
  Vec3 shadingNormal(const Crossing& c, const Vec3& onSurface) const
  {
    const TriangleMesh& mesh = this->End.caster.mesh();
    const SideNormals side = sideNormals(mesh, this->End.caster.edges(), c.edge, c.side);
    const Vec3 normal =
      unitOr(glm::mix(mesh.normals[side.a], mesh.normals[side.b], c.parameter), onSurface);
    return glm::dot(normal, onSurface) < 0.0 ? -normal : normal;
  }

  const NearEnd& End;
  const std::size_t VertexCount;
  const std::size_t NodeCount;
  const std::vector<Vec3> Normals; ///< of the silhouette's points
  IndexSet First;                  ///< nodes, and of each the silhouette's first point
  std::vector<Index> PointOfNode;
  IndexSet Used;
  SilhouetteGap Gap;
};
}

SilhouetteGap makeSilhouetteGap(
  const NearEnd& end, const SilhouetteInput& silhouette, const std::vector<Vec3>& normals)
{
  return GapBuilder(end, silhouette, turnedOutwards(end, silhouette, normals)).build();
}
}
