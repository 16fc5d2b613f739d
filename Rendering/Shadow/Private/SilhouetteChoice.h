/**
 * Which kind of silhouette a caster needs.
 */
#ifndef SilhouetteChoice_h
#define SilhouetteChoice_h

#include <string>

struct SilhouetteChoice
{
  /**
   * Of the smooth surface; otherwise edges of the mesh will do.
   */
  bool Smooth = false;

  /**
   * How near the smooth silhouette has to be to its curve, in the unit of the arguments; 0 for
   * edges.
   */
  double Tolerance = 0.0;

  std::string Reason;
};

/**
 * `meshDeviation` is the greatest distance between the mesh's edges and the smooth surface's curves
 * over them, `pixel` that by which the silhouette may move until its shadow moves by a pixel
 * (CasterPlan::Pixel), both in one unit of length; `pixelTolerance` is in pixels.
 *
 * Across an edge of length h a surface of curvature k rises k h^2 / 8 above it, and k h^2 / 6 above
 * the middle of an equilateral triangle: what the mesh casts is off by up to 4/3 of the deviation.
 * More is seen of the shadow that a surface has on itself: its edge, too, is where the light
 * grazes, moves by about an edge's length, and is told by how bright it is beside that. Weighted by
 * that (n.l), it counts as 4 deviations. So edges will do if these are within the tolerance.
 *
 * Otherwise the tolerance is rounded down to a power of two: a camera that moves keeps its volumes
 * until its distance changes by some factor of up to two.
 *
 * A deviation that is not a number is not known, and taken as too large. Without a size of a pixel,
 * or with no tolerance above 0, there is nothing to hold a smooth silhouette to, and edges are
 * taken.
 */
SilhouetteChoice ChooseSilhouette(double meshDeviation, double pixel, double pixelTolerance);

#endif
