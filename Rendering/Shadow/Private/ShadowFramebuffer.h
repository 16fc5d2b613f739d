/**
 * What the pass draws into before the delegate draws: depth and stencil of the renderer's size,
 * and one mask per casting light.
 *
 * Counts of shadow volumes go into the stencil or, where 8 bits may not do, into floats.
 *
 * A mask is a channel of a layer of one RGBA8 array texture, so that any number of lights costs
 * the mappers' shaders a single texture unit. Depth and stencil are one buffer: drivers need not
 * support them apart.
 */
#ifndef ShadowFramebuffer_h
#define ShadowFramebuffer_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;
class vtkOpenGLState;

class ShadowFramebuffer
{
public:
  static constexpr int ChannelsPerLayer = 4;

  static int LayersFor(int masks) { return (masks + ChannelsPerLayer - 1) / ChannelsPerLayer; }

  /**
   * Makes everything anew if size or number of masks changed. On failure says why in `error`,
   * keeps nothing and returns false.
   */
  bool Allocate(vtkOpenGLState* state, int width, int height, int masks, std::string& error);

  /**
   * Whether Allocate has nothing to make anew, so that what was drawn is still there.
   */
  bool Fits(int width, int height, int masks) const;

  void Release();

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }

  /**
   * Binds the buffers without any colour, which are then safe to draw into with the masks'
   * texture bound, and clears them.
   */
  void BeginDepth(vtkOpenGLState* state);

  /**
   * Binds the buffers with one mask's layer as colour and clears the stencil. The first mask of a
   * layer makes the whole layer visible.
   */
  void BeginMask(vtkOpenGLState* state, int mask);

  /**
   * Binds the buffers with the counts as colour, which are made when first asked for, and clears
   * these: for counts that a stencil buffer has too few bits for. On failure says why in `error`
   * and returns false.
   */
  bool BeginCounts(vtkOpenGLState* state, std::string& error);

  /**
   * Binds that mask's layer, as BeginMask left it, and makes its channel the only one that can be
   * written.
   */
  void OpenMask(vtkOpenGLState* state, int mask);

  /**
   * Binds the masks to a texture unit, or frees that unit of them.
   */
  void BindMasks(vtkOpenGLState* state, int unit) const;
  static void UnbindMasks(vtkOpenGLState* state, int unit);

  /**
   * The counts: one component of float, to be fetched as the texture it is.
   */
  unsigned int GetCounts() const { return this->Counts; }

  /**
   * One component, unsigned char. Null if nothing is allocated.
   */
  vtkSmartPointer<vtkImageData> ReadMask(vtkOpenGLState* state, int mask) const;

private:
  bool Create(vtkOpenGLState* state, std::string& error);
  bool CreateCounts(vtkOpenGLState* state, std::string& error);
  void ReleaseCounts();

  int Width = 0;
  int Height = 0;
  int Layers = 0;
  unsigned int DepthStencil = 0;
  unsigned int Masks = 0;
  unsigned int DepthTarget = 0;
  unsigned int MaskTarget = 0;
  unsigned int Counts = 0;
  unsigned int CountTarget = 0;
};

#endif
