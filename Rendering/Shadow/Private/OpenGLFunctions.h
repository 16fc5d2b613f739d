/**
 * The OpenGL functions, through whichever loader this VTK was built with: GLEW up to 9.3, glad
 * from 9.4 on. The only place that knows.
 */
#ifndef OpenGLFunctions_h
#define OpenGLFunctions_h

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#endif
