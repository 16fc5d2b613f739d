#include "LightCharts.h"

namespace shadow
{
Box2 LightCharts::boxIn(std::size_t chart, const Vec3* views, std::size_t corners)
{
  const glm::length_t axis = static_cast<glm::length_t>(chart / 2);
  const double sign = chart % 2 == 0 ? 1.0 : -1.0;
  Box2 box;
  std::array<std::size_t, 4> outside{}; // of each side of the chart's pyramid
  bool isBehind = false;
  for (std::size_t i = 0; i < corners; ++i)
  {
    const double w = sign * views[i][axis];
    const double u = views[i][(axis + 1) % 3];
    const double v = views[i][(axis + 2) % 3];
    outside[0] += u > w;
    outside[1] += -u > w;
    outside[2] += v > w;
    outside[3] += -v > w;
    if (w > 0.0)
    {
      box.add(std::clamp(u / w, -1.0, 1.0), std::clamp(v / w, -1.0, 1.0));
    }
    else
    {
      isBehind = true;
    }
  }
  if (std::find(outside.begin(), outside.end(), corners) != outside.end())
  {
    return Box2();
  }
  if (isBehind)
  {
    box.add(-1.0, -1.0);
    box.add(1.0, 1.0);
  }
  return box;
}
}
