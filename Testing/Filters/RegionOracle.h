/**
 * @brief What is true of receivers that were split into lit and shadowed parts, checked without the
 * code that split them.
 */
#ifndef RegionOracle_h
#define RegionOracle_h

#include "MeshBuilder.h"

#include <array>
#include <string>
#include <vector>

namespace shadowtest
{
class Random;

struct RegionReport
{
  vtkIdType Polygons = 0;
  int Looks = 0;
  int Shadowed = 0; ///< of the looks that are clear
  int Unclear = 0;  ///< looks within a millionth of the size of where rays begin to say otherwise
  int Wrong = 0;
  std::string FirstWrong; ///< one of them, for messages
  /// Greatest difference between the area of a receiver's cell and that of its polygons, and of the
  /// reported areas and those of the polygons, as a share of the receiver's area.
  double AreaError = 0.0;
  /// Length of the border of all polygons, T-junctions included, less that of the receivers', as a
  /// share of the latter (or of the size, without a border).
  double BorderError = 0.0;
  vtkIdType Turned = 0; ///< polygons wound against their receiver's cell, more than rounding does
};

/// Looks at random places of all polygons and at whole receivers. Receivers are triangles.
RegionReport checkRegions(vtkPolyData* regions, const std::vector<Mesh>& receivers,
  const std::vector<Mesh>& casters, const std::array<double, 4>& light, Random& random,
  int looks);
}

#endif
