// Shading stays that of the mappers: where a mask is 255 a picture must be as without the pass, and
// where it is 0 as with that light's intensity at 0.

#include "ImageChecks.h"
#include "ShadowScene.h"
#include "TestMeshes.h"

#include "vtkStencilShadowPass.h"

#include <vtkActor.h>
#include <vtkCellData.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkCompositePolyDataMapper2.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkMapper.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace
{
using namespace shadowtest;

/**
 * The picture must be composed of those without the pass, where `light` is the only casting light,
 * by a mask that is that of the objects over the ground. Exact: a light times 1 or 0 rounds
 * nothing.
 */
void ExpectComposed(Scene& scene, vtkLight* light, const RayLight& position,
  std::vector<RayObject> objects, const char* what)
{
  SCOPED_TRACE(what);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  window->Render();
  const Image picture = Grab(window);
  const Image mask = scene.Mask(light);
  ASSERT_TRUE(mask);
  objects.insert(objects.begin(), RayObject{ scene.GroundMesh });
  ExpectMask(scene, light, position, objects, what);

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
  long hidden = 0;
  for (int y = 0; y < 150; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      vtkImageData* expected = Byte(mask, x, y) ? lit.Get() : unlit.Get();
      bool same = true;
      bool isDimmed = false;
      for (int i = 0; i < 3; ++i)
      {
        same = same && Byte(picture, x, y, i) == Byte(expected, x, y, i);
        const bool differs = Byte(lit, x, y, i) > Byte(unlit, x, y, i) + 20;
        changed += differs;
        isDimmed = isDimmed || (differs && !Byte(mask, x, y));
      }
      wrong += !same;
      hidden += isDimmed;
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(changed, 5000);
  EXPECT_GT(hidden, 200);
}

/// Texture coordinates from above.
void AddTextureCoordinates(vtkPolyData* mesh)
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  coordinates->SetName("Coordinates");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* point = mesh->GetPoint(i);
    coordinates->InsertNextTuple2(0.4 * point[0] + 0.5, 0.4 * point[1] + 0.5);
  }
  mesh->GetPointData()->SetTCoords(coordinates);
}

/// Stripes in both directions, in colour.
vtkSmartPointer<vtkTexture> MakeTexture()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 16, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int pixel = 0; pixel < 256; ++pixel)
  {
    bytes[3 * pixel] = pixel % 4 < 2 ? 250 : 120;
    bytes[3 * pixel + 1] = pixel / 16 % 4 < 2 ? 240 : 100;
    bytes[3 * pixel + 2] = 180;
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->RepeatOn();
  texture->InterpolateOn();
  return texture;
}

/// Numbers from 0 to 1 on points or cells, which the mapper takes its colours by.
void AddScalars(vtkDataSetAttributes* data, vtkIdType count)
{
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("Numbers");
  for (vtkIdType i = 0; i < count; ++i)
  {
    scalars->InsertNextValue(static_cast<double>(37 * i % 101) / 100.0);
  }
  data->SetScalars(scalars);
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
  const auto physicalColored = [&](vtkActor* actor, vtkPolyData* mesh) {
    physical(actor, mesh);
    colored(actor, mesh);
  };
  const auto textured = [](vtkActor* actor, vtkPolyData* mesh) {
    AddTextureCoordinates(mesh);
    actor->SetTexture(MakeTexture());
  };
  const auto physicalTextured = [&](vtkActor* actor, vtkPolyData* mesh) {
    physical(actor, mesh);
    AddTextureCoordinates(mesh);
    const vtkSmartPointer<vtkTexture> texture = MakeTexture();
    texture->UseSRGBColorSpaceOn();
    actor->GetProperty()->SetBaseColorTexture(texture);
  };
  const auto pointScalars = [](vtkActor*, vtkPolyData* mesh) {
    AddScalars(mesh->GetPointData(), mesh->GetNumberOfPoints());
  };
  const auto cellScalars = [](vtkActor* actor, vtkPolyData* mesh) {
    AddScalars(mesh->GetCellData(), mesh->GetNumberOfCells());
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(5);
    table->SetHueRange(0.1, 0.6);
    table->SetSaturationRange(0.5, 0.5);
    table->Build();
    actor->GetMapper()->SetLookupTable(table);
    actor->GetMapper()->SetScalarModeToUseCellData();
  };
  const auto interpolatedScalars = [](vtkActor* actor, vtkPolyData* mesh) {
    AddScalars(mesh->GetPointData(), mesh->GetNumberOfPoints());
    actor->GetMapper()->SetInterpolateScalarsBeforeMapping(true);
  };
  for (const Case& test : std::vector<Case>{ { "point", PointLight, false, none },
         { "direction", DirectionalLight, false, none },
         { "point and headlight", PointLight, true, shiny },
         { "direction and headlight", DirectionalLight, true, shiny },
         { "flat", PointLight, false, flat }, { "colours", PointLight, false, colored },
         { "PBR point", PointLight, false, physical },
         { "PBR direction", DirectionalLight, false, physical },
         { "PBR and headlight", PointLight, true, physical },
         { "PBR colours", DirectionalLight, false, physicalColored },
         { "PBR texture", PointLight, false, physicalTextured },
         { "texture", PointLight, true, textured },
         { "point scalars", DirectionalLight, false, pointScalars },
         { "cell scalars", PointLight, false, cellScalars },
         { "scalars mapped per pixel", PointLight, true, interpolatedScalars } })
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
    ExpectComposed(scene, light, test.Light, { { mesh } }, test.Name);
  }
}

TEST(StencilShadowPass, LightsShineAsWithoutThePass)
{
  struct Case
  {
    const char* Name;
    RayLight Light;
    std::function<void(vtkLight*)> Prepare;
  };
  for (const Case& test :
    std::vector<Case>{ { "cone", PointLight, [](vtkLight* light) { light->SetConeAngle(25.0); } },
      { "cone with a falloff", PointLight,
        [](vtkLight* light) {
          light->SetConeAngle(40.0);
          light->SetExponent(12.0);
        } },
      { "cone to the side", { -2.5, -1.5, 2.5, 1.0 },
        [](vtkLight* light) {
          light->SetConeAngle(35.0);
          light->SetFocalPoint(0.3, 0.2, 0.8);
        } },
      { "attenuation", PointLight,
        [](vtkLight* light) { light->SetAttenuationValues(0.2, 0.1, 0.05); } },
      { "attenuated cone", PointLight,
        [](vtkLight* light) {
          light->SetConeAngle(30.0);
          light->SetAttenuationValues(0.3, 0.2, 0.0);
        } },
      { "intensity above 1", DirectionalLight, [](vtkLight* light) { light->SetIntensity(3.0); } },
      { "faint", PointLight, [](vtkLight* light) { light->SetIntensity(0.3); } },
      { "colour", PointLight, [](vtkLight* light) {
         light->SetDiffuseColor(1.0, 0.4, 0.2);
         light->SetSpecularColor(0.2, 0.5, 1.0);
       } } })
  {
    for (const bool physical : { false, true })
    {
      Scene scene;
      const Mesh mesh = FloatingBox();
      vtkSmartPointer<vtkActor> caster = scene.Add(mesh);
      for (vtkActor* actor : { caster.Get(), scene.Ground.Get() })
      {
        actor->GetProperty()->SetSpecular(0.3);
        actor->GetProperty()->SetSpecularPower(5.0);
        actor->GetProperty()->SetInterpolation(physical ? VTK_PBR : VTK_PHONG);
      }
      scene.AddHeadlight(0.2);
      vtkSmartPointer<vtkLight> light = scene.AddLight(test.Light);
      test.Prepare(light);
      ExpectComposed(scene, light, test.Light, { { mesh } }, test.Name);
    }
  }
}

TEST(StencilShadowPass, BlocksInTheirColours)
{
  for (const bool scalars : { false, true })
  {
    Scene scene;
    const Mesh cube = moved(box(), 0.45, { -0.8, 0.2, 0.9 }, 5);
    const Mesh ball = moved(sphere(10, 20), 0.5, { 0.8, 0.0, 1.1 });
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, cube);
    blocks->SetBlock(1, ball);
    blocks->SetBlock(2, scene.GroundMesh);
    vtkNew<vtkCompositePolyDataMapper2> mapper;
    mapper->SetInputDataObject(blocks);
    vtkNew<vtkCompositeDataDisplayAttributes> attributes;
    mapper->SetCompositeDataDisplayAttributes(attributes);
    const double orange[3] = { 1.0, 0.6, 0.3 };
    attributes->SetBlockColor(ball, orange);
    const double green[3] = { 0.6, 0.9, 0.5 };
    attributes->SetBlockColor(scene.GroundMesh, green);
    if (scalars)
    {
      // On one block only, whose shader is another one.
      AddScalars(cube->GetPointData(), cube->GetNumberOfPoints());
    }
    scene.Renderer->RemoveActor(scene.Ground);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    scene.Renderer->AddActor(actor);
    scene.AddHeadlight(0.2);
    vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
    ExpectComposed(scene, light, PointLight, { { cube }, { ball } },
      scalars ? "scalars on a block" : "colours of blocks");
  }
}

TEST(StencilShadowPass, GlyphsInTheirColours)
{
  for (const bool physical : { false, true })
  {
    Scene scene;
    vtkNew<vtkPoints> places;
    vtkNew<vtkDoubleArray> numbers;
    numbers->SetName("Numbers");
    const Mesh source = moved(sphere(8, 16), 0.35, { 0.0, 0.0, 0.0 });
    std::vector<Mesh> copies;
    for (int i = 0; i < 9; ++i)
    {
      const Vec3 place = { -1.5 + 1.5 * (i % 3), -1.2 + 1.2 * (i / 3), 0.6 + 0.1 * i };
      places->InsertNextPoint(place.data());
      numbers->InsertNextValue(0.125 * i);
      copies.push_back(moved(source, 1.0, place));
    }
    vtkNew<vtkPolyData> points;
    points->SetPoints(places);
    points->GetPointData()->SetScalars(numbers);
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputData(points);
    mapper->SetSourceData(source);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetInterpolation(physical ? VTK_PBR : VTK_PHONG);
    scene.Renderer->AddActor(actor);
    vtkSmartPointer<vtkLight> light = scene.AddLight(PointLight);
    ExpectComposed(scene, light, PointLight, { { merged(copies) } }, physical ? "PBR" : "Phong");
  }
}
