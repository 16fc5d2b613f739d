/**
 * Cast contours, outlines and creases as a drawing in layers.
 */
#ifndef ContourDrawing_h
#define ContourDrawing_h

#include "OutputFile.h"
#include "Scene.h"
#include "Statistics.h"

#include <string>
#include <vector>

struct DrawingOptions
{
  SceneOptions Scene; ///< the view; its lights are not looked at
  bool Outlines = false;
  bool Parallel = false;
  double Scale = 0.0;    ///< millimetres on paper for a unit; 0: the size in pixels
  std::string ScaleText; ///< as it was given
};

/// Draws what of the contours is seen between the meshes, visible and hidden ones (from the light)
/// in layers of their own, and writes the SVG under the file's temporary name. Gives figures of it.
/// Throws Failure, or
/// UsageError where the sheet has no size to that scale.
Json WriteDrawing(vtkPolyData* contours, const std::vector<Mesh>& meshes, double featureAngle,
  const Homogeneous& light, const DrawingOptions& options, OutputFile& file);

#endif
