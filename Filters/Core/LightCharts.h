/// Plane charts of what a light sees, to rule out what cannot meet.
#pragma once

#include "BoundingTree2.h"

namespace shadow
{
/// One chart where all views have a positive z, x / z and y / z; else the six faces of a cube
/// around the light, each from -1 to 1. Straight lines stay straight.
class LightCharts
{
public:
  explicit LightCharts(bool isOne)
    : IsOne(isOne)
  {
  }

  std::size_t count() const { return this->IsOne ? 1 : 6; }

  /// The place of a view in the one chart.
  static Box2 boxOf(const Vec3& view)
  {
    Box2 box;
    box.add(view.x / view.z, view.y / view.z);
    return box;
  }

  /// A box around the part that a chart of six has of a segment or triangle; empty where it has
  /// nothing of it. The whole chart where a corner is behind it.
  static Box2 boxIn(std::size_t chart, const Vec3* views, std::size_t corners);

private:
  bool IsOne;
};

inline bool isEmpty(const Box2& box)
{
  return !(box.ends[0] <= -box.ends[2]);
}
}
