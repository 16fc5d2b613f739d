#include "CoreMeshes.h"
#include "JetFit.h"
#include "JetNormals.h"
#include "Random.h"
#include "VertexNormals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

using namespace shadow;

namespace
{
constexpr double Pi = 3.14159265358979323846;

std::vector<JetSample> samplesOf(
  const std::function<double(double, double)>& height, std::size_t count)
{
  shadowtest::Random random(11);
  std::vector<JetSample> samples;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = random.uniform(-1.0, 1.0);
    const double y = random.uniform(-1.0, 1.0);
    samples.push_back({ x, y, height(x, y) });
  }
  return samples;
}

/// A parametric surface on a grid of cells, each of two triangles, whose inner points are jittered
/// by a fifth of a cell. A closed direction joins its ends.
struct Grid
{
  int columns;
  int rows;
  bool closedColumns;
  bool closedRows;
  double jitter = 0.2;
};

TriangleMesh gridMesh(const Grid& grid, const std::function<Vec3(double u, double v)>& point)
{
  shadowtest::Random random(5);
  TriangleMesh mesh;
  const int last[2] = { grid.columns + (grid.closedColumns ? 0 : 1),
    grid.rows + (grid.closedRows ? 0 : 1) };
  for (int j = 0; j < last[1]; ++j)
  {
    for (int i = 0; i < last[0]; ++i)
    {
      const bool inner[2] = { grid.closedColumns || (i > 0 && i < grid.columns),
        grid.closedRows || (j > 0 && j < grid.rows) };
      const double u = i + (inner[0] ? random.uniform(-grid.jitter, grid.jitter) : 0.0);
      const double v = j + (inner[1] ? random.uniform(-grid.jitter, grid.jitter) : 0.0);
      mesh.points.push_back(point(u / grid.columns, v / grid.rows));
    }
  }
  const auto id = [&](int i, int j)
  { return static_cast<Index>((j % last[1]) * last[0] + i % last[0]); };
  for (int j = 0; j < grid.rows; ++j)
  {
    for (int i = 0; i < grid.columns; ++i)
    {
      mesh.triangles.push_back({ id(i, j), id(i + 1, j), id(i + 1, j + 1) });
      mesh.triangles.push_back({ id(i, j), id(i + 1, j + 1), id(i, j + 1) });
    }
  }
  return mesh;
}

struct Estimates
{
  TriangleMesh byAngle;
  TriangleMesh byJet;
  std::size_t fallbacks = 0;
};

Estimates estimate(TriangleMesh mesh, double featureAngle = Pi / 3.0)
{
  const EdgeTable edges = buildEdgeTable(mesh);
  estimateCornerNormals(mesh, edges, featureAngle);
  Estimates estimates{ mesh, mesh, 0 };
  estimates.fallbacks = fitJetNormals(estimates.byJet, serialLoop);
  return estimates;
}

/// Largest angle between a mesh's normals and the true ones.
double largestError(const TriangleMesh& mesh, const std::function<Vec3(const Vec3&)>& normal)
{
  double largest = 0.0;
  for (std::size_t n = 0; n < mesh.normals.size(); ++n)
  {
    const Vec3 expected = normal(mesh.points[mesh.normalVertex[n]]);
    const Vec3 sine = glm::cross(mesh.normals[n], expected);
    const double cosine = glm::dot(mesh.normals[n], expected);
    largest = std::fmax(largest, std::atan2(glm::length(sine), cosine));
  }
  return largest;
}

/// The same, root mean square.
double meanError(const TriangleMesh& mesh, const std::function<Vec3(const Vec3&)>& normal)
{
  double sum = 0.0;
  for (std::size_t n = 0; n < mesh.normals.size(); ++n)
  {
    const Vec3 off = mesh.normals[n] - normal(mesh.points[mesh.normalVertex[n]]);
    sum += glm::dot(off, off);
  }
  return std::sqrt(sum / static_cast<double>(mesh.normals.size()));
}

struct Shape
{
  std::string name;
  std::function<TriangleMesh(int cells, double jitter)> mesh;
  std::function<Vec3(const Vec3&)> normal;
};

Vec3 torusPoint(double u, double v)
{
  const double radius = 1.0 + 0.4 * std::cos(2.0 * Pi * v);
  return { radius * std::cos(2.0 * Pi * u), radius * std::sin(2.0 * Pi * u),
    0.4 * std::sin(2.0 * Pi * v) };
}

const Shape Torus = { "torus",
  [](int cells, double jitter)
  { return gridMesh({ 2 * cells, cells, true, true, jitter }, torusPoint); },
  [](const Vec3& p)
  { return glm::normalize(p - glm::normalize(Vec3(p.x, p.y, 0.0))); } };

/// The half z > 0 of the ellipsoid with half axes (2, 1, 0.5), from a disc: it has a border.
const Shape EllipsoidCap = { "cap of an ellipsoid",
  [](int cells, double jitter)
  {
    return gridMesh({ cells, cells, false, false, jitter },
      [](double u, double v)
      {
        const double x = 1.2 * u - 0.6;
        const double y = 1.2 * v - 0.6;
        return Vec3(2.0 * x, y, 0.5 * std::sqrt(1.0 - x * x - y * y));
      });
  },
  [](const Vec3& p) { return glm::normalize(p / Vec3(4.0, 1.0, 0.25)); } };

const Shape Sphere = { "belt of a sphere",
  [](int cells, double jitter)
  {
    return gridMesh({ 2 * cells, cells, true, false, jitter },
      [](double u, double v)
      {
        const double latitude = 2.0 * v - 1.0;
        return Vec3(std::cos(latitude) * std::cos(2.0 * Pi * u),
          std::cos(latitude) * std::sin(2.0 * Pi * u), std::sin(latitude));
      });
  },
  [](const Vec3& p) { return glm::normalize(p); } };

/// The order of an error over meshes of 24 to 192 cells.
double orderOf(const std::function<double(int cells)>& error)
{
  return std::log2(error(24) / error(192)) / 3.0;
}

void expectUsable(const TriangleMesh& mesh, const Estimates& e, const std::string& name)
{
  ASSERT_EQ(e.byJet.normals.size(), e.byAngle.normals.size()) << name;
  EXPECT_LE(e.fallbacks, e.byJet.normals.size()) << name;
  for (std::size_t n = 0; n < e.byJet.normals.size(); ++n)
  {
    const Vec3& rough = e.byAngle.normals[n];
    const Vec3& fitted = e.byJet.normals[n];
    ASSERT_TRUE(isFinite(fitted)) << name;
    EXPECT_NEAR(glm::length(fitted), glm::length(rough), 1e-12) << name;
    EXPECT_TRUE(rough == Vec3(0.0) || glm::dot(rough, fitted) > 0.9) << name;
  }
  EXPECT_EQ(mesh.points.size(), e.byJet.points.size());
}
}

TEST(JetFit, CubicsAreExact)
{
  const auto cubic = [](double x, double y)
  {
    return 0.3 - 0.7 * x + 0.4 * y + x * x - 2.0 * x * y + 0.5 * y * y + 3.0 * x * x * x -
      x * x * y + 2.0 * x * y * y - 0.6 * y * y * y;
  };
  for (const std::size_t count : { 16u, 19u, 60u })
  {
    const JetSlopes slopes = fitJet(samplesOf(cubic, count));
    EXPECT_NEAR(slopes.x, -0.7, 1e-11) << count;
    EXPECT_NEAR(slopes.y, 0.4, 1e-11) << count;
    EXPECT_GT(slopes.certainty, 1e-3) << count;
  }
}

TEST(JetFit, FewerPointsGiveQuadrics)
{
  const auto quadric = [](double x, double y)
  { return 0.3 - 0.7 * x + 0.4 * y + x * x - 2.0 * x * y + 0.5 * y * y; };
  for (const std::size_t count : { 8u, 12u, 15u })
  {
    const JetSlopes slopes = fitJet(samplesOf(quadric, count));
    EXPECT_NEAR(slopes.x, -0.7, 1e-11) << count;
    EXPECT_NEAR(slopes.y, 0.4, 1e-11) << count;
  }
  EXPECT_EQ(fitJet(samplesOf(quadric, 7)).certainty, 0.0);
}

// Two rows of points cannot tell a slope from a curvature, one place tells nothing.
TEST(JetFit, UndeterminedSlopesAreUncertain)
{
  std::vector<JetSample> rows;
  for (int i = 0; i < 20; ++i)
  {
    const double x = 0.1 * (i / 2) - 0.45;
    const double y = i % 2;
    rows.push_back({ 0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y, 0.1 * x * x });
  }
  EXPECT_LT(fitJet(rows).certainty, 1e-9);
  EXPECT_EQ(fitJet(std::vector<JetSample>(20, JetSample{ 0.0, 0.0, 0.0 })).certainty, 0.0);
  EXPECT_LT(fitJet(std::vector<JetSample>(20, JetSample{ 0.5, 0.2, 0.1 })).certainty, 1e-9);
}

// The quadric's slopes carry a third of the noise of the cubic's.
TEST(JetFit, NoiseGetsTheQuadric)
{
  shadowtest::Random random(3);
  double sum = 0.0;
  const int trials = 200;
  for (int trial = 0; trial < trials; ++trial)
  {
    std::vector<JetSample> samples;
    for (int i = -2; i <= 2; ++i)
    {
      for (int j = -2; j <= 2; ++j)
      {
        samples.push_back({ 0.5 * i, 0.5 * j, random.uniform(-1.0, 1.0) });
      }
    }
    const double slope = fitJet(samples).x;
    sum += slope * slope;
  }
  // Variance of the noise: 1/3. Of the slope: that over sum x^2 = 12.5 with the quadric, four and
  // a half times as much with the cubic.
  EXPECT_LT(std::sqrt(sum / trials), 1.5 * std::sqrt(1.0 / 3.0 / 12.5));
}

TEST(JetNormals, PlanesAreExact)
{
  const Vec3 x = glm::normalize(Vec3(3.0, -1.0, 2.0));
  const Vec3 y = glm::normalize(glm::cross(Vec3(1.0, 1.0, 5.0), x));
  const TriangleMesh mesh = gridMesh({ 12, 9, false, false },
    [&](double u, double v) { return u * x + v * y; });
  const Estimates e = estimate(mesh);
  EXPECT_LT(largestError(e.byJet, [&](const Vec3&) { return glm::cross(x, y); }), 1e-14);
  EXPECT_EQ(e.fallbacks, 0u);
}

// A cubic's third derivatives are all that there is: beside the tilt of the frame, which is small
// where the surface is, nothing is left of the error.
TEST(JetNormals, TangentPlanesOfShallowCubicsAreExact)
{
  const double depth = 1e-4;
  const TriangleMesh mesh = gridMesh({ 12, 12, false, false },
    [&](double u, double v)
    { return Vec3(u, v, depth * (u * u * u - 2.0 * u * u * v + v * v - u * v * v)); });
  const auto normal = [&](const Vec3& p)
  {
    return glm::normalize(Vec3(-depth * (3.0 * p.x * p.x - 4.0 * p.x * p.y - p.y * p.y),
      -depth * (-2.0 * p.x * p.x + 2.0 * p.y - 2.0 * p.x * p.y), 1.0));
  };
  const Estimates e = estimate(mesh);
  EXPECT_EQ(e.fallbacks, 0u);
  EXPECT_LT(largestError(e.byJet, normal), 1e-10);
  EXPECT_GT(largestError(e.byAngle, normal), 1e-6);
}

// What remains of a cubic's error is the fourth derivative times the cube of an edge; where the
// mesh is regular the vertices on both sides cancel it. Angle-weighted normals are of order 1, and
// 2 on regular meshes.
TEST(JetNormals, OrderIsThreeOnIrregularMeshes)
{
  for (const Shape& shape : { Torus, EllipsoidCap, Sphere })
  {
    EXPECT_GT(orderOf([&](int cells)
                { return meanError(estimate(shape.mesh(cells, 0.2)).byJet, shape.normal); }),
      2.9)
      << shape.name;
    EXPECT_LT(orderOf([&](int cells)
                { return meanError(estimate(shape.mesh(cells, 0.2)).byAngle, shape.normal); }),
      1.4)
      << shape.name;
    const Estimates fine = estimate(shape.mesh(192, 0.2));
    EXPECT_EQ(fine.fallbacks, 0u) << shape.name;
    EXPECT_LT(
      largestError(fine.byJet, shape.normal), 0.02 * largestError(fine.byAngle, shape.normal))
      << shape.name;
  }
}

TEST(JetNormals, OrderIsMoreThanThreeOnRegularMeshes)
{
  EXPECT_GT(orderOf([&](int cells)
              { return meanError(estimate(Torus.mesh(cells, 0.0)).byJet, Torus.normal); }),
    3.5);
}

// The rim of a cylinder of several rows of points, and one of two rows, where the angle-weighted
// normals stay. They are exact there, as the mesh is regular.
TEST(JetNormals, RimsOfCylinders)
{
  const auto cylinder = [](double height)
  {
    return [height](double u, double v)
    { return Vec3(std::cos(2.0 * Pi * u), std::sin(2.0 * Pi * u), height * v); };
  };
  const auto normal = [](const Vec3& p) { return glm::normalize(Vec3(p.x, p.y, 0.0)); };
  const Estimates high =
    estimate(gridMesh({ 96, 8, true, false }, cylinder(8.0 * 2.0 * Pi / 96.0)));
  EXPECT_LT(largestError(high.byJet, normal), 0.1 * largestError(high.byAngle, normal));
  const Estimates low = estimate(gridMesh({ 96, 1, true, false, 0.0 }, cylinder(0.1)));
  EXPECT_EQ(low.fallbacks, low.byJet.normals.size());
  EXPECT_LT(largestError(low.byJet, normal), 1e-13);
}

// A roof that is not split: where the fan of a vertex is flat it keeps its face's normal.
TEST(JetNormals, FlatFacesBesideABendStayFlat)
{
  const TriangleMesh mesh = gridMesh({ 12, 12, false, false, 0.0 },
    [](double u, double v) { return Vec3(u, v, u < 0.5 ? 0.0 : 0.3 * (u - 0.5)); });
  const Estimates e = estimate(mesh);
  for (std::size_t n = 0; n < e.byJet.normals.size(); ++n)
  {
    if (e.byJet.points[e.byJet.normalVertex[n]].x < 0.499)
    {
      EXPECT_NEAR(glm::length(e.byJet.normals[n] - Vec3(0.0, 0.0, 1.0)), 0.0, 1e-12);
    }
  }
  EXPECT_GT(e.fallbacks, 20u);
}

// Vertices are never gathered over a crease: two planes that meet at one stay planes.
TEST(JetNormals, CreasesSeparate)
{
  TriangleMesh folded =
    gridMesh({ 12, 12, false, false }, [](double u, double v) { return Vec3(u, v, 0.0); });
  for (Vec3& p : folded.points)
  {
    p = p.x <= 0.5 ? p : Vec3(0.5, p.y, 2.0 * (p.x - 0.5));
  }
  // The middle column, which was jittered, is the crease.
  for (int row = 0; row <= 12; ++row)
  {
    folded.points[static_cast<std::size_t>(row * 13 + 6)] = Vec3(0.5, row / 12.0, 0.0);
  }
  const Estimates e = estimate(folded);
  EXPECT_EQ(e.fallbacks, 0u);
  EXPECT_EQ(e.byJet.normals.size(), folded.points.size() + 13u) << "two at a crease's vertex";
  for (std::size_t t = 0; t < folded.triangles.size(); ++t)
  {
    const Vec3 flat = glm::normalize(folded.areaNormal(static_cast<Index>(t)));
    for (const Index n : e.byJet.cornerNormals[t])
    {
      EXPECT_NEAR(glm::length(e.byJet.normals[n] - flat), 0.0, 1e-12);
    }
  }
}

TEST(JetNormals, NoiseCountsLessThanWithAngleWeights)
{
  TriangleMesh mesh = Torus.mesh(60, 0.2);
  const TriangleMesh exact = mesh;
  shadowtest::Random random(17);
  for (Vec3& p : mesh.points)
  {
    p += 0.05 * 2.0 * Pi / 120.0 *
      Vec3(random.uniform(-1.7, 1.7), random.uniform(-1.7, 1.7), random.uniform(-1.7, 1.7));
  }
  auto [byAngle, byJet, fallbacks] = estimate(mesh);
  EXPECT_EQ(fallbacks, 0u);
  for (TriangleMesh* estimated : { &byAngle, &byJet })
  {
    estimated->points = exact.points; // to compare with the normals there
  }
  EXPECT_LT(meanError(byJet, Torus.normal), 0.6 * meanError(byAngle, Torus.normal));
}

// Turning all triangles turns all normals, and nothing else.
TEST(JetNormals, NormalsAreOnTheSideOfTheWinding)
{
  TriangleMesh mesh = Torus.mesh(24, 0.2);
  const Estimates outward = estimate(mesh);
  for (Triangle& t : mesh.triangles)
  {
    std::swap(t[1], t[2]);
  }
  const Estimates inward = estimate(mesh);
  EXPECT_LT(largestError(outward.byJet, Torus.normal), 0.1);
  EXPECT_LT(largestError(inward.byJet, [](const Vec3& p) { return -Torus.normal(p); }), 0.1);
}

TEST(JetNormals, SizeAndPlaceDoNotMatter)
{
  const TriangleMesh mesh = Torus.mesh(36, 0.2);
  const Estimates expected = estimate(mesh);
  struct Move
  {
    double scale;
    double shift;
    double within;
  };
  // Doubles at 1e7 times the size are off by 1e-9 of it, that is 1e-8 of an edge.
  for (const Move& move : { Move{ 1e-9, 0.0, 1e-9 }, Move{ 1e9, 0.0, 1e-9 },
         Move{ 1e-60, 0.0, 1e-9 }, Move{ 1e60, 0.0, 1e-9 }, Move{ 1.0, 1e7, 1e-6 } })
  {
    TriangleMesh moved = mesh;
    for (Vec3& p : moved.points)
    {
      p = move.scale * p + Vec3(move.shift);
    }
    const Estimates e = estimate(moved);
    ASSERT_EQ(e.byJet.normals.size(), expected.byJet.normals.size());
    EXPECT_EQ(e.fallbacks, expected.fallbacks);
    for (std::size_t n = 0; n < e.byJet.normals.size(); ++n)
    {
      EXPECT_LT(glm::length(e.byJet.normals[n] - expected.byJet.normals[n]), move.within)
        << move.scale << ", " << move.shift;
    }
  }
}

TEST(JetNormals, RangesDoNotMatter)
{
  TriangleMesh serial = estimate(Torus.mesh(30, 0.2)).byAngle;
  TriangleMesh parted = serial;
  const std::size_t kept = fitJetNormals(serial, serialLoop);
  const std::size_t keptByParts = fitJetNormals(parted,
    [](std::size_t count, std::size_t, const RangeBody& body)
    {
      for (std::size_t end = count; end > 0; end -= std::min<std::size_t>(end, 7))
      {
        body(end - std::min<std::size_t>(end, 7), end);
      }
    });
  EXPECT_EQ(kept, keptByParts);
  EXPECT_TRUE(serial.normals == parted.normals);
}

TEST(JetNormals, DegenerateNeighbourhoodsFallBack)
{
  struct Case
  {
    std::string name;
    TriangleMesh mesh;
  };
  std::vector<Case> cases;
  const auto add = [&](const std::string& name, std::vector<Vec3> points,
                     std::vector<Triangle> triangles)
  {
    TriangleMesh mesh;
    mesh.points = std::move(points);
    mesh.triangles = std::move(triangles);
    cases.push_back({ name, mesh });
  };
  add("single triangle", { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } });
  add("isolated vertices", { { 9, 9, 9 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 5, 5, 5 } },
    { { 1, 2, 3 } });
  add("zero area", { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, { { 0, 1, 2 } });
  add("equal points", { { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 } },
    { { 0, 1, 2 }, { 0, 2, 3 } });
  add("five at an edge",
    { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 1, 1, 0 } },
    { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 0, 4 }, { 0, 1, 5 }, { 1, 0, 6 } });
  add("cube", coretest::cube().points, coretest::cube().triangles);
  for (const Case& c : cases)
  {
    const Estimates e = estimate(c.mesh);
    expectUsable(c.mesh, e, c.name);
    EXPECT_EQ(e.fallbacks, e.byJet.normals.size()) << c.name;
    EXPECT_GT(e.fallbacks, 0u) << c.name;
    EXPECT_TRUE(e.byJet.normals == e.byAngle.normals) << c.name;
  }
  EXPECT_EQ(estimate(TriangleMesh{}).fallbacks, 0u);
}

TEST(JetNormals, BadMeshesGetUsableNormals)
{
  // A fan of needles, as at the pole of a sphere, with a thousand triangles at one vertex.
  TriangleMesh fan;
  fan.points.emplace_back(0.0, 0.0, 0.1);
  for (int i = 0; i < 1000; ++i)
  {
    fan.points.emplace_back(std::cos(2.0 * Pi * i / 1000), std::sin(2.0 * Pi * i / 1000), 0.0);
    fan.triangles.push_back(
      { 0, static_cast<Index>(1 + i), static_cast<Index>(1 + (i + 1) % 1000) });
  }
  expectUsable(fan, estimate(fan), "fan");

  const TriangleMesh slivers = gridMesh({ 40, 40, false, false },
    [](double u, double v) { return Vec3(u, 1e-9 * v, 0.1 * u * u); });
  expectUsable(slivers, estimate(slivers), "slivers");

  TriangleMesh torn = Torus.mesh(12, 0.2);
  for (std::size_t i = 0; i < torn.points.size(); i += 5)
  {
    torn.points[i] = torn.points[i / 2]; // vertices that are not one, at equal places
  }
  expectUsable(torn, estimate(torn), "equal places");

  TriangleMesh doubled = Torus.mesh(12, 0.2);
  const std::vector<Triangle> once = doubled.triangles;
  doubled.triangles.insert(doubled.triangles.end(), once.begin(), once.end());
  expectUsable(doubled, estimate(doubled), "non-manifold");

  shadowtest::Random random(23);
  TriangleMesh soup;
  for (int i = 0; i < 40; ++i)
  {
    soup.points.emplace_back(random.uniform(), random.uniform(), 0.2 * random.uniform());
  }
  for (int i = 0; i < 300; ++i)
  {
    const int a = random.integer(0, 39);
    const int b = random.integer(1, 39);
    const int c = random.integer(1, 38);
    const int second = (a + b) % 40;
    const int third = (a + (c < b ? c : c + 1)) % 40;
    soup.triangles.push_back(
      { static_cast<Index>(a), static_cast<Index>(second), static_cast<Index>(third) });
  }
  for (const double featureAngle : { 0.5, 3.2 })
  {
    expectUsable(soup, estimate(soup, featureAngle), "soup");
  }
}
