/**
 * @brief Scenes in which silhouettes cast contours, and what is true of any such contour.
 */
#ifndef shadowtest_ContourScenes_h
#define shadowtest_ContourScenes_h

#include "MeshBuilder.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace shadowtest
{
class Random;

/// A square field of cells x cells squares, each of two triangles, from (-half, -half) to (half,
/// half), facing up. Heights are drawn from 0 to `relief` below `top`: whole numbers if asked for.
Mesh terrain(Random& random, int cells, double half, double top, double relief, bool whole);

struct ContourScene
{
  std::string Kind;
  std::vector<Mesh> Casters;
  std::vector<Mesh> Receivers;
  std::array<double, 4> Light;
};

/// The same for the same seed: casters of all kinds of randomMesh over whole-numbered and other
/// terrains, as their own receivers, several at once, and with the light among the receivers.
ContourScene randomContourScene(std::uint64_t seed);

struct LineReport
{
  vtkIdType Lines = 0;
  vtkIdType ClosedLines = 0;
  vtkIdType Segments = 0;
  /// At edges of the receiver that are not between two triangles that face the light.
  vtkIdType EndsAtBorders = 0;
  vtkIdType EndsAtCasters = 0; ///< where the silhouette pierces the receiver
  vtkIdType BadEnds = 0;       ///< anywhere else
  vtkIdType BadClosed = 0;     ///< `Closed` does not say whether the last point is the first
};

/// Looks at all lines of contours on some receivers under a light.
LineReport checkLines(vtkPolyData* contours, const std::vector<Mesh>& receivers,
  const std::array<double, 4>& light);
}

#endif
