/// How often something occurs, and where.
#pragma once

#include "Geometry.h"

namespace shadow
{
/// Counts places and keeps the least of them by x, then y, then z: whatever the order in which they
/// are added. Places that are not finite count, and are kept only while there is no other.
struct Occurrences
{
  std::size_t count = 0;
  Vec3 place{ std::numeric_limits<double>::quiet_NaN() };

  void add(const Vec3& at)
  {
    ++this->count;
    this->keepLess(at);
  }

  void add(const Occurrences& others)
  {
    this->count += others.count;
    this->keepLess(others.place);
  }

private:
  void keepLess(const Vec3& at)
  {
    const Vec3& p = this->place;
    const bool isLess = at.x != p.x ? at.x < p.x : at.y != p.y ? at.y < p.y : at.z < p.z;
    if (isFinite(at) && (isLess || !isFinite(p)))
    {
      this->place = at;
    }
  }
};
}
