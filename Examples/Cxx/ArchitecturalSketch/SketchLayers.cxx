#include "SketchLayers.h"

#include "Hatching.h"
#include "SketchView.h"

#include <vtkCastShadowContour.h>
#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkSmoothLightSilhouette.h>

namespace
{
PolyData SilhouetteOf(vtkPolyData* mesh, Homogeneous from, int kind)
{
  vtkNew<vtkSmoothLightSilhouette> silhouette;
  silhouette->SetInputData(mesh);
  silhouette->SetKind(kind);
  silhouette->SetLightPosition(from.data());
  silhouette->Update();
  return silhouette->GetOutput();
}

PolyData CreasesOf(vtkPolyData* mesh)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->ColoringOff();
  edges->Update();
  return edges->GetOutput();
}

PolyData CastContoursOf(const Model& model, const std::vector<vtkPolyData*>& receivers)
{
  vtkNew<vtkCastShadowContour> contour;
  // Discrete, as then what is hidden is told exactly, by the triangles that the hatching is by.
  for (vtkPolyData* caster : { model.Chair.Get(), model.Animal.Get() })
  {
    contour->AddInputDataObject(0, SilhouetteOf(caster, Sun, vtkSmoothLightSilhouette::DISCRETE));
    contour->AddInputDataObject(2, caster);
  }
  for (vtkPolyData* receiver : receivers)
  {
    contour->AddInputDataObject(1, receiver);
  }
  contour->Update();
  return contour->GetOutput();
}

// The lines that are at least so long: a scanned surface has many short ones, which no hand draws.
PolyData WithoutShort(vtkPolyData* data, double shortest)
{
  const std::vector<Polyline3> lines = LinesOf(data);
  return LinesThat(data,
    [&](vtkIdType line) { return LengthOf(lines[static_cast<std::size_t>(line)]) >= shortest; });
}
}

std::vector<Layer> MakeLayers(const Model& model)
{
  return {
    { { "hatching", "Hatching", 1.1, 0.1, 2.0, 0.5, 2.0, 0.42 }, DataOf(Hatching(model)) },
    { { "contours", "Shadow contours", 1.5, 0.05, 2.0, 0.4, 0.5, 0.20 },
      CastContoursOf(model, { model.Chair, model.Ground }) },
    { { "animal-contours", "Shadow contours on the animal", 1.5, 0.1, 0.0, 0.3, 0.5, 0.20 },
      WithoutShort(CastContoursOf(model, { model.Animal }), 0.025) },
    { { "creases", "Creases", 1.7, 0.02, 6.0, 0.6, 2.0, 0.12 }, CreasesOf(model.Chair) },
    { { "outlines", "Outlines", 2.4, 0.1, 1.0, 0.3, 5.0, 0.05 },
      WithoutShort(SilhouetteOf(model.Animal, Eye, vtkSmoothLightSilhouette::SMOOTH), 0.05) },
  };
}
