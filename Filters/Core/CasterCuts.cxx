#include "CasterCuts.h"

namespace shadow
{
namespace
{
using Corners = std::array<Vec3, 3>;

Corners cornersOf(const TriangleMesh& mesh, Index triangle)
{
  const Triangle& t = mesh.triangles[triangle];
  return { mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]] };
}

Box boxAround(const Corners& corners)
{
  Box box;
  for (const Vec3& corner : corners)
  {
    box.add(corner);
  }
  return box;
}

Box enlarged(Box box, double by)
{
  box.low -= Vec3(by);
  box.high += Vec3(by);
  return box;
}

std::vector<Corners> trianglesNear(const std::vector<ContourReceiver>& casters,
  const std::vector<ContourReceiver>& receivers, double touch)
{
  std::vector<Box> bounds;
  for (const ContourReceiver& receiver : receivers)
  {
    bounds.push_back(enlarged(receiver.mesh->bounds(), touch));
  }
  std::vector<Corners> near;
  for (const ContourReceiver& caster : casters)
  {
    for (std::size_t i = 0; i < caster.mesh->triangles.size(); ++i)
    {
      const Corners corners = cornersOf(*caster.mesh, static_cast<Index>(i));
      const Box box = boxAround(corners);
      if (std::any_of(
            bounds.begin(), bounds.end(), [&](const Box& around) { return around.meets(box); }))
      {
        near.push_back(corners);
      }
    }
  }
  return near;
}

BoxTree treeOf(const std::vector<Corners>& triangles)
{
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const Corners& corners : triangles)
  {
    boxes.push_back(boxAround(corners));
  }
  return BoxTree(boxes);
}
}

CasterCuts::CasterCuts(const std::vector<ContourReceiver>& casters,
  const std::vector<ContourReceiver>& receivers, double touch)
  : Triangles(trianglesNear(casters, receivers, touch))
  , Touch(touch)
  , Tree(treeOf(Triangles))
{
}

void CasterCuts::addCuts(
  const Corners& receiver, Index triangle, const Corners& caster, std::vector<CellCut>& cuts) const
{
  const Vec3 normal = unitOrZero(glm::cross(receiver[1] - receiver[0], receiver[2] - receiver[0]));
  if (normal == Vec3(0.0))
  {
    return;
  }
  // An edge that is the receiver's own is where a mesh that is both goes on.
  const auto isCorner = [&](const Vec3& point)
  { return std::find(receiver.begin(), receiver.end(), point) != receiver.end(); };
  std::array<double, 3> heights;
  std::array<bool, 3> isOn;
  for (unsigned k = 0; k < 3; ++k)
  {
    heights[k] = glm::dot(normal, caster[k] - receiver[0]);
    isOn[k] = std::fabs(heights[k]) <= this->Touch;
  }
  std::array<Vec3, 2> ends;
  std::size_t found = 0;
  for (unsigned k = 0; k < 3; ++k)
  {
    const unsigned other = next(k);
    if (isOn[k] && isOn[other] && !(isCorner(caster[k]) && isCorner(caster[other])))
    {
      cuts.push_back({ triangle, caster[k], caster[other], CasterMeets });
    }
    if (isOn[k] && found < 2)
    {
      ends[found++] = caster[k];
    }
    if (!isOn[k] && !isOn[other] && (heights[k] > 0.0) != (heights[other] > 0.0) && found < 2)
    {
      ends[found++] =
        glm::mix(caster[k], caster[other], heights[k] / (heights[k] - heights[other]));
    }
  }
  // With two corners in the plane it is the edge between them.
  if (found == 2 && isOn[0] + isOn[1] + isOn[2] < 2)
  {
    cuts.push_back({ triangle, ends[0], ends[1], CasterMeets });
  }
}

std::vector<CellCut> CasterCuts::cuts(const ReceiverView& receiver, const RangeLoop& loop) const
{
  const std::vector<Index>& lit = receiver.lit();
  std::vector<std::vector<CellCut>> found((lit.size() + lightGrain - 1) / lightGrain);
  loop(found.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block)
    {
      const std::size_t last = std::min(lit.size(), (block + 1) * lightGrain);
      for (std::size_t i = block * lightGrain; i < last; ++i)
      {
        const Corners corners = cornersOf(receiver.mesh(), lit[i]);
        Box box = boxAround(corners);
        box.low -= Vec3(this->Touch);
        box.high += Vec3(this->Touch);
        this->Tree.search([&](const Box& around) { return around.meets(box); },
          [&](Index caster) {
            this->addCuts(corners, lit[i], this->Triangles[caster], found[block]);
            return true;
          });
      }
    }
  });
  std::vector<CellCut> all;
  for (const std::vector<CellCut>& part : found)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}
}
