#include "CoreMeshes.h"
#include "PiercedTriangles.h"
#include "Random.h"
#include "Tolerances.h"

#include <gtest/gtest.h>

#include <thread>

using namespace shadow;

namespace
{
TriangleMesh soup(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
{
  TriangleMesh mesh;
  mesh.points = points;
  mesh.triangles = triangles;
  return mesh;
}

std::size_t pierced(const TriangleMesh& mesh)
{
  return findPiercedTriangles(mesh, serialLoop).count;
}

/// Another way to ask: solves for the point where the segment's line meets the plane, in the
/// plane's own coordinates. How clear the answer is goes into the margin.
bool goesThrough(
  const Vec3& from, const Vec3& to, const Vec3& a, const Vec3& b, const Vec3& c, double& margin)
{
  const Vec3 along = to - from;
  const Vec3 u = b - a;
  const Vec3 v = c - a;
  const Vec3 h = glm::cross(along, v);
  const double determinant = glm::dot(u, h);
  const Vec3 q = glm::cross(from - a, u);
  const double s = glm::dot(from - a, h) / determinant;
  const double t = glm::dot(along, q) / determinant;
  const double w = glm::dot(v, q) / determinant;
  for (const double bound : { s, t, 1.0 - s - t, w, 1.0 - w })
  {
    margin = std::min(margin, std::fabs(bound));
  }
  return s > 0.0 && t > 0.0 && s + t < 1.0 && w > 0.0 && w < 1.0;
}

bool pierceEachOther(const TriangleMesh& mesh, std::size_t i, std::size_t j, double& margin)
{
  bool found = false;
  for (const auto& [one, other] : { std::pair(i, j), std::pair(j, i) })
  {
    const Triangle& s = mesh.triangles[one];
    const Triangle& t = mesh.triangles[other];
    for (unsigned k = 0; k < 3; ++k)
    {
      found = goesThrough(mesh.points[s[k]], mesh.points[s[next(k)]], mesh.points[t[0]],
                mesh.points[t[1]], mesh.points[t[2]], margin) ||
        found;
    }
  }
  return found;
}

void loopOnThreads(std::size_t count, std::size_t, const RangeBody& body)
{
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < 4; ++t)
  {
    threads.emplace_back([&, t] { body(count * t / 4, count * (t + 1) / 4); });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}
}

TEST(PiercedTriangles, BothOfAPairCountAndThePlaceIsWhereTheyCross)
{
  const TriangleMesh mesh = soup({ { -1.0, -1.0, 0.0 }, { 1.0, -1.0, 0.0 }, { 0.0, 1.0, 0.0 },
                                   { 0.0, 0.0, -1.0 }, { 0.0, 0.0, 1.0 }, { 9.0, 0.0, 0.0 } },
    { { 0, 1, 2 }, { 3, 4, 5 } });
  const Occurrences found = findPiercedTriangles(mesh, serialLoop);
  EXPECT_EQ(found.count, 2u);
  // They have (0, 0, 0) to (0.5, 0, 0) in common.
  EXPECT_LT(glm::length(found.place - Vec3(0.25, 0.0, 0.0)), shadowtest::tolerance::SamePoint);
}

TEST(PiercedTriangles, TouchingIsNotPiercing)
{
  const std::vector<Vec3> ground{ { -1.0, -1.0, 0.0 }, { 1.0, -1.0, 0.0 }, { 0.0, 1.0, 0.0 } };
  const std::vector<std::vector<Vec3>> others{
    { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 }, { 0.5, 0.0, 1.0 } },    // stands on a corner
    { { -0.1, 0.0, 0.0 }, { 0.1, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } },   // on a side
    { { -0.1, -0.2, 0.0 }, { 0.1, -0.2, 0.0 }, { 0.0, 0.2, 0.0 } }, // lies in it
    { { 0.0, -1.0, -1.0 }, { 0.0, -1.0, 1.0 }, { 0.0, -3.0, 0.0 } } // side meets side
  };
  for (const std::vector<Vec3>& other : others)
  {
    std::vector<Vec3> points = ground;
    points.insert(points.end(), other.begin(), other.end());
    const TriangleMesh mesh = soup(points, { { 0, 1, 2 }, { 3, 4, 5 } });
    EXPECT_EQ(pierced(mesh), 0u);
    // Pushed on by a little it pierces, unless it lies in the plane.
    TriangleMesh pushed = mesh;
    for (Index v = 3; v < 6; ++v)
    {
      pushed.points[v] += Vec3(0.0, 1e-9, -1e-9);
    }
    EXPECT_EQ(pierced(pushed), other[2].z == 0.0 && other[0].z == 0.0 ? 0u : 2u);
  }
}

TEST(PiercedTriangles, NeighboursDoSoOnlyBeyondWhatTheyShare)
{
  EXPECT_EQ(pierced(coretest::cube()), 0u);
  // Both have vertex 0; the far side of the second one goes through the first.
  const TriangleMesh mesh = soup({ { 0.0, 0.0, 0.0 }, { 2.0, -1.0, 0.0 }, { 2.0, 1.0, 0.0 },
                                   { 1.0, 0.0, -1.0 }, { 1.0, 0.0, 1.0 } },
    { { 0, 1, 2 }, { 0, 3, 4 } });
  EXPECT_EQ(pierced(mesh), 2u);
  const TriangleMesh away = soup({ { 0.0, 0.0, 0.0 }, { 2.0, -1.0, 0.0 }, { 2.0, 1.0, 0.0 },
                                   { -1.0, 0.0, -1.0 }, { -1.0, 0.0, 1.0 } },
    { { 0, 1, 2 }, { 0, 3, 4 } });
  EXPECT_EQ(pierced(away), 0u);
}

// Pairs with a common vertex, each told by one of the two opposite sides, in both orders; and a
// look at all such pairs, by the other way to ask.
TEST(PiercedTriangles, FansAreJudgedByTheirOppositeSides)
{
  std::size_t total = 0;
  std::size_t apart = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    shadowtest::Random random(seed);
    const auto anywhere = [&]
    {
      const double size = random.uniform(0.1, 1.0);
      Vec3 p(0.0);
      random.direction(&p.x);
      return size * p;
    };
    TriangleMesh mesh;
    mesh.points.push_back(Vec3(0.0));
    for (Index i = 0; i < 6; ++i)
    {
      const Index first = static_cast<Index>(mesh.points.size());
      mesh.points.push_back(anywhere());
      mesh.points.push_back(anywhere());
      mesh.triangles.push_back({ first, 0, first + 1 });
      std::rotate(mesh.triangles[i].begin(), mesh.triangles[i].begin() + i % 3,
        mesh.triangles[i].end());
    }
    std::size_t expected = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      const auto oppositeGoesThrough = [&](std::size_t one, std::size_t other)
      {
        const Index first = static_cast<Index>(2 * one + 1);
        const Triangle& t = mesh.triangles[other];
        double margin = 1.0;
        return goesThrough(mesh.points[first], mesh.points[first + 1], mesh.points[t[0]],
          mesh.points[t[1]], mesh.points[t[2]], margin);
      };
      bool found = false;
      for (std::size_t j = 0; j < mesh.triangles.size(); ++j)
      {
        found = found || (i != j && (oppositeGoesThrough(i, j) || oppositeGoesThrough(j, i)));
      }
      expected += found;
      apart += !found;
    }
    EXPECT_EQ(pierced(mesh), expected);
    total += expected;
  }
  EXPECT_GT(total, 50u);
  EXPECT_GT(apart, 50u);
}

// Two walls that cross, their diagonals too: no side of a triangle goes through another's inside.
TEST(PiercedTriangles, TiesDoNotHideThem)
{
  std::vector<Vec3> points;
  for (const double y : { -1.0, 1.0 })
  {
    points.insert(points.end(),
      { { -1.0, y, 0.0 }, { 1.0, -y, 0.0 }, { 1.0, -y, 2.0 }, { -1.0, y, 2.0 } });
  }
  const TriangleMesh mesh =
    soup(points, { { 0, 1, 2 }, { 0, 2, 3 }, { 4, 5, 6 }, { 4, 6, 7 } });
  const Occurrences found = findPiercedTriangles(mesh, serialLoop);
  EXPECT_EQ(found.count, 4u);
  EXPECT_LT(glm::length(found.place - Vec3(0.0, 0.0, 0.5)), shadowtest::tolerance::SamePoint);
}

TEST(PiercedTriangles, AreThoseOfALookAtAllPairs)
{
  std::size_t total = 0;
  std::size_t apart = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    shadowtest::Random random(seed);
    TriangleMesh mesh;
    for (Index i = 0; i < 120; ++i)
    {
      const Vec3 at(random.uniform(), random.uniform(), random.uniform());
      for (int k = 0; k < 3; ++k)
      {
        mesh.points.push_back(
          at + 0.2 * Vec3(random.uniform(), random.uniform(), random.uniform()));
      }
      mesh.triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
    }
    std::size_t expected = 0;
    double margin = 1.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    {
      bool found = false;
      for (std::size_t j = 0; j < mesh.triangles.size(); ++j)
      {
        found = found || (i != j && pierceEachOther(mesh, i, j, margin));
      }
      expected += found;
      apart += !found;
    }
    ASSERT_GT(margin, shadowtest::tolerance::TooClose);
    const Occurrences found = findPiercedTriangles(mesh, serialLoop);
    EXPECT_EQ(found.count, expected);
    EXPECT_TRUE(isFinite(found.place));
    const Occurrences threaded = findPiercedTriangles(mesh, loopOnThreads);
    EXPECT_EQ(threaded.count, found.count);
    EXPECT_EQ(threaded.place, found.place);
    total += expected;
  }
  EXPECT_GT(total, 400u);
  EXPECT_GT(apart, 400u);
}
