/// What edges' curves take their triangles for, kept over lights.
#pragma once

#include "Geometry.h"

#include <atomic>
#include <memory>
#include <mutex>

namespace shadow
{
/// A number for each edge of a range, made when it is first asked for. Four bytes an edge, from the
/// first question on. Safe to be used from several threads: at worst some make the same number.
class AcrossCorrections
{
public:
  /// The edge's number, from make() if it is not known. `count` edges are there, always as many.
  template <class Make>
  float get(std::size_t count, Index edge, const Make& make)
  {
    std::call_once(this->Allocated, [&] { this->allocate(count); });
    std::atomic<float>& kept = this->Values[edge];
    float value = kept.load(std::memory_order_relaxed);
    if (std::isnan(value))
    {
      value = make();
      kept.store(value, std::memory_order_relaxed);
    }
    return value;
  }

  std::size_t memory() const { return this->Count.load() * sizeof(float); } ///< bytes

private:
  void allocate(std::size_t count)
  {
    this->Values = std::make_unique<std::atomic<float>[]>(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Values[i].store(std::numeric_limits<float>::quiet_NaN(), std::memory_order_relaxed);
    }
    this->Count.store(count);
  }

  std::once_flag Allocated;
  std::unique_ptr<std::atomic<float>[]> Values;
  std::atomic<std::size_t> Count{ 0 };
};
}
