// Medians of repeated measurements.
#ifndef Measure_h
#define Measure_h

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <ctime>
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

/// Milliseconds that it takes to run once.
template <class Body>
double timeOf(const Body& body)
{
  const auto start = std::chrono::steady_clock::now();
  body();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  return time.count();
}

inline double medianOf(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Times of rivals that took turns, in milliseconds: [rival][round].
struct Turns
{
  std::vector<std::vector<double>> Times;
  /// What all threads took. Other load of the machine hardly changes it.
  std::vector<std::vector<double>> ProcessorTimes;

  double median(std::size_t rival) const { return medianOf(this->Times[rival]); }

  /// The medians of the ratios of each round.
  double ratio(std::size_t rival, std::size_t other, bool ofProcessorTimes) const
  {
    const auto& times = ofProcessorTimes ? this->ProcessorTimes : this->Times;
    std::vector<double> ratios;
    for (std::size_t round = 0; round < times[rival].size(); ++round)
    {
      ratios.push_back(times[rival][round] / times[other][round]);
    }
    return medianOf(ratios);
  }
};

/// Runs body(rival, round) for all rivals in turn, round by round; the first round is not counted.
template <class Body>
Turns measureInTurns(std::size_t rivals, const Body& body, int rounds = 15)
{
  Turns turns;
  turns.Times.resize(rivals);
  turns.ProcessorTimes.resize(rivals);
  for (int round = 0; round <= rounds; ++round)
  {
    for (std::size_t rival = 0; rival < rivals; ++rival)
    {
      const std::clock_t start = std::clock();
      const double time = timeOf([&] { body(rival, round); });
      const std::clock_t end = std::clock();
      if (round > 0)
      {
        turns.Times[rival].push_back(time);
        turns.ProcessorTimes[rival].push_back(
          1e3 * static_cast<double>(end - start) / CLOCKS_PER_SEC);
      }
    }
  }
  return turns;
}

/// Runs body(i) for i = 0..runs; the first run is not counted.
template <class Body>
Figure measure(const Body& body, int runs = 15)
{
  std::vector<double> times;
  for (int i = 0; i <= runs; ++i)
  {
    const double time = timeOf([&] { body(i); });
    if (i > 0)
    {
      times.push_back(time);
    }
  }
  std::sort(times.begin(), times.end());
  return { times[times.size() / 2], times.front(), times.back() };
}
}

#endif
