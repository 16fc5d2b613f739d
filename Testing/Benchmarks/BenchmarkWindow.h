// The window that frames are drawn in.
#ifndef BenchmarkWindow_h
#define BenchmarkWindow_h

#include <vtkCamera.h>
#include <vtkOffscreenWindows.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <cstdlib>
#include <iostream>

namespace benchmarks
{
/// An offscreen window of size x size pixels without multisampling. Ends the program with the
/// reason if there is none.
inline vtkSmartPointer<vtkRenderWindow> openWindow(int size, vtkRenderer* renderer)
{
  auto window =
    vtkSmartPointer<vtkRenderWindow>::Take(vtkOffscreenWindows::NewWindow(nullptr));
  if (!window)
  {
    std::cerr << vtkOffscreenWindows::GetLastReason() << std::endl;
    std::exit(1);
  }
  window->SetMultiSamples(0);
  window->SetSize(size, size);
  window->AddRenderer(renderer);
  return window;
}

/// Looks at a mesh of size 2 on the ground, obliquely from above.
inline void lookAtTheGround(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(2.0, -3.6, 2.4);
  camera->SetFocalPoint(0.0, 0.0, -0.2);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
}
}

#endif
