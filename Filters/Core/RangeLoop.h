/// How kernels over ranges are run, and the selection of indices with it.
#pragma once

#include "Geometry.h"

#include <algorithm>
#include <functional>

namespace shadow
{
/// Calls body(begin, end) on disjoint ranges that cover [0, count), in any order and on any
/// threads. Fewer than `grain` items are not worth a thread. The caller brings it; the core starts
/// no threads itself.
using RangeBody = std::function<void(std::size_t begin, std::size_t end)>;
using RangeLoop =
  std::function<void(std::size_t count, std::size_t grain, const RangeBody& body)>;

/// Grains of kernels by what an item costs: nanoseconds, or about a microsecond.
constexpr std::size_t lightGrain = 8192;
constexpr std::size_t heavyGrain = 128;

inline void serialLoop(std::size_t count, std::size_t /*grain*/, const RangeBody& body)
{
  if (count > 0)
  {
    body(0, count);
  }
}

/// The indices below count that pass the test, ascending, whatever the number of threads.
template <class Test>
std::vector<Index> selectIndices(std::size_t count, const RangeLoop& loop, const Test& test)
{
  constexpr std::size_t blockSize = lightGrain;
  const std::size_t blocks = (count + blockSize - 1) / blockSize;
  std::vector<std::vector<Index>> found(blocks);
  loop(blocks, 1,
    [&](std::size_t firstBlock, std::size_t endBlock)
    {
      for (std::size_t block = firstBlock; block < endBlock; ++block)
      {
        const std::size_t end = std::min(count, (block + 1) * blockSize);
        for (std::size_t i = block * blockSize; i < end; ++i)
        {
          if (test(static_cast<Index>(i)))
          {
            found[block].push_back(static_cast<Index>(i));
          }
        }
      }
    });
  std::size_t total = 0;
  for (const auto& part : found)
  {
    total += part.size();
  }
  std::vector<Index> selected;
  selected.reserve(total);
  for (const auto& part : found)
  {
    selected.insert(selected.end(), part.begin(), part.end());
  }
  return selected;
}
}
