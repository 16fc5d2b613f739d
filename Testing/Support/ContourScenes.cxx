#include "ContourScenes.h"

#include "Random.h"
#include "RandomMeshes.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace shadowtest
{
Mesh terrain(Random& random, int cells, double half, double top, double relief, bool whole)
{
  MeshBuilder mesh;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      const double depth =
        whole ? random.integer(0, static_cast<int>(relief)) : random.uniform(0.0, relief);
      mesh.addPoint(
        { half * (2.0 * i / cells - 1.0), half * (2.0 * j / cells - 1.0), top - depth });
    }
  }
  const int row = cells + 1;
  for (int j = 0; j < cells; ++j)
  {
    for (int i = 0; i < cells; ++i)
    {
      const int at = j * row + i;
      if ((i + j) % 2 == 0)
      {
        mesh.addQuad(at, at + 1, at + row + 1, at + row);
      }
      else
      {
        mesh.addQuad(at + 1, at + row + 1, at + row, at);
      }
    }
  }
  return mesh.build();
}

ContourScene randomContourScene(std::uint64_t seed)
{
  const RandomMesh caster = randomMesh(seed);
  Random random(seed + 1000003);
  ContourScene scene;
  scene.Casters = { caster.Surface };
  scene.Light = caster.Light;
  const bool whole = caster.Exact || random.chance(0.3);
  const auto field = [&](double top, double relief)
  { return terrain(random, random.integer(1, 8), 8.0, top, relief, whole); };
  switch (random.integer(0, 5))
  {
    case 0:
      scene.Kind = "its own receiver";
      scene.Receivers = { caster.Surface };
      break;
    case 1:
      scene.Kind = "light among the receivers";
      scene.Receivers = { field(-2.0, 2.0), moved(box(6.0, 6.0, 6.0), -1.0, { 0.0, 0.0, 0.0 }),
        voxels(3, seed) };
      scene.Light = { static_cast<double>(random.integer(-3, 3)),
        static_cast<double>(random.integer(-3, 3)), static_cast<double>(random.integer(-1, 4)),
        1.0 };
      break;
    case 2:
      scene.Kind = "several casters and receivers";
      scene.Casters.push_back(voxels(2, seed + 7));
      scene.Casters.push_back(moved(icosphere(1, seed + 1), 0.7, { 1.0, 0.5, -1.5 }));
      scene.Receivers = { field(-2.0, 3.0), caster.Surface, scene.Casters[1] };
      break;
    case 3:
      scene.Kind = "through the receiver";
      scene.Receivers = { field(1.0, 2.0) };
      break;
    default:
      scene.Kind = "over a terrain";
      scene.Receivers = { field(-3.0, 3.0) };
      break;
  }
  scene.Kind += ", " + caster.Kind;
  return scene;
}

namespace
{
double distanceToEdge(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 along = b - a;
  const double squared = dot(along, along);
  const double t =
    squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
  const Vec3 away = p - a - t * along;
  return std::sqrt(dot(away, away));
}

bool isWhole(const Vec3& p)
{
  return p[0] == std::round(p[0]) && p[1] == std::round(p[1]) && p[2] == std::round(p[2]);
}

/// Edges of a receiver, by coordinates, at which contours may end.
class BorderEdges
{
public:
  BorderEdges(vtkPolyData* mesh, const std::array<double, 4>& light)
  {
    MeshBuilder read;
    read.append(mesh);
    std::map<std::pair<Vec3, Vec3>, std::vector<int>> sides;
    for (const auto& cell : read.Cells)
    {
      for (std::size_t i = 2; i < cell.size(); ++i)
      {
        this->addTriangle({ read.Points[static_cast<std::size_t>(cell[0])],
                            read.Points[static_cast<std::size_t>(cell[i - 1])],
                            read.Points[static_cast<std::size_t>(cell[i])] },
          light, sides);
      }
    }
    for (const auto& [edge, directions] : sides)
    {
      const bool isInner = directions.size() == 2 && directions[0] == -directions[1];
      if (!isInner)
      {
        this->Edges.push_back(edge);
      }
    }
  }

  double distance(const Vec3& point) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : this->Edges)
    {
      least = std::min(least, distanceToEdge(point, a, b));
    }
    return least;
  }

private:
  void addTriangle(const std::array<Vec3, 3>& t, const std::array<double, 4>& light,
    std::map<std::pair<Vec3, Vec3>, std::vector<int>>& sides)
  {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    {
      return;
    }
    const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
    const Vec3 toLight = Vec3{ light[0], light[1], light[2] } - light[3] * t[0];
    const double facing = dot(normal, toLight);
    const Vec3 u = t[1] - t[0];
    const Vec3 v = t[2] - t[0];
    const double sizes = std::sqrt(std::max(dot(u, u), dot(v, v)) *
      std::max(dot(u, u), dot(v, v)) * dot(toLight, toLight));
    // Close to edge-on, or without area, it is not for another formula to say which way it faces,
    // unless it computes without rounding.
    const bool isExact = isWhole({ light[0], light[1], light[2] }) && isWhole(t[0]) &&
      isWhole(t[1]) && isWhole(t[2]) && light[3] == std::round(light[3]);
    const bool isEdgeOn = std::fabs(facing) <= tolerance::EdgeOn * sizes && !isExact;
    if (facing < 0.0 && !isEdgeOn)
    {
      return;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vec3& a = t[k];
      const Vec3& b = t[(k + 1) % 3];
      auto& found = sides[a < b ? std::pair(a, b) : std::pair(b, a)];
      found.push_back(a < b ? 1 : -1);
      if (isEdgeOn)
      {
        this->Edges.emplace_back(a, b);
      }
    }
  }

  std::vector<std::pair<Vec3, Vec3>> Edges;
};
}

LineReport checkLines(vtkPolyData* contours, const std::vector<Mesh>& receivers,
  const std::array<double, 4>& light)
{
  LineReport report;
  vtkDataArray* closed = contours->GetCellData()->GetArray("Closed");
  vtkDataArray* receiver = contours->GetCellData()->GetArray("Receiver");
  vtkDataArray* casters = contours->GetPointData()->GetArray("CasterPoints");
  std::vector<BorderEdges> borders;
  std::vector<double> sizes;
  for (vtkPolyData* mesh : receivers)
  {
    borders.emplace_back(mesh, light);
    sizes.push_back(mesh->GetLength());
  }
  for (vtkIdType line = 0; line < contours->GetNumberOfLines(); ++line)
  {
    vtkIdType count;
    const vtkIdType* ids;
    contours->GetLines()->GetCellAtId(line, count, ids);
    ++report.Lines;
    report.Segments += count - 1;
    const bool isClosed = closed->GetComponent(line, 0) != 0.0;
    report.BadClosed += count < 2 || isClosed != (ids[0] == ids[count - 1]);
    report.ClosedLines += isClosed;
    if (isClosed)
    {
      continue;
    }
    const auto number = static_cast<std::size_t>(receiver->GetComponent(line, 0));
    for (const vtkIdType id : { ids[0], ids[count - 1] })
    {
      Vec3 point;
      Vec3 caster;
      contours->GetPoint(id, point.data());
      casters->GetTuple(id, caster.data());
      if (point == caster)
      {
        ++report.EndsAtCasters;
      }
      else if (borders[number].distance(point) <= tolerance::SamePoint * sizes[number])
      {
        ++report.EndsAtBorders;
      }
      else
      {
        ++report.BadEnds;
      }
    }
  }
  return report;
}
}
