#include "CoreMeshes.h"
#include "EdgeTable.h"

#include <gtest/gtest.h>

using namespace shadow;

TEST(EdgeTable, CubeHasEighteenEdgesOfTwoOpposedSides)
{
  const TriangleMesh mesh = coretest::cube();
  const EdgeTable table = buildEdgeTable(mesh);
  ASSERT_EQ(table.edges.size(), 18u);
  EXPECT_EQ(table.regular, 18u);
  for (Index e = 0; e < 18; ++e)
  {
    EXPECT_LT(table.edges[e].a, table.edges[e].b);
    ASSERT_EQ(table.sideCount(e), 2u);
    const Side s0 = table.sides[table.firstSide(e)];
    const Side s1 = table.sides[table.firstSide(e) + 1];
    EXPECT_EQ(sideSign(mesh, table, e, s0), 1);
    EXPECT_EQ(sideSign(mesh, table, e, s1), -1);
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
  EXPECT_EQ(table.regular, 0u);
  EXPECT_EQ(table.sides.size(), 15u);
  EXPECT_TRUE(buildEdgeTable(TriangleMesh()).edges.empty());
}

TEST(EdgeTable, RegularEdgesComeInAnyOrderAndBeforeTheOthers)
{
  TriangleMesh mesh = coretest::cube();
  mesh.triangles.pop_back();
  EdgeTable table = buildEdgeTable(mesh);
  ASSERT_EQ(table.edges.size(), 18u);
  ASSERT_EQ(table.regular, 15u);
  std::vector<Index> order(table.regular);
  for (Index i = 0; i < order.size(); ++i)
  {
    order[i] = (4 * i + 3) % 15;
  }
  const EdgeTable before = table;
  reorderRegularEdges(table, order);
  for (Index e = 0; e < table.edges.size(); ++e)
  {
    const Index old = e < order.size() ? order[e] : e;
    EXPECT_EQ(table.edges[e].a, before.edges[old].a);
    EXPECT_EQ(table.edges[e].b, before.edges[old].b);
    ASSERT_EQ(table.sideCount(e), table.isRegular(e) ? 2u : 1u);
    for (Index i = 0; i < table.sideCount(e); ++i)
    {
      const Side side = table.sides[table.firstSide(e) + i];
      EXPECT_EQ(side, before.sides[before.firstSide(old) + i]);
      EXPECT_EQ(table.triangleEdges[side / 3][side % 3], e);
    }
  }
}
