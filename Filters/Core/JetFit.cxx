#include "JetFit.h"

#include <algorithm>

namespace shadow
{
namespace
{
// The order of the terms lets one elimination serve both degrees: after that of the first four what
// remains of the slopes is the quadric's, after that of the cubic terms the cubic's.
constexpr std::size_t quadricTerms = 4; // 1, xx, xy, yy
constexpr std::size_t slopeX = 8;       // after xxx, xxy, xyy, yyy
constexpr std::size_t slopeY = 9;
constexpr std::size_t height = 10;
constexpr std::size_t columns = 11;

using Normals = std::array<std::array<double, columns>, columns>; // upper triangle

// A term of which less than this (squared) is not a sum of others counts as such a sum: well above
// the rounding of sums of unit length, well below what the slopes may be found by.
constexpr double dependent = 1e-12;

Normals normalEquations(const std::vector<JetSample>& samples)
{
  Normals a{};
  for (const JetSample& s : samples)
  {
    const double xx = s.x * s.x;
    const double xy = s.x * s.y;
    const double yy = s.y * s.y;
    const std::array<double, columns> terms = { 1.0, xx, xy, yy, xx * s.x, xx * s.y, xy * s.y,
      yy * s.y, s.x, s.y, s.z };
    for (std::size_t i = 0; i < columns; ++i)
    {
      for (std::size_t j = i; j < columns; ++j)
      {
        a[i][j] += terms[i] * terms[j];
      }
    }
  }
  return a;
}

void eliminate(Normals& a, std::size_t k)
{
  if (!(a[k][k] > dependent))
  {
    return; // the terms before it say the same
  }
  for (std::size_t i = k + 1; i < columns; ++i)
  {
    const double factor = a[k][i] / a[k][k];
    for (std::size_t j = i; j < columns; ++j)
    {
      a[i][j] -= factor * a[k][j];
    }
  }
}

struct Solution
{
  JetSlopes slopes;
  double residual = 0.0; // squared
};

// From what remains of the slopes' own equations; their smaller eigenvalue is the certainty.
Solution solve(const Normals& a)
{
  const double xx = a[slopeX][slopeX];
  const double xy = a[slopeX][slopeY];
  const double yy = a[slopeY][slopeY];
  const double xz = a[slopeX][height];
  const double yz = a[slopeY][height];
  Solution s;
  const double certainty = 0.5 * (xx + yy) - std::hypot(0.5 * (xx - yy), xy);
  if (!(certainty > dependent))
  {
    return s;
  }
  const double determinant = xx * yy - xy * xy;
  s.slopes = { (yy * xz - xy * yz) / determinant, (xx * yz - xy * xz) / determinant, certainty };
  s.residual = std::fmax(a[height][height] - s.slopes.x * xz - s.slopes.y * yz, 0.0);
  return s;
}

// At 2, noise in the points of 1 to 5% of an edge has 0.4 of the effect that it has on an
// angle-weighted normal (at 1, 0.6; always the cubic, 1.15), and exact points of curved shapes lose
// nothing. At 4 coarse meshes do.
constexpr double shrinkage = 2.0;

double cubicShare(double quadricResidual, double cubicResidual, std::size_t samples)
{
  const double unexplained = cubicResidual / (static_cast<double>(samples) - 10.0);
  const double explained = (quadricResidual - cubicResidual) / 4.0;
  return explained > shrinkage * unexplained ? 1.0 - shrinkage * unexplained / explained : 0.0;
}

// As in fitJetNormals: from 1e-6 to 1e-2 it makes no difference on smooth shapes.
constexpr double leastCubicCertainty = 1e-3;
}

JetSlopes fitJet(const std::vector<JetSample>& samples)
{
  if (samples.size() < fewestForQuadric)
  {
    return {};
  }
  Normals a = normalEquations(samples);
  // Terms of unit length: no other scaling makes the elimination much more accurate.
  std::array<double, columns> scale{};
  for (std::size_t i = 0; i < columns; ++i)
  {
    scale[i] = i == height ? 1.0 : 1.0 / std::sqrt(a[i][i]);
    if (!std::isfinite(scale[i]))
    {
      return {};
    }
  }
  for (std::size_t i = 0; i < columns; ++i)
  {
    for (std::size_t j = i; j < columns; ++j)
    {
      a[i][j] *= scale[i] * scale[j];
    }
  }
  std::size_t k = 0;
  while (k < quadricTerms)
  {
    eliminate(a, k++);
  }
  const Solution quadric = solve(a);
  JetSlopes slopes = quadric.slopes;
  if (samples.size() >= fewestForCubic && slopes.certainty > 0.0)
  {
    while (k < slopeX)
    {
      eliminate(a, k++);
    }
    const Solution cubic = solve(a);
    if (cubic.slopes.certainty > leastCubicCertainty)
    {
      const double share = cubicShare(quadric.residual, cubic.residual, samples.size());
      slopes.x += share * (cubic.slopes.x - slopes.x);
      slopes.y += share * (cubic.slopes.y - slopes.y);
    }
  }
  slopes.x *= scale[slopeX];
  slopes.y *= scale[slopeY];
  return slopes;
}
}
