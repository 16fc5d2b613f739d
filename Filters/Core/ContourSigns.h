/// On which side what lies as seen from the light: all decisions that a cast contour's topology
/// rests on.
///
/// Points are given as vectors h from which the light's frame has been taken (LightFrame): what is
/// on one ray is parallel, and h is affine in the point. Every sign is that of a determinant
/// det(ha, hb, hx), exactly.
///
/// **The tie rule.** Where a determinant is exactly zero all receivers are taken to be shifted by
/// (e, e^2, e^3) in this frame, and all silhouettes by f (1, k, k^2), where each of k, e and f is
/// smaller than any power of the one before, and all are as good as zero. The first term of the
/// determinant that is not zero then decides, so all signs are those of one arrangement without
/// ties, and agree with each other whatever the scene. The second shift is for point lights alone:
/// an edge that is parallel to the ray through a silhouette's vertex stays so when it is shifted. A
/// determinant that is zero whatever the shifts (of a segment or an edge of no length) is positive.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// A determinant and the sign that it counts with, 1 or -1.
struct ContourSide
{
  double value; ///< of the exact sign, so that ratios are safe; 0 for a tie
  int sign;
};

/// The plane through the light and a silhouette's segment from a to b. What is shadowed by the
/// surface that the segment bounds is on its positive side.
struct WallPlane
{
  WallPlane(const Vec3& start, const Vec3& end);

  Vec3 a;
  Vec3 b;
  Vec3 normal;    ///< a x b, in double
  Vec3 permanent; ///< the same with all products positive
};

/// The side of a receiver's vertex.
ContourSide sideOfWall(const WallPlane& wall, const Vec3& x);

/// The side of the plane through the light and a receiver's edge from x to y on which a vertex a of
/// a silhouette is. The ends must be given in the same order whenever the edge is asked for.
ContourSide sideOfEdge(const Vec3& x, const Vec3& y, const Vec3& a);

/// 1 for a receiver's triangle that turns counter-clockwise in the light's view, -1 for one that
/// turns clockwise, by the same rule; 0 for one without area.
int turnOf(const Vec3& x, const Vec3& y, const Vec3& z);
}
