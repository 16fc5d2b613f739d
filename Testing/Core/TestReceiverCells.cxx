// Triangles cut along segments: nothing is lost, no cut runs through a cell, and marks are where
// the segments are.

#include "CasterCuts.h"
#include "CellIllumination.h"
#include "CoreMeshes.h"
#include "ReceiverCells.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

using namespace shadow;

namespace
{
/// 12 triangles whose edges are known.
struct Cube
{
  TriangleMesh mesh = coretest::cube();
  EdgeTable edges = buildEdgeTable(mesh);
  ReceiverCells cells{ { &mesh, &edges } };

  Vec3 at(Index triangle, double u, double v) const
  {
    const Triangle& t = this->mesh.triangles[triangle];
    const Vec3& a = this->mesh.points[t[0]];
    return a + u * (this->mesh.points[t[1]] - a) + v * (this->mesh.points[t[2]] - a);
  }

  std::vector<Index> whole() const
  {
    std::vector<Index> whole;
    for (std::size_t i = 0; i < this->cells.count(); ++i)
    {
      if (!this->cells.isCut(static_cast<Index>(i)))
      {
        whole.push_back(static_cast<Index>(i));
      }
    }
    return whole;
  }
};

/// Length of the edges with marks.
double markedLength(const Cube& cube, std::uint8_t marks)
{
  std::set<Index> seen;
  double length = 0.0;
  for (const Index cell : cube.whole())
  {
    for (const CellSide& side : cube.cells.sides(cell))
    {
      const CellEdges& edges = cube.cells.edges();
      const EdgePart& edge = edges.edge(side.edge);
      if (edge.marks == marks && seen.insert(side.edge).second)
      {
        length += glm::distance(edges.place(edge.a), edges.place(edge.b));
      }
    }
  }
  return length;
}
}

TEST(ReceiverCells, OneCutHalvesAndMarksItsOwnPart)
{
  Cube cube;
  const Vec3 from = cube.at(3, 0.25, 0.25);
  const Vec3 to = cube.at(3, 0.25, 0.5);
  cube.cells.cut({ 3, from, to, ShadowOnLeft });
  ASSERT_EQ(cube.cells.count(), 14u);
  EXPECT_TRUE(cube.cells.isCut(3));
  EXPECT_EQ(cube.cells.triangle(cube.cells.halves(3)), 3u);
  EXPECT_EQ(cube.cells.edges().points().size(), 8u + 2u + 2u); // on the sides, and the cut's ends
  EXPECT_NEAR(markedLength(cube, ShadowOnLeft), 0.25, 1e-15);
  // The shadow's cell runs along it, the other one against it.
  for (const Index half : { cube.cells.halves(3), cube.cells.halves(3) + 1 })
  {
    for (const CellSide& side : cube.cells.sides(half))
    {
      const EdgePart& edge = cube.cells.edges().edge(side.edge);
      if (edge.marks == ShadowOnLeft)
      {
        const Vec3 along =
          cube.cells.edges().place(edge.b) - cube.cells.edges().place(edge.a);
        EXPECT_GT(glm::dot(along, to - from), 0.0);
        EXPECT_EQ(side.forward, half == cube.cells.halves(3));
      }
    }
  }
}

TEST(ReceiverCells, CutsAlongEdgesMarkThem)
{
  Cube cube;
  cube.cells.cut({ 5, cube.at(5, 0.0, 0.0), cube.at(5, 0.5, 0.0), ShadowOnLeft });
  EXPECT_EQ(cube.cells.count(), 12u);
  EXPECT_GT(markedLength(cube, ShadowOnLeft) + markedLength(cube, ShadowOnRight), 0.49);
  // Along a chord that is there, the other way around.
  cube.cells.cut({ 2, cube.at(2, 0.1, 0.1), cube.at(2, 0.1, 0.4), CasterMeets });
  cube.cells.cut({ 2, cube.at(2, 0.1, 0.7), cube.at(2, 0.1, 0.2), ShadowOnLeft });
  EXPECT_EQ(cube.cells.count(), 14u);
  const double side = glm::distance(cube.at(2, 0.0, 0.0), cube.at(2, 0.0, 1.0));
  EXPECT_NEAR(markedLength(cube, CasterMeets), 0.1 * side, 1e-15);
  EXPECT_NEAR(markedLength(cube, CasterMeets | ShadowOnRight), 0.2 * side, 1e-15);
  EXPECT_EQ(markedLength(cube, CasterMeets | ShadowOnLeft), 0.0);
}

// Where a mesh that casts on itself goes on there is neither cut nor mark; where another one is,
// there are both.
TEST(ReceiverCells, CutsByCasters)
{
  Cube cube;
  Box bounds = cube.mesh.bounds();
  Cube upper;
  for (Vec3& point : upper.mesh.points)
  {
    point = Vec3(0.25, 0.25, 0.9) + 0.5 * point;
    bounds.add(point);
  }
  const Light light{ { 0.3, 0.2, 1.0 }, 0.0 };
  const LightFrame frame(light, bounds);
  const ContourReceiver receiver{ &cube.mesh, &cube.edges };
  const ReceiverView view(receiver, frame, serialLoop);
  const auto apply = [&](const std::vector<ContourReceiver>& casters)
  {
    for (const CellCut& cut : CasterCuts(casters, { receiver }, 1e-9).cuts(view, serialLoop))
    {
      cube.cells.cut(cut);
    }
  };
  apply({ receiver });
  EXPECT_EQ(cube.cells.count(), 12u);
  EXPECT_EQ(markedLength(cube, CasterMeets), 0.0);
  apply({ receiver, { &upper.mesh, &upper.edges } });
  EXPECT_GT(cube.cells.count(), 15u);
  EXPECT_NEAR(markedLength(cube, CasterMeets), 4.0 * 0.5, 1e-14);
}

TEST(ReceiverCells, CutsOutsideDoNothing)
{
  Cube cube;
  cube.cells.cut({ 1, cube.at(1, -0.5, 0.2), cube.at(1, -0.1, 0.4), ShadowOnLeft });
  cube.cells.cut({ 1, cube.at(1, 0.7, 0.7), cube.at(1, 0.9, 0.6), ShadowOnLeft });
  cube.cells.cut({ 1, cube.at(1, 0.2, 0.2), cube.at(1, 0.2, 0.2), ShadowOnLeft });
  cube.cells.cut({ 1, cube.at(1, -0.5, 0.0), cube.at(1, 0.0, 0.0), ShadowOnLeft }); // at a corner
  EXPECT_EQ(cube.cells.count(), 12u);
  // Through the whole triangle and beyond: what is within counts.
  cube.cells.cut({ 1, cube.at(1, -1.0, 0.5), cube.at(1, 3.0, 0.5), ShadowOnLeft });
  EXPECT_EQ(cube.cells.count(), 14u);
}

TEST(ReceiverCells, RandomCuts)
{
  for (unsigned seed = 1; seed <= 200; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937_64 engine(seed);
    // On a grid there are ties of all kinds: common ends, overlaps, cuts along edges.
    const bool isGrid = seed % 2 == 0;
    const auto draw = [&]
    {
      return isGrid ? static_cast<double>(engine() % 9) / 8.0
                    : static_cast<double>(engine() >> 11) * 0x1p-53;
    };
    Cube cube;
    std::vector<CellCut> cuts;
    for (int i = 0; i < 60; ++i)
    {
      const Index triangle = static_cast<Index>(engine() % 12);
      const double u = draw();
      const double v = draw();
      const double s = draw();
      const double t = draw();
      cuts.push_back({ triangle, cube.at(triangle, u, v), cube.at(triangle, s, t), ShadowOnLeft });
      cube.cells.cut(cuts.back());
    }
    std::vector<double> areas(12, 0.0);
    std::map<Index, int> runs;
    for (const Index cell : cube.whole())
    {
      const std::vector<CellSide> sides = cube.cells.sides(cell);
      const CellEdges& edges = cube.cells.edges();
      const Index triangle = cube.cells.triangle(cell);
      const Vec3 normal = unitOrZero(cube.mesh.areaNormal(triangle));
      const double area = 0.5 * glm::dot(normal, areaNormal(sides, edges));
      EXPECT_GT(area, 0.0);
      areas[triangle] += area;
      for (std::size_t i = 0; i < sides.size(); ++i)
      {
        EXPECT_EQ(edges.edge(sides[i].edge).parts, None);
        runs[sides[i].edge] += sides[i].forward ? 1 : -1;
        const Vec3& a = edges.place(edges.start(sides[i]));
        const Vec3& b = edges.place(edges.start(sides[(i + 1) % sides.size()]));
        const Vec3& c = edges.place(edges.start(sides[(i + 2) % sides.size()]));
        EXPECT_GT(glm::dot(normal, glm::cross(b - a, c - b)), -1e-14); // convex
      }
      // No cut has a part within: clip it by all sides.
      for (const CellCut& cut : cuts)
      {
        double from = 0.0;
        double to = cut.triangle == triangle ? 1.0 : 0.0;
        for (const CellSide& side : sides)
        {
          const Vec3& a = edges.place(edges.start(side));
          const Vec3& b = edges.place(
            side.forward ? edges.edge(side.edge).b : edges.edge(side.edge).a);
          const Vec3 inward = unitOrZero(glm::cross(normal, b - a));
          const double atFrom = glm::dot(inward, cut.from - a) - 1e-12;
          const double atTo = glm::dot(inward, cut.to - a) - 1e-12;
          if (atFrom <= 0.0 && atTo <= 0.0)
          {
            to = from;
          }
          else if (atFrom <= 0.0)
          {
            from = std::max(from, atFrom / (atFrom - atTo));
          }
          else if (atTo <= 0.0)
          {
            to = std::min(to, atFrom / (atFrom - atTo));
          }
        }
        EXPECT_LE((to - from) * glm::distance(cut.from, cut.to), 1e-11);
      }
    }
    for (const double area : areas)
    {
      EXPECT_NEAR(area, 0.5, 1e-14);
    }
    // A closed mesh stays closed: each edge is run both ways.
    for (const auto& [edge, sum] : runs)
    {
      EXPECT_EQ(sum, 0);
    }
    EXPECT_GT(cube.cells.count(), 12u + 60u);
  }
}
