// Where a surface is hollow towards the light it lies in its own shadow: no light may get in
// between a mesh and the walls that begin at its contour.

#include "LightLeak.h"
#include "ShadowScene.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <gtest/gtest.h>

namespace
{
using namespace shadowtest;

const std::array<RayLight, 3> Lights = { { { 1.0, -0.4, 0.5, 0.0 }, { -0.5, 0.9, 0.4, 0.0 },
  { 2.5, 1.0, 1.5, 1.0 } } };

LeakCounts countTorusLeaks(int kind)
{
  static const RayScene rays({ { torus(512, 256) } });
  LeakCounts counts{};
  for (const RayLight& position : Lights)
  {
    Scene scene;
    scene.Renderer->RemoveActor(scene.Ground);
    scene.Pass->SetKind(kind);
    scene.Add(torus(36, 16));
    const auto light = scene.AddLight(position);
    scene.Look(1.4, -2.2, 2.4);
    const auto window = MakeWindow(400, 400);
    window->AddRenderer(scene.Renderer);
    window->Render();
    const Image mask = scene.Mask(light);
    countLeaks(rays.render(ViewOf(scene.Renderer, mask), position), mask, counts);
  }
  return counts;
}
}

TEST(ConcaveContours, LetNoLightIn)
{
  const double lostByTriangles = countTorusLeaks(vtkStencilShadowPass::DISCRETE)[2].percentLost();
  for (const int kind : { vtkStencilShadowPass::DISCRETE, vtkStencilShadowPass::ACCURATE,
         vtkStencilShadowPass::SMOOTH })
  {
    const LeakCounts counts = countTorusLeaks(kind);
    for (std::size_t i = 1; i < counts.size(); ++i)
    {
      EXPECT_GT(counts[i].Shadow, 300) << "cosines from " << LeakCosines[i];
      EXPECT_LT(counts[i].percentLeaking(), tolerance::LeakPercent)
        << "kind " << kind << ", cosines from " << LeakCosines[i] << ": " << counts[i].Leaking
        << " of " << counts[i].Shadow;
    }
    // Elsewhere corner fields keep smooth what the triangles' own shadow breaks up.
    if (kind != vtkStencilShadowPass::DISCRETE)
    {
      EXPECT_GT(counts[2].Lit, 300);
      EXPECT_LT(counts[2].percentLost(), 0.25 * lostByTriangles);
    }
  }
}
