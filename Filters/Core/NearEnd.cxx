#include "NearEnd.h"

#include "VolumeRims.h"

#include <algorithm>

namespace shadow
{
namespace
{
/// A smooth contour may leave the mesh's ball.
bool isOutside(const Light& light, const Caster& caster, const SilhouetteInput& silhouette)
{
  const Vec3& centre = caster.centre();
  double radius = caster.radius();
  for (const Vec3& p : silhouette.points)
  {
    radius = std::max(radius, glm::length(p - centre));
  }
  return glm::length(light.toward(centre)) > 1.001 * light.w * radius;
}
}

NearEnd makeNearEnd(const Caster& caster, const SilhouetteChain& chain,
  const SilhouetteInput& silhouette, Caps caps)
{
  NearEnd end{ caster, chain, std::nullopt, {}, {}, {}, {},
    isOutside(chain.light, caster, silhouette) };
  if (caps != Caps::None)
  {
    end.cap.emplace(caster, chain, caps == Caps::Lit ? CapSide::Lit : CapSide::Dark);
  }
  addRims(silhouette, end);
  return end;
}
}
