#include "HostileMeshes.h"

#include "Random.h"
#include "TestMeshes.h"

#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace shadowtest
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

MeshBuilder opening(vtkPolyData* mesh)
{
  MeshBuilder builder;
  builder.append(mesh);
  return builder;
}

const Vec3& pointOf(const MeshBuilder& mesh, vtkIdType id)
{
  return mesh.Points[static_cast<std::size_t>(id)];
}
}

Mesh fin(int faces)
{
  MeshBuilder mesh;
  const Vec3 low{ 0.0, 0.0, 0.0 };
  const Vec3 high{ 0.0, 0.0, 1.0 };
  mesh.addPoint(low);
  mesh.addPoint(high);
  for (int i = 0; i < faces; ++i)
  {
    const double angle = 2.0 * Pi * (i + 0.1) / faces;
    const vtkIdType tip = mesh.addPoint({ std::cos(angle), std::sin(angle), 0.5 });
    mesh.addTriangle(i % 2, 1 - i % 2, tip);
  }
  return facetted(mesh.build());
}

Mesh finnedBox(int fins)
{
  MeshBuilder mesh = opening(weldedBox());
  for (int i = 0; i < fins; ++i)
  {
    // On the edge of corners 3 (+x +y -z) and 7 (+x +y +z), leaning outwards.
    const double angle = 0.5 * Pi * (i + 1) / (fins + 1);
    const vtkIdType tip = mesh.addPoint({ 1.0 + std::cos(angle), 1.0 + std::sin(angle), 0.1 * i });
    mesh.addTriangle(i % 2 ? 3 : 7, i % 2 ? 7 : 3, tip);
  }
  return mesh.build();
}

Mesh moebiusStrip(int quads)
{
  MeshBuilder mesh;
  for (int i = 0; i < quads; ++i)
  {
    const double angle = 2.0 * Pi * i / quads;
    for (double side : { -0.3, 0.3 })
    {
      const double radius = 1.0 + side * std::cos(0.5 * angle);
      mesh.addPoint(
        { radius * std::cos(angle), radius * std::sin(angle), side * std::sin(0.5 * angle) });
    }
  }
  for (int i = 0; i < quads; ++i)
  {
    const vtkIdType a = 2 * i;
    // The last quad meets the first one upside down.
    const bool last = i + 1 == quads;
    mesh.addQuad(a, last ? 1 : a + 2, last ? 0 : a + 3, a + 1);
  }
  return mesh.build();
}

Mesh sliverBox(double aspect)
{
  return box(1.0, 1.0, aspect);
}

Mesh slivers(int count, double height)
{
  MeshBuilder mesh;
  const Vec3 up{ 0.0, 0.0, 1.0 };
  mesh.addPoint({ 0.0, 0.0, 0.0 }, up);
  mesh.addPoint({ 1.0, 0.0, 0.0 }, up);
  vtkIdType previous = 1;
  for (int i = 1; i <= count; ++i)
  {
    const vtkIdType tip =
      mesh.addPoint({ 0.5, std::pow(height, 1.0 - (i - 1.0) / count), 0.0 }, up);
    mesh.addTriangle(0, previous, tip);
    previous = tip;
  }
  return mesh.build();
}

Mesh tJunction()
{
  MeshBuilder mesh;
  for (const Vec3& p : std::vector<Vec3>{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 2, 0 }, { 0, 2, 0 },
         { 2, 0, 1 }, { 2, 2, 1 }, { 1, 1, 0 } })
  {
    mesh.addPoint(p);
  }
  mesh.addQuad(0, 1, 2, 3);
  mesh.addTriangle(1, 4, 6);
  mesh.addTriangle(4, 5, 6);
  mesh.addTriangle(6, 5, 2);
  return mesh.build();
}

Mesh opened(vtkPolyData* surface, double fraction, std::uint64_t seed)
{
  Random random(seed);
  MeshBuilder mesh = opening(surface);
  std::vector<std::vector<vtkIdType>> kept;
  for (const auto& cell : mesh.Cells)
  {
    if (!random.chance(fraction))
    {
      kept.push_back(cell);
    }
  }
  mesh.Cells = kept;
  return mesh.build();
}

Mesh misoriented(vtkPolyData* surface, double fraction, std::uint64_t seed)
{
  Random random(seed);
  MeshBuilder mesh = opening(surface);
  for (auto& cell : mesh.Cells)
  {
    if (random.chance(fraction))
    {
      std::swap(cell[0], cell[1]);
    }
  }
  return mesh.build();
}

Mesh degenerated(vtkPolyData* surface, double fraction, std::uint64_t seed)
{
  Random random(seed);
  MeshBuilder mesh = opening(surface);
  const std::size_t count = mesh.Cells.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!random.chance(fraction))
    {
      continue;
    }
    auto& cell = mesh.Cells[i];
    if (random.chance(0.5))
    {
      // A corner twice.
      cell[1] = cell[0];
    }
    else
    {
      // Three points on a line.
      const Vec3 middle = 0.5 * (pointOf(mesh, cell[0]) + pointOf(mesh, cell[1]));
      cell[2] = mesh.Normals.empty()
        ? mesh.addPoint(middle)
        : mesh.addPoint(middle, mesh.Normals[static_cast<std::size_t>(cell[0])]);
    }
  }
  return mesh.build();
}

Mesh duplicated(vtkPolyData* surface, double fraction, std::uint64_t seed)
{
  Random random(seed);
  MeshBuilder mesh = opening(surface);
  const std::size_t count = mesh.Cells.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!random.chance(fraction))
    {
      continue;
    }
    std::vector<vtkIdType> cell = mesh.Cells[i];
    if (random.chance(0.5))
    {
      for (vtkIdType& id : cell)
      {
        const Vec3 point = pointOf(mesh, id);
        id = mesh.Normals.empty()
          ? mesh.addPoint(point)
          : mesh.addPoint(point, Vec3(mesh.Normals[static_cast<std::size_t>(id)]));
      }
    }
    mesh.Cells.push_back(cell);
  }
  return mesh.build();
}

Mesh withBadPoints(vtkPolyData* surface, int count, std::uint64_t seed)
{
  Random random(seed);
  MeshBuilder mesh = opening(surface);
  const double bad[3] = { std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  for (int i = 0; i < count; ++i)
  {
    const int point = random.integer(0, static_cast<int>(mesh.pointCount()) - 1);
    mesh.Points[static_cast<std::size_t>(point)][static_cast<std::size_t>(random.integer(0, 2))] =
      bad[random.integer(0, 2)];
  }
  return mesh.build();
}

Mesh voxels(int n, std::uint64_t seed)
{
  Random random(seed);
  std::vector<bool> filled(static_cast<std::size_t>(n * n * n));
  for (std::size_t i = 0; i < filled.size(); ++i)
  {
    filled[i] = random.chance(0.5);
  }
  auto inside = [&](const int c[3]) {
    for (int axis = 0; axis < 3; ++axis)
    {
      if (c[axis] < 0 || c[axis] >= n)
      {
        return false;
      }
    }
    return static_cast<bool>(filled[static_cast<std::size_t>((c[2] * n + c[1]) * n + c[0])]);
  };
  MeshBuilder mesh;
  std::map<Vec3, vtkIdType> ids;
  auto corner = [&](const int c[3]) {
    const Vec3 p{ static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2]) };
    auto found = ids.emplace(p, mesh.pointCount());
    if (found.second)
    {
      mesh.addPoint(p);
    }
    return found.first->second;
  };
  for (int i = 0; i < n * n * n; ++i)
  {
    const int cell[3] = { i % n, i / n % n, i / (n * n) };
    if (!inside(cell))
    {
      continue;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int step : { -1, 1 })
      {
        int neighbour[3] = { cell[0], cell[1], cell[2] };
        neighbour[axis] += step;
        if (inside(neighbour))
        {
          continue;
        }
        // (u, v, axis) is right-handed, so u then v turns counter-clockwise seen from +axis.
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        vtkIdType quad[4];
        for (int k = 0; k < 4; ++k)
        {
          int c[3] = { cell[0], cell[1], cell[2] };
          c[axis] += step > 0 ? 1 : 0;
          c[u] += k == 1 || k == 2 ? 1 : 0;
          c[v] += k >= 2 ? 1 : 0;
          quad[k] = corner(c);
        }
        mesh.addQuad(quad[0], quad[step > 0 ? 1 : 3], quad[2], quad[step > 0 ? 3 : 1]);
      }
    }
  }
  return mesh.build();
}
}
