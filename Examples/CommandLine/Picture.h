/**
 * Meshes, ground, lights and camera in a VTK window, drawn with or without the shadow pass.
 */
#ifndef Picture_h
#define Picture_h

#include "Scene.h"

#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkStencilShadowPass.h>
#include <vtkTable.h>

#include <string>
#include <vector>

/// What the shadows are to be, as vtkStencilShadowPass has it.
struct ShadowOptions
{
  std::string Kind = "auto"; ///< auto, smooth, accurate or discrete; none: no shadows
  double PixelTolerance = 0.5;
  std::string Counting = "auto"; ///< auto, zpass or zfail
  bool Plan = false; ///< nothing is taken over from the frame before, and each step is timed
};

class Picture
{
public:
  /// `window` is a name that vtkOffscreenWindows knows. `size` is in pixels to draw. Throws Failure
  /// where there is no such window here.
  Picture(const std::string& window, const std::array<int, 2>& size);

  /// Both after the window's start, as the renderer is cleared with it.
  void AddMeshes(const std::vector<vtkPolyData*>& meshes);
  void AddScene(const Scene& scene, bool ground);

  /// Draws shadows from here on; without this call there are none.
  void CastShadows(const ShadowOptions& options);

  /// What was done for each light and caster in the last frame, as vtkStencilShadowPass tells; null
  /// without shadows.
  vtkSmartPointer<vtkTable> Plan();

  /// Draws a frame to its end and gives the milliseconds that it took. Prints a warning where VTK
  /// gives one; throws Failure.
  double Draw();

  /// Moves each light a little; step 0 is its place in the scene.
  void MoveLights(const Scene& scene, double size, int step);

  /// The last frame, RGB.
  vtkSmartPointer<vtkImageData> Image();

  /// Visibility of light i in the last frame: 255 where it is visible, 0 in its shadow.
  vtkSmartPointer<vtkImageData> Mask(std::size_t light);

  /// OpenGL's name of what draws.
  std::string GraphicsName();

private:
  void AddFillLight();

  std::string WindowName;
  std::array<int, 2> Size;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkStencilShadowPass> Pass;
  std::vector<vtkSmartPointer<vtkLight>> Lights;
};

#endif
