#include "EdgeCurveCache.h"

namespace shadow
{
std::vector<EdgeCurve> EdgeCurveCache::get(const TriangleMesh& mesh, const EdgeTable& edges,
  const std::vector<Index>& wanted, const RangeLoop& loop)
{
  std::vector<EdgeCurve> curves(wanted.size());
  std::vector<std::size_t> missing;
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Place.resize(edges.edges.size(), None);
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
      const Index place = this->Place[wanted[i]];
      if (place == None)
      {
        missing.push_back(i);
      }
      else
      {
        curves[i] = this->Curves[place];
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
    if (this->Place[wanted[i]] == None)
    {
      this->Curves.push_back(curves[i]);
      this->Place[wanted[i]] = static_cast<Index>(this->Curves.size() - 1);
    }
  }
  return curves;
}

std::size_t EdgeCurveCache::memory() const
{
  const std::lock_guard<std::mutex> lock(this->Guard);
  return this->Place.capacity() * sizeof(Index) + this->Curves.capacity() * sizeof(EdgeCurve);
}
}
