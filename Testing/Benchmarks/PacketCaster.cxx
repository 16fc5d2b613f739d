#include "PacketCaster.h"

#include "Measure.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace benchmarks
{
namespace
{
using namespace shadowtest;

// The pixels of a packet.
constexpr int PacketWidth = 4;
constexpr int PacketHeight = 2;
constexpr unsigned int Lanes = PacketWidth * PacketHeight;

// Of the scene's size: how far from the surface shadow rays begin.
constexpr double LeastDistance = 1e-4;

Vec3 unproject(const RayView& view, double x, double y, double z)
{
  const double clip[4] = { 2.0 * x / view.Width - 1.0, 2.0 * y / view.Height - 1.0, z, 1.0 };
  double world[4];
  vtkMatrix4x4::MultiplyPoint(view.ClipToWorld, clip, world);
  return { world[0] / world[3], world[1] / world[3], world[2] / world[3] };
}

/// On a plane of constant depth places are linear in the pixel.
struct PlaneOfPixels
{
  Vec3 Origin;
  Vec3 Right;
  Vec3 Up;

  PlaneOfPixels(const RayView& view, double z)
    : Origin(unproject(view, 0.0, 0.0, z))
    , Right((1.0 / view.Width) * (unproject(view, view.Width, 0.0, z) - Origin))
    , Up((1.0 / view.Height) * (unproject(view, 0.0, view.Height, z) - Origin))
  {
  }

  Vec3 at(double x, double y) const { return this->Origin + x * this->Right + y * this->Up; }
};

RTCGeometry makeGeometry(RTCDevice device, vtkPolyData* mesh)
{
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const auto points = static_cast<std::size_t>(mesh->GetNumberOfPoints());
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
    geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), points));
  for (std::size_t i = 0; i < points; ++i)
  {
    double p[3];
    mesh->GetPoint(static_cast<vtkIdType>(i), p);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      vertices[3 * i + axis] = static_cast<float>(p[axis]);
    }
  }
  std::vector<unsigned int> triangles;
  const auto cell = vtkSmartPointer<vtkCellArrayIterator>::Take(mesh->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cell->GetCurrentCell(size, ids);
    for (vtkIdType i = 2; i < size; ++i)
    {
      for (const vtkIdType id : { ids[0], ids[i - 1], ids[i] })
      {
        triangles.push_back(static_cast<unsigned int>(id));
      }
    }
  }
  auto* indices = static_cast<unsigned int*>(rtcSetNewGeometryBuffer(geometry,
    RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned int), triangles.size() / 3));
  std::copy(triangles.begin(), triangles.end(), indices);
  rtcCommitGeometry(geometry);
  return geometry;
}

struct alignas(32) Packet
{
  RTCRayHit8 Rays;
  int Valid[Lanes];
};

void setRay(RTCRay8& ray, unsigned int lane, const Vec3& from, const Vec3& direction,
  double nearest, double farthest)
{
  ray.org_x[lane] = static_cast<float>(from[0]);
  ray.org_y[lane] = static_cast<float>(from[1]);
  ray.org_z[lane] = static_cast<float>(from[2]);
  ray.dir_x[lane] = static_cast<float>(direction[0]);
  ray.dir_y[lane] = static_cast<float>(direction[1]);
  ray.dir_z[lane] = static_cast<float>(direction[2]);
  ray.tnear[lane] = static_cast<float>(nearest);
  ray.tfar[lane] = static_cast<float>(farthest);
  ray.time[lane] = 0.0f;
  ray.mask[lane] = ~0u;
  ray.id[lane] = lane;
  ray.flags[lane] = 0;
}
}

class PacketCaster::Internals
{
public:
  ~Internals()
  {
    rtcReleaseScene(this->Scene);
    rtcReleaseDevice(this->Device);
  }

  RTCDevice Device = nullptr;
  RTCScene Scene = nullptr;
  double Size = 1.0;
  double BuildTime = 0.0;
};

PacketCaster::PacketCaster(const std::vector<RayObject>& objects)
  : Internal(std::make_unique<Internals>())
{
  Internals& self = *this->Internal;
  self.Device = rtcNewDevice("threads=1");
  if (!self.Device)
  {
    throw std::runtime_error("PacketCaster: Embree cannot be started");
  }
  self.Scene = rtcNewScene(self.Device);
  for (const RayObject& object : objects)
  {
    RTCGeometry geometry = makeGeometry(self.Device, object.Surface);
    rtcAttachGeometry(self.Scene, geometry);
    rtcReleaseGeometry(geometry);
  }
  self.BuildTime = timeOf([&] { rtcCommitScene(self.Scene); });
  RTCBounds bounds;
  rtcGetSceneBounds(self.Scene, &bounds);
  self.Size = std::hypot(static_cast<double>(bounds.upper_x - bounds.lower_x),
    static_cast<double>(bounds.upper_y - bounds.lower_y),
    static_cast<double>(bounds.upper_z - bounds.lower_z));
}

PacketCaster::~PacketCaster() = default;

double PacketCaster::getBuildTime() const
{
  return this->Internal->BuildTime;
}

bool PacketCaster::isNative() const
{
  return rtcGetDeviceProperty(this->Internal->Device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) !=
    0;
}

std::vector<unsigned char> PacketCaster::render(
  const RayView& view, const RayLight& light, double& primaryTime, double& shadowTime) const
{
  if (view.Width % PacketWidth != 0 || view.Height % PacketHeight != 0)
  {
    throw std::runtime_error("PacketCaster: the picture is not made of whole packets");
  }
  RTCScene scene = this->Internal->Scene;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  const PlaneOfPixels nearPlane(view, -1.0);
  const PlaneOfPixels farPlane(view, 1.0);
  std::vector<Packet> packets(
    static_cast<std::size_t>(view.Width) * static_cast<std::size_t>(view.Height) / Lanes);
  std::vector<unsigned char> mask(packets.size() * Lanes, 255);
  const auto forEachLane = [&](const auto& body) {
    std::size_t packet = 0;
    for (int y = 0; y < view.Height; y += PacketHeight)
    {
      for (int x = 0; x < view.Width; x += PacketWidth, ++packet)
      {
        for (unsigned int lane = 0; lane < Lanes; ++lane)
        {
          body(packets[packet], lane, x + static_cast<int>(lane) % PacketWidth,
            y + static_cast<int>(lane) / PacketWidth);
        }
      }
    }
  };

  primaryTime += timeOf([&] {
    forEachLane([&](Packet& packet, unsigned int lane, int x, int y) {
      const Vec3 from = nearPlane.at(x + 0.5, y + 0.5);
      setRay(packet.Rays.ray, lane, from, farPlane.at(x + 0.5, y + 0.5) - from, 0.0, 1.0);
      packet.Rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
      packet.Rays.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
      packet.Valid[lane] = -1;
    });
    for (Packet& packet : packets)
    {
      rtcIntersect8(packet.Valid, scene, &context, &packet.Rays);
    }
  });

  const double length = std::hypot(light[0], light[1], light[2]);
  shadowTime += timeOf([&] {
    forEachLane([&](Packet& packet, unsigned int lane, int, int) {
      RTCRay8& ray = packet.Rays.ray;
      packet.Valid[lane] = packet.Rays.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID ? 0 : -1;
      const auto at = [&](float from, float direction) {
        return static_cast<double>(from) + static_cast<double>(ray.tfar[lane] * direction);
      };
      const Vec3 hit{ at(ray.org_x[lane], ray.dir_x[lane]), at(ray.org_y[lane], ray.dir_y[lane]),
        at(ray.org_z[lane], ray.dir_z[lane]) };
      const Vec3 towards = Vec3{ light[0], light[1], light[2] } - light[3] * hit;
      const double distance = light[3] != 0.0 ? std::sqrt(dot(towards, towards)) : length;
      setRay(ray, lane, hit, towards, LeastDistance * this->Internal->Size / distance,
        light[3] != 0.0 ? 1.0 / light[3] : std::numeric_limits<double>::infinity());
    });
    for (Packet& packet : packets)
    {
      rtcOccluded8(packet.Valid, scene, &context, &packet.Rays.ray);
    }
  });

  forEachLane([&](const Packet& packet, unsigned int lane, int x, int y) {
    if (packet.Valid[lane] != 0 && packet.Rays.ray.tfar[lane] < 0.0f)
    {
      mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(view.Width) +
        static_cast<std::size_t>(x)] = 0;
    }
  });
  return mask;
}
}
