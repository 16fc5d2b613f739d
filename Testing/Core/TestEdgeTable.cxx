#include "CoreMeshes.h"
#include "EdgeTable.h"

#include <gtest/gtest.h>

using namespace shadow;

TEST(EdgeTable, CubeHasEighteenEdgesOfTwoOpposedSides)
{
  const TriangleMesh mesh = coretest::cube();
  const EdgeTable table = buildEdgeTable(mesh);
  ASSERT_EQ(table.edges.size(), 18u);
  for (Index e = 0; e < 18; ++e)
  {
    EXPECT_LT(table.edges[e].a, table.edges[e].b);
    ASSERT_EQ(table.sideCount(e), 2u);
    const Side s0 = table.sides[table.firstSide[e]];
    const Side s1 = table.sides[table.firstSide[e] + 1];
    EXPECT_EQ(sideSign(mesh, table, e, s0), -sideSign(mesh, table, e, s1));
    EXPECT_EQ(table.triangleEdges[s0 / 3][s0 % 3], e);
  }
}

TEST(EdgeTable, AnyNumberOfSidesAndNone)
{
  TriangleMesh fin;
  fin.points.resize(7, Vec3(0.0));
  fin.triangles = { { 5, 1, 2 }, { 1, 5, 3 }, { 5, 1, 4 }, { 1, 5, 6 }, { 1, 5, 0 } };
  const EdgeTable table = buildEdgeTable(fin);
  EXPECT_EQ(table.edges.size(), 11u);
  Index widest = 0;
  for (Index e = 0; e < table.edges.size(); ++e)
  {
    widest = std::max(widest, table.sideCount(e));
  }
  EXPECT_EQ(widest, 5u);
  EXPECT_TRUE(buildEdgeTable(TriangleMesh()).edges.empty());
}
