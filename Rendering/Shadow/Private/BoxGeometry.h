/**
 * Boxes as their corners, and rays from a light through them.
 */
#ifndef BoxGeometry_h
#define BoxGeometry_h

#include "PointArithmetic.h"

#include <array>
#include <utility>

/**
 * The corners of a box, which may have been turned and sheared. Bit k of a corner's number says on
 * which side it is along the box's axis k.
 */
using BoxCorners = std::array<Point3, 8>;

/**
 * The corners of bounds in VTK's order (xmin, xmax, ymin, ...), moved by a matrix.
 */
BoxCorners CornersOf(const std::array<double, 6>& bounds, const Matrix4& toWorld);

/**
 * Corners that an edge joins.
 */
extern const std::array<std::pair<int, int>, 12> BoxEdges;

/**
 * The corner of a face and the far ends of its two edges from there.
 */
struct BoxFace
{
  int Corner;
  int First;
  int Second;

  /**
   * A corner of the opposite face.
   */
  int Opposite;
};
extern const std::array<BoxFace, 6> BoxFaces;

/**
 * The plane of a face, positive inside of the box; all zero or rounding if the face has no area or
 * the box no depth behind it.
 */
Point4 FacePlane(const BoxCorners& box, const BoxFace& face);

Point3 MiddleOf(const BoxCorners& box);
double DiagonalOf(const BoxCorners& box);
bool AllBehind(const Point4& plane, const BoxCorners& box);

/**
 * From a homogeneous light on through a point, not normalised: the place that is t further is
 * point + t * ray, and a step of the point makes one there that is 1 + t * light[3] times as long.
 */
Point3 RayOf(const Point4& light, const Point3& point);

/**
 * The t at which a ray from a point on the inner side of a plane comes to it; infinite if it does
 * not.
 */
double StepsToPlane(const Point4& plane, const Point3& point, const Point3& ray);

#endif
