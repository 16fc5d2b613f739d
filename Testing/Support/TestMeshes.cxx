#include "TestMeshes.h"

#include "Random.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>
#include <map>
#include <utility>

namespace shadowtest
{
namespace
{
constexpr double Pi = 3.14159265358979323846;

// Of the width of a grid cell. Two neighbours moved towards each other keep half the width, so no
// face turns over.
constexpr double GridJitter = 0.25;

struct Sphere
{
  std::vector<Vec3> Points;
  std::vector<std::array<vtkIdType, 3>> Triangles;
};

Sphere uvSphere(int rings, int segments, std::uint64_t jitterSeed)
{
  Random random(jitterSeed);
  auto jitter = [&]() { return jitterSeed ? random.uniform(-GridJitter, GridJitter) : 0.0; };
  Sphere sphere;
  sphere.Points.push_back({ 0.0, 0.0, 1.0 });
  for (int ring = 1; ring < rings; ++ring)
  {
    for (int segment = 0; segment < segments; ++segment)
    {
      const double polar = Pi * (ring + jitter()) / rings;
      const double azimuth = 2.0 * Pi * (segment + jitter()) / segments;
      sphere.Points.push_back({ std::sin(polar) * std::cos(azimuth),
        std::sin(polar) * std::sin(azimuth), std::cos(polar) });
    }
  }
  sphere.Points.push_back({ 0.0, 0.0, -1.0 });

  const vtkIdType last = static_cast<vtkIdType>(sphere.Points.size()) - 1;
  auto id = [&](int ring, int segment) -> vtkIdType {
    return 1 + static_cast<vtkIdType>(ring - 1) * segments + segment % segments;
  };
  for (int s = 0; s < segments; ++s)
  {
    sphere.Triangles.push_back({ 0, id(1, s), id(1, s + 1) });
    for (int r = 1; r + 1 < rings; ++r)
    {
      sphere.Triangles.push_back({ id(r, s), id(r + 1, s), id(r + 1, s + 1) });
      sphere.Triangles.push_back({ id(r, s), id(r + 1, s + 1), id(r, s + 1) });
    }
    sphere.Triangles.push_back({ id(rings - 1, s), last, id(rings - 1, s + 1) });
  }
  return sphere;
}

Sphere icoSphere(int subdivisions, std::uint64_t jitterSeed)
{
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  Sphere sphere;
  for (const Vec3& p : std::vector<Vec3>{ { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 },
         { 0, -1, g }, { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 },
         { -g, 0, -1 }, { -g, 0, 1 } })
  {
    sphere.Points.push_back(normalized(p));
  }
  sphere.Triangles = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
    { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 },
    { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },
    { 9, 8, 1 } };
  for (int level = 0; level < subdivisions; ++level)
  {
    std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> middles;
    auto middle = [&](vtkIdType a, vtkIdType b) {
      auto found = middles.emplace(std::minmax(a, b), static_cast<vtkIdType>(sphere.Points.size()));
      if (found.second)
      {
        sphere.Points.push_back(normalized(
          sphere.Points[static_cast<std::size_t>(a)] + sphere.Points[static_cast<std::size_t>(b)]));
      }
      return found.first->second;
    };
    std::vector<std::array<vtkIdType, 3>> finer;
    for (const auto& t : sphere.Triangles)
    {
      const vtkIdType ab = middle(t[0], t[1]);
      const vtkIdType bc = middle(t[1], t[2]);
      const vtkIdType ca = middle(t[2], t[0]);
      finer.push_back({ t[0], ab, ca });
      finer.push_back({ ab, t[1], bc });
      finer.push_back({ ca, bc, t[2] });
      finer.push_back({ ab, bc, ca });
    }
    sphere.Triangles = std::move(finer);
  }
  if (jitterSeed)
  {
    Random random(jitterSeed);
    // The icosahedron's edge is 1.05 long; a fifth of an edge leaves every face its orientation.
    const double reach = 0.2 * 1.05 / std::pow(2.0, subdivisions);
    for (Vec3& p : sphere.Points)
    {
      Vec3 step;
      random.direction(step.data());
      const Vec3 tangent = step - dot(step, p) * p;
      p = normalized(p + (reach * random.uniform()) * normalized(tangent));
    }
  }
  return sphere;
}

Mesh scaledSphere(const Sphere& sphere, const double axes[3])
{
  MeshBuilder mesh;
  for (const Vec3& p : sphere.Points)
  {
    mesh.addPoint({ axes[0] * p[0], axes[1] * p[1], axes[2] * p[2] },
      normalized({ p[0] / axes[0], p[1] / axes[1], p[2] / axes[2] }));
  }
  for (const auto& t : sphere.Triangles)
  {
    mesh.addTriangle(t[0], t[1], t[2]);
  }
  return mesh.build();
}

class Rotation
{
public:
  explicit Rotation(std::uint64_t seed)
    : Identity(seed == 0)
  {
    Random random(seed);
    Vec3 other;
    random.direction(this->Rows[0].data());
    random.direction(other.data());
    this->Rows[1] = normalized(cross(other, this->Rows[0]));
    this->Rows[2] = cross(this->Rows[0], this->Rows[1]);
  }

  Vec3 operator()(const Vec3& v) const
  {
    return this->Identity
      ? v
      : Vec3{ dot(this->Rows[0], v), dot(this->Rows[1], v), dot(this->Rows[2], v) };
  }

private:
  bool Identity;
  Vec3 Rows[3];
};

const double UnitAxes[3] = { 1.0, 1.0, 1.0 };

// Quads of a box by the corner's bits: 1 for +x, 2 for +y, 4 for +z.
const int BoxFaces[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
  { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };

Vec3 boxCorner(int bits, double x, double y, double z)
{
  return { bits & 1 ? x : -x, bits & 2 ? y : -y, bits & 4 ? z : -z };
}
}

const double EllipsoidAxes[3] = { 2.0, 1.0, 0.5 };

Mesh sphere(int rings, int segments, std::uint64_t jitterSeed)
{
  return scaledSphere(uvSphere(rings, segments, jitterSeed), UnitAxes);
}

Mesh icosphere(int subdivisions, std::uint64_t jitterSeed)
{
  return scaledSphere(icoSphere(subdivisions, jitterSeed), UnitAxes);
}

Mesh ellipsoid(int rings, int segments, std::uint64_t jitterSeed)
{
  return scaledSphere(uvSphere(rings, segments, jitterSeed), EllipsoidAxes);
}

Mesh icoEllipsoid(int subdivisions, std::uint64_t jitterSeed)
{
  return scaledSphere(icoSphere(subdivisions, jitterSeed), EllipsoidAxes);
}

Mesh torus(int around, int across, std::uint64_t jitterSeed)
{
  Random random(jitterSeed);
  auto jitter = [&]() { return jitterSeed ? random.uniform(-GridJitter, GridJitter) : 0.0; };
  MeshBuilder mesh;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double u = 2.0 * Pi * (i + jitter()) / around;
      const double v = 2.0 * Pi * (j + jitter()) / across;
      const double radius = TorusRadius + TorusTube * std::cos(v);
      mesh.addPoint({ radius * std::cos(u), radius * std::sin(u), TorusTube * std::sin(v) },
        { std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v) });
    }
  }
  auto id = [&](int i, int j) -> vtkIdType {
    return static_cast<vtkIdType>(i % around) * across + j % across;
  };
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      mesh.addQuad(id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1));
    }
  }
  return mesh.build();
}

Mesh cylinder(int sides, int stacks)
{
  MeshBuilder mesh;
  auto rim = [&](int side, double z) -> Vec3 {
    const double angle = 2.0 * Pi * (side % sides) / sides;
    return { std::cos(angle), std::sin(angle), z };
  };
  for (int stack = 0; stack <= stacks; ++stack)
  {
    const double z = -1.0 + 2.0 * stack / stacks;
    for (int side = 0; side < sides; ++side)
    {
      const Vec3 p = rim(side, z);
      mesh.addPoint(p, { p[0], p[1], 0.0 });
    }
  }
  auto id = [&](int stack, int side) -> vtkIdType {
    return static_cast<vtkIdType>(stack) * sides + side % sides;
  };
  for (int stack = 0; stack < stacks; ++stack)
  {
    for (int side = 0; side < sides; ++side)
    {
      mesh.addQuad(
        id(stack, side), id(stack, side + 1), id(stack + 1, side + 1), id(stack + 1, side));
    }
  }
  for (double z : { -1.0, 1.0 })
  {
    const vtkIdType centre = mesh.addPoint({ 0.0, 0.0, z }, { 0.0, 0.0, z });
    for (int side = 0; side < sides; ++side)
    {
      mesh.addPoint(rim(side, z), { 0.0, 0.0, z });
    }
    for (int side = 0; side < sides; ++side)
    {
      const vtkIdType a = centre + 1 + side;
      const vtkIdType b = centre + 1 + (side + 1) % sides;
      mesh.addTriangle(centre, z > 0.0 ? a : b, z > 0.0 ? b : a);
    }
  }
  return mesh.build();
}

Mesh box(double x, double y, double z)
{
  MeshBuilder mesh;
  for (int face = 0; face < 6; ++face)
  {
    Vec3 normal{ 0.0, 0.0, 0.0 };
    normal[static_cast<std::size_t>(face / 2)] = face % 2 ? 1.0 : -1.0;
    const vtkIdType first = mesh.pointCount();
    for (int corner : BoxFaces[face])
    {
      mesh.addPoint(boxCorner(corner, x, y, z), normal);
    }
    mesh.addQuad(first, first + 1, first + 2, first + 3);
  }
  return mesh.build();
}

Mesh weldedBox(double x, double y, double z)
{
  MeshBuilder mesh;
  for (int corner = 0; corner < 8; ++corner)
  {
    mesh.addPoint(boxCorner(corner, x, y, z));
  }
  for (const auto& face : BoxFaces)
  {
    mesh.addQuad(face[0], face[1], face[2], face[3]);
  }
  return mesh.build();
}

Mesh quadBox(double x, double y, double z)
{
  MeshBuilder mesh;
  for (int corner = 0; corner < 8; ++corner)
  {
    mesh.addPoint(boxCorner(corner, x, y, z));
  }
  for (const auto& face : BoxFaces)
  {
    mesh.addPolygon({ face[0], face[1], face[2], face[3] });
  }
  return mesh.build();
}

Mesh ground(double height, double halfSize, int cells)
{
  MeshBuilder mesh;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      mesh.addPoint(
        { halfSize * (2.0 * i / cells - 1.0), halfSize * (2.0 * j / cells - 1.0), height },
        { 0.0, 0.0, 1.0 });
    }
  }
  const vtkIdType row = cells + 1;
  for (int j = 0; j < cells; ++j)
  {
    for (int i = 0; i < cells; ++i)
    {
      const vtkIdType a = j * row + i;
      mesh.addQuad(a, a + 1, a + 1 + row, a + row);
    }
  }
  return mesh.build();
}

Mesh triangle()
{
  MeshBuilder mesh;
  const Vec3 up{ 0.0, 0.0, 1.0 };
  mesh.addPoint({ 0.0, 0.0, 0.0 }, up);
  mesh.addPoint({ 1.0, 0.0, 0.0 }, up);
  mesh.addPoint({ 0.0, 1.0, 0.0 }, up);
  mesh.addTriangle(0, 1, 2);
  return mesh.build();
}

Mesh starShaped(int subdivisions, std::uint64_t seed, double amplitude)
{
  struct Wave
  {
    Vec3 Frequency;
    double Phase;
    double Height;
  };
  Random random(seed);
  constexpr int WaveCount = 6;
  std::vector<Wave> waves(WaveCount);
  for (Wave& wave : waves)
  {
    random.direction(wave.Frequency.data());
    wave.Frequency = random.uniform(1.0, 5.0) * wave.Frequency;
    wave.Phase = random.uniform(0.0, 2.0 * Pi);
    wave.Height = amplitude * random.uniform(0.5, 1.0) / WaveCount;
  }
  const Sphere sphere = icoSphere(subdivisions, seed);
  MeshBuilder mesh;
  for (const Vec3& d : sphere.Points)
  {
    // The surface |x| = radius(x/|x|) is a level set of |x| - radius; its gradient is the normal.
    double radius = 1.0;
    Vec3 slope{ 0.0, 0.0, 0.0 };
    for (const Wave& wave : waves)
    {
      const double angle = dot(wave.Frequency, d) + wave.Phase;
      radius += wave.Height * std::sin(angle);
      slope = slope + (wave.Height * std::cos(angle)) * wave.Frequency;
    }
    const Vec3 tangential = slope - dot(slope, d) * d;
    mesh.addPoint(radius * d, normalized(d - (1.0 / radius) * tangential));
  }
  for (const auto& t : sphere.Triangles)
  {
    mesh.addTriangle(t[0], t[1], t[2]);
  }
  return mesh.build();
}

Mesh withoutNormals(vtkPolyData* mesh)
{
  Mesh copy = Mesh::New();
  copy->DeepCopy(mesh);
  copy->GetPointData()->SetNormals(nullptr);
  return copy;
}

Mesh facetted(vtkPolyData* mesh)
{
  MeshBuilder in;
  in.append(mesh);
  MeshBuilder out;
  for (const auto& cell : in.Cells)
  {
    std::vector<Vec3> corners;
    for (vtkIdType id : cell)
    {
      corners.push_back(in.Points[static_cast<std::size_t>(id)]);
    }
    const Vec3 normal = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
    std::vector<vtkIdType> ids;
    for (const Vec3& corner : corners)
    {
      ids.push_back(out.addPoint(corner, normal));
    }
    out.addPolygon(ids);
  }
  return out.build();
}

Mesh moved(vtkPolyData* mesh, double scale, const Vec3& shift, std::uint64_t rotationSeed)
{
  const Rotation rotation(rotationSeed);
  MeshBuilder builder;
  builder.append(mesh);
  for (Vec3& p : builder.Points)
  {
    p = scale * rotation(p) + shift;
  }
  for (Vec3& n : builder.Normals)
  {
    n = rotation(n);
  }
  return builder.build();
}

std::array<double, 4> movedLight(
  const double light[4], double scale, const Vec3& shift, std::uint64_t rotationSeed)
{
  Vec3 l = Rotation(rotationSeed)({ light[0], light[1], light[2] });
  if (light[3] != 0.0)
  {
    l = scale * l + light[3] * shift;
  }
  return { l[0], l[1], l[2], light[3] };
}

Mesh merged(const std::vector<Mesh>& meshes)
{
  MeshBuilder builder;
  for (const Mesh& mesh : meshes)
  {
    builder.append(mesh);
  }
  return builder.build();
}

double meanEdgeLength(vtkPolyData* triangles)
{
  MeshBuilder mesh;
  mesh.append(triangles);
  double sum = 0.0;
  std::size_t count = 0;
  for (const auto& cell : mesh.Cells)
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      const Vec3 edge = mesh.Points[static_cast<std::size_t>(cell[(i + 1) % cell.size()])] -
        mesh.Points[static_cast<std::size_t>(cell[i])];
      sum += std::sqrt(dot(edge, edge));
      ++count;
    }
  }
  return count ? sum / static_cast<double>(count) : 0.0;
}
}
