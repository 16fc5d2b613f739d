/**
 * @brief Bytes of a fuzzer as numbers, lights and meshes.
 *
 * Past the end all bytes are 0: any bytes are an input, and the beginning of one is one as well.
 * Counts are small, so that a run is over in less than a millisecond.
 */
#ifndef shadowtest_FuzzInput_h
#define shadowtest_FuzzInput_h

#include "MeshBuilder.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace shadowtest
{
/// What numbers are drawn from.
enum class Numbers
{
  Grid,   ///< whole ones from -4 to 4: ties everywhere, and fields without rounding
  Float,  ///< from -8 to 8, in steps that float has
  Hostile ///< these, all other doubles, and the worst of them more often
};

class FuzzInput
{
public:
  FuzzInput(const std::uint8_t* bytes, std::size_t size);

  unsigned byte();
  /// From 0 to count - 1; count at most 256.
  unsigned below(unsigned count) { return this->byte() % count; }
  bool flag() { return this->below(2) != 0; }

  double number(Numbers numbers);
  Vec3 vector(Numbers numbers);
  /// Homogeneous, as in vtkSmoothLightSilhouette: a point, a direction, or any four numbers.
  std::array<double, 4> light(Numbers numbers);

private:
  const std::uint8_t* Bytes;
  std::size_t Size;
};

/// Points of float, double or int; polygons, strips, lines and vertices of any length; ids of
/// points that do not exist; normals none, or of any type, length and number of components.
Mesh hostileMesh(FuzzInput& input);

/// Points of double. One of some small bodies, or nothing, with points moved, cells turned, removed
/// and added; normals none, those of the body, or any. The ids exist and numbers are finite.
Mesh smallMesh(FuzzInput& input, Numbers numbers);
}

#endif
