/// The coordinates in which what lies on one ray of a light is parallel.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// A frame for a light and a scene within some bounds. A point has a place in it, in which order
/// along the rays is told, and a view, a vector that is parallel for all points of a ray:
/// - Near, a light among the scene: both are the vector from the point to the light;
/// - Far, a light outside of the ball around the bounds: the place is taken about the bounds'
///   centre, along two axes across and one along the line to the light, so that it keeps its digits
///   however far the light; the view has the light's distance added. One chart sees all;
/// - Direction: the limit of that. Views are (x, y, 1).
/// Axes across are products of whole numbers where the light's coordinates are whole, so what is
/// exactly aligned in the world is so here. They are not of unit length.
///
/// In either space a triangle whose corners have a positive determinant faces the light, and seen
/// from it the place of what is farther lies on the negative side of what is nearer.
class LightFrame
{
public:
  LightFrame(const Light& light, const Box& bounds);

  Vec3 place(const Vec3& point) const;

  Vec3 view(const Vec3& place) const
  {
    return this->Kind == Kinds::Direction ? Vec3(place.x, place.y, 1.0)
                                          : Vec3(place.x, place.y, place.z + this->Distance);
  }

  /// Along the ray through a place, away from the light, of any length.
  Vec3 onward(const Vec3& place) const
  {
    return this->Kind == Kinds::Direction ? Vec3(0.0, 0.0, 1.0) : this->view(place);
  }

  Vec3 viewOf(const Vec3& point) const { return this->view(this->place(point)); }

  /// Whether all views within the bounds have a positive z.
  bool hasOneChart() const { return this->Kind != Kinds::Near; }

  /// Of the scene, in places: the radius of a ball around the bounds.
  double size() const { return this->Size; }

  /// How far off the coordinates of a place may be by rounding.
  double placeError() const { return this->Error; }

private:
  enum class Kinds
  {
    Near,
    Far,
    Direction
  };

  Kinds Kind;
  Vec3 Origin; ///< the light (Near), or the centre of the bounds
  Vec3 Across;
  Vec3 Up;
  Vec3 Along; ///< towards the light
  double Distance = 0.0;
  double Size = 0.0;
  double Error = 0.0;
};
}
