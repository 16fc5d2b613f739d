/// Exact welding: points with equal coordinates become one vertex, equal normals at it one normal.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// What the points of a mesh become: numbers of distinct items in order of first appearance.
struct Welding
{
  std::vector<Index> target; ///< for each input item, the number of its distinct item
  std::vector<Index> first;  ///< for each distinct item, the first input item that is it
};

/// Welds points whose coordinates are equal (-0 equals 0). Non-finite points stay single.
/// O(n) on average.
Welding weldPoints(const std::vector<Vec3>& points);

/// Welds normals that are equal and belong to the same vertex, vertex[i]. O(n) on average.
Welding weldNormals(const std::vector<Vec3>& normals, const std::vector<Index>& vertex);
}
