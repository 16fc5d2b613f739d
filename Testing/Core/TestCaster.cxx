#include "Caster.h"
#include "CoreMeshes.h"
#include "SilhouetteLoops.h"

#include <gtest/gtest.h>

#include <thread>

using namespace shadow;

namespace
{
/// A grid over the unit sphere, without its poles: it has borders, and is large enough for a tree.
TriangleMesh band(Index rings, Index segments)
{
  std::vector<Vec3> places;
  std::vector<Triangle> triangles;
  for (Index i = 0; i <= rings; ++i)
  {
    for (Index j = 0; j < segments; ++j)
    {
      const double z = -0.9 + 1.8 * i / rings;
      const double angle = 6.283185307179586 * j / segments;
      places.emplace_back(
        std::sqrt(1.0 - z * z) * std::cos(angle), std::sqrt(1.0 - z * z) * std::sin(angle), z);
      if (i < rings)
      {
        const Index here = i * segments + j;
        const Index beside = i * segments + (j + 1) % segments;
        triangles.push_back({ here, beside, beside + segments });
        triangles.push_back({ here, beside + segments, here + segments });
      }
    }
  }
  return coretest::onSphere(places, triangles);
}

struct Request
{
  Light light;
  SilhouetteKind kind;
};

std::vector<Request> requests()
{
  std::vector<Request> list;
  for (int i = 0; i < 12; ++i)
  {
    const Light light{ Vec3(std::cos(0.5 * i), std::sin(0.5 * i), 0.3), i % 2 == 0 ? 0.0 : 0.2 };
    for (const SilhouetteKind kind :
      { SilhouetteKind::Discrete, SilhouetteKind::Accurate, SilhouetteKind::Smooth })
    {
      list.push_back({ light, kind });
    }
  }
  return list;
}

void expectSame(const SilhouetteChain& first, const SilhouetteChain& second)
{
  EXPECT_GT(first.pieces.size(), 10u);
  ASSERT_EQ(first.pieces.size(), second.pieces.size());
  for (std::size_t i = 0; i < first.pieces.size(); ++i)
  {
    EXPECT_EQ(first.pieces[i].from, second.pieces[i].from);
    EXPECT_EQ(first.pieces[i].to, second.pieces[i].to);
  }
  ASSERT_EQ(first.crossings.size(), second.crossings.size());
  for (std::size_t i = 0; i < first.crossings.size(); ++i)
  {
    EXPECT_EQ(first.crossings[i].point, second.crossings[i].point);
    EXPECT_EQ(first.crossings[i].normal, second.crossings[i].normal);
  }
}
}

// Filters that read one mesh share its caster, and may run at once.
TEST(Caster, ManyThreadsGetWhatOneGets)
{
  const TriangleMesh mesh = band(30, 60);
  Caster alone(mesh, 1.0, serialLoop);
  Caster shared(mesh, 1.0, serialLoop);
  const std::vector<Request> list = requests();
  std::vector<std::shared_ptr<const SilhouetteChain>> found(list.size());
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < 4; ++t)
  {
    threads.emplace_back(
      [&, t]
      {
        for (std::size_t i = 0; i < list.size(); ++i)
        {
          const std::size_t at = (i + t * list.size() / 4) % list.size();
          const auto chain = shared.silhouette(list[at].light, list[at].kind, {}, serialLoop);
          shared.silhouette(
            list[at].light, list[at].kind, { SearchMethod::Tracking }, serialLoop);
          if (at % 4 == t)
          {
            found[at] = chain;
          }
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    ASSERT_TRUE(found[i]);
    expectSame(*alone.silhouette(list[i].light, list[i].kind, {}, serialLoop), *found[i]);
  }
}

// Automatic never takes an incomplete one, and who asks for a method gets it.
TEST(Caster, TheLastSilhouetteIsGivenToWhoAsksForIt)
{
  Caster caster(band(30, 60), 1.0, serialLoop);
  const Light light{ Vec3(1.0, 0.4, 0.3), 0.0 };
  const auto get = [&](SearchSettings settings)
  { return caster.silhouette(light, SilhouetteKind::Smooth, settings, serialLoop); };
  const auto first = get({});
  EXPECT_EQ(first, get({}));
  EXPECT_EQ(first->search.method, SearchMethod::Hierarchy);
  EXPECT_EQ(first, get({ SearchMethod::Hierarchy }));
  const auto tracked = get({ SearchMethod::Tracking });
  EXPECT_FALSE(tracked->complete);
  EXPECT_EQ(tracked, get({ SearchMethod::Tracking }));
  const auto again = get({});
  EXPECT_TRUE(again->complete);
  expectSame(*first, *again);
  const auto all = get({ SearchMethod::BruteForce });
  EXPECT_NE(all, again);
  EXPECT_EQ(all, get({}));
  EXPECT_TRUE(traceLoops(tracked->pieces, caster.mesh().points.size()).balanced);
}
