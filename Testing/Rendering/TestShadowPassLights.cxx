// Several lights, lights that come, go and move, and scenes in which no light casts.

#include "ImageChecks.h"
#include "RayCast.h"
#include "ShadowScene.h"
#include "TestMeshes.h"

#include "vtkStencilShadowPass.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace shadowtest;

TEST(StencilShadowPass, ManyLightsEachItsMask)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  scene.Add(mesh);
  // Three layers of masks; a headlight and one that is off lie between, so that numbers of lights,
  // of lights that are on, and of masks all differ.
  const std::vector<RayLight> positions = { { 1.5, 1.0, 4.0, 1.0 }, { 2.0, 1.0, 4.0, 0.0 },
    { -2.0, 1.0, 3.0, 1.0 }, { 0.5, -2.0, 4.0, 0.0 }, { 0.1, 2.5, 3.0, 1.0 },
    { -1.0, 0.4, 5.0, 0.0 }, { 2.5, -1.5, 3.5, 1.0 }, { -2.0, -1.0, 5.0, 0.0 },
    { -1.5, 2.0, 4.0, 1.0 } };
  std::vector<vtkSmartPointer<vtkLight>> lights;
  vtkSmartPointer<vtkLight> headlight;
  for (const RayLight& position : positions)
  {
    lights.push_back(scene.AddLight(position, 0.02 + 0.02 * static_cast<double>(lights.size())));
    lights.back()->SetDiffuseColor(1.0, 0.1 * static_cast<double>(lights.size()), 0.5);
    if (lights.size() == 1)
    {
      scene.AddLight({ 0.0, 0.0, 3.0, 1.0 })->SwitchOff();
    }
    if (lights.size() == 3)
    {
      headlight = scene.AddHeadlight(0.05);
    }
  }
  auto window = MakeWindow(300, 220);
  window->AddRenderer(scene.Renderer);
  window->Render();

  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    ExpectMask(scene, lights[i], positions[i], { { scene.GroundMesh }, { mesh } },
      ("light " + std::to_string(i)).c_str());
  }
  EXPECT_EQ(scene.Pass->GetMask(headlight), nullptr);
  EXPECT_FALSE(scene.Pass->GetLightCasts(headlight));

  // On the ground the colour is the sum over lights of mask times Lambert.
  const Image picture = Grab(window);
  std::vector<Image> masks;
  for (const auto& light : lights)
  {
    masks.push_back(scene.Mask(light));
  }
  const RayView view = ViewOf(scene.Renderer, picture);
  const RayScene rays({ { scene.GroundMesh }, { mesh } });
  double camera[3];
  scene.Renderer->GetActiveCamera()->GetPosition(camera);
  double axis[3];
  scene.Renderer->GetActiveCamera()->GetDirectionOfProjection(axis);
  const double color[3] = { 1.0, 0.9, 0.8 };
  long checked = 0;
  long wrong = 0;
  for (int y = 0; y < view.Height; y += 2)
  {
    for (int x = 0; x < view.Width; x += 2)
    {
      const RaySample sample = rays.look(view, x + 0.5, y + 0.5, positions[0]);
      if (sample.Object != 0)
      {
        continue;
      }
      double light[3] = { -axis[2] * 0.05, -axis[2] * 0.05, -axis[2] * 0.05 };
      for (std::size_t i = 0; i < lights.size(); ++i)
      {
        const RayLight& p = positions[i];
        const Vec3 place = { p[0], p[1], p[2] };
        const Vec3 toLight = normalized(p[3] == 0.0 ? place : place - sample.Point);
        for (int c = 0; c < 3; ++c)
        {
          light[c] += Byte(masks[i], x, y) / 255.0 * toLight[2] * lights[i]->GetIntensity() *
            lights[i]->GetDiffuseColor()[c];
        }
      }
      ++checked;
      for (int c = 0; c < 3; ++c)
      {
        wrong +=
          std::abs(Byte(picture, x, y, c) - 255.0 * color[c] * (0.125 + 0.75 * light[c])) > 1.5;
      }
    }
  }
  EXPECT_GT(checked, 8000);
  EXPECT_EQ(wrong, 0);
}

TEST(StencilShadowPass, CameraLightsGoWithTheCamera)
{
  for (const bool positional : { false, true })
  {
    Scene scene;
    const Mesh mesh = FloatingBox();
    scene.Add(mesh);
    auto light = vtkSmartPointer<vtkLight>::New();
    light->SetLightTypeToCameraLight();
    light->SetPositional(positional);
    light->SetConeAngle(180.0);
    light->SetPosition(0.4, 0.5, 0.9);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    scene.Renderer->AddLight(light);
    vtkSmartPointer<vtkLight> still = scene.AddLight(DirectionalLight, 0.3);
    auto window = MakeWindow(240, 180);
    window->AddRenderer(scene.Renderer);
    const std::vector<RayObject> objects = { { scene.GroundMesh }, { mesh } };
    for (const Vec3& eye : std::vector<Vec3>{ { -3, -6, 5 }, { 4, -5, 4 }, { 1, 5, 6 } })
    {
      scene.Look(eye[0], eye[1], eye[2]);
      window->Render();
      // The camera's axes at its focal point, where units are its distance.
      const Vec3 focus = { 0.0, 0.0, 0.5 };
      const Vec3 toEye = eye - focus;
      const double distance = std::sqrt(dot(toEye, toEye));
      const Vec3 back = normalized(toEye);
      const Vec3 right = normalized(cross({ 0.0, 0.0, 1.0 }, back));
      const Vec3 up = cross(back, right);
      const Vec3 offset = distance * (0.4 * right + 0.5 * up + 0.9 * back);
      const Vec3 place = focus + offset;
      const RayLight position = positional ? RayLight{ place[0], place[1], place[2], 1.0 }
                                           : RayLight{ offset[0], offset[1], offset[2], 0.0 };
      ExpectMask(scene, light, position, objects, "with the camera");
      ExpectMask(scene, still, DirectionalLight, objects, "in the scene");
    }
    // The camera turned, the light of the scene did not: only that of the camera is made again.
    EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 2);
  }
}

TEST(StencilShadowPass, LightsWithATransform)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  scene.Add(mesh);
  vtkSmartPointer<vtkLight> light = scene.AddLight({ 0.0, 1.0, 2.0, 1.0 });
  vtkNew<vtkTransform> transform;
  transform->Translate(-0.5, 0.3, 1.0);
  transform->RotateZ(70.0);
  transform->Scale(1.5, 1.5, 1.5);
  light->SetTransformMatrix(transform->GetMatrix());
  double place[3] = { 0.0, 1.0, 2.0 };
  transform->TransformPoint(place, place);
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  window->Render();
  const std::vector<RayObject> objects = { { scene.GroundMesh }, { mesh } };
  ExpectMask(scene, light, { place[0], place[1], place[2], 1.0 }, objects, "lamp");

  light->PositionalOff();
  double focus[3] = { 0.0, 0.0, 0.0 };
  transform->TransformPoint(focus, focus);
  window->Render();
  ExpectMask(scene, light, { place[0] - focus[0], place[1] - focus[1], place[2] - focus[2], 0.0 },
    objects, "direction");
}

TEST(StencilShadowPass, LampsCastAllAround)
{
  // A lamp in a ring of boxes, low over the ground: shadows go out in all directions, those of
  // boxes below it down and those of boxes above it nowhere that is seen. Cones change no mask, but that shadows where no light comes
  // are left out: so pictures are the same.
  for (const double cone : { 180.0, 90.0, 60.0, 30.0, 5.0 })
  {
    Scene scene;
    std::vector<RayObject> objects = { { scene.GroundMesh } };
    for (int i = 0; i < 6; ++i)
    {
      const double angle = vtkMath::Pi() * i / 3.0;
      objects.push_back({ moved(
        box(), 0.25, { 1.4 * std::cos(angle), 1.4 * std::sin(angle), 0.4 + 0.1 * i }, 11) });
      scene.Add(objects.back().Surface);
    }
    const RayLight lamp = { 0.0, 0.1, 1.0, 1.0 };
    vtkSmartPointer<vtkLight> light = scene.AddLight(lamp);
    light->SetConeAngle(cone);
    scene.Look(-2.0, -6.0, 7.0);
    auto window = MakeWindow(240, 180);
    window->AddRenderer(scene.Renderer);
    window->Render();
    const Image picture = Grab(window);
    scene.Pass->SkipCastersOutsideConesOff();
    window->Render();
    ExpectMask(scene, light, lamp, objects, ("cone " + std::to_string(cone)).c_str());
    EXPECT_EQ(Differences(Grab(window), picture), 0) << "cone " << cone;
  }
}

TEST(StencilShadowPass, LightsAndActorsThatMove)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  const Mesh still = moved(sphere(8, 16), 0.3, { -1.5, -0.5, 0.6 });
  vtkSmartPointer<vtkActor> mover = scene.Add(mesh);
  scene.Add(still);
  vtkSmartPointer<vtkLight> point = scene.AddLight(PointLight, 0.5);
  vtkSmartPointer<vtkLight> direction = scene.AddLight(DirectionalLight, 0.5);
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  const auto check = [&](const RayLight& position, const char* what) {
    const std::vector<RayObject> objects = { { scene.GroundMesh }, { mesh, mover->GetMatrix() },
      { still } };
    ExpectMask(scene, point, position, objects, what);
    ExpectMask(scene, direction, DirectionalLight, objects, what);
  };

  // The ground casts as well: three casters, two lights.
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 6);
  check(PointLight, "first");
  scene.Look(3.0, -6.0, 5.0);
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 0);
  check(PointLight, "camera moved");

  const RayLight elsewhere = { -0.5, 1.5, 3.5, 1.0 };
  point->SetPosition(elsewhere[0], elsewhere[1], elsewhere[2]);
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 3);
  check(elsewhere, "light moved");

  // A translation leaves a directional light where it was.
  mover->SetPosition(0.5, 0.2, 0.1);
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 1);
  check(elsewhere, "actor moved");

  direction->SwitchOff();
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 0);
  EXPECT_EQ(scene.Pass->GetMask(direction), nullptr);
  direction->SwitchOn();
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 3);
  check(elsewhere, "light on again");

  mesh->GetPoints()->SetPoint(0, 0.0, 0.0, 1.9);
  mesh->GetPoints()->Modified();
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 2);
  scene.Pass->SetKindToSmooth();
  window->Render();
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 6);
}

TEST(StencilShadowPass, LightsThatComeAndGo)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  scene.Add(mesh);
  const std::vector<RayObject> objects = { { scene.GroundMesh }, { mesh } };
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  std::vector<vtkSmartPointer<vtkLight>> lights;
  std::vector<RayLight> positions;
  Image five;
  for (int i = 0; i < 6; ++i)
  {
    positions.push_back({ 1.5 - 0.6 * i, 1.0 + 0.2 * i, 4.0, i % 2 == 0 ? 1.0 : 0.0 });
    lights.push_back(scene.AddLight(positions.back(), 0.15));
    window->Render();
    for (std::size_t k = 0; k < lights.size(); ++k)
    {
      ExpectMask(scene, lights[k], positions[k], objects, "added");
    }
    five = i == 4 ? Grab(window) : five;
  }
  scene.Renderer->RemoveLight(lights.back());
  window->Render();
  EXPECT_EQ(Differences(Grab(window), five), 0);

  // The same lights shine, but masks move to other channels: only the first light's shadow goes.
  const Image firstMask = scene.Mask(lights[0]);
  scene.Pass->SetLightCasts(lights[0], false);
  window->Render();
  const Image four = Grab(window);
  EXPECT_GT(Differences(four, five), 500);
  long elsewhere = 0;
  for (int y = 0; y < 150; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      elsewhere += Byte(firstMask, x, y) == 255 && Byte(four, x, y) != Byte(five, x, y);
    }
  }
  EXPECT_EQ(elsewhere, 0);
  ExpectMask(scene, lights[1], positions[1], objects, "first does not cast");
  scene.Pass->SetLightCasts(lights[0], true);
  window->Render();
  EXPECT_EQ(Differences(Grab(window), five), 0);
}

TEST(StencilShadowPass, ScenesWithoutShadows)
{
  Scene scene;
  auto window = MakeWindow(100, 80);
  window->AddRenderer(scene.Renderer);
  // No light, only a headlight, a light without a direction, an empty mesh.
  window->Render();
  vtkSmartPointer<vtkLight> headlight = scene.AddHeadlight(1.0);
  window->Render();
  EXPECT_EQ(scene.Pass->GetMask(headlight), nullptr);
  vtkSmartPointer<vtkLight> light = scene.AddLight({ 0.0, 0.0, 0.0, 0.0 });
  window->Render();
  EXPECT_EQ(scene.Pass->GetMask(light), nullptr);
  light->SetPosition(1.0, 1.0, 1.0);
  scene.Add(vtkNew<vtkPolyData>());
  vtkNew<vtkActor> withoutMapper;
  scene.Renderer->AddActor(withoutMapper);
  window->Render();
  ASSERT_TRUE(scene.Mask(light));
  EXPECT_EQ(blackFraction(scene.Mask(light)), 0.0);
}
