#include "SilhouetteTracking.h"

#include "SilhouetteWalk.h"

#include <algorithm>
#include <random>

namespace shadow
{
namespace
{
/// How many triangles a walk from the last silhouette may see.
constexpr std::size_t shortWalk = 16;

/// Walks on a part of the mesh: one, and more on larger parts, which can have several loops.
constexpr Index trianglesPerStart = 256;
constexpr Index mostStarts = 4;

std::size_t longWalk(const TriangleMesh& mesh)
{
  const double across = std::sqrt(static_cast<double>(mesh.triangles.size()));
  return 64 + static_cast<std::size_t>(4.0 * across);
}

/// Looks at the pieces of a silhouette; missed(triangle) is called where there is none any more.
template <class Missed>
void startFrom(const SearchedMesh& searched, const SearchResult& last, SilhouetteFollower& follower,
  const Missed& missed)
{
  for (const Index t : last.triangles)
  {
    if (!follower.startAt(t))
    {
      missed(t);
    }
  }
  for (const Index e : last.edges)
  {
    if (!follower.startOn(e))
    {
      missed(searched.edges.sides[searched.edges.firstSide(e)] / 3);
    }
  }
}

/// Items in the order in which a sample numbers them: edges, or triangles and then link edges.
std::size_t countItems(const SearchedMesh& searched, FieldKind kind)
{
  return kind == FieldKind::Face ? searched.edges.edges.size()
                                 : searched.mesh.triangles.size() + searched.linkEdges.size();
}

std::size_t sampleSize(std::size_t items, double fraction)
{
  if (!(fraction > 0.0))
  {
    return 0;
  }
  return fraction < 1.0
    ? std::min(items, static_cast<std::size_t>(fraction * static_cast<double>(items) + 0.5))
    : items;
}

/// One of each of `count` ranges, ascending, whose sizes differ by at most one. The standard fixes
/// the engine's sequence, but not those of its distributions.
std::vector<std::size_t> drawSample(std::size_t items, std::size_t count, std::uint32_t seed)
{
  std::mt19937 engine(seed);
  std::vector<std::size_t> sample(count);
  std::size_t begin = 0;
  std::size_t owed = 0; // of the division's remainder, in parts of count
  for (std::size_t& drawn : sample)
  {
    owed += items % count;
    const std::size_t size = items / count + (owed >= count ? 1 : 0);
    owed -= owed >= count ? count : 0;
    drawn = begin + ((std::uint64_t(engine()) * size) >> 32);
    begin += size;
  }
  return sample;
}
}

TrackingSeeds findTrackingSeeds(const SearchedMesh& searched, FieldKind kind)
{
  TrackingSeeds seeds;
  const std::size_t triangles = searched.mesh.triangles.size();
  std::vector<Index> size(searched.weights.parts.size(), 0);
  for (std::size_t t = 0; t < triangles; ++t)
  {
    ++size[searched.weights.part(static_cast<Index>(t))];
  }
  std::vector<Index> passed(size.size(), 0);
  for (std::size_t t = 0; t < triangles; ++t)
  {
    const Index p = searched.weights.part(static_cast<Index>(t));
    const Index starts = std::min(mostStarts, 1 + size[p] / trianglesPerStart);
    const Index spacing = (size[p] + starts - 1) / starts;
    if (passed[p]++ % spacing == 0)
    {
      seeds.starts.push_back(static_cast<Index>(t));
    }
  }
  for (std::size_t e = 0; e < searched.edges.edges.size(); ++e)
  {
    const ChainWeight sum = sumOfSides(
      searched.mesh, searched.edges, searched.weights, kind, static_cast<Index>(e));
    if (!sum.isZero())
    {
      seeds.borders.push_back(static_cast<Index>(e));
    }
  }
  return seeds;
}

TrackedResult trackSilhouette(const SearchedMesh& searched, const TrackingSeeds& seeds,
  const Light& light, FieldKind kind, const SearchResult* last)
{
  SilhouetteFollower follower(searched, light, kind);
  if (last)
  {
    std::vector<Index> missed;
    startFrom(searched, *last, follower, [&](Index t) { missed.push_back(t); });
    SilhouetteWalk walk(follower, searched, light, kind);
    for (const Index t : missed)
    {
      walk.walkFrom(t, shortWalk);
    }
  }
  for (const Index e : seeds.borders)
  {
    follower.startOn(e);
  }
  // Another walk, for which the region around the last silhouette is not closed.
  SilhouetteWalk walk(follower, searched, light, kind);
  const std::size_t budget = longWalk(searched.mesh);
  for (const Index t : seeds.starts)
  {
    walk.walkFrom(t, budget);
  }
  return { follower.result(), walk.visited() == searched.mesh.triangles.size() };
}

TrackedResult sampleSilhouette(const SearchedMesh& searched, const Light& light, FieldKind kind,
  double sampleFraction, std::uint32_t seed, const SearchResult* last, const RangeLoop& loop)
{
  const std::size_t items = countItems(searched, kind);
  const std::size_t count = sampleSize(items, sampleFraction);
  if (count == items)
  {
    return { searchAll(searched, light, kind, loop), true };
  }
  const std::vector<std::size_t> sample = drawSample(items, count, seed);
  const std::size_t triangles = searched.mesh.triangles.size();
  const LightField field(searched.mesh, light, kind);
  const auto isLit = [&](Index item) { return field.lit(item); };
  const auto isHit = [&](Index i) {
    if (kind == FieldKind::Face)
    {
      return faceMultiplicity(searched, isLit, static_cast<Index>(sample[i])) != 0;
    }
    return sample[i] < triangles
      ? isMixed(searched.mesh, isLit, static_cast<Index>(sample[i]))
      : findEdgePieces(searched, isLit, searched.linkEdges[sample[i] - triangles], [](Index) {
        }).any();
  };
  SilhouetteFollower follower(searched, light, kind);
  if (last)
  {
    startFrom(searched, *last, follower, [](Index) {});
  }
  for (const Index i : selectIndices(count, loop, isHit))
  {
    if (kind == FieldKind::Face)
    {
      follower.startOn(static_cast<Index>(sample[i]));
    }
    else if (sample[i] < triangles)
    {
      follower.startAt(static_cast<Index>(sample[i]));
    }
    else
    {
      follower.startOn(searched.linkEdges[sample[i] - triangles]);
    }
  }
  TrackedResult result{ follower.result(), false };
  result.found.tested += count;
  return result;
}
}
