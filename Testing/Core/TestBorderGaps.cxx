#include "BorderGaps.h"

#include <gtest/gtest.h>

using namespace shadow;

namespace
{
/// A sheet of cells x 1 squares over [0, 1] x [low, high], z = 0, appended to the mesh.
void addStrip(TriangleMesh& mesh, Index cells, double low, double high)
{
  const Index first = static_cast<Index>(mesh.points.size());
  for (Index i = 0; i <= cells; ++i)
  {
    mesh.points.emplace_back(double(i) / cells, low, 0.0);
    mesh.points.emplace_back(double(i) / cells, high, 0.0);
  }
  for (Index i = 0; i < cells; ++i)
  {
    const Index a = first + 2 * i;
    mesh.triangles.push_back({ a, a + 2, a + 3 });
    mesh.triangles.push_back({ a, a + 3, a + 1 });
  }
}

BorderGaps gapsOf(const TriangleMesh& mesh, double reach)
{
  return findBorderGaps(mesh, buildEdgeTable(mesh), reach, serialLoop);
}
}

TEST(BorderGaps, SeamsOpenByLittleAreFound)
{
  TriangleMesh mesh;
  addStrip(mesh, 8, 0.0, 1.0);
  addStrip(mesh, 8, 1.0 + 1e-8, 2.0);
  const BorderGaps gaps = gapsOf(mesh, 1e-6);
  EXPECT_EQ(gaps.nearSeams.count, 18u);
  EXPECT_EQ(gaps.nearSeams.place, Vec3(0.0, 1.0, 0.0));
  EXPECT_EQ(gaps.tJunctions.count, 0u);
  EXPECT_EQ(gapsOf(mesh, 1e-9).nearSeams.count, 0u);
}

// Points at the same place were left apart on purpose, or they would have been welded.
TEST(BorderGaps, OneOfNoWidthIsNone)
{
  TriangleMesh mesh;
  addStrip(mesh, 8, 0.0, 1.0);
  addStrip(mesh, 8, 1.0, 2.0);
  EXPECT_EQ(gapsOf(mesh, 1e-6).nearSeams.count, 0u);
}

// Against 8 squares stand 4: every second of the eight's vertices is inside of one of their edges.
TEST(BorderGaps, TJunctionsAreFoundWithAndWithoutAGap)
{
  for (const double gap : { 0.0, 1e-8 })
  {
    TriangleMesh mesh;
    addStrip(mesh, 8, 0.0, 1.0);
    addStrip(mesh, 4, 1.0 + gap, 2.0);
    const BorderGaps gaps = gapsOf(mesh, 1e-6);
    EXPECT_EQ(gaps.tJunctions.count, 4u);
    EXPECT_EQ(gaps.tJunctions.place, Vec3(0.125, 1.0, 0.0));
    EXPECT_EQ(gaps.nearSeams.count, gap > 0.0 ? 10u : 0u);
  }
}

// Unwelded triangles have the gaps of welded ones, at each of their vertices.
TEST(BorderGaps, TrianglesApartAreJudgedByTheirPlaces)
{
  TriangleMesh welded;
  addStrip(welded, 8, 0.0, 1.0);
  addStrip(welded, 4, 1.0 + 1e-8, 2.0);
  TriangleMesh apart;
  for (const Triangle& t : welded.triangles)
  {
    const Index first = static_cast<Index>(apart.points.size());
    for (const Index v : t)
    {
      apart.points.push_back(welded.points[v]);
    }
    apart.triangles.push_back({ first, first + 1, first + 2 });
  }
  const BorderGaps gaps = gapsOf(apart, 1e-6);
  // Three triangles meet on the seam within a strip, 1 and 2 at its ends.
  EXPECT_EQ(gapsOf(welded, 1e-6).tJunctions.count, 4u);
  EXPECT_EQ(gaps.tJunctions.count, 4u * 3u);
  EXPECT_EQ(gapsOf(welded, 1e-6).nearSeams.count, 10u);
  EXPECT_EQ(gaps.nearSeams.count, 2u * (3u * 3u + 1u + 2u));
  EXPECT_EQ(gaps.nearSeams.place, Vec3(0.0, 1.0, 0.0));
}

TEST(BorderGaps, TheFinestTriangleAtAPlaceSaysWhatIsNear)
{
  const std::vector<Vec3> fine{ { 0.0, 0.0, 0.0 }, { -1e-3, 0.0, 0.0 }, { 0.0, -1e-3, 0.0 } };
  const std::vector<Vec3> coarse{ { 0.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 }, { 0.0, -1.0, 0.0 } };
  const std::vector<Vec3> beside{ { 0.01, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 } };
  const auto nearSeams = [](const std::vector<std::vector<Vec3>>& triangles)
  {
    TriangleMesh mesh;
    for (const std::vector<Vec3>& corners : triangles)
    {
      const Index first = static_cast<Index>(mesh.points.size());
      mesh.points.insert(mesh.points.end(), corners.begin(), corners.end());
      mesh.triangles.push_back({ first, first + 1, first + 2 });
    }
    return gapsOf(mesh, 1.0).nearSeams.count;
  };
  EXPECT_EQ(nearSeams({ coarse, beside }), 2u);
  EXPECT_EQ(nearSeams({ coarse, fine, beside }), 0u);
  EXPECT_EQ(nearSeams({ fine, coarse, beside }), 0u);
}

// Neither vertices at one place nor those that many edges touch are kept or visited in pairs.
TEST(BorderGaps, FansOfTrianglesApartHaveNone)
{
  constexpr Index slices = 50000;
  TriangleMesh fan;
  for (Index i = 0; i < slices; ++i)
  {
    const double from = 1.5 * i / slices;
    const double to = 1.5 * (i + 1) / slices;
    fan.points.insert(fan.points.end(), { { 0.0, 0.0, 1.0 },
                                          { std::cos(from), std::sin(from), 0.0 },
                                          { std::cos(to), std::sin(to), 0.0 } });
    fan.triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  const BorderGaps gaps = gapsOf(fan, 1e-7);
  EXPECT_EQ(gaps.nearSeams.count, 0u);
  EXPECT_EQ(gaps.tJunctions.count, 0u);
  // A border edge through the apex alone has all of its vertices inside.
  const Index first = 3 * slices;
  fan.points.insert(
    fan.points.end(), { { 0.0, -1.0, 1.0 }, { 0.0, 1.0, 1.0 }, { 0.0, 0.0, 2.0 } });
  fan.triangles.push_back({ first, first + 1, first + 2 });
  EXPECT_EQ(gapsOf(fan, 1e-7).tJunctions.count, slices);
}

TEST(BorderGaps, FineAndThinMeshesAreNotTakenForGaps)
{
  TriangleMesh fine;
  addStrip(fine, 1000, 0.0, 1e-3);
  const BorderGaps gaps = gapsOf(fine, 1e-2);
  EXPECT_EQ(gaps.nearSeams.count, 0u);
  EXPECT_EQ(gaps.tJunctions.count, 0u);
  // A sliver's corner is as near to its own side.
  TriangleMesh sliver;
  sliver.points = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.5, 1e-9, 0.0 } };
  sliver.triangles = { { 0, 1, 2 } };
  EXPECT_EQ(gapsOf(sliver, 1e-6).tJunctions.count, 0u);
}
