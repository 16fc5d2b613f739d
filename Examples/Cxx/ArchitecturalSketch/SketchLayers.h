/**
 * The lines of the sketch, and how they are drawn.
 */
#ifndef SketchLayers_h
#define SketchLayers_h

#include "SketchModel.h"

#include <string>
#include <vector>

struct Pen
{
  std::string Id;
  std::string Label;
  double Width; ///< pixels, as Overshoot, Wobble and Lift; see vtkContourStrokes
  double Taper;
  double Overshoot;
  double Wobble;
  double Lift;
  double Grey; ///< 0 is black
};

struct Layer
{
  Pen How;
  PolyData Lines;
};

/// Hatching, contours of cast shadows, creases and outlines; later ones are drawn over earlier
/// ones.
std::vector<Layer> MakeLayers(const Model& model);

#endif
