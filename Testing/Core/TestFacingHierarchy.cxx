#include "FacingHierarchy.h"
#include "FacingPlane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

using namespace shadow;

namespace
{
/// Pairs of neighbours among n planes that touch a sphere around `centre`, with exact fields
/// beside.
struct Sphere
{
  /// Of a spiral by the golden angle, points 21 apart are neighbours.
  static constexpr std::size_t Apart = 21;

  Sphere(std::size_t count, const Vec3& centre)
    : TheBall{ centre, 1.0 }
    , Items(count > Apart ? count - Apart : 0)
  {
    this->Order.resize(this->Items);
    std::iota(this->Order.begin(), this->Order.end(), std::size_t(0));
    for (std::size_t i = 0; i < count; ++i)
    {
      const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
      const double angle = 2.399963229728653 * static_cast<double>(i);
      const double r = std::sqrt(1.0 - z * z);
      this->Normals.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
    // What faces alike is to be side by side: by the cells of an octree.
    const auto cell = [&](std::size_t i)
    {
      unsigned code = 0;
      for (int level = 0; level < 5; ++level)
      {
        for (int k = 0; k < 3; ++k)
        {
          const double at = std::ldexp(this->Normals[i][k] + 1.0, level);
          code = 2 * code + (static_cast<unsigned>(at) & 1u);
        }
      }
      return code;
    };
    std::stable_sort(this->Order.begin(), this->Order.end(),
      [&](std::size_t l, std::size_t r) { return cell(l) < cell(r); });
  }

  std::size_t fieldOf(std::size_t item, unsigned k) const { return this->Order[item] + k * Apart; }

  FacingHierarchy tree() const
  {
    return FacingHierarchy(2, this->Items, this->TheBall, serialLoop,
      [&](std::size_t item, unsigned k)
      {
        const std::size_t i = this->fieldOf(item, k);
        return i == this->Unknown
          ? Vec4(0.0)
          : facingPlane(this->Normals[i], this->point(i), this->TheBall);
      });
  }

  FacingFound search(const FacingHierarchy& tree, const Light& light, bool useTree) const
  {
    return tree.search(
      light, useTree,
      [&](Index item, unsigned k) { return this->lit(this->fieldOf(item, k), light); }, serialLoop);
  }

  Vec3 point(std::size_t i) const { return this->TheBall.centre + this->Normals[i]; }

  bool lit(std::size_t i, const Light& light) const
  {
    return isLit(glm::dot(this->Normals[i], light.toward(this->point(i))));
  }

  /// All that is mixed, nothing else, with its signs; the number of those.
  std::size_t expectExact(const FacingFound& found, const Light& light) const
  {
    std::size_t next = 0;
    for (std::size_t i = 0; i < this->Items; ++i)
    {
      const bool first = this->lit(this->fieldOf(i, 0), light);
      const bool second = this->lit(this->fieldOf(i, 1), light);
      if (first != second)
      {
        EXPECT_LT(next, found.items.size());
        if (next >= found.items.size())
        {
          return next;
        }
        EXPECT_EQ(found.items[next], i);
        EXPECT_EQ(found.lit[next], first ? 1 : 2);
        ++next;
      }
    }
    EXPECT_EQ(next, found.items.size());
    return next;
  }

  Ball TheBall;
  std::size_t Items;
  std::size_t Unknown = std::size_t(-1); ///< the point whose plane is not known
  std::vector<Vec3> Normals;
  std::vector<std::size_t> Order; ///< the first point of each item
};

std::vector<Light> someLights(const Vec3& centre)
{
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Light> lights;
  for (const double distance : { 0.0, 0.5, 1.2, 10.0, 1e9 })
  {
    const Vec3 direction(uniform(random), uniform(random), uniform(random));
    lights.push_back({ centre + distance * direction, 1.0 });
    lights.push_back({ direction, 0.0 });
  }
  return lights;
}
}

TEST(FacingHierarchy, FindsExactlyWhatIsMixedAndLooksAtLittle)
{
  for (const Vec3& centre : { Vec3(0.0), Vec3(3e4, -1e6, 2.0) })
  {
    const Sphere sphere(50000, centre);
    const FacingHierarchy tree = sphere.tree();
    std::size_t mixed = 0;
    for (const Light& light : someLights(centre))
    {
      const FacingFound found = sphere.search(tree, light, true);
      mixed += sphere.expectExact(found, light);
      EXPECT_LE(found.tested, sphere.Items / 4);
      const FacingFound all = sphere.search(tree, light, false);
      sphere.expectExact(all, light);
      EXPECT_EQ(all.tested, sphere.Items);
    }
    EXPECT_GT(mixed, 1000u);
  }
}

TEST(FacingHierarchy, PlanesThatAreUnknownAreEvaluated)
{
  Sphere sphere(300, Vec3(0.0));
  EXPECT_EQ(facingPlane(Vec3(0.0), Vec3(0.5), sphere.TheBall), Vec4(0.0));
  std::size_t mixed = 0;
  for (sphere.Unknown = 0; sphere.Unknown < 300; ++sphere.Unknown)
  {
    const FacingHierarchy tree = sphere.tree();
    for (const Light& light : someLights(Vec3(0.0)))
    {
      mixed += sphere.expectExact(sphere.search(tree, light, true), light);
    }
  }
  EXPECT_GT(mixed, 300u);
}

TEST(FacingHierarchy, OutOfRangeIsLookedAtAltogether)
{
  const Sphere sphere(300, Vec3(0.0));
  const FacingHierarchy tree = sphere.tree();
  for (const double length : { 1e-200, 1e200 })
  {
    const Light light{ Vec3(length, 0.0, 0.0), 0.0 };
    const FacingFound found = sphere.search(tree, light, true);
    EXPECT_GT(sphere.expectExact(found, light), 0u);
    EXPECT_EQ(found.tested, sphere.Items);
  }
}

TEST(FacingHierarchy, EmptyAndSmall)
{
  for (const std::size_t count : { 0, 22, 52, 53, 54, 150, 300 })
  {
    const Sphere sphere(count, Vec3(0.0));
    const FacingHierarchy tree = sphere.tree();
    for (const Light& light : someLights(Vec3(0.0)))
    {
      const FacingFound found = sphere.search(tree, light, true);
      sphere.expectExact(found, light);
      EXPECT_LE(found.tested, sphere.Items);
    }
  }
}
