/**
 * Takes note of all OpenGL state that the pass sets, and sets it back in its destructor.
 *
 * What vtkOpenGLState keeps a copy of goes back through it, so that its copies stay true; what it
 * does not know (polygon offset, depth clamp, front face) goes back to OpenGL. Values are asked of
 * OpenGL itself. vtkOpenGLState::Push and Pop would not do: Pop binds the program and the buffers
 * of the last Reset, not those of the Push.
 */
#ifndef RestoredState_h
#define RestoredState_h

#include <array>

class vtkOpenGLState;

class RestoredState
{
public:
  explicit RestoredState(vtkOpenGLState* state);
  ~RestoredState();

  RestoredState(const RestoredState&) = delete;
  RestoredState& operator=(const RestoredState&) = delete;

private:
  struct StencilFace
  {
    int WriteMask;
    int Function;
    int Reference;
    int ValueMask;
    int Fail;
    int DepthFail;
    int DepthPass;
  };

  vtkOpenGLState* State;
  std::array<bool, 5> Enabled;
  std::array<int, 4> Viewport;
  std::array<int, 4> Scissor;
  std::array<unsigned char, 4> ColorMask;
  std::array<int, 4> BlendFunction;
  std::array<int, 2> BlendEquation;
  unsigned char DepthMask;
  int DepthFunction;
  int ActiveTexture;
  std::array<StencilFace, 2> Stencil;

  bool DepthClamp;
  std::array<double, 2> DepthBounds; // the whole range if the test is off
  bool PolygonOffset;
  float OffsetFactor;
  float OffsetUnits;
  int FrontFace;
  int VertexArray;
  int ArrayBuffer;
};

#endif
