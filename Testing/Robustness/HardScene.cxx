#include "HardScene.h"

#include "ShadowScene.h"

#include "vtkStencilShadowPass.h"

#include <vtkInformation.h>
#include <vtkRenderWindow.h>

namespace shadowtest
{
void expectCastMask(const std::vector<HardCaster>& casters, const RayLight& light)
{
  expectCastMask(casters, light, light);
}

void expectCastMask(
  const std::vector<HardCaster>& casters, const RayLight& light, const RayLight& truth)
{
  Scene scene;
  std::vector<RayObject> objects = { { scene.GroundMesh } };
  for (const HardCaster& caster : casters)
  {
    scene.Add(caster.Drawn);
    if (caster.ShowTriangles)
    {
      vtkNew<vtkInformation> keys;
      keys->Set(vtkStencilShadowPass::CASTS_SHADOW(), 0);
      scene.Add(caster.Triangles)->SetPropertyKeys(keys);
    }
    objects.push_back({ caster.Triangles ? caster.Triangles : caster.Drawn });
  }
  vtkSmartPointer<vtkLight> drawn = scene.AddLight(light);
  auto window = MakeWindow(240, 180);
  window->AddRenderer(scene.Renderer);
  window->Render();
  ExpectMask(scene, drawn, truth, objects, "");
}
}
