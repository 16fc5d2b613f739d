/**
 * What a renderer draws when it has no pass.
 */
#ifndef RendererSteps_h
#define RendererSteps_h

#include "vtkSmartPointer.h"

class vtkRenderPass;

/**
 * Camera, lights and all geometry. Unlike vtkRenderStepsPass it heeds what the renderer is set to:
 * depth peeling or else order-independent blending of translucent geometry, hidden-line removal,
 * ambient occlusion, FXAA. Where the state has a framebuffer it is as vtkRenderStepsPass.
 */
vtkSmartPointer<vtkRenderPass> MakeRendererSteps();

#endif
