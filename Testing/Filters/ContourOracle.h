/**
 * @brief Cast contours by brute force: every segment's wall against every triangle, in double.
 *
 * Without ties, charts, trees or keys, so for scenes in general position only.
 */
#ifndef ContourOracle_h
#define ContourOracle_h

#include "SegmentChain.h"

#include <array>

class vtkPolyData;

namespace shadowtest
{
/// All pieces of one silhouette's contours on one receiver, with the shadow on their left as seen
/// from the light. Pieces shorter than `least` are left out.
SegmentChain contoursByBruteForce(vtkPolyData* silhouette, vtkPolyData* receiver,
  const std::array<double, 4>& light, double least);
}

#endif
