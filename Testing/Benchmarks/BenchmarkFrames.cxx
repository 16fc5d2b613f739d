// Frame times at 768 x 768 without shadows, with vtkShadowMapPass and with vtkStencilShadowPass,
// the light moving and at rest; and the pixels of either's shadows that differ from a ray cast.

#include "BenchmarkWindow.h"
#include "ImageChecks.h"
#include "MaskComparison.h"
#include "Measure.h"
#include "RayCast.h"
#include "RealMeshes.h"
#include "TestMeshes.h"

#include <vtkActor.h>
#include <vtkCameraPass.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkShadowMapPass.h>
#include <vtkStencilShadowPass.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace
{
using namespace shadowtest;

constexpr int Size = 768;

/// A direction, which both passes can cast: vtkShadowMapPass needs a spot for anything else.
void placeLight(vtkLight* light, int step)
{
  const double angle = 0.6 + 0.02 * step;
  light->SetPosition(2.0 * std::cos(angle), 2.0 * std::sin(angle), 4.0);
}

struct Scene
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkLight> Light;
  vtkSmartPointer<vtkRenderWindow> Window;

  void add(vtkPolyData* mesh)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    // White, diffuse only: a pixel is black exactly if it gets no light.
    actor->GetProperty()->SetAmbient(0.0);
    this->Renderer->AddActor(actor);
  }

  Scene(const std::vector<RayObject>& objects)
  {
    for (const RayObject& object : objects)
    {
      this->add(object.Surface);
    }
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetBackground(0.5, 0.5, 0.5);
    this->Light->SetPositional(false);
    this->Light->SetFocalPoint(0.0, 0.0, 0.0);
    placeLight(this->Light, 0);
    this->Renderer->AddLight(this->Light);
    benchmarks::lookAtTheGround(this->Renderer);
    this->Window = benchmarks::openWindow(Size, this->Renderer);
  }

  benchmarks::Figure frames(bool lightMoves)
  {
    return benchmarks::measure(
      [&](int i)
      {
        if (lightMoves)
        {
          placeLight(this->Light, i % 7);
        }
        this->Window->Render();
        static_cast<vtkOpenGLRenderWindow*>(this->Window.Get())->WaitForCompletion();
      });
  }

  vtkSmartPointer<vtkImageData> picture()
  {
    placeLight(this->Light, 0);
    this->Window->Render();
    vtkNew<vtkWindowToImageFilter> capture;
    capture->SetInput(this->Window);
    capture->ReadFrontBufferOff();
    capture->Update();
    // One channel: 0 where no light comes.
    auto mask = vtkSmartPointer<vtkImageData>::New();
    mask->SetDimensions(Size, Size, 1);
    mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    for (int y = 0; y < Size; ++y)
    {
      for (int x = 0; x < Size; ++x)
      {
        const double value = capture->GetOutput()->GetScalarComponentAsDouble(x, y, 0, 0);
        mask->SetScalarComponentFromDouble(x, y, 0, 0, value > 0.0 ? 255.0 : 0.0);
      }
    }
    return mask;
  }
};

vtkSmartPointer<vtkRenderPass> shadowMapPass()
{
  vtkNew<vtkShadowMapPass> shadows;
  shadows->GetShadowMapBakerPass()->SetResolution(2048);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(shadows->GetShadowMapBakerPass());
  passes->AddItem(shadows);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  auto camera = vtkSmartPointer<vtkCameraPass>::New();
  camera->SetDelegatePass(sequence);
  return camera;
}

std::string rendererLine(vtkRenderWindow* window)
{
  const std::string capabilities = window->ReportCapabilities();
  const std::size_t begin = capabilities.find("OpenGL renderer string:");
  return begin == std::string::npos
    ? capabilities
    : capabilities.substr(begin, capabilities.find('\n', begin) - begin);
}

void report(const char* name, Scene& scene, const RayScene* rays, double unshadowed)
{
  const benchmarks::Figure moving = scene.frames(true);
  const benchmarks::Figure resting = scene.frames(false);
  std::printf("%-28s %8.1f %6.2f %8.1f %6.2f", name, moving.median, moving.median / unshadowed,
    resting.median, resting.median / unshadowed);
  if (rays)
  {
    double position[3];
    const auto picture = scene.picture();
    scene.Light->GetPosition(position);
    const RayLight light{ position[0], position[1], position[2], 0.0 };
    const RayView view = RayView::fromCamera(scene.Renderer->GetActiveCamera(), Size, Size);
    const MaskComparison wrong = compareMask(*rays, view, light, picture);
    std::printf(" %8ld %8ld %8ld %8ld", wrong.Objects[0].Wrong, wrong.Objects[0].WrongBeyond,
      wrong.Objects[1].Wrong, wrong.Objects[1].WrongBeyond);
  }
  std::printf("\n");
}
}

int main()
{
  const Mesh mesh = standing(bunny(), 1);
  double bounds[6];
  mesh->GetBounds(bounds);
  const std::vector<RayObject> objects = { { ground(bounds[4], 4.0, 8) }, { mesh } };
  const RayScene rays(objects);

  Scene plain(objects);
  const double unshadowed = plain.frames(true).median;
  std::printf("bunny, %lld triangles, over a plane; %d x %d; milliseconds, medians of 15 frames; "
              "wrong pixels against\na ray cast of the triangles, in all and beyond one pixel of an "
              "edge; no colour of the caster's\nlit side is told from shadow below 1/255\n%s\n",
    static_cast<long long>(mesh->GetNumberOfCells()), Size, Size, rendererLine(plain.Window).c_str());
  std::printf("%-28s %8s %6s %8s %6s %17s %17s\n", "", "moving", "ratio", "resting", "ratio",
    "ground", "caster");
  report("no shadows", plain, nullptr, unshadowed);
  Scene mapped(objects);
  mapped.Renderer->SetPass(shadowMapPass());
  report("vtkShadowMapPass 2048", mapped, &rays, unshadowed);
  const char* names[] = { "stencil, discrete", "stencil, accurate", "stencil, smooth" };
  for (int kind = 0; kind < 3; ++kind)
  {
    Scene scene(objects);
    vtkNew<vtkStencilShadowPass> pass;
    pass->SetKind(kind);
    scene.Renderer->SetPass(pass);
    report(names[kind], scene, &rays, unshadowed);
  }
  return 0;
}
