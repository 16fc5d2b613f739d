#include "BoxGeometry.h"

#include <algorithm>
#include <limits>

using namespace PointArithmetic;

const std::array<std::pair<int, int>, 12> BoxEdges = { { { 0, 1 }, { 2, 3 }, { 4, 5 }, { 6, 7 },
  { 0, 2 }, { 1, 3 }, { 4, 6 }, { 5, 7 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } } };

const std::array<BoxFace, 6> BoxFaces = { { { 0, 2, 4, 1 }, { 1, 3, 5, 0 }, { 0, 1, 4, 2 },
  { 2, 3, 6, 0 }, { 0, 1, 2, 4 }, { 4, 5, 6, 0 } } };

BoxCorners CornersOf(const std::array<double, 6>& bounds, const Matrix4& toWorld)
{
  BoxCorners corners;
  for (std::size_t i = 0; i < 8; ++i)
  {
    const Point4 corner =
      Multiply(toWorld, { bounds[i & 1], bounds[2 + (i >> 1 & 1)], bounds[4 + (i >> 2 & 1)], 1.0 });
    corners[i] = { corner[0] / corner[3], corner[1] / corner[3], corner[2] / corner[3] };
  }
  return corners;
}

Point4 FacePlane(const BoxCorners& box, const BoxFace& face)
{
  const auto corner = [&](int number) -> const Point3& {
    return box[static_cast<std::size_t>(number)];
  };
  const Point3& at = corner(face.Corner);
  const Point4 plane = PlaneThrough(at, Cross(corner(face.First) - at, corner(face.Second) - at));
  return Height(plane, corner(face.Opposite)) < 0.0 ? -plane : plane;
}

Point3 MiddleOf(const BoxCorners& box)
{
  Point3 middle{};
  for (const Point3& corner : box)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      middle[axis] += corner[axis] / 8.0;
    }
  }
  return middle;
}

double DiagonalOf(const BoxCorners& box)
{
  return std::max(std::max(Length(box[7] - box[0]), Length(box[6] - box[1])),
    std::max(Length(box[5] - box[2]), Length(box[4] - box[3])));
}

bool AllBehind(const Point4& plane, const BoxCorners& box)
{
  return std::all_of(
    box.begin(), box.end(), [&](const Point3& point) { return Height(plane, point) < 0.0; });
}

Point3 RayOf(const Point4& light, const Point3& point)
{
  return { light[3] * point[0] - light[0], light[3] * point[1] - light[1],
    light[3] * point[2] - light[2] };
}

double StepsToPlane(const Point4& plane, const Point3& point, const Point3& ray)
{
  const double toward = plane[0] * ray[0] + plane[1] * ray[1] + plane[2] * ray[2];
  const double height = Height(plane, point);
  return toward < 0.0 && height > 0.0 ? -height / toward : std::numeric_limits<double>::infinity();
}
