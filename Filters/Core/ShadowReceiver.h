/// How far a curve's shadow is from its chord's, on what receives it.
#pragma once

#include "CubicCurve.h"

namespace shadow
{
/// The bounds of the receivers of one light's shadow. A shadow is measured on that face of the
/// bounds through which its ray leaves them: what is nearer to the light sees it smaller.
class ShadowReceiver
{
public:
  ShadowReceiver(const Light& light, const Vec3& low, const Vec3& high);

  /// No point of the curve has its shadow farther than this from the shadow of the curve's chord
  /// (world units). 0 where the whole curve's shadow misses the bounds, or they lie before it.
  /// Infinite where the curve is too long to tell: its parts are not.
  double deviationBound(const CubicCurve& curve) const;

private:
  struct Face
  {
    Vec3 normal; ///< outwards
    double offset;
  };

  /// A face and the control points of a curve. The larger `nearness` is, the sooner a point's ray
  /// comes to the face; being linear in the point it is bounded by its values at the control
  /// points.
  struct Meeting
  {
    std::array<double, 4> nearness;
    bool leaves = true; ///< all rays leave through the face's plane
    bool enters = true; ///< all rays that come in come through it

    double least() const;
    double most() const;
  };

  Meeting meet(const Face& face, const CubicCurve& curve) const;
  double deviationOn(const Face& face, const CubicCurve& curve) const;

  Light TheLight;
  std::array<Face, 6> Faces;
};
}
