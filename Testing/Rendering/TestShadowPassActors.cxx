// What actors say about themselves: matrices, assemblies, the keys of the pass, translucency.

#include "ImageChecks.h"
#include "ShadowScene.h"
#include "TestMeshes.h"

#include "vtkStencilShadowPass.h"

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace
{
using namespace shadowtest;

void SetKey(vtkProp* prop, vtkInformationIntegerKey* key, int value)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  if (!keys)
  {
    vtkNew<vtkInformation> made;
    prop->SetPropertyKeys(made);
    keys = made;
  }
  keys->Set(key, value);
}
}

TEST(StencilShadowPass, Keys)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  vtkSmartPointer<vtkActor> caster = scene.Add(mesh);
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  window->Render();
  const Image shadowed = Grab(window);
  const Image mask = scene.Mask(light);
  EXPECT_GT(blackFraction(mask), 0.05);

  scene.Renderer->SetPass(nullptr);
  window->Render();
  const Image plain = Grab(window);
  scene.Renderer->SetPass(scene.Pass);
  EXPECT_GT(Differences(shadowed, plain), 1000);

  SetKey(caster, vtkStencilShadowPass::CASTS_SHADOW(), 0);
  window->Render();
  EXPECT_EQ(blackFraction(scene.Mask(light)), 0.0);
  EXPECT_EQ(Differences(Grab(window), plain), 0);

  SetKey(caster, vtkStencilShadowPass::CASTS_SHADOW(), 1);
  SetKey(caster, vtkStencilShadowPass::RECEIVES_SHADOW(), 0);
  SetKey(scene.Ground, vtkStencilShadowPass::RECEIVES_SHADOW(), 0);
  scene.Pass->SkipCastersWithoutReceiversOff();
  window->Render();
  EXPECT_EQ(Differences(scene.Mask(light), mask), 0);
  EXPECT_EQ(Differences(Grab(window), plain), 0);
  scene.Pass->SkipCastersWithoutReceiversOn();
  window->Render();
  EXPECT_EQ(blackFraction(scene.Mask(light)), 0.0);
  EXPECT_EQ(Differences(Grab(window), plain), 0);

  SetKey(caster, vtkStencilShadowPass::RECEIVES_SHADOW(), 1);
  SetKey(scene.Ground, vtkStencilShadowPass::RECEIVES_SHADOW(), 1);
  window->Render();
  EXPECT_EQ(Differences(Grab(window), shadowed), 0);

  scene.Pass->SetLightCasts(light, false);
  EXPECT_FALSE(scene.Pass->GetLightCasts(light));
  window->Render();
  EXPECT_EQ(scene.Pass->GetMask(light), nullptr);
  EXPECT_EQ(Differences(Grab(window), plain), 0);
  scene.Pass->SetLightCasts(light, true);
  window->Render();
  EXPECT_EQ(Differences(Grab(window), shadowed), 0);
}

TEST(StencilShadowPass, PropsThatShareTheirKeys)
{
  Scene scene;
  vtkSmartPointer<vtkActor> caster = scene.Add(FloatingBox());
  scene.AddLight(PointLight);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  window->Render();
  const Image picture = Grab(window);

  vtkNew<vtkInformation> keys;
  caster->SetPropertyKeys(keys);
  scene.Ground->SetPropertyKeys(keys);
  window->Render();
  EXPECT_EQ(Differences(Grab(window), picture), 0);
  const int references = scene.Pass->GetReferenceCount();
  window->Render();
  EXPECT_EQ(scene.Pass->GetReferenceCount(), references);
  keys->Set(vtkStencilShadowPass::CASTS_SHADOW(), 0);
  window->Render();
  EXPECT_GT(Differences(Grab(window), picture), 1000);
}

TEST(StencilShadowPass, TransformedActors)
{
  struct Case
  {
    const char* Name;
    std::function<void(vtkTransform*)> Apply;
  };
  for (const Case& test :
    std::vector<Case>{ { "translated", [](vtkTransform* t) { t->Translate(0.7, -0.4, 0.3); } },
      { "rotated", [](vtkTransform* t) { t->RotateWXYZ(50.0, 1.0, 2.0, 3.0); } },
      { "scaled",
        [](vtkTransform* t) {
          t->RotateX(20.0);
          t->Scale(1.6, 0.5, 0.9);
          t->RotateY(35.0);
        } },
      { "mirrored", [](vtkTransform* t) { t->Scale(-1.3, 0.8, 1.0); } },
      { "all of it",
        [](vtkTransform* t) {
          t->RotateWXYZ(40.0, 3.0, 1.0, 2.0);
          t->Scale(1.2, -0.6, 0.9);
          t->RotateWXYZ(70.0, -1.0, 2.0, 1.0);
          t->Scale(0.8, 1.0, 1.5);
        } },
      { "mirrored in all axes", [](vtkTransform* t) { t->Scale(-1.0, -1.2, -0.9); } } })
  {
    for (const RayLight& position : { PointLight, DirectionalLight })
    {
      Scene scene;
      const Mesh mesh = moved(torus(20, 10), 0.6, { 0.0, 0.0, 0.0 }, 3);
      vtkSmartPointer<vtkActor> caster = scene.Add(mesh);
      // Its shadow overlaps: volumes of opposite orientation would cancel out.
      const Mesh other = moved(box(), 0.4, { 0.3, 0.2, 2.1 }, 5);
      scene.Add(other);
      vtkNew<vtkTransform> transform;
      transform->Translate(0.0, 0.0, 1.3);
      test.Apply(transform);
      caster->SetUserTransform(transform);
      vtkSmartPointer<vtkLight> light = scene.AddLight(position);
      auto window = MakeWindow(240, 180);
      window->AddRenderer(scene.Renderer);
      window->Render();
      ExpectMask(scene, light, position,
        { { scene.GroundMesh }, { mesh, caster->GetMatrix() }, { other } }, test.Name);
    }
  }
}

TEST(StencilShadowPass, PartsOfAssemblies)
{
  Scene scene;
  const Mesh mesh = moved(box(), 0.3, { 0.0, 0.0, 0.0 }, 5);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> left;
  left->SetMapper(mapper);
  left->SetPosition(-0.8, 0.0, 0.0);
  vtkNew<vtkActor> right;
  right->SetMapper(mapper);
  right->SetPosition(0.8, 0.0, 0.0);
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(left);
  assembly->AddPart(right);
  assembly->SetPosition(0.0, 0.0, 1.2);
  assembly->RotateZ(40.0);
  scene.Renderer->AddActor(assembly);
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  window->Render();

  vtkNew<vtkMatrix4x4> leftMatrix;
  vtkNew<vtkMatrix4x4> rightMatrix;
  vtkMatrix4x4::Multiply4x4(assembly->GetMatrix(), left->GetMatrix(), leftMatrix);
  vtkMatrix4x4::Multiply4x4(assembly->GetMatrix(), right->GetMatrix(), rightMatrix);
  ExpectMask(scene, light, PointLight,
    { { scene.GroundMesh }, { mesh, leftMatrix }, { mesh, rightMatrix } }, "assembly");

  SetKey(assembly, vtkStencilShadowPass::CASTS_SHADOW(), 0);
  window->Render();
  EXPECT_EQ(blackFraction(scene.Mask(light)), 0.0);
  const Image plain = Grab(window);

  // The ground as a part of another assembly, which at first receives.
  SetKey(assembly, vtkStencilShadowPass::CASTS_SHADOW(), 1);
  scene.Renderer->RemoveActor(scene.Ground);
  vtkNew<vtkAssembly> base;
  base->AddPart(scene.Ground);
  scene.Renderer->AddActor(base);
  window->Render();
  EXPECT_GT(Differences(Grab(window), plain), 1000);
  SetKey(base, vtkStencilShadowPass::RECEIVES_SHADOW(), 0);
  SetKey(assembly, vtkStencilShadowPass::RECEIVES_SHADOW(), 0);
  scene.Pass->SkipCastersWithoutReceiversOff();
  window->Render();
  EXPECT_GT(blackFraction(scene.Mask(light)), 0.02);
  EXPECT_EQ(Differences(Grab(window), plain), 0);
}

TEST(StencilShadowPass, NestedAssemblies)
{
  // Mirrored on the way, and one actor in two places.
  const Mesh mesh = moved(torus(16, 8), 0.3, { 0.0, 0.0, 0.0 }, 3);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(0.5, 0.1, 0.0);
  actor->RotateX(35.0);
  actor->SetScale(1.2, 0.9, 0.7);
  vtkNew<vtkAssembly> inner;
  inner->AddPart(actor);
  inner->SetPosition(0.0, 0.6, 0.1);
  inner->RotateZ(30.0);
  vtkNew<vtkAssembly> mirrored;
  mirrored->AddPart(inner);
  mirrored->AddPart(actor);
  mirrored->SetScale(-1.0, 1.1, 1.0);
  vtkNew<vtkAssembly> outer;
  outer->AddPart(mirrored);
  outer->SetPosition(0.2, -0.2, 1.1);
  outer->RotateY(15.0);

  for (const RayLight& position : { PointLight, DirectionalLight })
  {
    Scene scene;
    scene.Renderer->AddActor(outer);
    vtkSmartPointer<vtkLight> light = scene.AddLight(position);
    auto window = MakeWindow(240, 180);
    window->AddRenderer(scene.Renderer);
    const auto check = [&](const char* what) {
      vtkNew<vtkTransform> once;
      once->Concatenate(outer->GetMatrix());
      once->Concatenate(mirrored->GetMatrix());
      vtkNew<vtkTransform> twice;
      twice->Concatenate(once->GetMatrix());
      once->Concatenate(actor->GetMatrix());
      twice->Concatenate(inner->GetMatrix());
      twice->Concatenate(actor->GetMatrix());
      window->Render();
      ExpectMask(scene, light, position,
        { { scene.GroundMesh }, { mesh, once->GetMatrix() }, { mesh, twice->GetMatrix() } }, what);
    };
    check("nested");
    EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 3);
    check("again");
    EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 0);
    inner->RotateZ(25.0);
    check("inner one turned");
    EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 1);
    outer->RotateZ(-20.0);
    check("outer one turned");
    EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 2);

    // The actor is a part in two places: hidden, it is in neither.
    actor->VisibilityOff();
    window->Render();
    EXPECT_EQ(blackFraction(scene.Mask(light)), 0.0);
    actor->VisibilityOn();
    outer->VisibilityOff();
    window->Render();
    EXPECT_EQ(blackFraction(scene.Mask(light)), 0.0);
    outer->VisibilityOn();
    check("visible again");

    // The outermost assembly's keys are those of all parts; VTK drops what others say.
    SetKey(mirrored, vtkStencilShadowPass::CASTS_SHADOW(), 0);
    check("an inner assembly with a key");
    SetKey(outer, vtkStencilShadowPass::CASTS_SHADOW(), 0);
    window->Render();
    EXPECT_EQ(blackFraction(scene.Mask(light)), 0.0);
    outer->SetPropertyKeys(nullptr);
    mirrored->SetPropertyKeys(nullptr);
  }
}

TEST(StencilShadowPass, HiddenActors)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  const Mesh other = moved(sphere(8, 16), 0.4, { 1.4, 0.4, 1.0 });
  vtkSmartPointer<vtkActor> caster = scene.Add(mesh);
  scene.Add(other);
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  window->Render();
  ExpectMask(scene, light, PointLight, { { scene.GroundMesh }, { mesh }, { other } }, "both");
  caster->VisibilityOff();
  window->Render();
  ExpectMask(scene, light, PointLight, { { scene.GroundMesh }, { other } }, "one");
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 0);
  caster->VisibilityOn();
  window->Render();
  ExpectMask(scene, light, PointLight, { { scene.GroundMesh }, { mesh }, { other } }, "shown");
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 1);
}

TEST(StencilShadowPass, KeysOfOneAmongSeveral)
{
  Scene scene;
  const Mesh mesh = FloatingBox();
  const Mesh other = moved(sphere(8, 16), 0.4, { 1.4, 0.4, 1.0 });
  // Under the box and in its shadow.
  const Mesh table = moved(ground(0.0, 0.5), 1.0, { -0.3, -0.2, 0.3 });
  vtkSmartPointer<vtkActor> caster = scene.Add(mesh);
  scene.Add(other);
  vtkSmartPointer<vtkActor> receiver = scene.Add(table);
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  const auto check = [&](bool casts, const char* what) {
    window->Render();
    RayObject box = { mesh };
    box.Casts = casts;
    ExpectMask(scene, light, PointLight, { { scene.GroundMesh }, box, { other }, { table } }, what);
  };
  check(true, "all cast");
  const Image all = Grab(window);

  // One that does not cast still receives, and nothing else is made again.
  SetKey(caster, vtkStencilShadowPass::CASTS_SHADOW(), 0);
  check(false, "the box does not");
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 0);
  SetKey(caster, vtkStencilShadowPass::CASTS_SHADOW(), 1);
  check(true, "it does");
  EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), 1);
  EXPECT_EQ(Differences(Grab(window), all), 0);

  // One that does not receive is lit, still casts, and changes no other pixel.
  SetKey(receiver, vtkStencilShadowPass::RECEIVES_SHADOW(), 0);
  check(true, "the table does not receive");
  const Image free = Grab(window);
  const RayScene rays({ { scene.GroundMesh }, { mesh }, { other }, { table } });
  const RayView view = ViewOf(scene.Renderer, free);
  long changed = 0;
  long elsewhere = 0;
  for (int y = 0; y < view.Height; ++y)
  {
    for (int x = 0; x < view.Width; ++x)
    {
      if (Byte(free, x, y) == Byte(all, x, y))
      {
        continue;
      }
      ++changed;
      bool isTable = false;
      for (int i = 0; i < 25 && !isTable; ++i)
      {
        isTable =
          rays.look(view, x + 0.5 + (i % 5 - 2) / 2.0, y + 0.5 + (i / 5 - 2) / 2.0, PointLight)
            .Object == 3;
      }
      elsewhere += !isTable;
    }
  }
  EXPECT_GT(changed, 200);
  EXPECT_EQ(elsewhere, 0);
}

TEST(StencilShadowPass, OnlyWhatMovedIsMadeAgain)
{
  Scene scene;
  std::vector<Mesh> meshes;
  std::vector<vtkSmartPointer<vtkActor>> actors;
  for (int i = 0; i < 4; ++i)
  {
    meshes.push_back(moved(box(), 0.3, { 0.0, 0.0, 0.0 }, static_cast<std::uint64_t>(i) + 1));
    actors.push_back(scene.Add(meshes.back()));
    actors.back()->SetPosition(-1.5 + i, 0.4 * (i % 2), 0.8 + 0.1 * i);
  }
  const RayLight other = { -2.0, 1.0, 3.0, 1.0 };
  vtkSmartPointer<vtkLight> point = scene.AddLight(PointLight, 0.4);
  vtkSmartPointer<vtkLight> lamp = scene.AddLight(other, 0.3);
  vtkSmartPointer<vtkLight> direction = scene.AddLight(DirectionalLight, 0.3);
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  const auto check = [&](int made, const char* what) {
    SCOPED_TRACE(what);
    window->Render();
    EXPECT_EQ(scene.Pass->GetNumberOfVolumesMade(), made);
    std::vector<RayObject> objects = { { scene.GroundMesh } };
    for (std::size_t i = 0; i < actors.size(); ++i)
    {
      objects.push_back({ meshes[i], actors[i]->GetMatrix() });
    }
    ExpectMask(scene, point, PointLight, objects, "first lamp");
    ExpectMask(scene, lamp, other, objects, "second lamp");
    ExpectMask(scene, direction, DirectionalLight, objects, "direction");
  };
  check(15, "first");
  check(0, "at rest");
  actors[1]->RotateX(20.0);
  check(3, "one turned");
  actors[1]->SetPosition(-0.4, -0.5, 1.2);
  check(2, "one moved: a directional light stays where it was");
  actors[0]->SetPosition(-1.4, 0.2, 0.9);
  actors[2]->SetScale(1.0, 1.5, 0.8);
  check(5, "one moved, one scaled");
  actors[3]->GetProperty()->SetColor(0.5, 0.9, 0.4);
  check(0, "one coloured");
  meshes[2]->GetPoints()->SetPoint(0, 0.0, 0.0, 0.6);
  meshes[2]->GetPoints()->Modified();
  check(3, "one bent");
}

TEST(StencilShadowPass, TranslucentActorsNeitherCastNorDarken)
{
  Scene scene;
  scene.Add(FloatingBox());
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  window->Render();
  const Image mask = scene.Mask(light);

  // Over the shadow, as the eye sees it.
  vtkSmartPointer<vtkActor> pane = scene.Add(moved(ground(0.0, 1.0), 1.0, { -0.8, -1.0, 1.0 }));
  pane->GetProperty()->SetOpacity(0.5);
  window->Render();
  EXPECT_EQ(Differences(scene.Mask(light), mask), 0);
  const Image picture = Grab(window);
  SetKey(pane, vtkStencilShadowPass::RECEIVES_SHADOW(), 0);
  window->Render();
  EXPECT_EQ(Differences(Grab(window), picture), 0);
  pane->VisibilityOff();
  window->Render();
  EXPECT_GT(Differences(Grab(window), picture), 1000);
}
