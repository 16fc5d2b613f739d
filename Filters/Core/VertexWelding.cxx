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
std::uint64_t hashOf(const Vec3& p)
{
  constexpr std::uint64_t golden = 0x9E3779B97F4A7C15ull;
  std::uint64_t h = bits(p.x) * golden;
  h = (h ^ (h >> 32) ^ bits(p.y)) * golden;
  h = (h ^ (h >> 32) ^ bits(p.z)) * golden;
  return h ^ (h >> 32);
}
}

Welding weldPoints(const std::vector<Vec3>& points)
{
  std::size_t capacity = 16;
  while (capacity < 2 * points.size())
  {
    capacity *= 2;
  }
  std::vector<Index> table(capacity, None);
  Welding welding;
  welding.target.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    // A point that is no number equals nothing, itself included, and so takes a slot of its own.
    std::size_t slot = hashOf(points[i]) & (capacity - 1);
    while (table[slot] != None && points[welding.first[table[slot]]] != points[i])
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

Welding weldNormals(
  const std::vector<Vec3>& normals, const std::vector<Index>& vertex, std::size_t vertexCount)
{
  std::vector<Index> newest(vertexCount, None); // head of each vertex's list of distinct normals
  std::vector<Index> older;
  Welding welding;
  welding.target.reserve(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    Index found = newest[vertex[i]];
    while (found != None && normals[welding.first[found]] != normals[i])
    {
      found = older[found];
    }
    if (found == None)
    {
      found = static_cast<Index>(welding.first.size());
      welding.first.push_back(static_cast<Index>(i));
      older.push_back(newest[vertex[i]]);
      newest[vertex[i]] = found;
    }
    welding.target.push_back(found);
  }
  return welding;
}
}
