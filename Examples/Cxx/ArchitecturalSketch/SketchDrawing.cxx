#include "SketchDrawing.h"

#include "DrawingView.h"
#include "SketchView.h"
#include "SvgDrawing.h"

bool WriteDrawing(const Model& model, const std::vector<Layer>& layers, const char* file)
{
  const DrawingView view(View, false, Size, model.All());
  SvgDrawing drawing(view.Width(), view.Height(), Size[0], Size[1], "");
  const double pixels = 1e3 / Size[1]; // in thousandths of the height
  for (const Layer& layer : layers)
  {
    const int grey = static_cast<int>(255.0 * layer.How.Grey);
    const std::string level = std::to_string(grey);
    drawing.Add({ layer.How.Id, layer.How.Label, "rgb(" + level + "," + level + "," + level + ")",
      layer.How.Width * pixels, false, view.DrawAll(layer.Lines, 1e-3) });
  }
  return drawing.Write(file);
}
