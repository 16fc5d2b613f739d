// Masks wherever the eye is: in a shadow, beside a light, far from the origin, with clipping planes
// through a volume, and in parallel projection.

#include "ImageChecks.h"
#include "ShadowScene.h"
#include "TestMeshes.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkMapper.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace shadowtest;

TEST(StencilShadowPass, EyeInShadow)
{
  for (const RayLight& position : { PointLight, DirectionalLight })
  {
    Scene scene;
    const Mesh roof = moved(box(2.0, 2.0, 0.05), 1.0, { 0.0, 0.0, 1.5 });
    scene.Add(roof);
    vtkSmartPointer<vtkLight> light = scene.AddLight(position);
    scene.Look(0.3, 0.2, 0.9);
    scene.Renderer->GetActiveCamera()->SetFocalPoint(-2.0, -3.0, 0.0);
    scene.Renderer->GetActiveCamera()->SetClippingRange(0.01, 20.0);
    auto window = MakeWindow(240, 180);
    window->AddRenderer(scene.Renderer);
    window->Render();
    ExpectMask(scene, light, position, { { scene.GroundMesh }, { roof } }, "under a roof");
    const double dark = blackFraction(scene.Mask(light));
    EXPECT_GT(dark, 0.1);
    EXPECT_LT(dark, 0.95);
  }
}

TEST(StencilShadowPass, NearAndFarPlaneThroughVolume)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  scene.Add(mesh);
  vtkSmartPointer<vtkLight> light = scene.AddLight(DirectionalLight);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  // Behind the caster and within reach of its shadow: the near plane cuts the walls, and the far
  // plane lies just behind what is seen.
  camera->SetPosition(-1.0, -0.3, 0.6);
  camera->SetFocalPoint(-0.4, 0.3, 0.0);
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  for (const double nearest : { 0.05, 0.3, 0.5, 0.6 })
  {
    camera->SetClippingRange(nearest, 6.0);
    window->Render();
    const Image mask = scene.Mask(light);
    // The oracle looks from the near plane on, so it does not see what that plane cuts away.
    ExpectMask(scene, light, DirectionalLight, { { scene.GroundMesh }, { mesh } }, "near plane");
  }
}

TEST(StencilShadowPass, ParallelProjection)
{
  for (const RayLight& position : { PointLight, DirectionalLight, RayLight{ 3.0, 6.0, 4.5, 0.0 } })
  {
    // The last of them shines straight at the eye.
    Scene scene;
    const Mesh mesh = FloatingBox();
    scene.Add(mesh);
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    scene.Renderer->GetActiveCamera()->SetParallelScale(2.5);
    vtkSmartPointer<vtkLight> light = scene.AddLight(position);
    auto window = MakeWindow(240, 180);
    window->AddRenderer(scene.Renderer);
    window->Render();
    ExpectMask(scene, light, position, { { scene.GroundMesh }, { mesh } }, "parallel");
  }
}

TEST(StencilShadowPass, CasterOutOfViewAndLightInView)
{
  Scene scene;
  const Mesh mesh = moved(box(), 0.4, { 1.6, 1.2, 3.2 }, 5);
  scene.Add(mesh);
  const RayLight position = { 2.6, 2.0, 5.0, 1.0 };
  vtkSmartPointer<vtkLight> light = scene.AddLight(position);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, -1.5, 3.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  window->Render();
  ExpectMask(scene, light, position, { { scene.GroundMesh }, { mesh } }, "out of view");

  camera->SetPosition(-3.0, -2.0, 3.0);
  camera->SetFocalPoint(1.6, 1.2, 2.6);
  camera->SetViewAngle(80.0);
  scene.Renderer->SetWorldPoint(position.data());
  scene.Renderer->WorldToView();
  EXPECT_LT(std::abs(scene.Renderer->GetViewPoint()[0]), 1.0);
  EXPECT_LT(std::abs(scene.Renderer->GetViewPoint()[1]), 1.0);
  window->Render();
  ExpectMask(scene, light, position, { { scene.GroundMesh }, { mesh } }, "light in view");
}

TEST(StencilShadowPass, FarFromTheOrigin)
{
  const Vec3 shift = { 3e6, -2e6, 1e6 };
  Scene scene;
  scene.Renderer->RemoveAllViewProps();
  const Mesh mesh = moved(FloatingBox(), 1.0, shift);
  const Mesh plane = moved(ground(0.0, 4.0, 3), 1.0, shift);
  for (vtkPolyData* part : { mesh.Get(), plane.Get() })
  {
    // Otherwise VTK itself draws the mesh with what precision floats have there.
    vtkActor* actor = scene.Add(part);
    vtkOpenGLPolyDataMapper::SafeDownCast(actor->GetMapper())
      ->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE);
  }
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(shift[0] - 3.0, shift[1] - 6.0, shift[2] + 5.0);
  camera->SetFocalPoint(shift[0], shift[1], shift[2] + 0.5);
  const RayLight position = { shift[0] + 1.5, shift[1] + 1.0, shift[2] + 4.0, 1.0 };
  vtkSmartPointer<vtkLight> light = scene.AddLight(position);
  auto window = MakeWindow(320, 240);
  window->AddRenderer(scene.Renderer);
  window->Render();
  ExpectMask(scene, light, position, { { plane }, { mesh } }, "far away");
}
