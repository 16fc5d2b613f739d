// Masks of views: parallel, with the caster out of view, far from the origin. Harder ones are in
// Robustness/TestHardPictures.

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

using namespace shadowtest;

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

TEST(StencilShadowPass, CasterOutOfView)
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
