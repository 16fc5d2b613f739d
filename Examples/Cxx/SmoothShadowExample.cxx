// A torus of 256 triangles over a plane. On the left what the shadow pass draws; on the right what
// it draws with: the silhouette as seen from the light, and the walls of the shadow volume.
//
//     SmoothShadowExample [picture.png]

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCleanPolyData.h>
#include <vtkInformation.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOffscreenWindows.h>
#include <vtkPNGWriter.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkShadowVolumeExtruder.h>
#include <vtkSmartPointer.h>
#include <vtkSmoothLightSilhouette.h>
#include <vtkStencilShadowPass.h>
#include <vtkTubeFilter.h>
#include <vtkWindowToImageFilter.h>

#include <iostream>

namespace
{
vtkNew<vtkActor> MakeActor(vtkAlgorithm* source, double red, double green, double blue)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, green, blue);
  actor->GetProperty()->SetAmbient(0.15);
  return actor;
}
}

int main(int argc, char* argv[])
{
  const char* picture = argc > 1 ? argv[1] : "SmoothShadowExample.png";
  double lamp[4] = { -3.0, -2.0, 5.0, 1.0 }; // w = 1: a point, w = 0: a direction

  // A mesh with normals. VTK leaves the torus's seam open: closed meshes are faster to shadow.
  vtkNew<vtkParametricTorus> shape;
  shape->SetRingRadius(1.0);
  shape->SetCrossSectionRadius(0.4);
  vtkNew<vtkParametricFunctionSource> sampled;
  sampled->SetParametricFunction(shape);
  sampled->SetUResolution(17);
  sampled->SetVResolution(9);
  vtkNew<vtkCleanPolyData> torus;
  torus->SetInputConnection(sampled->GetOutputPort());
  torus->SetTolerance(1e-6);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-20.0, -20.0, -0.9);
  plane->SetPoint1(20.0, -20.0, -0.9);
  plane->SetPoint2(-20.0, 20.0, -0.9);

  // The filters, as in any pipeline.
  vtkNew<vtkSmoothLightSilhouette> silhouette;
  silhouette->SetInputConnection(torus->GetOutputPort());
  silhouette->SetLightPosition(lamp);
  vtkNew<vtkShadowVolumeExtruder> volume;
  volume->SetInputConnection(torus->GetOutputPort());
  volume->SetSilhouetteConnection(silhouette->GetOutputPort());
  volume->SetLength(2.0);
  volume->SetCapsToNone();
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(silhouette->GetOutputPort());
  tube->SetRadius(0.02);
  tube->SetNumberOfSides(8);

  // A scene, as without shadows, and the pass.
  const vtkNew<vtkActor> torusActor = MakeActor(torus, 0.91, 0.66, 0.42);
  const vtkNew<vtkActor> planeActor = MakeActor(plane, 0.86, 0.86, 0.84);
  vtkNew<vtkInformation> keys;
  keys->Set(vtkStencilShadowPass::CASTS_SHADOW(), 0);
  planeActor->SetPropertyKeys(keys);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(true);
  light->SetConeAngle(180.0);
  light->SetPosition(lamp);
  light->SetIntensity(0.85);
  vtkNew<vtkRenderer> left;
  left->AddActor(torusActor);
  left->AddActor(planeActor);
  left->AddLight(light);
  left->SetBackground(0.80, 0.85, 0.90);
  left->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkStencilShadowPass> shadows;
  left->SetPass(shadows);

  // Silhouette and volume, drawn as the meshes that they are.
  const vtkNew<vtkActor> wallActor = MakeActor(volume, 0.35, 0.45, 0.65);
  wallActor->GetProperty()->SetOpacity(0.35);
  vtkNew<vtkRenderer> right;
  right->AddActor(torusActor);
  right->AddActor(MakeActor(tube, 0.80, 0.15, 0.10));
  right->AddActor(wallActor);
  right->SetBackground(1.0, 1.0, 1.0);
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  right->SetActiveCamera(left->GetActiveCamera());
  left->GetActiveCamera()->SetPosition(2.0, -6.5, 4.0);
  left->GetActiveCamera()->SetFocalPoint(0.4, 0.2, -0.4);
  left->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);

  // Any window of VTK that has a stencil buffer does; this one needs no display.
  const auto window = vtkSmartPointer<vtkRenderWindow>::Take(vtkOffscreenWindows::NewWindow("egl"));
  if (!window)
  {
    std::cerr << vtkOffscreenWindows::GetLastReason() << std::endl;
    return 1;
  }
  window->SetSize(1200, 600);
  window->AddRenderer(left);
  window->AddRenderer(right);
  window->Render();

  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  capture->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(capture->GetOutputPort());
  writer->SetFileName(picture);
  writer->Write();
  std::cout << picture << ": " << silhouette->GetOutput()->GetNumberOfLines() << " silhouette loops"
            << std::endl;
  return 0;
}
