#include "AnalyticShadow.h"

#include "Tolerances.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace shadowtest
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int MostSteps = 60;

double length(const Vec3& v)
{
  return std::sqrt(dot(v, v));
}

Vec3 toward(const LightPoint& light, const Vec3& point)
{
  return Vec3{ light[0], light[1], light[2] } - light[3] * point;
}

// Solves the 3 x 3 system of columns a, b, c.
Vec3 solve(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& right)
{
  const Vec3 bc = cross(b, c);
  const double determinant = dot(a, bc);
  return { dot(right, bc) / determinant, dot(right, cross(c, a)) / determinant,
    dot(right, cross(a, b)) / determinant };
}

struct Frame
{
  explicit Frame(const Plane& plane)
    : N(normalized(plane.Normal))
  {
    const Vec3 other = std::abs(this->N[0]) < 0.6 ? Vec3{ 1, 0, 0 } : Vec3{ 0, 1, 0 };
    this->X = normalized(cross(other, this->N));
    this->Y = cross(this->N, this->X);
  }

  Vec3 X;
  Vec3 Y;
  Vec3 N;
};

class EllipsoidShadow : public AnalyticShadow
{
public:
  EllipsoidShadow(const double halfAxes[3], const LightPoint& light, const Plane& receiver)
    : Axes{ halfAxes[0], halfAxes[1], halfAxes[2] }
    , Light(light)
    , Receiver(receiver)
    , Basis(receiver)
  {
    // With the quadric x'Qx = 0 of the shape, the tangent cone from l is
    // (l'Ql) Q - (Ql)(Ql)': for x on it the line from l to x meets the shape once.
    const double quadric[4] = { 1.0 / (Axes[0] * Axes[0]), 1.0 / (Axes[1] * Axes[1]),
      1.0 / (Axes[2] * Axes[2]), -1.0 };
    double form = 0.0;
    double polar[4];
    for (std::size_t i = 0; i < 4; ++i)
    {
      polar[i] = quadric[i] * light[i];
      form += polar[i] * light[i];
    }
    // The plane's points are B (s, t, 1)'.
    double columns[3][4] = {};
    for (std::size_t i = 0; i < 3; ++i)
    {
      columns[0][i] = this->Basis.X[i];
      columns[1][i] = this->Basis.Y[i];
      columns[2][i] = receiver.Origin[i];
    }
    columns[2][3] = 1.0;
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        double sum = 0.0;
        double left = 0.0;
        double right = 0.0;
        for (int i = 0; i < 4; ++i)
        {
          sum += columns[row][i] * quadric[i] * columns[column][i];
          left += columns[row][i] * polar[i];
          right += columns[column][i] * polar[i];
        }
        this->Conic[row][column] = form * sum - left * right;
      }
    }
  }

  BoundaryDistance distance(const Vec3& nearSilhouette) const override
  {
    const Vec3 shadow =
      shadowOn(this->Receiver, this->Light, nearSilhouette) - this->Receiver.Origin;
    const double s0 = dot(shadow, this->Basis.X);
    const double t0 = dot(shadow, this->Basis.Y);
    // Foot of the perpendicular: C(q) = 0 and q + d grad C(q) = (s0, t0), unknown s, t, d.
    double s = s0;
    double t = t0;
    double d = 0.0;
    BoundaryDistance result;
    result.Converged = false;
    for (int step = 0; step < MostSteps && !result.Converged; ++step)
    {
      const Vec3 g = this->apply({ s, t, 1.0 });
      const double value = g[0] * s + g[1] * t + g[2];
      const Vec3 residual{ value, s + 2.0 * d * g[0] - s0, t + 2.0 * d * g[1] - t0 };
      const Vec3 byS{ 2.0 * g[0], 1.0 + 2.0 * d * this->Conic[0][0], 2.0 * d * this->Conic[1][0] };
      const Vec3 byT{ 2.0 * g[1], 2.0 * d * this->Conic[0][1], 1.0 + 2.0 * d * this->Conic[1][1] };
      const Vec3 byD{ 0.0, 2.0 * g[0], 2.0 * g[1] };
      const Vec3 change = solve(byS, byT, byD, -1.0 * residual);
      s += change[0];
      t += change[1];
      d += change[2];
      result.Converged =
        std::hypot(change[0], change[1]) <= tolerance::Newton * (1.0 + std::hypot(s, t));
    }
    result.Value = std::hypot(s - s0, t - t0);
    return result;
  }

  std::vector<Vec3> contour(int count) const override
  {
    // On the unit sphere y = x / axes the light is l / axes, and the contour is the circle
    // y.l = w, |y| = 1.
    const Vec3 l{ this->Light[0] / this->Axes[0], this->Light[1] / this->Axes[1],
      this->Light[2] / this->Axes[2] };
    const double height = this->Light[3] / length(l);
    const double radius = std::sqrt(1.0 - height * height);
    const Frame around(Plane{ { 0.0, 0.0, 0.0 }, l });
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i)
    {
      const double angle = 2.0 * Pi * i / count;
      const Vec3 y = height * around.N + (radius * std::cos(angle)) * around.X +
        (radius * std::sin(angle)) * around.Y;
      points.push_back({ this->Axes[0] * y[0], this->Axes[1] * y[1], this->Axes[2] * y[2] });
    }
    return points;
  }

private:
  Vec3 apply(const Vec3& q) const
  {
    Vec3 result{ 0.0, 0.0, 0.0 };
    for (std::size_t row = 0; row < 3; ++row)
    {
      for (std::size_t column = 0; column < 3; ++column)
      {
        result[row] += this->Conic[row][column] * q[column];
      }
    }
    return result;
  }

  double Axes[3];
  LightPoint Light;
  Plane Receiver;
  Frame Basis;
  double Conic[3][3];
};

class TorusShadow : public AnalyticShadow
{
public:
  TorusShadow(double radius, double tube, const LightPoint& light, const Plane& receiver)
    : Radius(radius)
    , Tube(tube)
    , Light(light)
    , Receiver(receiver)
    , Normal(normalized(receiver.Normal))
  {
    constexpr int Around = 4096;
    for (const Angles& angles : this->angles(Around))
    {
      this->Starts.push_back({ angles, this->point(angles) });
    }
  }

  BoundaryDistance distance(const Vec3& nearSilhouette) const override
  {
    BoundaryDistance result;
    const Start* start = nullptr;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Start& candidate : this->Starts)
    {
      const Vec3 step = candidate.Point - nearSilhouette;
      const double squared = dot(step, step);
      if (squared < nearest)
      {
        nearest = squared;
        start = &candidate;
      }
    }
    if (!start)
    {
      result.Converged = false;
      return result;
    }
    const Vec3 target = shadowOn(this->Receiver, this->Light, nearSilhouette);
    // The boundary's normal m in the receiver is the surface's normal n projected on it, since the
    // tangent plane of a contour point holds the light's ray. So the nearest boundary point is
    // P(u, v) = target - d m with n.r = 0: unknown u, v, d.
    const Frame frame(this->Receiver);
    Vec3 unknown{ start->At.U, start->At.V, 0.0 };
    auto residual = [&](const Vec3& x) -> Vec3 {
      const Angles angles{ x[0], x[1] };
      const Vec3 n = this->normal(angles);
      const Vec3 p = this->point(angles);
      const Vec3 m = normalized(n - dot(n, this->Normal) * this->Normal);
      const Vec3 gap = shadowOn(this->Receiver, this->Light, p) - target + x[2] * m;
      return { dot(n, normalized(toward(this->Light, p))), dot(gap, frame.X), dot(gap, frame.Y) };
    };
    result.Converged = false;
    for (int step = 0; step < MostSteps && !result.Converged; ++step)
    {
      constexpr double Delta = 1e-6;
      Vec3 columns[3];
      for (std::size_t i = 0; i < 3; ++i)
      {
        Vec3 more = unknown;
        Vec3 less = unknown;
        more[i] += Delta;
        less[i] -= Delta;
        columns[i] = (0.5 / Delta) * (residual(more) - residual(less));
      }
      Vec3 change = solve(columns[0], columns[1], columns[2], -1.0 * residual(unknown));
      // Near the start: a step of a radian would leave this contour for another one.
      const double angle = std::hypot(change[0], change[1]);
      change = std::min(1.0, 0.2 / angle) * change;
      unknown = unknown + change;
      // The differences are good to about 1e-10 relative, so steps shrink by that factor.
      result.Converged = length(change) <= 1e-12;
    }
    const Angles foot{ unknown[0], unknown[1] };
    result.Valid = std::abs(this->radialCurvature(start->At)) >= tolerance::CuspRadialCurvature &&
      std::abs(this->radialCurvature(foot)) >= tolerance::CuspRadialCurvature;
    result.Value = std::abs(unknown[2]);
    return result;
  }

  std::vector<Vec3> contour(int count) const override
  {
    std::vector<Vec3> points;
    for (const Angles& angles : this->angles(count / 2))
    {
      points.push_back(this->point(angles));
    }
    return points;
  }

  int cusps() const
  {
    constexpr std::size_t Around = 100000;
    // Off the ring's level every angle u has two points: even and odd ones are the two contours.
    const std::vector<Angles> contours = this->angles(static_cast<int>(Around));
    int changes = 0;
    for (std::size_t i = 0; i < contours.size(); ++i)
    {
      const Angles& next = contours[(i + 2) % contours.size()];
      changes += (this->radialCurvature(contours[i]) < 0.0) != (this->radialCurvature(next) < 0.0);
    }
    return changes;
  }

private:
  struct Angles
  {
    double U; // around z
    double V; // around the tube
  };

  struct Start
  {
    Angles At;
    Vec3 Point;
  };

  // n.(l - w p) = A cos v + B sin v - w tube at a given u.
  std::vector<Angles> angles(int around) const
  {
    std::vector<Angles> result;
    for (int i = 0; i < around; ++i)
    {
      const double u = 2.0 * Pi * i / around;
      const double a =
        this->Light[0] * std::cos(u) + this->Light[1] * std::sin(u) - this->Light[3] * this->Radius;
      const double b = this->Light[2];
      const double ratio = this->Light[3] * this->Tube / std::hypot(a, b);
      if (std::abs(ratio) <= 1.0)
      {
        const double middle = std::atan2(b, a);
        result.push_back({ u, middle + std::acos(ratio) });
        result.push_back({ u, middle - std::acos(ratio) });
      }
    }
    return result;
  }

  Vec3 normal(const Angles& x) const
  {
    return { std::cos(x.V) * std::cos(x.U), std::cos(x.V) * std::sin(x.U), std::sin(x.V) };
  }

  Vec3 point(const Angles& x) const
  {
    return this->Tube * this->normal(x) + this->Radius * Vec3{ std::cos(x.U), std::sin(x.U), 0.0 };
  }

  // Normal curvature along the light's ray: zero where the contour's tangent is the ray itself.
  double radialCurvature(const Angles& x) const
  {
    const Vec3 ray = toward(this->Light, this->point(x));
    const Vec3 n = this->normal(x);
    const Vec3 t = normalized(ray - dot(ray, n) * n);
    const Vec3 around{ -std::sin(x.U), std::cos(x.U), 0.0 };
    const double along = dot(t, around);
    const double across = dot(t, cross(around, n));
    return across * across / this->Tube +
      along * along * std::cos(x.V) / (this->Radius + this->Tube * std::cos(x.V));
  }

  double Radius;
  double Tube;
  LightPoint Light;
  Plane Receiver;
  Vec3 Normal;
  std::vector<Start> Starts; // a dense sample of the contour
};
}

Vec3 shadowOn(const Plane& plane, const LightPoint& light, const Vec3& point)
{
  const Vec3 ray = toward(light, point);
  const double t = dot(plane.Normal, plane.Origin - point) / dot(plane.Normal, ray);
  return point + t * ray;
}

std::unique_ptr<AnalyticShadow> ellipsoidShadow(
  const double halfAxes[3], const LightPoint& light, const Plane& receiver)
{
  return std::make_unique<EllipsoidShadow>(halfAxes, light, receiver);
}

std::unique_ptr<AnalyticShadow> torusShadow(
  double radius, double tube, const LightPoint& light, const Plane& receiver)
{
  return std::make_unique<TorusShadow>(radius, tube, light, receiver);
}

int torusCusps(double radius, double tube, const LightPoint& light)
{
  return TorusShadow(radius, tube, light, { { 0.0, 0.0, -1.0 }, { 0.0, 0.0, 1.0 } }).cusps();
}

bool ellipsoidHides(const double halfAxes[3], const Vec3& point, const LightPoint& light)
{
  Vec3 p = point;
  Vec3 d = toward(light, point);
  for (std::size_t i = 0; i < 3; ++i)
  {
    p[i] /= halfAxes[i];
    d[i] /= halfAxes[i];
  }
  // |p + t d|^2 = 1 with 0 < t < 1/w.
  const double a = dot(d, d);
  const double b = dot(p, d);
  const double discriminant = b * b - a * (dot(p, p) - 1.0);
  if (discriminant <= 0.0)
  {
    return false;
  }
  const double t0 = (-b - std::sqrt(discriminant)) / a;
  const double t1 = (-b + std::sqrt(discriminant)) / a;
  return t1 > 0.0 && light[3] * t0 < 1.0;
}

ShadowError shadowError(vtkPolyData* silhouette, const AnalyticShadow& shadow, int samplesPerChord)
{
  ShadowError result;
  double squares = 0.0;
  auto measure = [&](const Vec3& point) {
    const BoundaryDistance distance = shadow.distance(point);
    if (!distance.Valid)
    {
      ++result.LeftOut;
    }
    else if (!distance.Converged || !std::isfinite(distance.Value))
    {
      ++result.Failed;
    }
    else
    {
      ++result.Samples;
      squares += distance.Value * distance.Value;
      result.Largest = std::max(result.Largest, distance.Value);
    }
  };
  auto cell = vtk::TakeSmartPointer(silhouette->GetLines()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    for (vtkIdType i = 1; i < size; ++i)
    {
      Vec3 from;
      Vec3 to;
      silhouette->GetPoint(ids[i - 1], from.data());
      silhouette->GetPoint(ids[i], to.data());
      for (int k = 0; k <= samplesPerChord; ++k)
      {
        measure(from + (static_cast<double>(k) / (samplesPerChord + 1)) * (to - from));
      }
    }
  }
  if (result.Samples > 0)
  {
    result.RootMeanSquare = std::sqrt(squares / static_cast<double>(result.Samples));
  }
  return result;
}

double fitOrder(const std::vector<double>& h, const std::vector<double>& error)
{
  double meanX = 0.0;
  double meanY = 0.0;
  for (std::size_t i = 0; i < h.size(); ++i)
  {
    meanX += std::log(h[i]) / static_cast<double>(h.size());
    meanY += std::log(error[i]) / static_cast<double>(h.size());
  }
  double covariance = 0.0;
  double variance = 0.0;
  for (std::size_t i = 0; i < h.size(); ++i)
  {
    const double x = std::log(h[i]) - meanX;
    covariance += x * (std::log(error[i]) - meanY);
    variance += x * x;
  }
  return covariance / variance;
}
}
