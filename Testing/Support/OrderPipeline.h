/**
 * @brief The study of convergence run on vtkSmoothLightSilhouette.
 */
#ifndef shadowtest_OrderPipeline_h
#define shadowtest_OrderPipeline_h

#include "OrderStudy.h"
#include "ShadowPipeline.h"

namespace shadowtest
{
/// Chords of discrete and accurate silhouettes are the silhouette itself and are measured along
/// their length; a smooth one stands for a curve, and its points are on it, between crossings too.
inline OrderFigures measureOrder(const OrderCase& study, int kind)
{
  return measureOrder(
    study,
    [kind](vtkPolyData* mesh, const LightPoint& light) -> vtkSmartPointer<vtkPolyData> {
      ShadowPipeline pipeline(mesh, light, kind);
      pipeline.Silhouette->SetTolerance(1e-7);
      return pipeline.silhouette();
    },
    kind == vtkSmoothLightSilhouette::SMOOTH ? 0 : 4);
}
}

#endif
