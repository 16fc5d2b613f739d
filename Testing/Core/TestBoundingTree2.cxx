#include "BoundingTree2.h"
#include "Random.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace shadow;

namespace
{
constexpr TreeBuilder allBuilders[] = { TreeBuilder::Unsorted, TreeBuilder::ObjectMedian,
  TreeBuilder::Morton };

/// A box in double, apart from the code that is tested.
struct Square
{
  double left, right, bottom, top;

  bool meets(const Square& o) const
  {
    return this->left <= o.right && o.left <= this->right && this->bottom <= o.top &&
      o.bottom <= this->top;
  }

  Box2 box() const
  {
    Box2 made;
    made.add(this->left, this->top);
    made.add(this->right, this->bottom);
    return made;
  }
};

Square randomSquare(shadowtest::Random& random, double size)
{
  const double x = random.uniform();
  const double y = random.uniform();
  return { x, x + size * random.uniform(), y, y + size * random.uniform() };
}

/// Small whole numbers: boxes touch, are equal, or are points.
Square wholeSquare(shadowtest::Random& random)
{
  const double x = random.integer(0, 8);
  const double y = random.integer(0, 8);
  return { x, x + random.integer(0, 2), y, y + random.integer(0, 2) };
}

std::vector<Box2> boxesOf(const std::vector<Square>& squares)
{
  std::vector<Box2> boxes;
  for (const Square& square : squares)
  {
    boxes.push_back(square.box());
  }
  return boxes;
}

std::vector<Index> found(const BoundingTree2& tree, const Box2& box)
{
  std::vector<Index> items;
  TreeVisits visits;
  tree.search(box, visits,
    [&](Index item)
    {
      items.push_back(item);
      return true;
    });
  EXPECT_EQ(visits.leaves, items.size());
  std::sort(items.begin(), items.end());
  return items;
}

std::vector<Index> expected(const std::vector<Square>& squares, const Square& wanted)
{
  std::vector<Index> items;
  for (std::size_t i = 0; i < squares.size(); ++i)
  {
    if (squares[i].meets(wanted))
    {
      items.push_back(static_cast<Index>(i));
    }
  }
  return items;
}

void expectSame(const std::vector<Square>& squares, const std::vector<Square>& queries,
  std::size_t& total)
{
  for (const TreeBuilder builder : allBuilders)
  {
    const BoundingTree2 tree(boxesOf(squares), builder);
    EXPECT_EQ(tree.size(), squares.size());
    for (const Square& query : queries)
    {
      const std::vector<Index> wanted = expected(squares, query);
      EXPECT_EQ(found(tree, query.box()), wanted)
        << squares.size() << " boxes, builder " << static_cast<int>(builder);
      total += wanted.size();
    }
  }
}
}

TEST(BoundingTree2, FindsAllThatMeetAndNoOther)
{
  shadowtest::Random random(21);
  std::size_t total = 0;
  for (const int count : { 0, 1, 2, 3, 5, 7, 8, 9, 63, 64, 65, 1000 })
  {
    for (const bool whole : { false, true })
    {
      std::vector<Square> squares;
      std::vector<Square> queries;
      for (int i = 0; i < count; ++i)
      {
        squares.push_back(whole ? wholeSquare(random) : randomSquare(random, 0.1));
      }
      for (int i = 0; i < 40; ++i)
      {
        queries.push_back(whole ? wholeSquare(random) : randomSquare(random, 0.5));
      }
      expectSame(squares, queries, total);
    }
  }
  EXPECT_GT(total, 10000u);
}

TEST(BoundingTree2, TakesEqualAndEndlessBoxes)
{
  std::size_t total = 0;
  expectSame(std::vector<Square>(37, Square{ 1.0, 1.0, 2.0, 2.0 }),
    { { 0.0, 1.0, 0.0, 2.0 }, { 1.5, 2.0, 0.0, 5.0 } }, total);
  EXPECT_EQ(total, 3u * 37u);

  constexpr double endless = std::numeric_limits<double>::infinity();
  total = 0;
  expectSame({ { -endless, endless, -endless, endless }, { 3.0, 4.0, 3.0, 4.0 },
               { -endless, 0.0, 0.0, endless } },
    { { 3.5, 3.5, 3.5, 3.5 }, { -1e30, -1e30, 1e30, 1e30 }, { -endless, endless, 0.0, 0.0 } },
    total);
  EXPECT_EQ(total, 3u * (2u + 2u + 2u));
}

// Boxes that touch in double still do when they are floats.
TEST(BoundingTree2, RoundsBoxesOutward)
{
  shadowtest::Random random(22);
  int tested = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const double x = random.uniform(-3.0, 3.0) * std::pow(10.0, random.integer(-30, 30));
    Box2 left;
    left.add(x - 1.0, 0.0);
    left.add(x, 1.0);
    Box2 right;
    right.add(x, 1.0);
    right.add(x + 1.0, 2.0);
    EXPECT_TRUE(meet(left, right)) << x;
    EXPECT_EQ(found(BoundingTree2({ left }, TreeBuilder::Morton), right).size(), 1u) << x;
    EXPECT_LE(static_cast<double>(left.ends[0]), x - 1.0);
    EXPECT_GE(static_cast<double>(-left.ends[2]), x);
    ++tested;
  }
  EXPECT_EQ(tested, 2000);

  // Around zero and at the ends of what floats can say.
  for (const double x : { 0.0, 1e-50, -1e-50, 1.0, 1.0 + 1e-12, 1e300, -1e300 })
  {
    Box2 box;
    box.add(x, x);
    EXPECT_LE(static_cast<double>(box.ends[0]), x);
    EXPECT_GE(static_cast<double>(-box.ends[2]), x);
    const float nearest = static_cast<float>(x);
    EXPECT_EQ(box.ends[0],
      static_cast<double>(nearest) > x
        ? std::nextafter(nearest, -std::numeric_limits<float>::infinity())
        : nearest);
  }
}

TEST(BoundingTree2, LooksAtFewWhereItSorts)
{
  shadowtest::Random random(23);
  std::vector<Square> squares;
  for (int i = 0; i < 5000; ++i)
  {
    squares.push_back(randomSquare(random, 0.01));
  }
  const Square wanted = randomSquare(random, 0.01);
  const auto nodes = [&](TreeBuilder builder)
  {
    TreeVisits visits;
    BoundingTree2(boxesOf(squares), builder)
      .search(wanted.box(), visits, [](Index) { return true; });
    return visits.nodes;
  };
  EXPECT_LT(nodes(TreeBuilder::ObjectMedian), 200u);
  EXPECT_LT(nodes(TreeBuilder::Morton), 300u);
  EXPECT_GT(nodes(TreeBuilder::Morton), 12u);
  // In random order almost every box covers almost everything.
  EXPECT_GT(nodes(TreeBuilder::Unsorted), 2000u);
}

TEST(BoundingTree2, EndsWhenToldTo)
{
  const std::vector<Square> squares(40, Square{ 0.0, 1.0, 0.0, 1.0 });
  const BoundingTree2 tree(boxesOf(squares), TreeBuilder::Unsorted);
  TreeVisits visits;
  int calls = 0;
  tree.search(squares[0].box(), visits, [&](Index) { return ++calls < 7; });
  EXPECT_EQ(calls, 7);
  EXPECT_EQ(visits.leaves, 7u);
}

// Loops come in order, and unsorted leaves keep it: so do items that are found.
TEST(BoundingTree2, UnsortedLeavesStayInOrder)
{
  for (const std::size_t count : { 1u, 2u, 6u, 11u, 16u, 100u })
  {
    const BoundingTree2 tree(
      std::vector<Box2>(count, Square{ 0.0, 1.0, 0.0, 1.0 }.box()), TreeBuilder::Unsorted);
    TreeVisits visits;
    Index next = 0;
    tree.search(Square{ 0.0, 1.0, 0.0, 1.0 }.box(), visits,
      [&](Index item)
      {
        EXPECT_EQ(item, next);
        ++next;
        return true;
      });
    EXPECT_EQ(next, count);
    EXPECT_EQ(visits.nodes, 2 * count - 1);
  }
}
