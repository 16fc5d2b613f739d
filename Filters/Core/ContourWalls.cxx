#include "ContourWalls.h"

#include "ExactSum.h"

namespace shadow
{
namespace
{
/// Whether the light, at the origin of views, is on the segment between two of them.
bool holdsLight(const Vec3& a, const Vec3& b)
{
  return glm::dot(a, b) <= 0.0 && crossSign(a.x, a.y, b.x, b.y) == 0 &&
    crossSign(a.y, a.z, b.y, b.z) == 0 && crossSign(a.z, a.x, b.z, b.x) == 0;
}
}

void ContourLoops::add(const std::vector<Vec3>& polyline, const std::vector<Vec3>& onMesh,
  bool isClosed, bool isOfEdges)
{
  this->ofEdges.push_back(isOfEdges);
  this->points.insert(this->points.end(), polyline.begin(), polyline.end());
  this->meshPoints.insert(this->meshPoints.end(), onMesh.begin(), onMesh.end());
  this->first.push_back(this->points.size());
  this->closed.push_back(isClosed);
}

ContourWalls::ContourWalls(const ContourLoops& loops, const LightFrame& frame, TreeBuilder builder)
  : Next(loops.points.size(), None)
  , IsEnd(loops.points.size(), false)
  , Loops(loops.points.size())
  , Charts(frame.hasOneChart())
  , Boxes(this->Charts.count())
  , Segments(this->Charts.count())
{
  const std::size_t count = loops.points.size();
  std::vector<Vec3> views;
  views.reserve(count);
  this->Places.reserve(count);
  for (const Vec3& point : loops.points)
  {
    this->Places.push_back(frame.place(point));
    views.push_back(frame.view(this->Places.back()));
  }
  this->Walls.reserve(count);
  for (std::size_t loop = 0; loop < loops.count(); ++loop)
  {
    const std::size_t begin = loops.first[loop];
    const std::size_t end = loops.first[loop + 1];
    for (std::size_t i = begin; i < end; ++i)
    {
      const bool isLast = i + 1 == end;
      const std::size_t to = isLast ? begin : i + 1;
      this->Loops[i] = static_cast<Index>(loop);
      this->Walls.emplace_back(views[i], views[to]);
      if (isLast && !loops.closed[loop])
      {
        continue;
      }
      this->Next[i] = static_cast<Index>(to);
      this->IsEnd[to] = true;
      if (this->LightPoint == None && holdsLight(views[i], views[to]))
      {
        this->LightPoint = static_cast<Index>(i);
      }
    }
  }
  std::vector<Box2> inTree;
  for (std::size_t chart = 0; chart < this->Charts.count(); ++chart)
  {
    this->Boxes[chart].resize(count);
    inTree.clear();
    for (std::size_t i = 0; i < count; ++i)
    {
      if (this->Next[i] == None)
      {
        continue;
      }
      const std::array<Vec3, 2> ends{ this->Walls[i].a, this->Walls[i].b };
      Box2& box = this->Boxes[chart][i];
      if (frame.hasOneChart())
      {
        box = LightCharts::boxOf(ends[0]);
        box.add(LightCharts::boxOf(ends[1]));
      }
      else
      {
        box = LightCharts::boxIn(chart, ends.data(), 2);
      }
      if (!isEmpty(box))
      {
        inTree.push_back(box);
        this->Segments[chart].push_back(static_cast<Index>(i));
      }
    }
    this->Trees.emplace_back(inTree, builder);
  }
}
}
