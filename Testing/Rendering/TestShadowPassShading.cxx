// Shading stays that of the mappers: where a mask is 255 a picture must be as without the pass, and
// where it is 0 as with that light's intensity at 0.

#include "ImageChecks.h"
#include "ShadowScene.h"
#include "TestMeshes.h"

#include "vtkStencilShadowPass.h"

#include <vtkActor.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace
{
using namespace shadowtest;

/**
 * The picture must be composed of those without the pass, where `light` is the only casting light.
 * Exact: a light times 1 or 0 rounds nothing.
 */
void ExpectComposed(Scene& scene, vtkLight* light, const char* what)
{
  SCOPED_TRACE(what);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  window->Render();
  const Image picture = Grab(window);
  const Image mask = scene.Mask(light);
  ASSERT_TRUE(mask);

  scene.Renderer->SetPass(nullptr);
  window->Render();
  const Image lit = Grab(window);
  const double intensity = light->GetIntensity();
  light->SetIntensity(0.0);
  window->Render();
  const Image unlit = Grab(window);
  light->SetIntensity(intensity);
  scene.Renderer->SetPass(scene.Pass);

  EXPECT_GT(blackFraction(mask), 0.02);
  long wrong = 0;
  long changed = 0;
  for (int y = 0; y < 150; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      vtkImageData* expected = Byte(mask, x, y) ? lit.Get() : unlit.Get();
      bool same = true;
      for (int i = 0; i < 3; ++i)
      {
        same = same && Byte(picture, x, y, i) == Byte(expected, x, y, i);
        changed += Byte(lit, x, y, i) > Byte(unlit, x, y, i) + 20;
      }
      wrong += !same;
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(changed, 5000);
}
}

TEST(StencilShadowPass, ShadingIsTheMappersOwn)
{
  struct Case
  {
    const char* Name;
    RayLight Light;
    bool Headlight;
    std::function<void(vtkActor*, vtkPolyData*)> Prepare;
  };
  const auto none = [](vtkActor*, vtkPolyData*) {};
  const auto shiny = [](vtkActor* actor, vtkPolyData*) {
    actor->GetProperty()->SetSpecular(0.5);
    actor->GetProperty()->SetSpecularPower(8.0);
  };
  const auto physical = [](vtkActor* actor, vtkPolyData*) {
    actor->GetProperty()->SetInterpolationToPBR();
    actor->GetProperty()->SetMetallic(0.3);
    actor->GetProperty()->SetRoughness(0.4);
  };
  const auto flat = [](vtkActor* actor, vtkPolyData*) {
    actor->GetProperty()->SetInterpolationToFlat();
  };
  const auto colored = [](vtkActor*, vtkPolyData* mesh) {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    colors->SetName("Colors");
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      colors->InsertNextTuple3(
        static_cast<double>(60 + 37 * i % 190), 200.0, static_cast<double>(255 - 53 * i % 200));
    }
    mesh->GetPointData()->SetScalars(colors);
  };
  for (const Case& test : std::vector<Case>{ { "point", PointLight, false, none },
         { "direction", DirectionalLight, false, none },
         { "point and headlight", PointLight, true, shiny },
         { "direction and headlight", DirectionalLight, true, shiny },
         { "flat", PointLight, false, flat }, { "colours", PointLight, false, colored },
         { "PBR point", PointLight, false, physical },
         { "PBR direction", DirectionalLight, false, physical },
         { "PBR and headlight", PointLight, true, physical } })
  {
    Scene scene;
    const Mesh mesh = moved(sphere(12, 24), 0.7, { 0.0, 0.0, 1.1 });
    vtkSmartPointer<vtkActor> caster = scene.Add(mesh);
    test.Prepare(caster, mesh);
    test.Prepare(scene.Ground, scene.GroundMesh);
    if (test.Headlight)
    {
      scene.AddHeadlight(0.3);
    }
    vtkSmartPointer<vtkLight> light = scene.AddLight(test.Light);
    ExpectComposed(scene, light, test.Name);
  }
}

TEST(StencilShadowPass, SpotConeLimitsLightOnly)
{
  Scene scene;
  scene.Add(FloatingBox());
  vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
  light->SetConeAngle(25.0);
  ExpectComposed(scene, light, "cone");
}
