/**
 * GL_EXT_depth_bounds_test, where the driver has it: fragments are drawn only where the depth that is
 * stored already lies in a range. Of drivers of Mesa's that draw on the CPU softpipe has it and
 * llvmpipe has not.
 */
#ifndef DepthBoundsTest_h
#define DepthBoundsTest_h

#include "OpenGLFunctions.h"

#include <array>

namespace DepthBoundsTest
{
inline bool IsSupported()
{
#if defined(GLEW_EXT_depth_bounds_test)
  return GLEW_EXT_depth_bounds_test != 0;
#elif defined(GLAD_GL_EXT_depth_bounds_test)
  return GLAD_GL_EXT_depth_bounds_test != 0;
#else
  return false;
#endif
}

/**
 * Of window depths, from 0 to 1. The whole range turns the test off.
 */
inline void SetRange(const std::array<double, 2>& range)
{
#if defined(GLEW_EXT_depth_bounds_test) || defined(GLAD_GL_EXT_depth_bounds_test)
  if (!IsSupported())
  {
    return;
  }
  const bool isWhole = range[0] <= 0.0 && range[1] >= 1.0;
  isWhole ? glDisable(GL_DEPTH_BOUNDS_TEST_EXT) : glEnable(GL_DEPTH_BOUNDS_TEST_EXT);
  glDepthBoundsEXT(range[0], range[1]);
#else
  (void)range;
#endif
}
}

#endif
