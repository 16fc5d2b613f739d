// Many shadow volumes around one point: more than the 8 bits of a stencil tell apart.

#include "ShadowPipeline.h"
#include "ShadowScene.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{
using namespace shadowtest;

// From outside of the stack, so that all sheets but the last lie between the lamp and the ground.
const RayLight Lamp = { 0.4, 0.3, 6.0, 1.0 };

// Sheets over one another, each a little smaller than the one below if they are to be a pyramid.
std::vector<Mesh> sheets(int count, bool pyramid)
{
  std::vector<Mesh> stack;
  for (int i = 0; i < count; ++i)
  {
    const double halfSize = pyramid ? 1.0 - 0.9 * i / count : 0.6;
    stack.push_back(ground(0.5 + 0.005 * i, halfSize));
  }
  return stack;
}

// A comb of fins that stand on a common base: one closed surface without a crease in topology.
Mesh heatSink(int fins)
{
  MeshBuilder mesh;
  const double pitch = 2.0 / fins;
  std::vector<std::array<double, 2>> outline;
  for (int i = 0; i < fins; ++i)
  {
    const double left = -1.0 + pitch * i;
    const double height = 0.4 + 0.8 * i / fins;
    outline.push_back({ left, height });
    outline.push_back({ left + 0.5 * pitch, height });
    outline.push_back({ left + 0.5 * pitch, 0.3 });
    outline.push_back({ left + pitch, 0.3 });
  }
  // Front and back of each column, and what joins them; z is up, the fins stand across x.
  std::vector<vtkIdType> front;
  std::vector<vtkIdType> back;
  std::vector<vtkIdType> frontBase;
  std::vector<vtkIdType> backBase;
  for (const auto& [x, z] : outline)
  {
    front.push_back(mesh.addPoint({ x, -0.8, z }));
    back.push_back(mesh.addPoint({ x, 0.8, z }));
    frontBase.push_back(mesh.addPoint({ x, -0.8, 0.1 }));
    backBase.push_back(mesh.addPoint({ x, 0.8, 0.1 }));
  }
  const std::size_t last = outline.size() - 1;
  for (std::size_t i = 0; i < last; ++i)
  {
    mesh.addQuad(front[i], front[i + 1], back[i + 1], back[i]);
    mesh.addQuad(frontBase[i + 1], frontBase[i], backBase[i], backBase[i + 1]);
    if (outline[i][0] != outline[i + 1][0])
    {
      mesh.addQuad(frontBase[i], frontBase[i + 1], front[i + 1], front[i]);
      mesh.addQuad(backBase[i + 1], backBase[i], back[i], back[i + 1]);
    }
  }
  mesh.addQuad(frontBase[0], front[0], back[0], backBase[0]);
  mesh.addQuad(front[last], frontBase[last], backBase[last], back[last]);
  return mesh.build();
}

double greatestDepth(vtkPolyData* mesh, const RayLight& light)
{
  ShadowPipeline pipeline(mesh, light, vtkSmoothLightSilhouette::DISCRETE);
  return fieldValue(pipeline.volume(), "GreatestDepth");
}

void expectMask(const std::vector<Mesh>& meshes, const RayLight& position, const char* what)
{
  Scene scene;
  std::vector<RayObject> objects = { { scene.GroundMesh } };
  for (const Mesh& mesh : meshes)
  {
    scene.Add(mesh);
    objects.push_back({ mesh });
  }
  const vtkSmartPointer<vtkLight> light = scene.AddLight(position);
  const auto window = MakeWindow(300, 220);
  window->AddRenderer(scene.Renderer);
  window->Render();
  ExpectMask(scene, light, position, objects, what);
}
}

TEST(NestedVolumes, SheetsOfOneSizeUpTo256)
{
  // 8 bits would take exactly 256 for none.
  for (const int count : { 127, 128, 255, 256, 257 })
  {
    const Mesh stack = merged(sheets(count, false));
    EXPECT_EQ(greatestDepth(stack, Lamp), count);
    expectMask({ stack }, Lamp, (std::to_string(count) + " sheets").c_str());
  }
}

TEST(NestedVolumes, A300FoldPyramidOfSheets)
{
  const Mesh pyramid = merged(sheets(300, true));
  EXPECT_EQ(greatestDepth(pyramid, Lamp), 300);
  expectMask({ pyramid }, Lamp, "pyramid");
}

TEST(NestedVolumes, A300FoldPyramidOfActors)
{
  expectMask(sheets(300, true), Lamp, "actors");
}

TEST(NestedVolumes, OneClosedPartOf300Fins)
{
  const RayLight across = { 4.0, 0.3, 1.2, 0.0 };
  const Mesh sink = heatSink(300);
  EXPECT_GE(greatestDepth(sink, across), 256);
  expectMask({ sink }, across, "fins");
}

// Lights whose counts need floats and others in one frame, at more than one size.
TEST(NestedVolumes, LightsOfEitherCountTogether)
{
  const Mesh stack = merged(sheets(140, false));
  const std::array<RayLight, 3> positions = { { { 4.0, 0.5, 0.03, 0.0 }, Lamp,
    { 0.3, 0.2, 1.0, 0.0 } } };
  EXPECT_LT(greatestDepth(stack, positions[0]), 127);
  EXPECT_GT(greatestDepth(stack, positions[1]), 127);
  Scene scene;
  scene.Add(stack);
  std::vector<vtkSmartPointer<vtkLight>> lights;
  for (const RayLight& position : positions)
  {
    lights.push_back(scene.AddLight(position));
  }
  const auto window = MakeWindow(300, 220);
  window->AddRenderer(scene.Renderer);
  for (const int width : { 300, 220, 330 })
  {
    window->SetSize(width, 220);
    window->Render();
    for (std::size_t i = 0; i < lights.size(); ++i)
    {
      ExpectMask(scene, lights[i], positions[i], { { scene.GroundMesh }, { stack } }, "lights");
    }
  }
}
