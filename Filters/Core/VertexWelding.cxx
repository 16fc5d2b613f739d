#include "VertexWelding.h"

#include <cstring>

namespace shadow
{
namespace
{
std::uint64_t bits(double value)
{
  value += 0.0; // -0 becomes 0
  std::uint64_t result;
  std::memcpy(&result, &value, sizeof(result));
  return result;
}

/// Mixes the three coordinates; the multiplier is the golden ratio in 64 bits, which spreads
/// coordinates that differ in few bits over the high half.
std::uint64_t hashOf(const Vec3& p, std::uint64_t seed)
{
  constexpr std::uint64_t golden = 0x9E3779B97F4A7C15ull;
  std::uint64_t h = (seed ^ bits(p.x)) * golden;
  h = (h ^ (h >> 32) ^ bits(p.y)) * golden;
  h = (h ^ (h >> 32) ^ bits(p.z)) * golden;
  return h ^ (h >> 32);
}

/// Welds equal items by open addressing. An item that equals nothing, itself included, as one that
/// is no number does, takes a slot of its own.
template <class Hash, class Equal>
Welding weld(std::size_t count, const Hash& hash, const Equal& equal)
{
  std::size_t capacity = 16;
  while (capacity < 2 * count)
  {
    capacity *= 2;
  }
  std::vector<Index> table(capacity, None);
  Welding welding;
  welding.target.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    std::size_t slot = hash(i) & (capacity - 1);
    while (table[slot] != None && !equal(welding.first[table[slot]], i))
    {
      slot = (slot + 1) & (capacity - 1);
    }
    if (table[slot] == None)
    {
      table[slot] = static_cast<Index>(welding.first.size());
      welding.first.push_back(static_cast<Index>(i));
    }
    welding.target.push_back(table[slot]);
  }
  return welding;
}
}

Welding weldPoints(const std::vector<Vec3>& points)
{
  return weld(
    points.size(), [&](std::size_t i) { return hashOf(points[i], 0); },
    [&](std::size_t i, std::size_t j) { return points[i] == points[j]; });
}

Welding weldNormals(const std::vector<Vec3>& normals, const std::vector<Index>& vertex)
{
  return weld(
    normals.size(), [&](std::size_t i) { return hashOf(normals[i], vertex[i] + 1); },
    [&](std::size_t i, std::size_t j)
    { return vertex[i] == vertex[j] && normals[i] == normals[j]; });
}
}
