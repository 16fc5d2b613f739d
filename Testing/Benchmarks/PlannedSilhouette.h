// The silhouette that the pass makes of a caster, made once more.
#ifndef PlannedSilhouette_h
#define PlannedSilhouette_h

#include "SceneBounds.h"
#include "ShadowPlan.h"
#include "SilhouetteChoice.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSmoothLightSilhouette.h>
#include <vtkStencilShadowPass.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace benchmarks
{
/// What it says of a caster without matrix in a square window.
struct PlannedSilhouette
{
  double Pixel = 0.0;     ///< see CasterPlan
  double Tolerance = 0.0; ///< 0 if it is discrete
  vtkIdType Points = 0;

  PlannedSilhouette(vtkStencilShadowPass* pass, vtkRenderer* renderer, int size, vtkPolyData* mesh,
    const std::array<double, 4>& light)
  {
    vtkNew<vtkSmoothLightSilhouette> silhouette;
    silhouette->SetInputData(mesh);
    silhouette->SetLightPosition(light.data());
    const double deviation = silhouette->ComputeMeshDeviation();
    Matrix4 identity{};
    vtkMatrix4x4::Identity(identity.data());
    vtkCamera* camera = renderer->GetActiveCamera();
    std::vector<vtkProp*> receivingProps;
    const ShadowPlan plan(
      { ToMatrix4(camera->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0)), size, size },
      FindReceivers(renderer, receivingProps), {});
    const std::array<double, 6> bounds = FindFiniteBounds(mesh);
    const double room = 0.1 * FindDiagonal(bounds) + 2.0 * deviation;
    this->Pixel = plan.Decide({ light }, CornersOf(WithRoom(bounds, room), identity)).Pixel;
    const bool isChosen = pass->GetKind() == vtkStencilShadowPass::AUTOMATIC;
    const SilhouetteChoice choice =
      ChooseSilhouette(isChosen ? deviation : std::numeric_limits<double>::quiet_NaN(), this->Pixel,
        pass->GetPixelTolerance());
    silhouette->SetKindToDiscrete();
    if (choice.Smooth && pass->GetKind() != vtkStencilShadowPass::DISCRETE)
    {
      constexpr double finest = 1e-6;
      this->Tolerance = std::clamp(choice.Tolerance, finest * mesh->GetLength(), mesh->GetLength());
      silhouette->SetKindToSmooth();
      silhouette->SetToleranceModeToWorld();
      silhouette->SetTolerance(this->Tolerance);
    }
    silhouette->Update();
    this->Points = silhouette->GetOutput()->GetNumberOfPoints();
  }
};
}

#endif
