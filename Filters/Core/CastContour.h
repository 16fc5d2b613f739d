/// Cast-shadow contours: the curves on receivers where shadows begin.
#pragma once

#include "ContourStitching.h"

namespace shadow
{
/// What a contour's line is part of.
struct ContourLine
{
  Index receiver; ///< number of the receiver that it lies on
  Index loop;     ///< and of the silhouette's loop that casts it
  bool closed;
  bool visible; ///< nothing else is between it and the light
};

/// Lines with the shadow on their left as seen from the light. A closed line's first point is not
/// repeated.
struct CastContours
{
  std::vector<Vec3> points;
  std::vector<Vec3> normals;    ///< of the receiver, unit; at an edge the mean of both sides'
  std::vector<Vec3> directions; ///< in the receiver, into the shadow, unit
  std::vector<Vec3> casters;    ///< the points of the silhouettes that cast them
  std::vector<std::size_t> first{ 0 }; ///< where each line begins, and the end
  std::vector<ContourLine> lines;
};

struct ContourTimes
{
  double build = 0.0; ///< seconds for the tree over the silhouettes
  double query = 0.0; ///< for the pieces and their joining
  double hidden = 0.0;
};

struct ContourReport
{
  std::size_t loose = 0; ///< as in ContourChains
  TreeVisits visits;
  ContourTimes seconds;
  /// Where the light is on a silhouette, which casts no shadow then: the point at which that
  /// segment starts. There are no contours in this case.
  Index lightPoint = None;
};

/// What casts contours on what.
struct ContourScene
{
  ContourLoops loops;
  std::vector<ContourReceiver> receivers;
  std::vector<ContourReceiver> casters; ///< that hide contours; none: all are visible
  Light light;
};

struct ContourSettings
{
  TreeBuilder builder = TreeBuilder::Morton;
  bool keepHidden = false; ///< as lines of their own
};

/// Where the walls of shadow behind the loops meet the receivers. Same bytes whatever the threads.
CastContours castContours(const ContourScene& scene, const ContourSettings& settings,
  const RangeLoop& loop, ContourReport& report);
}
