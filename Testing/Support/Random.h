/**
 * @brief Random numbers that are the same with every standard library.
 *
 * The engines of <random> are fixed by the standard, its distributions are not: a seed printed by
 * one compiler's test must make the same mesh with another's.
 */
#ifndef shadowtest_Random_h
#define shadowtest_Random_h

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>

namespace shadowtest
{
/// A number that the environment asks for: SMOOTHSHADOW_TEST_SCENES is another number of random
/// scenes than the 1,000 of a usual run, SMOOTHSHADOW_TEST_SEED another first seed.
inline std::uint64_t fromEnvironment(const char* name, std::uint64_t otherwise)
{
  const char* value = std::getenv(name);
  return value ? std::strtoull(value, nullptr, 10) : otherwise;
}

class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Engine(seed * 0x9E3779B97F4A7C15ull + 0x632BE59BD9B4E019ull)
  {
  }

  /// In [low, high).
  double uniform(double low = 0.0, double high = 1.0)
  {
    return low + (high - low) * (static_cast<double>(this->Engine() >> 11) * 0x1.0p-53);
  }

  /// In {low, ..., high}, both included.
  int integer(int low, int high)
  {
    const auto range = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(this->Engine() % range);
  }

  bool chance(double probability) { return this->uniform() < probability; }

  /// Evenly spread over the unit sphere.
  void direction(double out[3])
  {
    const double z = this->uniform(-1.0, 1.0);
    const double angle = this->uniform(0.0, 6.283185307179586);
    const double radius = std::sqrt(1.0 - z * z);
    out[0] = radius * std::cos(angle);
    out[1] = radius * std::sin(angle);
    out[2] = z;
  }

private:
  std::mt19937_64 Engine;
};
}

#endif
