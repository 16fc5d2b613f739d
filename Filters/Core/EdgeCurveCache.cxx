#include "EdgeCurveCache.h"

namespace shadow
{
EdgeCurveCache::Entry& EdgeCurveCache::placeOf(Index edge)
{
  // The high half of a product with the golden ratio spreads neighbouring numbers.
  const std::uint32_t hash = edge * 2654435769u;
  return this->Entries[(std::uint64_t(hash) * this->Entries.size()) >> 32];
}

std::vector<EdgeCurve> EdgeCurveCache::get(const TriangleMesh& mesh, const EdgeTable& edges,
  const std::vector<Index>& wanted, const RangeLoop& loop)
{
  std::vector<EdgeCurve> curves(wanted.size());
  std::vector<std::size_t> missing;
  if (wanted.empty())
  {
    return curves;
  }
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (this->Entries.empty())
    {
      std::size_t capacity = 64;
      while (64 * capacity <= mesh.triangles.size())
      {
        capacity *= 2;
      }
      this->Entries.resize(capacity);
    }
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
      const Entry& entry = this->placeOf(wanted[i]);
      if (entry.edge == wanted[i])
      {
        curves[i] = entry.curve;
      }
      else
      {
        missing.push_back(i);
      }
    }
  }
  loop(missing.size(), heavyGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        curves[missing[i]] = makeEdgeCurve(mesh, edges, wanted[missing[i]]);
      }
    });
  const std::lock_guard<std::mutex> lock(this->Guard);
  for (const std::size_t i : missing)
  {
    this->placeOf(wanted[i]) = { wanted[i], curves[i] };
  }
  return curves;
}

std::size_t EdgeCurveCache::memory() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Entries.capacity() * sizeof(Entry);
}
}
