/**
 * @brief True outlines of sphere, ellipsoid and torus, and how far a silhouette's shadow is off.
 *
 * A light is homogeneous (l, w), as in vtkSmoothLightSilhouette. The receiver is a plane behind the
 * shape, not parallel to a light ray that touches it. An error is the distance, on the plane, from
 * the shadow of a point of the silhouette to the nearest point of the true shadow's boundary.
 */
#ifndef shadowtest_AnalyticShadow_h
#define shadowtest_AnalyticShadow_h

#include "MeshBuilder.h"

#include <array>
#include <memory>
#include <vector>

class vtkPolyData;

namespace shadowtest
{
using LightPoint = std::array<double, 4>;

struct Plane
{
  Vec3 Origin;
  Vec3 Normal;
};

/// Where the light's ray through a point meets the plane.
Vec3 shadowOn(const Plane& plane, const LightPoint& light, const Vec3& point);

struct BoundaryDistance
{
  /// Not: the point is near a cusp of the boundary (see tolerance::CuspRadialCurvature), where the
  /// boundary turns back and has no tangent.
  bool Valid = true;
  /// Newton's iteration ended at the boundary. If not, Value is not to be used.
  bool Converged = true;
  double Value = 0.0;
};

/// The shadow of a shape by one light on one plane.
class AnalyticShadow
{
public:
  virtual ~AnalyticShadow() = default;

  /// From the shadow of a point on or near the shape's silhouette to the true boundary.
  virtual BoundaryDistance distance(const Vec3& nearSilhouette) const = 0;

  /// Points of the exact silhouette on the shape, about `count` of them.
  virtual std::vector<Vec3> contour(int count) const = 0;
};

/// Half axes along x, y and z; a sphere has three equal ones. The boundary is a conic: the section
/// of the plane with the tangent cone of the light.
std::unique_ptr<AnalyticShadow> ellipsoidShadow(
  const double halfAxes[3], const LightPoint& light, const Plane& receiver);

/// Torus around z. Points of the contour have two exact positions across the tube for each angle
/// around the ring; the nearest boundary point is found from there by Newton's iteration.
std::unique_ptr<AnalyticShadow> torusShadow(
  double radius, double tube, const LightPoint& light, const Plane& receiver);

/// How many cusps the torus's outline has as seen from the light, hidden ones too: where the radial
/// curvature changes sign along the exact contour. The light is off the ring's level:
/// |light[2]| > w tube.
int torusCusps(double radius, double tube, const LightPoint& light);

/// Whether the ellipsoid stands between a point and the light.
bool ellipsoidHides(const double halfAxes[3], const Vec3& point, const LightPoint& light);

struct ShadowError
{
  double Largest = 0.0;
  double RootMeanSquare = 0.0;
  long Samples = 0; ///< that were measured
  long LeftOut = 0; ///< near cusps
  long Failed = 0;  ///< Newton did not converge; a test wants 0 of these
};

/// Error of all polylines of a silhouette, measured at its points and at `samplesPerChord` further
/// places inside of each chord.
ShadowError shadowError(
  vtkPolyData* silhouette, const AnalyticShadow& shadow, int samplesPerChord = 4);

/// The p of error = c h^p: least squares of log(error) over log(h). Needs two different h.
double fitOrder(const std::vector<double>& h, const std::vector<double>& error);
}

#endif
