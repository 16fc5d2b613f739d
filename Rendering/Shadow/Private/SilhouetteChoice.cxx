#include "SilhouetteChoice.h"

#include <cmath>
#include <limits>

namespace
{
constexpr double DeviationsOfMesh = 4.0;

double PowerOfTwoBelow(double value)
{
  int exponent = 0;
  std::frexp(value, &exponent);
  return std::ldexp(1.0, exponent - 1);
}
}

SilhouetteChoice ChooseSilhouette(double meshDeviation, double pixel, double pixelTolerance)
{
  const double tolerance = pixelTolerance * pixel;
  if (!(tolerance > 0.0))
  {
    return { false, 0.0, "there is no tolerance to hold a smooth silhouette to" };
  }
  if (tolerance == std::numeric_limits<double>::infinity())
  {
    return { false, 0.0, "nothing of its shadow is in view" };
  }
  if (DeviationsOfMesh * meshDeviation <= tolerance)
  {
    return { false, 0.0, "edges are within the tolerance" };
  }
  return { true, PowerOfTwoBelow(tolerance), "edges would be off by more than the tolerance" };
}
