#include "CoreMeshes.h"
#include "MeshDefects.h"
#include "Tolerances.h"
#include "VertexNormals.h"

#include <gtest/gtest.h>

using namespace shadow;

namespace
{
/// With normals estimated from the triangles, every one a crease's, and then changed.
template <class Change>
MeshDefects defectsOf(TriangleMesh mesh, const Change& change)
{
  const EdgeTable edges = buildEdgeTable(mesh);
  estimateCornerNormals(mesh, edges, 1.0);
  change(mesh);
  return findMeshDefects(mesh, edges, findChainWeights(mesh, edges));
}

MeshDefects defectsOf(const TriangleMesh& mesh)
{
  return defectsOf(mesh, [](TriangleMesh&) {});
}

std::size_t allOf(const MeshDefects& d)
{
  return d.borderEdges.count + d.nonManifoldEdges.count + d.inconsistentEdges.count +
    d.duplicateTriangles.count + d.flatTriangles.count + d.slivers.count +
    d.insideOutParts.count + d.turnedNormals.count + d.contraryNormals.count;
}

void turn(TriangleMesh& mesh)
{
  for (Triangle& t : mesh.triangles)
  {
    std::swap(t[1], t[2]);
  }
}
}

TEST(Occurrences, KeepTheLeastPlace)
{
  Occurrences found;
  found.add(Vec3(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(found.count, 1u);
  EXPECT_FALSE(isFinite(found.place));
  found.add(Vec3(1.0, 5.0, 5.0));
  found.add(Vec3(-std::numeric_limits<double>::infinity(), 0.0, 0.0));
  EXPECT_EQ(found.place, Vec3(1.0, 5.0, 5.0));
  found.add(Vec3(1.0, 4.0, 9.0));
  Occurrences others;
  others.add(Vec3(1.0, 4.0, 8.0));
  others.add(Vec3(2.0, 0.0, 0.0));
  found.add(others);
  EXPECT_EQ(found.count, 6u);
  EXPECT_EQ(found.place, Vec3(1.0, 4.0, 8.0));
}

TEST(MeshDefects, ACubeHasNone)
{
  const MeshDefects defects = defectsOf(coretest::cube());
  EXPECT_EQ(allOf(defects), 0u);
  EXPECT_EQ(defects.closedParts, 1u);
  EXPECT_EQ(defects.twoSidedTriangles, 0u);
}

TEST(MeshDefects, AMissingTriangleLeavesThreeBorders)
{
  TriangleMesh mesh = coretest::cube();
  mesh.triangles.erase(mesh.triangles.begin()); // (0,0,0), (0,1,0), (1,1,0)
  const MeshDefects defects = defectsOf(mesh);
  EXPECT_EQ(defects.borderEdges.count, 3u);
  EXPECT_EQ(defects.borderEdges.place, Vec3(0.0, 0.5, 0.0));
  EXPECT_EQ(defects.closedParts, 0u);
  EXPECT_EQ(defects.twoSidedTriangles, 11u);
  EXPECT_EQ(allOf(defects), 3u);
}

TEST(MeshDefects, ATriangleTurnedOverIsInconsistentOnThreeSides)
{
  TriangleMesh mesh = coretest::cube();
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  const MeshDefects defects = defectsOf(mesh);
  EXPECT_EQ(defects.inconsistentEdges.count, 3u);
  EXPECT_EQ(defects.twoSidedTriangles, 12u);
  EXPECT_EQ(allOf(defects), 3u);
}

TEST(MeshDefects, TrianglesGivenAgainInAnyOrderAreDuplicates)
{
  TriangleMesh mesh = coretest::cube();
  const Triangle t = mesh.triangles[4]; // (0,0,0), (1,0,0), (1,0,1)
  mesh.triangles.push_back({ t[1], t[2], t[0] });
  mesh.triangles.push_back({ t[1], t[0], t[2] });
  const MeshDefects defects = defectsOf(mesh);
  EXPECT_EQ(defects.duplicateTriangles.count, 2u);
  EXPECT_LT(glm::length(defects.duplicateTriangles.place - Vec3(2.0, 0.0, 1.0) / 3.0),
    shadowtest::tolerance::SamePoint);
  EXPECT_EQ(defects.nonManifoldEdges.count, 3u);
  EXPECT_EQ(defects.inconsistentEdges.count, 0u);
  EXPECT_EQ(defects.closedParts, 1u); // those given again cancel one another
}

TEST(MeshDefects, SliversAreToldFromNoArea)
{
  // On a line whose middle is rounded; far away, where steps are wider; and low or lower ones.
  const auto oneOf = [](const Vec3& a, const Vec3& b, const Vec3& c)
  {
    TriangleMesh mesh;
    mesh.points = { a, b, c };
    mesh.triangles = { { 0, 1, 2 } };
    return defectsOf(mesh);
  };
  std::size_t flat = 0;
  for (int i = 0; i < 100; ++i)
  {
    const Vec3 shift(i % 2 == 0 ? 0.0 : 1e6, 0.0, 0.0);
    const Vec3 a = shift + Vec3(0.1 * i, 0.7, -0.3);
    const Vec3 b = shift + Vec3(1.0, 1.0 / (i + 3), 0.9);
    const MeshDefects defects = oneOf(a, b, 0.5 * (a + b));
    flat += defects.flatTriangles.count;
    EXPECT_EQ(defects.slivers.count, 0u);
  }
  EXPECT_EQ(flat, 100u);
  for (const double height : { 1.0 / 1001.0, 1e-12 })
  {
    const MeshDefects defects = oneOf({ 0, 0, 0 }, { 1, 0, 0 }, { 0.3, height, 0 });
    EXPECT_EQ(defects.slivers.count, 1u);
    EXPECT_EQ(defects.flatTriangles.count, 0u);
  }
  const MeshDefects defects = oneOf({ 0, 0, 0 }, { 1, 0, 0 }, { 0.3, 1.0 / 999.0, 0 });
  EXPECT_EQ(defects.slivers.count, 0u);
  EXPECT_EQ(defects.flatTriangles.count, 0u);
}

// Areas of triangles, and squares of these, leave the range of doubles long before lengths do.
TEST(MeshDefects, ShapesAreToldAtAllSizes)
{
  for (const double size : { 1e-290, 1e-170, 1e-80, 1.0, 1e80, 1e155, 1e290 })
  {
    SCOPED_TRACE(size);
    for (const double height : { 0.5, 1.0 / 1001.0, 0.0 })
    {
      TriangleMesh mesh;
      mesh.points = { { 0.0, 0.0, 0.0 }, { size, 0.0, 0.0 }, { 0.3 * size, height * size, 0.0 } };
      mesh.triangles = { { 0, 1, 2 } };
      const MeshDefects defects = defectsOf(mesh);
      EXPECT_EQ(defects.flatTriangles.count, height == 0.0 ? 1u : 0u);
      EXPECT_EQ(defects.slivers.count, height == 1.0 / 1001.0 ? 1u : 0u);
    }
  }
}

TEST(MeshDefects, PartsAreCountedByWhatTheyAre)
{
  TriangleMesh mesh = coretest::cube();
  TriangleMesh inside = coretest::cube();
  turn(inside);
  for (const Triangle& t : inside.triangles)
  {
    mesh.triangles.push_back({ t[0] + 8, t[1] + 8, t[2] + 8 });
  }
  for (const Vec3& p : inside.points)
  {
    mesh.points.push_back(p + Vec3(3.0, 0.0, 0.0));
  }
  mesh.triangles.push_back({ 0, 8, 15 }); // along no edge of either
  const MeshDefects defects = defectsOf(mesh);
  EXPECT_EQ(defects.insideOutParts.count, 1u);
  EXPECT_NEAR(defects.insideOutParts.place.x, 3.0, shadowtest::tolerance::SamePoint);
  EXPECT_EQ(defects.closedParts, 2u);
  EXPECT_EQ(defects.twoSidedTriangles, 1u);
}

TEST(MeshDefects, NormalsAgainstTheWindingAreTurnedOrContrary)
{
  const auto turnFirst = [](std::size_t count)
  {
    // Each corner its own normal.
    return [count](TriangleMesh& mesh)
    {
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      {
        for (unsigned k = 0; k < 3; ++k)
        {
          const Vec3 normal = glm::normalize(mesh.areaNormal(static_cast<Index>(t)));
          mesh.normalVertex.push_back(mesh.triangles[t][k]);
          mesh.normals.push_back(t < count ? -normal : normal);
          mesh.cornerNormals[t][k] = static_cast<Index>(mesh.normals.size() - 1);
        }
      }
    };
  };
  const MeshDefects few = defectsOf(coretest::cube(), turnFirst(3));
  EXPECT_EQ(few.contraryNormals.count, 3u);
  EXPECT_EQ(few.turnedNormals.count, 0u);
  const MeshDefects most = defectsOf(coretest::cube(), turnFirst(10));
  EXPECT_EQ(most.contraryNormals.count, 2u);
  EXPECT_EQ(most.turnedNormals.count, 12u);
  TriangleMesh open = coretest::cube();
  open.triangles.pop_back();
  const MeshDefects each = defectsOf(open, turnFirst(5));
  EXPECT_EQ(each.contraryNormals.count, 0u);
  EXPECT_EQ(each.turnedNormals.count, 5u);
}
