#include "FacingHierarchy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace shadow;

namespace
{
/// Pairs of neighbours of n planes that touch a sphere around `centre`, with exact fields beside.
struct Sphere
{
  Sphere(std::size_t count, const Vec3& centre)
    : Centre(centre)
  {
    this->Items.centre = centre;
    this->Items.radius = 1.0;
    this->Items.arity = 2;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
      const double angle = 2.399963229728653 * static_cast<double>(i);
      const double r = std::sqrt(1.0 - z * z);
      this->Normals.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
      this->Items.planes.push_back(
        facingPlane(this->Normals[i], this->point(i), centre, this->Items.radius));
    }
    for (std::size_t i = 0; i + 21 < count; ++i)
    {
      // Of a spiral by the golden angle, points 21 apart are neighbours.
      this->Items.ids.push_back(static_cast<Index>(i));
      this->Items.fields.push_back(static_cast<Index>(i));
      this->Items.fields.push_back(static_cast<Index>(i + 21));
    }
  }

  Vec3 point(std::size_t i) const { return this->Centre + this->Normals[i]; }

  std::vector<Index> found(const Light& light) const
  {
    std::vector<Index> ids;
    for (const Index i : this->Items.ids)
    {
      if (this->lit(i, light) != this->lit(i + 21, light))
      {
        ids.push_back(i);
      }
    }
    return ids;
  }

  bool lit(std::size_t i, const Light& light) const
  {
    return isLit(glm::dot(this->Normals[i], light.toward(this->point(i))));
  }

  Vec3 Centre;
  FacingItems Items;
  std::vector<Vec3> Normals;
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

TEST(FacingHierarchy, MissesNothingAndLooksAtLittle)
{
  for (const Vec3& centre : { Vec3(0.0), Vec3(3e4, -1e6, 2.0) })
  {
    const Sphere sphere(50000, centre);
    const FacingHierarchy tree(sphere.Items, serialLoop);
    for (const Light& light : someLights(centre))
    {
      std::size_t tested = 0;
      const std::vector<Index> candidates = tree.candidates(light, serialLoop, tested);
      const std::vector<Index> expected = sphere.found(light);
      EXPECT_TRUE(std::is_sorted(candidates.begin(), candidates.end()));
      EXPECT_TRUE(std::includes(
        candidates.begin(), candidates.end(), expected.begin(), expected.end()));
      EXPECT_LE(candidates.size(), expected.size() + 20);
      EXPECT_LE(tested, sphere.Items.ids.size() / 8);
    }
  }
}

TEST(FacingHierarchy, PlanesThatAreNoneMayHaveEitherSign)
{
  Sphere sphere(300, Vec3(0.0));
  sphere.Items.planes[77] = facingPlane(Vec3(0.0), Vec3(0.5), Vec3(0.0), 1.0);
  EXPECT_EQ(sphere.Items.planes[77], glm::vec4(0.0f));
  const FacingHierarchy tree(sphere.Items, serialLoop);
  for (const Light& light : someLights(Vec3(0.0)))
  {
    std::size_t tested = 0;
    const std::vector<Index> candidates = tree.candidates(light, serialLoop, tested);
    EXPECT_TRUE(std::binary_search(candidates.begin(), candidates.end(), Index(77)));
    EXPECT_TRUE(std::binary_search(candidates.begin(), candidates.end(), Index(77 - 21)));
  }
}

TEST(FacingHierarchy, OutOfRangeIsLookedAtAltogether)
{
  const Sphere sphere(300, Vec3(0.0));
  const FacingHierarchy tree(sphere.Items, serialLoop);
  for (const double length : { 1e-200, 1e200 })
  {
    std::size_t tested = 0;
    EXPECT_EQ(tree.candidates({ Vec3(length, 0.0, 0.0), 0.0 }, serialLoop, tested),
      sphere.Items.ids);
    EXPECT_EQ(tested, sphere.Items.ids.size());
  }
}

TEST(FacingHierarchy, EmptyAndSmall)
{
  for (const std::size_t count : { 0, 22, 84, 85, 86, 150 })
  {
    const Sphere sphere(count, Vec3(0.0));
    const FacingHierarchy tree(sphere.Items, serialLoop);
    for (const Light& light : someLights(Vec3(0.0)))
    {
      std::size_t tested = 0;
      const std::vector<Index> candidates = tree.candidates(light, serialLoop, tested);
      const std::vector<Index> expected = sphere.found(light);
      EXPECT_TRUE(std::includes(
        candidates.begin(), candidates.end(), expected.begin(), expected.end()));
      EXPECT_LE(tested, sphere.Items.ids.size());
    }
  }
}
