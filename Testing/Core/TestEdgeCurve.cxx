#include "CoreMeshes.h"
#include "EdgeCurve.h"

#include <gtest/gtest.h>

using namespace shadow;

namespace
{
/// Two triangles of edge length about h on the unit sphere, joined at the edge 0 - 1.
TriangleMesh kite(double h)
{
  return coretest::onSphere(
    { { h, 0.1 * h, 1.0 }, { -h, -0.2 * h, 1.0 }, { 0.3 * h, 1.7 * h, 1.0 }, { 0.1 * h, -1.8 * h, 1.0 } },
    { { 0, 2, 1 }, { 0, 1, 3 } });
}

Index edgeBetween(const EdgeTable& edges, Index a, Index b)
{
  for (Index e = 0; e < edges.edges.size(); ++e)
  {
    if (edges.edges[e].a == a && edges.edges[e].b == b)
    {
      return e;
    }
  }
  return None;
}
}

TEST(EdgeCurve, MeetsPointsAndNormalsAtItsEnds)
{
  const TriangleMesh mesh = kite(0.2);
  const EdgeTable edges = buildEdgeTable(mesh);
  const EdgeCurve curve = makeEdgeCurve(mesh, edges, edgeBetween(edges, 0, 1));
  ASSERT_EQ(curve.shape, EdgeCurve::Shape::Surface);
  for (const int end : { 0, 1 })
  {
    const auto q = curve.sample(end, mesh.normals[0], mesh.normals[1]);
    EXPECT_NEAR(glm::length(q.point - mesh.points[end]), 0.0, 1e-15);
    EXPECT_NEAR(glm::dot(glm::normalize(q.normal), mesh.normals[end]), 1.0, 1e-14);
    EXPECT_NEAR(glm::dot(q.normal, curve.derivative(end)), 0.0, 1e-15);
  }
}

// Halving the mesh divides the distance from the sphere by about 16 or more.
TEST(EdgeCurve, IsOnTheSphereToFourthOrder)
{
  double last = 0.0;
  for (const double h : { 0.4, 0.2, 0.1 })
  {
    const TriangleMesh mesh = kite(h);
    const EdgeTable edges = buildEdgeTable(mesh);
    const EdgeCurve curve = makeEdgeCurve(mesh, edges, edgeBetween(edges, 0, 1));
    double error = 0.0;
    for (int i = 1; i < 20; ++i)
    {
      error = std::fmax(error, std::fabs(glm::length(curve.point(0.05 * i)) - 1.0));
    }
    EXPECT_GT(error, 0.0);
    if (last > 0.0)
    {
      EXPECT_GT(last / error, 14.0);
    }
    last = error;
  }
}

TEST(EdgeCurve, CrossingIsAZeroOfTheField)
{
  const TriangleMesh mesh = kite(0.3);
  const EdgeTable edges = buildEdgeTable(mesh);
  const EdgeCurve curve = makeEdgeCurve(mesh, edges, edgeBetween(edges, 0, 1));
  for (const Light& light :
    { Light{ Vec3(1.0, 0.2, 0.05), 0.0 }, Light{ Vec3(3.0, 1.0, 1.1), 1.0 } })
  {
    const double fa = glm::dot(mesh.normals[0], light.toward(mesh.points[0]));
    const double fb = glm::dot(mesh.normals[1], light.toward(mesh.points[1]));
    ASSERT_NE(isLit(fa), isLit(fb));
    const double s = solveCrossing(curve, mesh.normals[0], mesh.normals[1], fa, fb, light);
    const auto q = curve.sample(s, mesh.normals[0], mesh.normals[1]);
    EXPECT_NEAR(glm::dot(q.normal, light.toward(q.point)), 0.0, 1e-13);
  }
}

TEST(EdgeCurve, SidesOfACreaseShareTheCurve)
{
  TriangleMesh mesh = kite(0.2);
  // The second triangle gets normals of its own: a crease.
  for (const Index corner : { 0u, 1u })
  {
    mesh.cornerNormals[1][corner] = static_cast<Index>(mesh.normals.size());
    mesh.normals.push_back(glm::normalize(mesh.normals[corner] + Vec3(0.0, 1.0, 0.0)));
    mesh.normalVertex.push_back(corner);
  }
  const EdgeTable edges = buildEdgeTable(mesh);
  const Index e = edgeBetween(edges, 0, 1);
  EXPECT_EQ(edgeKind(mesh, edges, e), EdgeKind::Crease);
  const EdgeCurve curve = makeEdgeCurve(mesh, edges, e);
  ASSERT_EQ(curve.shape, EdgeCurve::Shape::Crease);
  for (const SideNormals& n : distinctNormals(mesh, edges, e))
  {
    EXPECT_NEAR(glm::dot(curve.derivative(0.0), mesh.normals[n.a]), 0.0, 1e-14);
    EXPECT_NEAR(glm::dot(curve.derivative(1.0), mesh.normals[n.b]), 0.0, 1e-14);
  }
  const CubicCurve arc = curve.arc(0.7, 0.2);
  EXPECT_NEAR(glm::length(arc.point(0.4) - curve.point(0.5)), 0.0, 1e-14);
}

TEST(EdgeCurve, SteepNormalsMakeItStraight)
{
  TriangleMesh mesh = kite(0.2);
  mesh.normals[0] = Vec3(0.0, 0.0, -1.0);
  const EdgeTable edges = buildEdgeTable(mesh);
  const EdgeCurve curve = makeEdgeCurve(mesh, edges, edgeBetween(edges, 0, 1));
  EXPECT_EQ(curve.shape, EdgeCurve::Shape::Straight);
  EXPECT_EQ(solveCrossing(curve, mesh.normals[0], mesh.normals[1], -1.0, 3.0, Light()), 0.25);
}
