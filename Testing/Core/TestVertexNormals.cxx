#include "CoreMeshes.h"
#include "VertexNormals.h"

#include <gtest/gtest.h>

#include <limits>

using namespace shadow;

TEST(VertexNormals, EdgesSharperThanTheFeatureAngleSplit)
{
  TriangleMesh mesh = coretest::cube();
  const EdgeTable edges = buildEdgeTable(mesh);
  estimateCornerNormals(mesh, edges, 1.0);
  EXPECT_EQ(mesh.normals.size(), 24u) << "three at each vertex";
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Vec3 flat = glm::normalize(mesh.areaNormal(static_cast<Index>(t)));
    for (const Index n : mesh.cornerNormals[t])
    {
      EXPECT_NEAR(glm::dot(flat, mesh.normals[n]), 1.0, 1e-15);
    }
  }
}

// Weighted by angle, the diagonals of the faces do not matter.
TEST(VertexNormals, SmoothCubeHasDiagonalNormals)
{
  TriangleMesh mesh = coretest::cube();
  const EdgeTable edges = buildEdgeTable(mesh);
  estimateCornerNormals(mesh, edges, 3.0);
  ASSERT_EQ(mesh.normals.size(), 8u);
  for (std::size_t n = 0; n < 8; ++n)
  {
    const Vec3 outward = glm::normalize(mesh.points[mesh.normalVertex[n]] - Vec3(0.5));
    EXPECT_NEAR(glm::dot(outward, mesh.normals[n]), 1.0, 1e-15);
  }
}

TEST(VertexNormals, UnusableOnesAreReplaced)
{
  TriangleMesh mesh = coretest::cube();
  const EdgeTable edges = buildEdgeTable(mesh);
  estimateCornerNormals(mesh, edges, 3.0);
  const std::vector<Vec3> expected = mesh.normals;
  mesh.normals[1] = Vec3(0.0);
  mesh.normals[2].x = std::numeric_limits<double>::quiet_NaN();
  mesh.normals[3] *= 7.0;
  repairNormals(mesh);
  for (std::size_t n = 0; n < 8; ++n)
  {
    EXPECT_NEAR(glm::length(mesh.normals[n] - expected[n]), 0.0, 1e-15);
  }
}
