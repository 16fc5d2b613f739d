#include "VolumeView.h"

#include <algorithm>
#include <limits>

using namespace PointArithmetic;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/**
 * Steps of a depth of 24 bits, and the rounding of a sum in single precision, relative to its
 * terms.
 */
constexpr double DepthMargin = 16.0 * 0x1p-24;
constexpr double ShaderRounding = 0x1p-21;

/**
 * Of buffers in single precision, relative to the caster's size.
 */
constexpr double BufferRounding = 0x1p-22;

double TermsOf(const Matrix4& matrix, const Point4& point)
{
  double sum = 0.0;
  for (std::size_t i = 8; i < 16; ++i)
  {
    sum += std::abs(matrix[i] * point[i % 4]);
  }
  return sum;
}
}

VolumeView::VolumeView(
  const ShadowView& view, const Point4& light, const BoxCorners& caster, const Point4& end)
  : View(view)
  , EndsInDirection(light[3] == 0.0 && end == Point4{})
  , Resolution(BufferRounding * DiagonalOf(caster))
{
  const Point4 clipLight = Multiply(view.WorldToClip, light);
  const double lightTerms = TermsOf(view.WorldToClip, light);
  for (std::size_t i = 0; i < 8; ++i)
  {
    const Point4 corner = { caster[i][0], caster[i][1], caster[i][2], 1.0 };
    const double t = StepsToPlane(end, caster[i], RayOf(light, caster[i]));
    const double s = std::isfinite(t) ? t / (1.0 + t * light[3])
      : light[3] != 0.0               ? 1.0 / light[3]
                                      : 1.0;
    this->Points[i] = Multiply(view.WorldToClip, corner);
    this->Terms[i] = TermsOf(view.WorldToClip, corner);
    for (std::size_t k = 0; k < 4; ++k)
    {
      this->Points[i + 8][k] =
        (this->EndsInDirection ? 0.0 : this->Points[i][k]) - s * clipLight[k];
    }
    this->Terms[i + 8] = (this->EndsInDirection ? 0.0 : this->Terms[i]) + s * lightTerms;
  }
}

double VolumeView::Inside(const Point4& point, std::size_t plane)
{
  return point[3] + (plane % 2 == 0 ? point[plane / 2] : -point[plane / 2]);
}

bool VolumeView::IsSeen() const
{
  for (std::size_t plane = 0; plane < 6; ++plane)
  {
    if (std::all_of(this->Points.begin(), this->Points.end(),
          [&](const Point4& point) { return Inside(point, plane) < 0.0; }))
    {
      return false;
    }
  }
  return true;
}

/**
 * Every point of the convex hull in front of the near plane is seen within the bounds of its edges
 * there, for which all pairs of points are taken.
 */
std::array<int, 4> VolumeView::FindScissor() const
{
  double lower[2] = { 1.0, 1.0 };
  double upper[2] = { -1.0, -1.0 };
  const auto add = [&](const Point4& point) {
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      const double place = point[axis] / point[3];
      // Not a number where the eye itself is: everything may be covered.
      lower[axis] = std::isnan(place) ? -1.0 : std::min(lower[axis], place);
      upper[axis] = std::isnan(place) ? 1.0 : std::max(upper[axis], place);
    }
  };
  const auto inFront = [](const Point4& point) { return point[2] + point[3]; };
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    const Point4& pointI = this->Points[i];
    const double heightI = inFront(pointI);
    if (heightI >= 0.0)
    {
      add(pointI);
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      const Point4& pointJ = this->Points[j];
      const double heightJ = inFront(pointJ);
      if ((heightI > 0.0) != (heightJ > 0.0))
      {
        const double t = heightI / (heightI - heightJ);
        Point4 cut;
        for (std::size_t k = 0; k < 4; ++k)
        {
          cut[k] = pointI[k] + t * (pointJ[k] - pointI[k]);
        }
        add(cut);
      }
    }
  }
  const double size[2] = { static_cast<double>(this->View.Width),
    static_cast<double>(this->View.Height) };
  std::array<int, 4> scissor{};
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    // A pixel more on either side, for roundings.
    const double first = std::floor(0.5 * (std::max(lower[axis], -1.0) + 1.0) * size[axis]) - 1.0;
    const double last = std::ceil(0.5 * (std::min(upper[axis], 1.0) + 1.0) * size[axis]) + 1.0;
    scissor[axis] = static_cast<int>(std::max(first, 0.0));
    scissor[axis + 2] = static_cast<int>(
      std::max(std::min(last, size[axis]) - static_cast<double>(scissor[axis]), 0.0));
  }
  return scissor;
}

/**
 * Depth over weight grows or falls along each line in front of the near plane, so that only points
 * and cuts with that plane matter.
 */
std::array<double, 2> VolumeView::FindDepthRange() const
{
  double lower = 1.0;
  double upper = 0.0;
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    const Point4& point = this->Points[i];
    const double inFront = point[2] + point[3];
    if (!std::isfinite(inFront))
    {
      return { 0.0, 1.0 };
    }
    if (point[2] == 0.0 && point[3] == 0.0)
    {
      // A direction along the view's plane: going there changes no depth.
      continue;
    }
    if (!(inFront > 0.0))
    {
      lower = 0.0;
      continue;
    }
    if (!(point[3] > 0.0))
    {
      upper = 1.0;
      continue;
    }
    const double depth = 0.5 * (1.0 + point[2] / point[3]);
    const double margin = DepthMargin + ShaderRounding * this->Terms[i] / point[3];
    if (!std::isfinite(depth) || !std::isfinite(margin))
    {
      return { 0.0, 1.0 };
    }
    lower = std::min(lower, depth - margin);
    upper = std::max(upper, depth + margin);
  }
  lower = std::clamp(lower, 0.0, 1.0);
  return { lower, std::clamp(upper, lower, 1.0) };
}

double VolumeView::LeastWeightInside(std::size_t plane) const
{
  const std::size_t places = this->EndsInDirection ? 8 : 16;
  double least = Infinity;
  std::array<double, 16> inside;
  bool allInside = true;
  for (std::size_t i = 0; i < places; ++i)
  {
    inside[i] = Inside(this->Points[i], plane);
    allInside = allInside && !(inside[i] < 0.0);
    if (!(inside[i] < 0.0))
    {
      least = std::min(least, this->Points[i][3]);
    }
  }
  for (std::size_t i = 0; i < places && !allInside; ++i)
  {
    for (std::size_t j = 0; j < places; ++j)
    {
      if (!(inside[i] < 0.0) && inside[j] < 0.0)
      {
        const double t = inside[i] / (inside[i] - inside[j]);
        least = std::min(least, this->Points[i][3] + t * (this->Points[j][3] - this->Points[i][3]));
      }
    }
  }
  if (!this->EndsInDirection)
  {
    return least;
  }
  const double toward = Inside(this->Points[8], plane);
  const double weight = this->Points[8][3];
  for (std::size_t i = 0; i < places; ++i)
  {
    // Inside as long as inside + t toward is positive.
    if ((inside[i] < 0.0) != (toward < 0.0))
    {
      least = std::min(least, this->Points[i][3] - inside[i] / toward * weight);
    }
    const bool staysInside = toward > 0.0 || (!(toward < 0.0) && !(inside[i] < 0.0));
    if (staysInside && weight < 0.0)
    {
      return -Infinity;
    }
  }
  return least;
}

double VolumeView::PixelsPerLength() const
{
  const Matrix4& m = this->View.WorldToClip;
  const auto row = [&](std::size_t k) { return Point3{ m[4 * k], m[4 * k + 1], m[4 * k + 2] }; };
  const Point3 weight = row(3);
  double greatest = 0.0;
  for (const double a : { -1.0, 1.0 })
  {
    for (const double b : { -1.0, 1.0 })
    {
      Point3 across = row(0);
      Point3 up = row(1);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        across[axis] = 0.5 * this->View.Width * (across[axis] - a * weight[axis]);
        up[axis] = 0.5 * this->View.Height * (up[axis] - b * weight[axis]);
      }
      const double xx = Dot(across, across);
      const double yy = Dot(up, up);
      greatest = std::max(greatest, 0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), Dot(across, up)));
    }
  }
  return std::sqrt(greatest) + Length(weight);
}

double VolumeView::FindPixel() const
{
  if (this->View.Width <= 0 || this->View.Height <= 0)
  {
    return Infinity;
  }
  double weight = -Infinity;
  for (std::size_t plane = 0; plane < 6; ++plane)
  {
    weight = std::max(weight, this->LeastWeightInside(plane));
  }
  const double pixel = weight / this->PixelsPerLength();
  // In this order they give the smallest number for what is not one.
  return std::max(
    std::numeric_limits<double>::min(), std::max(std::max(0.0, this->Resolution), pixel));
}
