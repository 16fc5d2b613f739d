// The bunny, finer.
#ifndef SubdividedBunny_h
#define SubdividedBunny_h

#include "RealMeshes.h"

#include <vtkLoopSubdivisionFilter.h>
#include <vtkNew.h>

namespace benchmarks
{
/// Subdivided some times after Loop, each time into four.
inline vtkSmartPointer<vtkPolyData> subdividedBunny(int times)
{
  vtkSmartPointer<vtkPolyData> mesh = shadowtest::bunny();
  if (times > 0)
  {
    vtkNew<vtkLoopSubdivisionFilter> loop;
    loop->SetInputData(mesh);
    loop->SetNumberOfSubdivisions(times);
    loop->Update();
    mesh = loop->GetOutput();
  }
  return mesh;
}
}

#endif
