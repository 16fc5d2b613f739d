// Writes a sphere and a torus of few triangles, with the normals of the smooth surfaces, in which
// the difference between kinds of silhouettes is plain to see.
//
//     CoarseShapes sphere.vtp torus.vtp

#include <vtkCleanPolyData.h>
#include <vtkNew.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkSphereSource.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkXMLPolyDataWriter.h>

#include <iostream>

namespace
{
bool Write(vtkAlgorithm* source, const char* file)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(source->GetOutputPort());
  writer->SetFileName(file);
  return writer->Write() != 0;
}
}

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: CoarseShapes sphere.vtp torus.vtp" << std::endl;
    return 2;
  }
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(12);
  sphere->SetPhiResolution(9);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);

  vtkNew<vtkParametricTorus> shape;
  shape->SetRingRadius(1.0);
  shape->SetCrossSectionRadius(0.4);
  vtkNew<vtkParametricFunctionSource> sampled;
  sampled->SetParametricFunction(shape);
  sampled->SetUResolution(17);
  sampled->SetVResolution(9);
  sampled->SetScalarModeToNone();
  sampled->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  // The source leaves the seam open, by the rounding of its sines.
  vtkNew<vtkCleanPolyData> torus;
  torus->SetInputConnection(sampled->GetOutputPort());
  torus->SetTolerance(1e-6);
  torus->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);

  // Leaning back, so that its shadow has a hole.
  vtkNew<vtkTransform> lean;
  lean->RotateX(-35.0);
  vtkNew<vtkTransformPolyDataFilter> leaning;
  leaning->SetInputConnection(torus->GetOutputPort());
  leaning->SetTransform(lean);

  return Write(sphere, argv[1]) && Write(leaning, argv[2]) ? 0 : 1;
}
