#include "ChainWeights.h"
#include "CoreMeshes.h"
#include "VertexNormals.h"

#include <gtest/gtest.h>

using namespace shadow;

namespace
{
ChainWeights weightsOf(TriangleMesh& mesh, bool turnNormals = false)
{
  const EdgeTable edges = buildEdgeTable(mesh);
  estimateCornerNormals(mesh, edges, 1.0);
  for (Vec3& n : mesh.normals)
  {
    n = turnNormals ? -n : n;
  }
  return findChainWeights(mesh, edges);
}

ChainWeight capOf(const ChainWeights& weights, FieldKind kind, CapSide side, Index triangle)
{
  return weights.cap(kind, triangle, weights.capsOnDarkField(kind, side)[weights.part(triangle)]);
}

void expectWeight(const ChainWeight& weight, int lit, int dark)
{
  EXPECT_EQ(weight.lit, lit);
  EXPECT_EQ(weight.dark, dark);
}
}

TEST(ChainWeights, ClosedMeshesCountTheirLitSide)
{
  TriangleMesh mesh = coretest::cube();
  const ChainWeights weights = weightsOf(mesh);
  ASSERT_EQ(weights.parts.size(), 1u);
  EXPECT_TRUE(weights.parts[0].closed);
  EXPECT_TRUE(weights.parts[0].outward);
  for (const FieldKind kind : { FieldKind::Face, FieldKind::Corner })
  {
    expectWeight(weights.silhouette(kind, 3), 1, 0);
    expectWeight(capOf(weights, kind, CapSide::Lit, 3), 1, 0);
    expectWeight(capOf(weights, kind, CapSide::Dark, 3), 0, -1);
  }
}

// What the field of an inward winding calls lit is the side away from the light.
TEST(ChainWeights, InsideOutMeshesHaveTheirDarkCapOnTheFarSide)
{
  TriangleMesh mesh = coretest::cube();
  for (Triangle& t : mesh.triangles)
  {
    std::swap(t[1], t[2]);
  }
  const ChainWeights weights = weightsOf(mesh);
  EXPECT_FALSE(weights.parts[0].outward);
  expectWeight(capOf(weights, FieldKind::Face, CapSide::Dark, 0), 1, 0);
  expectWeight(capOf(weights, FieldKind::Face, CapSide::Lit, 0), 0, -1);

  TriangleMesh turned = mesh;
  const ChainWeights contradicted = weightsOf(turned, true);
  expectWeight(contradicted.silhouette(FieldKind::Corner, 0), -1, 0);
  expectWeight(capOf(contradicted, FieldKind::Corner, CapSide::Dark, 0), 0, 1);
}

TEST(ChainWeights, OpenPartsCountBothSides)
{
  TriangleMesh mesh = coretest::cube();
  const TriangleMesh second = coretest::cube();
  for (std::size_t i = 1; i < second.triangles.size(); ++i)
  {
    const Triangle& t = second.triangles[i];
    mesh.triangles.push_back({ t[0] + 8, t[1] + 8, t[2] + 8 });
  }
  mesh.points.insert(mesh.points.end(), second.points.begin(), second.points.end());
  const ChainWeights weights = weightsOf(mesh);
  ASSERT_EQ(weights.parts.size(), 2u);
  EXPECT_TRUE(weights.parts[weights.part(0)].closed);
  EXPECT_FALSE(weights.parts[weights.part(12)].closed);
  expectWeight(weights.silhouette(FieldKind::Face, 0), 1, 0);
  expectWeight(weights.silhouette(FieldKind::Face, 12), 1, -1);
  expectWeight(capOf(weights, FieldKind::Face, CapSide::Dark, 12), 1, -1);
}
