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
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>

#include <gtest/gtest.h>

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
  window->Render();
  EXPECT_EQ(Differences(scene.Mask(light), mask), 0);
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
      { "mirrored", [](vtkTransform* t) { t->Scale(-1.3, 0.8, 1.0); } } })
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
  window->Render();
  EXPECT_GT(blackFraction(scene.Mask(light)), 0.02);
  EXPECT_EQ(Differences(Grab(window), plain), 0);
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
