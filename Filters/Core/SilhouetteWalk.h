/// Walks over the mesh towards the silhouette.
#pragma once

#include "SilhouetteFollower.h"

namespace shadow
{
/// Triangles that one walk has seen are left out by the next ones.
class SilhouetteWalk
{
public:
  SilhouetteWalk(
    SilhouetteFollower& follower, const SearchedMesh& searched, const Light& light, FieldKind kind)
    : Follower(follower)
    , Searched(searched)
    , Field(searched.mesh, light, kind)
  {
  }

  /// From a triangle always on to the one nearest to a field of zero among all that are next to
  /// those it was at, until the follower finds something: true, or `budget` triangles were seen. Of
  /// equal values the latest is taken, which crosses a flat region straight. O(budget log budget),
  /// if edges have few sides.
  bool walkFrom(Index start, std::size_t budget);

  /// Triangles at which walks were; if it is all of them, nothing can have been missed.
  std::size_t visited() const { return this->Visited; }

private:
  /// Values in float, so that rounding does not tell apart the values on a flat region.
  struct Step
  {
    float distance;
    Index order;
    Index triangle;

    /// Whether it comes after another one.
    bool operator<(const Step& o) const
    {
      return this->distance != o.distance ? this->distance > o.distance : this->order < o.order;
    }
  };

  float distanceToZero(Index triangle) const;
  void offer(Index triangle);

  SilhouetteFollower& Follower;
  const SearchedMesh Searched;
  const LightField Field;
  IndexSet Seen;
  std::vector<Step> Front; ///< a heap
  std::size_t Visited = 0;
};
}
