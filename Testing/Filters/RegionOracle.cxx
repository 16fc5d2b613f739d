#include "RegionOracle.h"

#include "Random.h"
#include "Tolerances.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace shadowtest
{
namespace
{
double lengthOf(const Vec3& v)
{
  return std::sqrt(dot(v, v));
}

using Corners = std::array<Vec3, 3>;

std::vector<vtkIdType> idsOf(vtkPolyData* mesh, vtkIdType cell)
{
  vtkIdType count;
  const vtkIdType* ids;
  mesh->GetPolys()->GetCellAtId(cell, count, ids);
  return std::vector<vtkIdType>(ids, ids + count);
}

std::vector<std::vector<Vec3>> polygonsOf(vtkPolyData* mesh)
{
  std::vector<std::vector<Vec3>> polygons;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    polygons.emplace_back();
    for (const vtkIdType id : idsOf(mesh, cell))
    {
      polygons.back().emplace_back();
      mesh->GetPoint(id, polygons.back().back().data());
    }
  }
  return polygons;
}

/// Normal, twice the area long.
Vec3 areaNormal(const std::vector<Vec3>& polygon)
{
  Vec3 normal{ 0.0, 0.0, 0.0 };
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
  {
    normal = normal + cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return normal;
}

double perimeterOf(const std::vector<Vec3>& polygon)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    sum += lengthOf(polygon[(i + 1) % polygon.size()] - polygon[i]);
  }
  return sum;
}

/// Length of the edges that polygons do not run as often in one direction as in the other. Points
/// of one number are one point.
double borderOf(const std::vector<std::vector<Vec3>>& polygons,
  const std::vector<std::vector<vtkIdType>>& numbers)
{
  std::map<std::pair<vtkIdType, vtkIdType>, std::pair<int, double>> runs;
  for (std::size_t cell = 0; cell < polygons.size(); ++cell)
  {
    for (std::size_t i = 0; i < polygons[cell].size(); ++i)
    {
      const std::size_t j = (i + 1) % polygons[cell].size();
      const auto [a, b] = std::pair(numbers[cell][i], numbers[cell][j]);
      auto& [sum, length] = runs[std::pair(std::min(a, b), std::max(a, b))];
      sum += a < b ? 1 : -1;
      length = lengthOf(polygons[cell][j] - polygons[cell][i]);
    }
  }
  double border = 0.0;
  for (const auto& [edge, run] : runs)
  {
    border += std::abs(run.first) * run.second;
  }
  return border;
}

/// The same number for points of equal coordinates.
std::vector<std::vector<vtkIdType>> numbersByPlace(const std::vector<std::vector<Vec3>>& polygons)
{
  std::map<Vec3, vtkIdType> known;
  std::vector<std::vector<vtkIdType>> numbers;
  for (const std::vector<Vec3>& polygon : polygons)
  {
    numbers.emplace_back();
    for (const Vec3& point : polygon)
    {
      numbers.back().push_back(
        known.emplace(point, static_cast<vtkIdType>(known.size())).first->second);
    }
  }
  return numbers;
}

/// Rays to a light against all triangles.
class Rays
{
public:
  Rays(const std::vector<Mesh>& casters, const std::array<double, 4>& light, double least)
    : Light(light)
    , Least(least)
  {
    for (vtkPolyData* caster : casters)
    {
      for (const std::vector<Vec3>& polygon : polygonsOf(caster))
      {
        for (std::size_t i = 2; i < polygon.size(); ++i)
        {
          this->Triangles.push_back({ polygon[0], polygon[i - 1], polygon[i] });
        }
      }
    }
  }

  Vec3 towards(const Vec3& point) const
  {
    return Vec3{ this->Light[0], this->Light[1], this->Light[2] } - this->Light[3] * point;
  }

  bool isShadowed(const Vec3& point) const
  {
    const Vec3 ray = this->towards(point);
    return std::any_of(this->Triangles.begin(), this->Triangles.end(),
      [&](const Corners& t) { return this->meets(point, ray, t); });
  }

  /// Whether the light is in a triangle's plane and within its bounds, to within rounding: then it
  /// is not defined what that triangle hides.
  bool isLightOnCaster() const
  {
    if (this->Light[3] == 0.0)
    {
      return false;
    }
    const Vec3 at = (1.0 / this->Light[3]) * Vec3{ this->Light[0], this->Light[1], this->Light[2] };
    return std::any_of(this->Triangles.begin(), this->Triangles.end(), [&](const Corners& t) {
      const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
      bool isOn = std::fabs(dot(normal, at - t[0])) <= this->Least * lengthOf(normal);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const auto [low, high] = std::minmax({ t[0][k], t[1][k], t[2][k] });
        isOn = isOn && at[k] >= low - this->Least && at[k] <= high + this->Least;
      }
      return isOn;
    });
  }

private:
  bool meets(const Vec3& point, const Vec3& ray, const Corners& t) const
  {
    const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
    const double along = dot(normal, ray);
    if (std::fabs(along) <= tolerance::TooClose * lengthOf(normal) * lengthOf(ray))
    {
      return false; // edge-on or without area
    }
    const double at = dot(normal, t[0] - point) / along;
    if (!(at * lengthOf(ray) > this->Least) ||
      (this->Light[3] != 0.0 && at * this->Light[3] >= 1.0))
    {
      return false;
    }
    const Vec3 hit = point + at * ray;
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (dot(normal, cross(t[(k + 1) % 3] - t[k], hit - t[k])) < 0.0)
      {
        return false;
      }
    }
    return true;
  }

  std::array<double, 4> Light;
  double Least;
  std::vector<Corners> Triangles;
};

/// Anywhere in a convex polygon, evenly but for its corners.
Vec3 placeIn(const std::vector<Vec3>& polygon, Random& random)
{
  std::vector<double> areas{ 0.0 };
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
  {
    areas.push_back(
      areas.back() + lengthOf(cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0])));
  }
  const double wanted = random.uniform(0.0, areas.back());
  const auto found = std::upper_bound(areas.begin(), areas.end() - 1, wanted);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(found - areas.begin(), 1));
  double u = random.uniform();
  double v = random.uniform();
  if (u + v > 1.0)
  {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  return polygon[0] + u * (polygon[i] - polygon[0]) + v * (polygon[i + 1] - polygon[0]);
}
}

RegionReport checkRegions(vtkPolyData* regions, const std::vector<Mesh>& receivers,
  const std::vector<Mesh>& casters, const std::array<double, 4>& light, Random& random, int looks)
{
  RegionReport report;
  report.Polygons = regions->GetNumberOfPolys();
  vtkDataArray* lit = regions->GetCellData()->GetArray("Lit");
  vtkDataArray* turnedAway = regions->GetCellData()->GetArray("TurnedAway");
  vtkDataArray* receiver = regions->GetCellData()->GetArray("Receiver");
  vtkDataArray* receiverCell = regions->GetCellData()->GetArray("ReceiverCell");
  double size = 0.0;
  std::vector<std::vector<std::vector<Vec3>>> originals;
  std::vector<std::vector<double>> areas;
  std::vector<std::array<double, 3>> sums(receivers.size(), { 0.0, 0.0, 0.0 });
  for (const auto* meshes : { &receivers, &casters })
  {
    for (vtkPolyData* mesh : *meshes)
    {
      size = std::max(size, mesh->GetLength());
    }
  }
  for (vtkPolyData* mesh : receivers)
  {
    originals.push_back(polygonsOf(mesh));
    areas.emplace_back(originals.back().size(), 0.0);
  }
  const double aside = tolerance::BesideContour * size;
  const Rays rays(casters, light, tolerance::TooClose * size);
  const bool isLightOnCaster = rays.isLightOnCaster();
  const std::vector<std::vector<Vec3>> polygons = polygonsOf(regions);
  std::vector<std::vector<std::vector<Vec3>>> ofReceiver(receivers.size());
  std::vector<std::vector<std::vector<vtkIdType>>> idsOfReceiver(receivers.size());
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    const auto cell = static_cast<vtkIdType>(i);
    const auto number = static_cast<std::size_t>(receiver->GetComponent(cell, 0));
    const auto source = static_cast<std::size_t>(receiverCell->GetComponent(cell, 0));
    const Vec3 normal = areaNormal(polygons[i]);
    const Vec3 sourceNormal = areaNormal(originals[number][source]);
    const double area = 0.5 * lengthOf(normal);
    // What is narrower is all within that of the edges of shadows.
    const bool isWide = area > aside * perimeterOf(polygons[i]);
    report.Turned += dot(normal, sourceNormal) < 0.0 && area > tolerance::TooClose * size * size;
    areas[number][source] += area;
    const bool isLit = lit->GetComponent(cell, 0) != 0.0;
    const bool isAway = turnedAway->GetComponent(cell, 0) != 0.0;
    sums[number][isLit ? 0 : isAway ? 2 : 1] += area;
    ofReceiver[number].push_back(polygons[i]);
    idsOfReceiver[number].push_back(idsOf(regions, cell));
    for (int look = 0; look < looks && isWide; ++look)
    {
      const Vec3 place = placeIn(polygons[i], random);
      const Vec3 towards = rays.towards(place);
      const double facing =
        dot(sourceNormal, towards) / (lengthOf(sourceNormal) * lengthOf(towards));
      ++report.Looks;
      if (isLightOnCaster || !(std::fabs(facing) > tolerance::EdgeOn))
      {
        ++report.Unclear;
        continue;
      }
      bool wrong = isAway != (facing < 0.0) || (isAway && isLit);
      if (facing > 0.0 && !isAway)
      {
        const Vec3 u = normalized(cross(sourceNormal,
          towards[0] == 0.0 && towards[1] == 0.0 ? Vec3{ 1.0, 0.0, 0.0 } : Vec3{ 0.0, 0.0, 1.0 }));
        const Vec3 v = normalized(cross(sourceNormal, u));
        const bool isShadowed = rays.isShadowed(place);
        wrong = isShadowed == isLit;
        if (wrong)
        {
          bool isClear = true;
          for (int turn = 0; turn < 8; ++turn)
          {
            const double angle = 0.25 * turn * 3.141592653589793;
            const Vec3 beside = place + aside * std::cos(angle) * u + aside * std::sin(angle) * v;
            isClear = isClear && rays.isShadowed(beside) == isShadowed;
          }
          report.Unclear += !isClear;
          wrong = isClear;
        }
        report.Shadowed += isShadowed;
      }
      if (wrong && ++report.Wrong == 1)
      {
        std::ostringstream text;
        text.precision(17);
        text << "receiver " << number << ", cell " << source << ", polygon " << i << " of area "
             << area << " is "
             << (isLit       ? "lit"
                    : isAway ? "turned away"
                             : "in shadow")
             << ", at (" << place[0] << ", " << place[1] << ", " << place[2] << ")";
        report.FirstWrong = text.str();
      }
    }
  }
  for (std::size_t number = 0; number < receivers.size(); ++number)
  {
    double whole = 0.0;
    double worst = 0.0;
    for (std::size_t i = 0; i < areas[number].size(); ++i)
    {
      const double area = 0.5 * lengthOf(areaNormal(originals[number][i]));
      whole += area;
      worst = std::max(worst, std::fabs(area - areas[number][i]));
    }
    const char* names[] = { "LitArea", "ShadowedArea", "TurnedAwayArea" };
    for (std::size_t k = 0; k < 3; ++k)
    {
      vtkDataArray* reported = regions->GetFieldData()->GetArray(names[k]);
      worst = std::max(worst,
        std::fabs(reported->GetComponent(static_cast<vtkIdType>(number), 0) - sums[number][k]));
    }
    report.AreaError = std::max(report.AreaError, whole > 0.0 ? worst / whole : worst);
    const double border = borderOf(originals[number], numbersByPlace(originals[number]));
    report.BorderError = std::max(report.BorderError,
      std::fabs(borderOf(ofReceiver[number], idsOfReceiver[number]) - border) /
        std::max(border, size));
  }
  return report;
}
}
