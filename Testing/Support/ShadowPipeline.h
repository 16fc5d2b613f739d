/**
 * @brief The pipeline that most tests run: mesh, silhouette, volume.
 */
#ifndef shadowtest_ShadowPipeline_h
#define shadowtest_ShadowPipeline_h

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkShadowVolumeExtruder.h>
#include <vtkSmoothLightSilhouette.h>

#include <vtkDataArray.h>
#include <vtkFieldData.h>

#include <array>
#include <limits>

namespace shadowtest
{
using LightPosition = std::array<double, 4>;

/// Both filters on one mesh.
struct ShadowPipeline
{
  vtkNew<vtkSmoothLightSilhouette> Silhouette;
  vtkNew<vtkShadowVolumeExtruder> Extruder;

  ShadowPipeline(vtkPolyData* mesh, const LightPosition& light, int kind)
  {
    this->Silhouette->SetInputData(mesh);
    this->Silhouette->SetKind(kind);
    this->Extruder->SetInputData(mesh);
    this->Extruder->SetSilhouetteConnection(this->Silhouette->GetOutputPort());
    this->setLight(light);
  }

  void setLight(const LightPosition& light) { this->Silhouette->SetLightPosition(light.data()); }

  vtkPolyData* silhouette()
  {
    this->Silhouette->Update();
    return this->Silhouette->GetOutput();
  }

  vtkPolyData* volume()
  {
    this->Extruder->Update();
    return this->Extruder->GetOutput();
  }
};

constexpr int AllKinds[] = { vtkSmoothLightSilhouette::DISCRETE, vtkSmoothLightSilhouette::ACCURATE,
  vtkSmoothLightSilhouette::SMOOTH };

/// First component of the first tuple of a field data array; NaN without such an array.
inline double fieldValue(vtkPolyData* data, const char* name, int component = 0)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, component) : std::numeric_limits<double>::quiet_NaN();
}
}

#endif
