/**
 * Times, and the median of a few of them, which one slow run does not spoil.
 */
#ifndef Timing_h
#define Timing_h

#include <algorithm>
#include <chrono>
#include <vector>

/// 0 for none.
inline double Median(std::vector<double> values)
{
  if (values.empty())
  {
    return 0.0;
  }
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// Milliseconds that the work takes.
template <class Work>
double Milliseconds(const Work& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
    .count();
}

#endif
