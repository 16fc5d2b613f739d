// A sphere and a torus of few triangles, and a mesh with most of its triangles taken away, three
// times: with discrete shadows, with smooth shadows, and with smooth shadows and outlines. In the
// middle one shadows are round whose meshes are not; on the right both are.
//
//     SmoothOutlines picture.png [mesh.obj]
//
// The mesh's y points upwards.

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCleanPolyData.h>
#include <vtkImageShrink3D.h>
#include <vtkInformation.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkOffscreenWindows.h>
#include <vtkPNGWriter.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkQuadricDecimation.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSilhouetteGap.h>
#include <vtkSmartPointer.h>
#include <vtkSmoothLightSilhouette.h>
#include <vtkSphereSource.h>
#include <vtkStencilShadowPass.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkWindowToImageFilter.h>

#include <array>
#include <iostream>
#include <vector>

namespace
{
using PolyData = vtkSmartPointer<vtkPolyData>;

constexpr int Supersampling = 3;
constexpr std::array<double, 3> Eye = { 0.6, -8.0, 3.0 };

struct Panel
{
  int Shadows;
  bool SmoothOutlines;
};
const std::array<Panel, 3> Panels = { { { vtkStencilShadowPass::DISCRETE, false },
  { vtkStencilShadowPass::SMOOTH, false }, { vtkStencilShadowPass::SMOOTH, true } } };

struct Shape
{
  PolyData Mesh;
  std::array<double, 3> Colour;
};

// Turned about x, then about z, to a height, and put on the ground.
PolyData Placed(
  vtkAlgorithm* source, double aboutX, double aboutZ, double height, double x, double y)
{
  vtkNew<vtkTransform> place;
  place->PostMultiply();
  place->RotateX(aboutX);
  place->RotateZ(aboutZ);
  vtkNew<vtkTransformPolyDataFilter> placed;
  placed->SetInputConnection(source->GetOutputPort());
  placed->SetTransform(place);
  placed->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  placed->Update();
  double bounds[6];
  placed->GetOutput()->GetBounds(bounds);
  place->Translate(-0.5 * (bounds[0] + bounds[1]), -0.5 * (bounds[2] + bounds[3]), -bounds[4]);
  const double scale = height / (bounds[5] - bounds[4]);
  place->Scale(scale, scale, scale);
  place->Translate(x, y, 0.0);
  placed->Update();
  return placed->GetOutput();
}

Shape MakeSphere()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(10);
  sphere->SetPhiResolution(8);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  return { Placed(sphere, 0.0, 0.0, 1.4, -1.15, -0.9), { 0.55, 0.66, 0.82 } };
}

Shape MakeTorus()
{
  vtkNew<vtkParametricTorus> shape;
  shape->SetCrossSectionRadius(0.4);
  vtkNew<vtkParametricFunctionSource> sampled;
  sampled->SetParametricFunction(shape);
  sampled->SetUResolution(17);
  sampled->SetVResolution(9);
  sampled->SetScalarModeToNone();
  sampled->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkCleanPolyData> closed;
  closed->SetInputConnection(sampled->GetOutputPort());
  closed->SetTolerance(1e-6);
  closed->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  return { Placed(closed, 70.0, 20.0, 2.3, 0.55, 0.9), { 0.91, 0.66, 0.42 } };
}

Shape MakeCoarse(const char* file)
{
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(file);
  vtkNew<vtkCleanPolyData> welded;
  welded->SetInputConnection(reader->GetOutputPort());
  welded->SetTolerance(0.0);
  vtkNew<vtkQuadricDecimation> coarse;
  coarse->SetInputConnection(welded->GetOutputPort());
  coarse->SetTargetReduction(0.99);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(coarse->GetOutputPort());
  normals->SplittingOff();
  return { Placed(normals, 90.0, 10.0, 1.6, 0.75, -1.3), { 0.80, 0.72, 0.66 } };
}

Shape MakeGround()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-20.0, -20.0, 0.0);
  plane->SetPoint1(20.0, -20.0, 0.0);
  plane->SetPoint2(-20.0, 20.0, 0.0);
  plane->Update();
  return { plane->GetOutput(), { 0.86, 0.86, 0.84 } };
}

// What is between a mesh and its outline as it is seen.
PolyData GapOf(vtkPolyData* mesh)
{
  vtkNew<vtkSmoothLightSilhouette> outline;
  outline->SetInputData(mesh);
  outline->SetLightPosition(Eye[0], Eye[1], Eye[2], 1.0);
  vtkNew<vtkSilhouetteGap> gap;
  gap->SetInputData(mesh);
  gap->SetSilhouetteConnection(outline->GetOutputPort());
  gap->Update();
  return gap->GetOutput();
}

vtkNew<vtkActor> MakeActor(vtkPolyData* mesh, const std::array<double, 3>& colour, bool casts)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->SetAmbient(0.2);
  actor->GetProperty()->SetDiffuse(0.9);
  if (!casts)
  {
    vtkNew<vtkInformation> keys;
    keys->Set(vtkStencilShadowPass::CASTS_SHADOW(), 0);
    actor->SetPropertyKeys(keys);
  }
  return actor;
}

vtkNew<vtkRenderer> Draw(const std::vector<Shape>& shapes, const Panel& panel)
{
  vtkNew<vtkRenderer> renderer;
  const Shape ground = MakeGround();
  renderer->AddActor(MakeActor(ground.Mesh, ground.Colour, false));
  for (const Shape& shape : shapes)
  {
    renderer->AddActor(MakeActor(shape.Mesh, shape.Colour, true));
    if (panel.SmoothOutlines)
    {
      renderer->AddActor(MakeActor(GapOf(shape.Mesh), shape.Colour, false));
    }
  }
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(-1.2, -0.75, 1.5);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->AddLight(light);
  renderer->SetBackground(0.80, 0.85, 0.90);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(Eye.data());
  camera->SetFocalPoint(-0.05, 0.0, 0.85);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(27.0);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkStencilShadowPass> pass;
  pass->SetKind(panel.Shadows);
  renderer->SetPass(pass);
  return renderer;
}
}

int main(int argc, char* argv[])
{
  if (argc != 2 && argc != 3)
  {
    std::cerr << "usage: SmoothOutlines picture.png [mesh.obj]" << std::endl;
    return 2;
  }
  std::vector<Shape> shapes = { MakeSphere(), MakeTorus() };
  if (argc == 3)
  {
    shapes.push_back(MakeCoarse(argv[2]));
  }
  const auto window = vtkSmartPointer<vtkRenderWindow>::Take(vtkOffscreenWindows::NewWindow("egl"));
  if (!window)
  {
    std::cerr << vtkOffscreenWindows::GetLastReason() << std::endl;
    return 1;
  }
  window->SetMultiSamples(0);
  window->SetSize(Supersampling * 1440, Supersampling * 440);
  for (std::size_t i = 0; i < Panels.size(); ++i)
  {
    const vtkNew<vtkRenderer> renderer = Draw(shapes, Panels[i]);
    const double share = 1.0 / static_cast<double>(Panels.size());
    const double left = static_cast<double>(i) * share;
    renderer->SetViewport(left, 0.0, left + share, 1.0);
    window->AddRenderer(renderer);
  }
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
  writer->SetFileName(argv[1]);
  writer->Write();
  for (const Shape& shape : shapes)
  {
    std::cout << shape.Mesh->GetNumberOfPolys() << " triangles and "
              << GapOf(shape.Mesh)->GetNumberOfPolys() << " in the gap" << std::endl;
  }
  return writer->GetErrorCode() == 0 ? 0 : 1;
}
