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
        LastTracked last;
        for (std::size_t i = 0; i < list.size(); ++i)
        {
          const std::size_t at = (i + t * list.size() / 4) % list.size();
          const auto chain = shared.silhouette(list[at].light, list[at].kind, {}, last, serialLoop);
          shared.silhouette(
            list[at].light, list[at].kind, { SearchMethod::Tracking }, last, serialLoop);
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
  LastTracked none;
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    ASSERT_TRUE(found[i]);
    expectSame(*alone.silhouette(list[i].light, list[i].kind, {}, none, serialLoop), *found[i]);
  }
}

// Automatic takes any that is complete, who asks for a method gets it, and what may be incomplete
// depends on what its caller found before, so nobody else gets it.
TEST(Caster, TheLastSilhouetteIsGivenToWhoAsksForIt)
{
  Caster caster(band(30, 60), 1.0, serialLoop);
  const Light light{ Vec3(1.0, 0.4, 0.3), 0.0 };
  LastTracked last;
  const auto get = [&](SearchSettings settings)
  { return caster.silhouette(light, SilhouetteKind::Smooth, settings, last, serialLoop); };
  const auto first = get({});
  EXPECT_EQ(first, get({}));
  EXPECT_EQ(first->search.method, SearchMethod::Hierarchy);
  EXPECT_EQ(first, get({ SearchMethod::Hierarchy }));
  EXPECT_FALSE(last.found[1]);
  const auto tracked = get({ SearchMethod::Tracking });
  EXPECT_FALSE(tracked->complete);
  EXPECT_TRUE(last.found[1]);
  EXPECT_TRUE(traceLoops(tracked->pieces, caster.mesh().points.size()).balanced);
  EXPECT_EQ(first, get({}));
  const auto all = get({ SearchMethod::BruteForce });
  EXPECT_NE(all, first);
  EXPECT_EQ(all, get({}));
  expectSame(*first, *all);
}

// A vertex that the bounds' ball goes through may lie outside of it by rounding.
TEST(Caster, ALightOnAVertexIsLiftedOffIt)
{
  for (int i = 1; i < 200; ++i)
  {
    TriangleMesh box = coretest::cube();
    for (Vec3& p : box.points)
    {
      p = p * Vec3(0.1 * i, 0.37 + 0.01 * i, 1.0 / i) + Vec3(0.3 * i, 0.0, 0.1);
    }
    Caster caster(box, 1.0, serialLoop);
    LastTracked none;
    const Light light{ box.points[7], 1.0 };
    const auto chain = caster.silhouette(light, SilhouetteKind::Discrete, {}, none, serialLoop);
    EXPECT_NE(chain->light.position, light.position) << i;
  }
}
