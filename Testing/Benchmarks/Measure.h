// Medians of repeated measurements.
#ifndef Measure_h
#define Measure_h

#include <algorithm>
#include <chrono>
#include <vector>

namespace benchmarks
{
/// Median and spread of a measurement's runs, in milliseconds.
struct Figure
{
  double median;
  double least;
  double most;
};

/// Runs body(i) for i = 0..runs; the first run is not counted.
template <class Body>
Figure measure(const Body& body, int runs = 15)
{
  std::vector<double> times;
  for (int i = 0; i <= runs; ++i)
  {
    const auto start = std::chrono::steady_clock::now();
    body(i);
    const std::chrono::duration<double, std::milli> time =
      std::chrono::steady_clock::now() - start;
    if (i > 0)
    {
      times.push_back(time.count());
    }
  }
  std::sort(times.begin(), times.end());
  return { times[times.size() / 2], times.front(), times.back() };
}
}

#endif
