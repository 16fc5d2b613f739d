/// The slopes of a surface at a point, by a polynomial through the points around it.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// A point in a frame whose origin is where the slopes are wanted and whose z is roughly the
/// normal there.
struct JetSample
{
  double x;
  double y;
  double z;
};

struct JetSlopes
{
  double x = 0.0;
  double y = 0.0;
  /// How much of the slopes the samples tell apart from the polynomial's other terms: 1 all, 0
  /// nothing, and then the slopes are 0.
  double certainty = 0.0;
};

/// Fewest samples for a quadric, and for a cubic.
constexpr std::size_t fewestForQuadric = 8;
constexpr std::size_t fewestForCubic = 16;

/// Fits z(x, y), a polynomial with all terms of its degree, by least squares (a jet: Cazals &
/// Pouget 2005). The slopes of a quadric carry a third of the samples' noise that those of a cubic
/// do, but are of order 2 in the samples' distance, not 3. So the cubic counts by how much its own
/// terms explain beside what remains unexplained, as an F test compares them (shrunk as by James &
/// Stein 1961): exact samples of a smooth surface keep the order, noise gets the quadric.
/// The samples should be scaled to about the unit disc. O(samples).
JetSlopes fitJet(const std::vector<JetSample>& samples);
}
