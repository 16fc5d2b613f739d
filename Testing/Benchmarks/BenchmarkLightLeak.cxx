// Light that the corner fields of accurate and smooth silhouettes leave where the surface that a
// mesh stands for shadows itself, and shadow where it is lit, by the cosine at which light comes
// in.
//
// The reference is a ray cast of a much finer mesh of the same surface: of the torus itself, and of
// the interpolating subdivision (vtkButterflySubdivisionFilter) of real meshes. Pixels beside an
// edge of a cast shadow are left out: edges of meshes differ.

#include "BenchmarkWindow.h"
#include "LightLeak.h"
#include "RayCast.h"
#include "RealMeshes.h"
#include "TestMeshes.h"

#include <vtkActor.h>
#include <vtkButterflySubdivisionFilter.h>
#include <vtkCamera.h>
#include <vtkCleanPolyData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStencilShadowPass.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace
{
using namespace shadowtest;

constexpr int Size = 768;

const std::array<std::array<double, 3>, 4> Eyes = { { { 1.2, -2.2, 1.4 }, { -2.0, 1.2, 1.6 },
  { 0.4, 2.6, 0.7 }, { 1.9, 1.4, -1.5 } } };
const std::array<RayLight, 4> Lights = { { { 1.0, -0.4, 0.5, 0.0 }, { -0.5, 0.9, 1.2, 0.0 },
  { 0.3, 0.8, 0.2, 0.0 }, { 2.5, 1.0, 2.0, 1.0 } } };

class View
{
public:
  explicit View(vtkPolyData* mesh)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->AddLight(this->Light);
    this->Renderer->SetPass(this->Pass);
    this->Window = benchmarks::openWindow(Size, this->Renderer);
  }

  RayView place(const std::array<double, 3>& eye, const RayLight& light, double size)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.5 * size * eye[0], 0.5 * size * eye[1], 0.5 * size * eye[2]);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(28.0);
    this->Renderer->ResetCameraClippingRange();
    this->Light->SetPositional(light[3] != 0.0);
    this->Light->SetConeAngle(180.0);
    this->Light->SetPosition(light[0], light[1], light[2]);
    return RayView::fromCamera(camera, Size, Size);
  }

  vtkSmartPointer<vtkImageData> mask(int kind)
  {
    this->Pass->SetKind(kind);
    this->Window->Render();
    return vtkSmartPointer<vtkImageData>::Take(this->Pass->GetMask(this->Light));
  }

private:
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkLight> Light;
  vtkNew<vtkStencilShadowPass> Pass;
  vtkSmartPointer<vtkRenderWindow> Window;
};

void report(const char* name, vtkPolyData* mesh, vtkPolyData* fine)
{
  const RayScene rays({ { fine } });
  View view(mesh);
  std::array<LeakCounts, 3> counts{};
  for (const RayLight& light : Lights)
  {
    for (const auto& eye : Eyes)
    {
      const RayPicture reference =
        rays.render(view.place(eye, light, mesh->GetLength()), light);
      for (int kind = 0; kind < 3; ++kind)
      {
        countLeaks(reference, view.mask(kind), counts[static_cast<std::size_t>(kind)]);
      }
    }
  }
  const char* kinds[] = { "discrete", "accurate", "smooth" };
  for (std::size_t kind = 0; kind < 3; ++kind)
  {
    std::printf("%-16s %-9s", kind == 0 ? name : "", kinds[kind]);
    for (const LeakCount& count : counts[kind])
    {
      std::printf(" %7.3f/%7.3f", count.percentLeaking(), count.percentLost());
    }
    std::printf("\n");
  }
  std::fflush(stdout);
}

void reportReal(const char* name, vtkPolyData* mesh)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(withoutNormals(mesh));
  vtkNew<vtkButterflySubdivisionFilter> fine;
  fine->SetInputConnection(clean->GetOutputPort());
  fine->SetNumberOfSubdivisions(2);
  fine->Update();
  report(name, mesh, fine->GetOutput());
}
}

int main()
{
  std::printf("percent of the pixels in shadow that are lit / of the lit ones that are dark, by the\n"
              "cosine of the light on the surface; %zu lights, %zu views of %d x %d\n%-26s",
    Lights.size(), Eyes.size(), Size, Size, "");
  for (std::size_t i = 0; i + 1 < LeakCosines.size(); ++i)
  {
    std::printf(" %7.2f -%6.2f", LeakCosines[i], LeakCosines[i + 1]);
  }
  std::printf("\n");
  const Mesh fineTorus = torus(768, 384);
  report("torus 1,152", torus(36, 16), fineTorus);
  report("torus 4,608", torus(72, 32), fineTorus);
  report("torus 18,432", torus(144, 64), fineTorus);
  reportReal("elephant", standing(cgalMesh("elephant"), 1));
  reportReal("armadillo", standing(cgalMesh("armadillo"), 1));
  reportReal("bunny", standing(bunny(), 1));
  return 0;
}
