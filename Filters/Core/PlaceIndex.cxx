#include "PlaceIndex.h"

#include <algorithm>
#include <numeric>

namespace shadow
{
namespace
{
bool isBefore(const Vec3& p, const Vec3& q)
{
  return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
}
}

PlaceIndex::PlaceIndex(const TriangleMesh& mesh)
  : Normals(mesh.normals.size())
{
  const auto place = [&](Index n) -> const Vec3& { return mesh.points[mesh.normalVertex[n]]; };
  std::iota(this->Normals.begin(), this->Normals.end(), Index(0));
  std::sort(this->Normals.begin(), this->Normals.end(),
    [&](Index l, Index r)
    { return place(l) == place(r) ? l < r : isBefore(place(l), place(r)); });
}

Index PlaceIndex::firstNormalAt(const TriangleMesh& mesh, const Vec3& place) const
{
  const auto found = std::lower_bound(this->Normals.begin(), this->Normals.end(), place,
    [&](Index n, const Vec3& p) { return isBefore(mesh.points[mesh.normalVertex[n]], p); });
  return found != this->Normals.end() && mesh.points[mesh.normalVertex[*found]] == place ? *found
                                                                                          : None;
}
}
