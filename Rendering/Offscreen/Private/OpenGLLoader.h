#ifndef OpenGLLoader_h
#define OpenGLLoader_h

/**
 * The module's one switch between the OpenGL loaders: GLEW up to VTK 9.3, where the process has
 * one set of function pointers that glewInit() fills, and glad from VTK 9.4 on, where the render
 * window is given the function that looks OpenGL's functions up.
 */
#if __has_include(<vtk_glad.h>)
#include <vtk_glad.h>
#define SMOOTHSHADOW_OPENGL_GLAD 1
#else
#include <vtk_glew.h>
#define SMOOTHSHADOW_OPENGL_GLAD 0
#endif

#endif
