/**
 * @brief Shadows by ray casting (Embree): the oracle of visibility masks.
 *
 * The triangles are those that are drawn. Embree computes in float, in a scene that is moved to the
 * origin and scaled to 1; it only proposes hits. Hit points, and whether a triangle really stands
 * between a point and the light, are decided in double, so no offset is needed: a ray leaves the
 * triangle that it starts on by leaving that triangle out, and what it hits must lie in front of
 * its start. Rays may pass an edge within 4e-7 of the scene's size on either side, which keeps
 * closed surfaces tight.
 */
#ifndef shadowtest_RayCast_h
#define shadowtest_RayCast_h

#include "MeshBuilder.h"

#include <vtkImageData.h>

#include <array>
#include <memory>
#include <vector>

class vtkCamera;
class vtkMatrix4x4;

namespace shadowtest
{
/// What is drawn: polygons (convex ones, taken as fans), with the actor's matrix if it has one.
struct RayObject
{
  Mesh Surface;
  vtkMatrix4x4* Matrix = nullptr;
  bool Casts = true;
  bool Receives = true;
};

/// Homogeneous, as in vtkSmoothLightSilhouette.
using RayLight = std::array<double, 4>;

/// Where pixels look: pixel (0, 0) is the lower left one, as in vtkImageData and OpenGL.
struct RayView
{
  int Width = 0;
  int Height = 0;
  /// Row-major, from clip coordinates (-1..1 in x, y, z) to the world.
  double ClipToWorld[16];

  static RayView fromCamera(vtkCamera* camera, int width, int height);
};

enum class Visibility : unsigned char
{
  Background, ///< nothing is hit
  Lit,
  Shadow,    ///< the side that is seen faces the light, something stands between
  TurnedAway ///< the side that is seen faces away from the light, or is exactly edge-on to it:
             ///< dark whatever the mask says
};

struct RaySample
{
  int Object = -1;
  vtkIdType Cell = -1;
  Vec3 Point{ 0.0, 0.0, 0.0 };
  Visibility Light = Visibility::Background;
  /// |cosine| between the triangle's normal and the direction to the light: 0 seen edge-on from it.
  double Cosine = 1.0;
};

/// One light's picture, row by row from below.
struct RayPicture
{
  int Width = 0;
  int Height = 0;
  std::vector<RaySample> Samples;

  const RaySample& at(int x, int y) const
  {
    return this->Samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(this->Width) +
      static_cast<std::size_t>(x)];
  }

  /// 255 where lit or background, 0 elsewhere; the format of vtkStencilShadowPass::GetMask.
  vtkSmartPointer<vtkImageData> mask() const;
};

class RayScene
{
public:
  explicit RayScene(const std::vector<RayObject>& objects);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// What is seen at (x, y), in pixels; the middle of pixel (i, j) is (i + 0.5, j + 0.5). Facing
  /// and blocking are those of the flat triangles.
  RaySample look(const RayView& view, double x, double y, const RayLight& light) const;

  RayPicture render(const RayView& view, const RayLight& light) const;

  /// Whether something that casts is between a point anywhere and the light.
  bool isBlocked(const Vec3& point, const RayLight& light) const;

  int objectCount() const;

private:
  class Internals;
  std::unique_ptr<Internals> Internal;
};
}

#endif
