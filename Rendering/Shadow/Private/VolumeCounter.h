/**
 * Counts shadow volumes and turns the counts into a mask. Counting is done by the stencil, whose 8
 * bits take 256 for 0, or, where there may be as many volumes, by blending floats, which is exact
 * up to 2^24 and dearer.
 *
 * z-fail: behind each pixel's surface, back faces count 1 and front faces -1. What remains is how
 * many volumes the surface lies in, wherever the eye is. z-pass: in front of it, front faces count 1
 * and back faces -1, which is the same if the eye is in none and the near plane cuts none. Caps lie on
 * surfaces or behind them, and so are not counted there, nor are far ends.
 */
#ifndef VolumeCounter_h
#define VolumeCounter_h

#include "Matrix4.h"

#include <string>

class VolumeBuffers;
class vtkOpenGLRenderWindow;
class vtkOpenGLState;
class vtkShaderProgram;

class VolumeCounter
{
public:
  /**
   * Readies the programs. If one does not compile, says so in `error` and returns false.
   */
  bool Prepare(vtkOpenGLRenderWindow* window, std::string& error);

  /**
   * Forgets the programs, which belong to the window's cache.
   */
  void Release();

  /**
   * Where the counting program takes its vertices.
   */
  unsigned int GetAttribute() const { return this->Attribute; }

  /**
   * The greatest depth of volumes that the stencil counts. It is half of what 8 bits hold, as
   * layers of caps that face away from the light may count on top, see
   * vtkShadowVolumeExtruder's GreatestDepth.
   */
  static constexpr int GreatestStencilDepth = 127;

  /**
   * Sets the state for calls of Count: into the stencil of the framebuffer that is bound, or into
   * its colour.
   */
  void BeginCountingInStencil(vtkOpenGLState* state);
  void BeginCountingInFloats(vtkOpenGLState* state);

  /**
   * `ToClip` takes the mesh to clip coordinates; the light and the plane at which the volume ends (all
   * zero: at infinity) are in the mesh's. DepthRange holds the window depths of all its points.
   */
  struct Placement
  {
    Matrix4 ToClip;
    std::array<double, 4> Light;
    std::array<double, 4> End;
    std::array<double, 2> DepthRange;
  };
  void Count(vtkOpenGLState* state, const VolumeBuffers& volume, const Placement& placement,
    bool zPass);

  /**
   * To be called after the last Count.
   */
  void EndCounting(vtkOpenGLState* state);

  /**
   * Draws 0 into the writable channels wherever the count is not 0, but not on the background.
   * For counts in floats `unit` is the texture unit that is free to read `counts` with.
   */
  void WriteMaskOfStencil(vtkOpenGLState* state);
  void WriteMaskOfFloats(vtkOpenGLState* state, unsigned int counts, int unit);

private:
  void BeginCounting(vtkOpenGLState* state);
  void SetMethod(vtkOpenGLState* state, bool zPass);
  void DrawFarEnd(const VolumeBuffers& volume);
  void WriteMask(vtkOpenGLState* state, vtkShaderProgram* program);

  vtkOpenGLRenderWindow* Window = nullptr;
  vtkShaderProgram* CountProgram = nullptr;
  vtkShaderProgram* MaskProgram = nullptr;
  vtkShaderProgram* CountsMaskProgram = nullptr;
  unsigned int Attribute = 0;
  unsigned int EmptyVertexArray = 0;
  bool InFloats = false;
};

#endif
