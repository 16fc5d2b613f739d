/**
 * @brief Light where the surface that a mesh stands for shadows itself, and shadow where it is lit.
 */
#ifndef shadowtest_LightLeak_h
#define shadowtest_LightLeak_h

#include "RayCast.h"

#include <array>

namespace shadowtest
{
/// Pixels of the reference's shadow that are lit, and of its light that are dark.
struct LeakCount
{
  long Shadow = 0;
  long Leaking = 0;
  long Lit = 0;
  long Lost = 0;

  double percentLeaking() const;
  double percentLost() const;
};

/// By the cosine at which light meets the surface: from each of these up to the next.
constexpr std::array<double, 6> LeakCosines = { 0.0, 0.03, 0.06, 0.12, 0.24, 1.0 };
using LeakCounts = std::array<LeakCount, LeakCosines.size() - 1>;

/// Adds a mask's pixels to the counts. The reference is a ray cast of a much finer mesh of the same
/// surface. Pixels that it sees turned away from the light are left out, as shading darkens them,
/// and those beside an edge of a cast shadow or of the object, as edges of meshes differ.
void countLeaks(const RayPicture& reference, vtkImageData* mask, LeakCounts& counts);
}

#endif
