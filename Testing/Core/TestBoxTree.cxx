#include "BoxTree.h"
#include "Random.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace shadow;

namespace
{
Box randomBox(shadowtest::Random& random, double size)
{
  const Vec3 at(random.uniform(), random.uniform(), random.uniform());
  Box box;
  box.add(at);
  box.add(at + size * Vec3(random.uniform(), random.uniform(), random.uniform()));
  return box;
}

std::vector<Index> meeting(const BoxTree& tree, const std::vector<Box>& boxes, const Box& wanted)
{
  std::vector<Index> found;
  tree.search([&](const Box& box) { return box.meets(wanted); },
    [&](Index i)
    {
      if (boxes[i].meets(wanted))
      {
        found.push_back(i);
      }
      return true;
    });
  std::sort(found.begin(), found.end());
  return found;
}
}

TEST(BoxTree, FindsAllThatMeet)
{
  shadowtest::Random random(11);
  std::size_t total = 0;
  for (const std::size_t count : { 0, 1, 4, 5, 63, 1000 })
  {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < count; ++i)
    {
      boxes.push_back(randomBox(random, 0.1));
    }
    const BoxTree tree(boxes);
    for (int query = 0; query < 50; ++query)
    {
      const Box wanted = randomBox(random, 0.8);
      std::vector<Index> expected;
      for (std::size_t i = 0; i < count; ++i)
      {
        if (boxes[i].meets(wanted))
        {
          expected.push_back(static_cast<Index>(i));
        }
      }
      EXPECT_EQ(meeting(tree, boxes, wanted), expected);
      total += expected.size();
    }
  }
  EXPECT_GT(total, 500u);
}

TEST(BoxTree, LooksAtFewOfThem)
{
  shadowtest::Random random(12);
  std::vector<Box> boxes;
  for (int i = 0; i < 4096; ++i)
  {
    boxes.push_back(randomBox(random, 0.01));
  }
  const BoxTree tree(boxes);
  int looks = 0;
  const Box wanted = randomBox(random, 0.01);
  tree.search(
    [&](const Box& box)
    {
      ++looks;
      return box.meets(wanted);
    },
    [](Index) { return true; });
  EXPECT_GT(looks, 10);
  EXPECT_LT(looks, 200);
}

TEST(BoxTree, EndsWhenToldTo)
{
  const std::vector<Box> boxes(40, Box{ Vec3(0.0), Vec3(1.0) });
  int visits = 0;
  BoxTree(boxes).search([](const Box&) { return true; }, [&](Index) { return ++visits < 7; });
  EXPECT_EQ(visits, 7);
}
