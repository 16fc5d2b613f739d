// The window that frames are drawn in, its pictures, and what it was that drew them.
#ifndef BenchmarkWindow_h
#define BenchmarkWindow_h

#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOffscreenWindows.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkVersion.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace benchmarks
{
/// An offscreen window of size x size pixels without multisampling. Ends the program with the
/// reason if there is none.
inline vtkSmartPointer<vtkRenderWindow> openWindow(int size, vtkRenderer* renderer)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::Take(vtkOffscreenWindows::NewWindow(nullptr));
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

/// A frame, until the graphics card is done with it.
inline void drawFrame(vtkRenderWindow* window)
{
  window->Render();
  static_cast<vtkOpenGLRenderWindow*>(window)->WaitForCompletion();
}

/// What the window shows, without rendering again.
inline vtkSmartPointer<vtkImageData> grab(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  capture->ReadFrontBufferOff();
  capture->ShouldRerenderOff();
  capture->Update();
  return capture->GetOutput();
}

/// OpenGL's renderer, of a window that has drawn.
inline std::string rendererOf(vtkRenderWindow* window)
{
  const std::string capabilities = window->ReportCapabilities();
  const std::string label = "OpenGL renderer string:";
  const std::size_t begin = capabilities.find(label);
  return begin == std::string::npos ? "not known"
                                    : capabilities.substr(begin + label.size(),
                                        capabilities.find('\n', begin) - begin - label.size());
}

/// Whether frames are drawn by the processor, so that its time tells what they cost.
inline bool drawsOnProcessor(vtkRenderWindow* window)
{
  const std::string renderer = rendererOf(window);
  return renderer.find("llvmpipe") != std::string::npos ||
    renderer.find("softpipe") != std::string::npos;
}

/// VTK, OpenGL's renderer, the machine's load, and what ratios are of.
inline std::string conditions(vtkRenderWindow* window)
{
  std::string load = "unknown";
  std::ifstream file("/proc/loadavg");
  std::getline(file, load);
  return std::string("VTK ") + vtkVersion::GetVTKVersion() + "; OpenGL renderer" +
    rendererOf(window) + "; load " + load + "; ratios are of " +
    (drawsOnProcessor(window) ? "processor time, of all threads" : "time");
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
