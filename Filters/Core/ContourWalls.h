/// Silhouettes as walls of shadow, to be searched for in the light's charts.
#pragma once

#include "ContourSigns.h"
#include "LightCharts.h"
#include "LightFrame.h"

namespace shadow
{
/// Silhouettes as polylines. Seen from the light, what casts is on the left.
struct ContourLoops
{
  std::vector<Vec3> points;            ///< loop after loop, the first of a closed one not repeated
  std::vector<Vec3> meshPoints;        ///< of the mesh that casts, those that belong to points
  std::vector<std::size_t> first{ 0 }; ///< where each loop begins, and the end
  std::vector<bool> closed;            ///< of each loop
  std::vector<bool> ofEdges;           ///< its segments are edges of the mesh that casts

  std::size_t count() const { return this->closed.size(); }
  void add(const std::vector<Vec3>& polyline, const std::vector<Vec3>& onMesh, bool isClosed,
    bool isOfEdges);
};

/// A segment has the number of the point at which it starts. Points at which none starts (the ends
/// of open loops) have none.
class ContourWalls
{
public:
  ContourWalls(const ContourLoops& loops, const LightFrame& frame, TreeBuilder builder);

  /// Whether the light is on a segment, which then has no wall.
  bool touchesLight() const { return this->LightPoint != None; }
  /// The start of that segment.
  Index lightPoint() const { return this->LightPoint; }

  bool hasSegment(Index point) const { return this->Next[point] != None; }
  Index next(Index point) const { return this->Next[point]; }
  /// Whether a segment ends at a point.
  bool isEnd(Index point) const { return this->IsEnd[point]; }
  std::size_t pointCount() const { return this->Next.size(); }

  const WallPlane& wall(Index segment) const { return this->Walls[segment]; }
  const Vec3& place(Index point) const { return this->Places[point]; }
  Index loopOf(Index point) const { return this->Loops[point]; }

  const LightCharts& charts() const { return this->Charts; }
  const Box2& box(std::size_t chart, Index segment) const { return this->Boxes[chart][segment]; }

  /// Calls visit(segment) for each segment whose box in a chart meets the given one.
  template <class Visit>
  void search(
    std::size_t chart, const Box2& box, TreeVisits& visits, const Visit& visit) const
  {
    this->Trees[chart].search(box, visits,
      [&](Index item)
      {
        visit(this->Segments[chart][item]);
        return true;
      });
  }

private:
  std::vector<Index> Next;
  std::vector<bool> IsEnd;
  std::vector<Index> Loops;
  std::vector<Vec3> Places;
  std::vector<WallPlane> Walls;
  LightCharts Charts;
  std::vector<std::vector<Box2>> Boxes;     ///< by chart, of each segment
  std::vector<std::vector<Index>> Segments; ///< by chart, of the tree's items
  std::vector<BoundingTree2> Trees;
  Index LightPoint = None;
};
}
