#include "SketchPicture.h"

#include "SketchView.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkContourStrokes.h>
#include <vtkImageShrink3D.h>
#include <vtkInformation.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOffscreenWindows.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSilhouetteGap.h>
#include <vtkSmoothLightSilhouette.h>
#include <vtkStencilShadowPass.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>
#include <iostream>

namespace
{
constexpr int Supersampling = 2;

// Paper: white where the light comes from above, a little less on other sides and in shadow.
vtkNew<vtkActor> PaperActor(vtkPolyData* mesh)
{
  const double cosine = Sun[2] / std::sqrt(Sun[0] * Sun[0] + Sun[1] * Sun[1] + Sun[2] * Sun[2]);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  actor->GetProperty()->SetAmbient(0.88);
  actor->GetProperty()->SetDiffuse(0.12 / cosine);
  return actor;
}

vtkNew<vtkActor> StrokeActor(const Layer& layer, vtkCamera* camera)
{
  vtkNew<vtkContourStrokes> strokes;
  strokes->SetInputData(layer.Lines);
  strokes->SetWidthUnitToPixels();
  strokes->SetWidth(Supersampling * layer.How.Width);
  Vector3 eye = View.Eye;
  strokes->SetEyePosition(eye[0], eye[1], eye[2], 1.0);
  strokes->SetViewDirection(camera->GetDirectionOfProjection());
  const double tangent = std::tan(0.5 * View.Angle * std::acos(-1.0) / 180.0);
  strokes->SetPixelSize(2.0 * tangent / (Supersampling * Size[1]));
  strokes->SetTaper(layer.How.Taper);
  strokes->SetOvershoot(layer.How.Overshoot);
  strokes->SetWobble(layer.How.Wobble);
  strokes->SetLift(layer.How.Lift);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(strokes->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(layer.How.Grey, layer.How.Grey, layer.How.Grey);
  vtkNew<vtkInformation> keys;
  keys->Set(vtkStencilShadowPass::CASTS_SHADOW(), 0);
  keys->Set(vtkStencilShadowPass::RECEIVES_SHADOW(), 0);
  actor->SetPropertyKeys(keys);
  return actor;
}

// Of paper, too. The mesh casts for it.
vtkNew<vtkActor> GapActor(vtkPolyData* mesh)
{
  vtkNew<vtkSmoothLightSilhouette> outline;
  outline->SetInputData(mesh);
  Homogeneous eye = Eye;
  outline->SetLightPosition(eye.data());
  vtkNew<vtkSilhouetteGap> gap;
  gap->SetInputData(mesh);
  gap->SetSilhouetteConnection(outline->GetOutputPort());
  gap->Update();
  vtkNew<vtkActor> actor = PaperActor(gap->GetOutput());
  vtkNew<vtkInformation> keys;
  keys->Set(vtkStencilShadowPass::CASTS_SHADOW(), 0);
  actor->SetPropertyKeys(keys);
  return actor;
}
}

bool WritePicture(
  const Model& model, const std::vector<Layer>& layers, bool smoothOutlines, const char* file)
{
  const auto window = vtkSmartPointer<vtkRenderWindow>::Take(vtkOffscreenWindows::NewWindow("egl"));
  if (!window)
  {
    std::cerr << vtkOffscreenWindows::GetLastReason() << std::endl;
    return false;
  }
  window->SetMultiSamples(0);
  window->SetSize(Supersampling * Size[0], Supersampling * Size[1]);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(View.Eye.data());
  camera->SetFocalPoint(View.At.data());
  camera->SetViewUp(View.Up.data());
  camera->SetViewAngle(View.Angle);
  for (vtkPolyData* mesh : model.All())
  {
    renderer->AddActor(PaperActor(mesh));
  }
  if (smoothOutlines)
  {
    renderer->AddActor(GapActor(model.Animal));
  }
  for (const Layer& layer : layers)
  {
    renderer->AddActor(StrokeActor(layer, camera));
  }
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(Sun[0], Sun[1], Sun[2]);
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->AddLight(sun);
  vtkNew<vtkStencilShadowPass> shadows;
  renderer->SetPass(shadows);
  window->AddRenderer(renderer);
  renderer->ResetCameraClippingRange();
  window->Render();

  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  capture->ReadFrontBufferOff();
  vtkNew<vtkImageShrink3D> smaller;
  smaller->SetInputConnection(capture->GetOutputPort());
  smaller->SetShrinkFactors(Supersampling, Supersampling, 1);
  smaller->AveragingOn();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(smaller->GetOutputPort());
  writer->SetFileName(file);
  writer->Write();
  return writer->GetErrorCode() == 0;
}
