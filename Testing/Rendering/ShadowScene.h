/**
 * @brief Small scenes with the pass in them, and what windows, pictures and masks of them are like.
 */
#ifndef shadowtest_ShadowScene_h
#define shadowtest_ShadowScene_h

#include "RayCast.h"
#include "TestMeshes.h"

#include "vtkStencilShadowPass.h"

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace shadowtest
{
using Image = vtkSmartPointer<vtkImageData>;

/// Two lights from above that cast shadows of what is near the origin onto the ground.
constexpr RayLight PointLight = { 1.5, 1.0, 4.0, 1.0 };
constexpr RayLight DirectionalLight = { 2.0, 1.0, 4.0, 0.0 };

/// An offscreen window without multisampling, of a size in pixels: the one that the environment's
/// SMOOTHSHADOW_WINDOW names, or else the kind that this executable was made for. Throws
/// std::runtime_error, with the reason, if there is none.
vtkSmartPointer<vtkRenderWindow> MakeWindow(int width, int height);

/// What the window shows, without rendering again: RGB of unsigned char, lower left pixel first.
Image Grab(vtkRenderWindow* window);

/// A component of a pixel of a picture or mask of unsigned char.
unsigned char Byte(vtkImageData* image, int x, int y, int component = 0);

/// Number of pixels that differ at all; see compareImages.
long Differences(vtkImageData* a, vtkImageData* b);

/// An actor with VTK's default properties.
vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* mesh);

/// A scene light that shines in all directions from a place, or, if w = 0, along a direction.
vtkSmartPointer<vtkLight> MakeLight(const RayLight& position, double intensity = 1.0);

/// A box over the ground, turned.
Mesh FloatingBox();

/**
 * A renderer that draws with the pass (discrete shadows) the ground z = 0, |x|, |y| <= 4, seen from
 * above. It has no lights and nothing on the ground yet.
 */
struct Scene
{
  /// What actors are made of.
  static constexpr double Red = 1.0;
  static constexpr double Green = 0.9;
  static constexpr double Blue = 0.8;
  static constexpr double Ambient = 0.125;
  static constexpr double Diffuse = 0.75;

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkStencilShadowPass> Pass;
  Mesh GroundMesh = ground(0.0, 4.0, 3);
  vtkSmartPointer<vtkActor> Ground;

  Scene();

  /// An actor of the colour and with the shares of ambient and diffuse light above.
  vtkSmartPointer<vtkActor> Add(vtkPolyData* mesh);

  /// See MakeLight.
  vtkSmartPointer<vtkLight> AddLight(const RayLight& position, double intensity = 1.0);

  /// A light that moves with the camera; it casts no shadows.
  vtkSmartPointer<vtkLight> AddHeadlight(double intensity);

  /// Looks from a place at (0, 0, 0.5), z upwards; clipping planes at 0.5 and 40.
  void Look(double x, double y, double z);

  /// The light's mask in the last picture; null if it cast no shadows.
  Image Mask(vtkLight* light);
};

/// Where the pixels of a mask or picture of the renderer look.
RayView ViewOf(vtkRenderer* renderer, vtkImageData* image);

/// Expects no pixel of the light's mask to be wrong beyond one pixel of a true edge, by the ray
/// cast of `objects`, and some shadow at all. `what` goes into messages.
void ExpectMask(Scene& scene, vtkLight* light, const RayLight& position,
  const std::vector<RayObject>& objects, const char* what);
}

#endif
