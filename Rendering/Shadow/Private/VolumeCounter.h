/**
 * Counts shadow volumes in the stencil buffer and turns the counts into a mask.
 *
 * z-fail: behind each pixel's surface, back faces count 1 and front faces -1. What remains is how
 * many volumes the surface lies in, wherever the eye is.
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
   * Sets the state for calls of Count, where `toClip` takes the mesh to clip coordinates.
   */
  void BeginCounting(vtkOpenGLState* state);
  void Count(const VolumeBuffers& volume, const Matrix4& toClip);

  /**
   * Draws 0 into the writable channels wherever the count is not 0, but not on the background.
   */
  void WriteMask(vtkOpenGLState* state);

private:
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkShaderProgram* CountProgram = nullptr;
  vtkShaderProgram* MaskProgram = nullptr;
  unsigned int Attribute = 0;
  unsigned int EmptyVertexArray = 0;
};

#endif
