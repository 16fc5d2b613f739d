#include "VertexFan.h"

#include <gtest/gtest.h>

#include <set>

using namespace shadow;

namespace
{
/// Triangles around vertex 0, each with two other vertices.
struct Around
{
  explicit Around(const std::vector<std::pair<Index, Index>>& others)
  {
    Index last = 0;
    for (const auto& [i, j] : others)
    {
      this->Mesh.triangles.push_back({ 0, i, j });
      last = std::max(last, std::max(i, j));
    }
    this->Mesh.points.assign(last + 1, Vec3(0.0));
    this->Edges = buildEdgeTable(this->Mesh);
  }

  Index edge(Index b) const
  {
    Index e = 0;
    while (this->Edges.edges[e].a != 0 || this->Edges.edges[e].b != b)
    {
      ++e;
    }
    return e;
  }

  /// The far ends of the edges around vertex 0 that hang together with 0-b there.
  std::set<Index> fanOf(Index b) const
  {
    VertexFan fan(this->Mesh, this->Edges);
    std::set<Index> ends;
    const std::vector<Index>& found = fan.edgesAround(this->edge(b), 0);
    EXPECT_EQ(found[0], this->edge(b));
    for (const Index e : found)
    {
      EXPECT_EQ(this->Edges.edges[e].a, 0u);
      EXPECT_TRUE(ends.insert(this->Edges.edges[e].b).second) << "twice";
    }
    return ends;
  }

  TriangleMesh Mesh;
  EdgeTable Edges;
};
}

TEST(VertexFan, GoesAroundAClosedFan)
{
  const Around mesh({ { 1, 2 }, { 2, 3 }, { 3, 4 }, { 4, 1 } });
  for (const Index b : { 1u, 2u, 3u, 4u })
  {
    EXPECT_EQ(mesh.fanOf(b), (std::set<Index>{ 1, 2, 3, 4 }));
  }
}

TEST(VertexFan, GoesBothWaysFromInsideAnOpenFan)
{
  const Around mesh({ { 1, 2 }, { 2, 3 }, { 4, 3 }, { 4, 5 } });
  for (const Index b : { 1u, 2u, 3u, 4u, 5u })
  {
    EXPECT_EQ(mesh.fanOf(b), (std::set<Index>{ 1, 2, 3, 4, 5 }));
  }
}

TEST(VertexFan, FansThatShareOnlyTheVertexAreApart)
{
  const Around mesh({ { 1, 2 }, { 2, 3 }, { 3, 1 }, { 4, 5 }, { 6, 5 } });
  EXPECT_EQ(mesh.fanOf(2), (std::set<Index>{ 1, 2, 3 }));
  EXPECT_EQ(mesh.fanOf(6), (std::set<Index>{ 4, 5, 6 }));
}

TEST(VertexFan, FansThatBranchAreWhole)
{
  // 0-3 has three sides; 7-8 is apart.
  const Around mesh({ { 1, 2 }, { 2, 3 }, { 3, 4 }, { 3, 5 }, { 5, 6 }, { 7, 8 } });
  for (const Index b : { 1u, 2u, 3u, 4u, 5u, 6u })
  {
    EXPECT_EQ(mesh.fanOf(b), (std::set<Index>{ 1, 2, 3, 4, 5, 6 }));
  }
  EXPECT_EQ(mesh.fanOf(7), (std::set<Index>{ 7, 8 }));
}

TEST(VertexFan, TheSameTriangleTwice)
{
  const Around mesh({ { 1, 2 }, { 1, 2 } });
  EXPECT_EQ(mesh.fanOf(1), (std::set<Index>{ 1, 2 }));
  const Around thrice({ { 1, 2 }, { 1, 2 }, { 2, 1 } });
  EXPECT_EQ(thrice.fanOf(2), (std::set<Index>{ 1, 2 }));
}

TEST(IndexSet, KeepsItemsOnceAndInOrder)
{
  IndexSet set;
  EXPECT_FALSE(set.contains(0));
  std::vector<Index> expected;
  for (const Index factor : { 1u, 2654435769u, 65536u })
  {
    for (Index i = 0; i < 1000; ++i)
    {
      const Index item = i * factor;
      const bool isNew = std::find(expected.begin(), expected.end(), item) == expected.end();
      EXPECT_EQ(set.contains(item), !isNew);
      const IndexSet::Insertion inserted = set.insert(item);
      EXPECT_EQ(inserted.isNew, isNew);
      if (isNew)
      {
        expected.push_back(item);
      }
      EXPECT_EQ(set.items()[inserted.place], item);
    }
  }
  EXPECT_TRUE(set.insert(None).isNew);
  EXPECT_FALSE(set.insert(None).isNew);
  expected.push_back(None);
  EXPECT_EQ(set.items(), expected);
  set.clear();
  EXPECT_EQ(set.size(), 0u);
  EXPECT_FALSE(set.contains(1));
  EXPECT_TRUE(set.insert(1).isNew);
}
