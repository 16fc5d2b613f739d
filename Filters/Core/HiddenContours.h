/// Which parts of cast contours are in the shadow of something else.
#pragma once

#include "ChordVertices.h"
#include "ContourLines.h"

namespace shadow
{
/// Which triangles of a mesh count that is closed: whose edges all have two sides that run against
/// each other. Of any other mesh all do.
enum class BlockerSides
{
  Needed, ///< those that face the light: a ray into the mesh meets one of them first
  All     ///< for obstructions: so a mesh around the light blocks too
};

/// What is between a point and the light.
enum class Obstruction
{
  None,
  /// Nothing but what is around segments of silhouettes (ChordVertices), or between segments and
  /// their chords on the mesh: which side of the contour the point is on is to tell.
  Around,
  Other
};

/// Triangles that cast, to be searched for in the light's charts.
class ContourBlockers
{
public:
  ContourBlockers(const std::vector<ContourReceiver>& casters, const ContourLoops& loops,
    const Light& light, const LightFrame& frame, BlockerSides sides, const RangeLoop& loop);

  /// Where triangles are between the light and pieces, which are straight lines on a receiver. A
  /// piece lies where the shadow of its own segment ends; so it is looked at as if it were moved by
  /// a share of 1e-9 of the scene to the side that is lit, and there every triangle hides what is
  /// behind it: the hidden parts are the union of what triangles cut from the line, whatever
  /// touches or pierces whatever.
  ///
  /// What is around a segment (ChordVertices) does not hide its contour.
  HiddenSpans hiddenSpans(const std::vector<ContourPiece>& pieces,
    const std::vector<PieceLine>& straight, const ContourWalls& walls, const RangeLoop& loop) const;

  /// What the ray from a point to the light meets. Triangles that share an edge leave no gap
  /// between them; what is nearer to the point than a share of 1e-9 of the scene, measured across
  /// the triangle, does not count.
  Obstruction obstructionOf(const Vec3& point) const;

private:
  struct Blocker
  {
    std::array<Vec3, 3> edges; ///< cross products of its views: a view within it is positive to all
    Vec3 permanent;            ///< their sum with all products positive
    Vec3 normal;               ///< away from the light, of places
    double offset;             ///< of the plane
    Triangle vertices;         ///< in numbers over all casters; None: between segment and chord

    /// Of a triangle so tiny or thin that its sides are all rounding any view may seem to be within
    /// it.
    bool isRounding(const Vec3& view) const;
  };
  struct MovedPiece;

  void addCaster(
    const ContourReceiver& caster, Index firstVertex, BlockerSides sides, const RangeLoop& loop);
  void addGaps(const ContourLoops& loops);
  template <class BoxIn>
  void addBlocker(std::array<Vec3, 3> places, const Triangle& vertices, const BoxIn& boxIn);
  /// Around up to three views.
  Box2 boxOf(std::size_t chart, const Vec3* views, std::size_t count) const;
  MovedPiece moved(const PieceLine& line, const WallPlane& wall, Index segment) const;
  void addSpan(const MovedPiece& piece, const Blocker& blocker,
    std::vector<std::array<double, 2>>& spans) const;
  void findSpans(const MovedPiece& piece, std::vector<std::array<double, 2>>& spans) const;

  const LightFrame& Frame;
  ChordVertices Around;
  LightCharts Charts;
  std::vector<Blocker> Blockers;
  std::vector<std::vector<Box2>> Boxes; ///< by chart, of the tree's items
  std::vector<std::vector<Index>> Items;
  std::vector<BoundingTree2> Trees;
};
}
