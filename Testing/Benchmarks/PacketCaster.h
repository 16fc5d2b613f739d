// Shadows by ray casting as fast as Embree has it on one thread: packets of 8 rays, coherent.
#ifndef PacketCaster_h
#define PacketCaster_h

#include "RayCast.h"

#include <memory>
#include <vector>

namespace benchmarks
{
/// Triangles without matrices. Everything is computed in single precision, and the shadow rays
/// begin a little off the surface: a rival in speed, no oracle.
class PacketCaster
{
public:
  explicit PacketCaster(const std::vector<shadowtest::RayObject>& objects);
  ~PacketCaster();
  PacketCaster(const PacketCaster&) = delete;
  PacketCaster& operator=(const PacketCaster&) = delete;

  /// Of the hierarchy of boxes, in milliseconds.
  double getBuildTime() const;

  /// Whether Embree takes the 8 rays at once.
  bool isNative() const;

  /// A picture: for each pixel 255, or 0 where something is hit that is in shadow. The milliseconds
  /// that the rays from the eye and those to the light took are added up.
  std::vector<unsigned char> render(const shadowtest::RayView& view,
    const shadowtest::RayLight& light, double& primaryTime, double& shadowTime) const;

private:
  class Internals;
  std::unique_ptr<Internals> Internal;
};
}

#endif
