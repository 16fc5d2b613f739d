#include "RayCast.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace shadowtest
{
namespace
{
// In a scene of half diagonal 1: some roundings of a float coordinate. Embree's own test is off by
// as much, so the test in double must not be stricter, or rays slip through between two triangles.
constexpr double EdgeSlack = 4e-7;

// Least distance along a shadow ray. Hits are computed in double, so this is far above rounding and
// far below anything that is seen.
constexpr double LeastDistance = 1e-9;

struct SceneTriangle
{
  Vec3 Corners[3];
  vtkIdType Cell;
};

struct SceneObject
{
  std::vector<SceneTriangle> Triangles;
  bool Casts;
  bool Receives;
};

struct Ray
{
  Vec3 Origin;
  Vec3 Direction; // unit
};

// Embree hands the address of the first member back to the filter.
struct ShadowContext
{
  RTCIntersectContext Base;
  const std::vector<SceneObject>* Objects;
  Ray TheRay;
  double Length;
  int FromObject;
  std::size_t FromTriangle;
};

double planeDistance(const SceneTriangle& triangle, const Ray& ray)
{
  const Vec3 normal =
    cross(triangle.Corners[1] - triangle.Corners[0], triangle.Corners[2] - triangle.Corners[0]);
  return dot(normal, triangle.Corners[0] - ray.Origin) / dot(normal, ray.Direction);
}

bool passesEdgesInside(const SceneTriangle& triangle, const Ray& ray)
{
  double volumes[3];
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const Vec3 a = triangle.Corners[i] - ray.Origin;
    const Vec3 b = triangle.Corners[(i + 1) % 3] - ray.Origin;
    volumes[i] = dot(ray.Direction, cross(a, b));
    sum += volumes[i];
  }
  for (int i = 0; i < 3; ++i)
  {
    if (volumes[i] * sum < 0.0)
    {
      const Vec3 edge = triangle.Corners[(i + 1) % 3] - triangle.Corners[i];
      const Vec3 common = cross(ray.Direction, edge);
      if (std::abs(volumes[i]) > EdgeSlack * std::sqrt(dot(common, common)))
      {
        return false;
      }
    }
  }
  return true;
}

void keepBlockers(const RTCFilterFunctionNArguments* args)
{
  const auto* context = reinterpret_cast<const ShadowContext*>(args->context);
  for (unsigned int i = 0; i < args->N; ++i)
  {
    if (args->valid[i] != -1)
    {
      continue;
    }
    const auto object = static_cast<int>(RTCHitN_geomID(args->hit, args->N, i));
    const std::size_t number = RTCHitN_primID(args->hit, args->N, i);
    const SceneObject& hit = (*context->Objects)[static_cast<std::size_t>(object)];
    const SceneTriangle& triangle = hit.Triangles[number];
    const double distance = planeDistance(triangle, context->TheRay);
    const bool itself = object == context->FromObject && number == context->FromTriangle;
    if (!hit.Casts || itself || !(distance > LeastDistance && distance < context->Length) ||
      !passesEdgesInside(triangle, context->TheRay))
    {
      args->valid[i] = 0;
    }
  }
}

RTCRay embreeRay(const Ray& ray, double length)
{
  RTCRay result{};
  result.org_x = static_cast<float>(ray.Origin[0]);
  result.org_y = static_cast<float>(ray.Origin[1]);
  result.org_z = static_cast<float>(ray.Origin[2]);
  result.dir_x = static_cast<float>(ray.Direction[0]);
  result.dir_y = static_cast<float>(ray.Direction[1]);
  result.dir_z = static_cast<float>(ray.Direction[2]);
  result.tnear = 0.0f;
  result.tfar = std::isfinite(length) ? static_cast<float>(length * (1.0 + 1e-5))
                                      : std::numeric_limits<float>::infinity();
  result.mask = ~0u;
  return result;
}

Vec3 unproject(const RayView& view, double x, double y, double z)
{
  const double clip[4] = { x, y, z, 1.0 };
  double world[4];
  vtkMatrix4x4::MultiplyPoint(view.ClipToWorld, clip, world);
  return { world[0] / world[3], world[1] / world[3], world[2] / world[3] };
}
}

RayView RayView::fromCamera(vtkCamera* camera, int width, int height)
{
  RayView view;
  view.Width = width;
  view.Height = height;
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(camera->GetCompositeProjectionTransformMatrix(
    static_cast<double>(width) / static_cast<double>(height), -1.0, 1.0));
  matrix->Invert();
  vtkMatrix4x4::DeepCopy(view.ClipToWorld, matrix);
  return view;
}

vtkSmartPointer<vtkImageData> RayPicture::mask() const
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(this->Width, this->Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  for (const RaySample& sample : this->Samples)
  {
    *out++ = sample.Light == Visibility::Lit || sample.Light == Visibility::Background ? 255 : 0;
  }
  return image;
}

class RayScene::Internals
{
public:
  ~Internals()
  {
    rtcReleaseScene(this->Scene);
    rtcReleaseDevice(this->Device);
  }

  Vec3 toLocal(const Vec3& world) const { return this->Scale * (world - this->Centre); }
  Vec3 toWorld(const Vec3& local) const { return (1.0 / this->Scale) * local + this->Centre; }

  void load(const std::vector<RayObject>& objects);
  void normalize();
  void build();
  bool blocked(const Vec3& point, int object, std::size_t triangle, const RayLight& light) const;

  std::vector<SceneObject> Objects;
  Vec3 Centre{ 0.0, 0.0, 0.0 };
  double Scale = 1.0;
  RTCDevice Device = nullptr;
  RTCScene Scene = nullptr;
};

void RayScene::Internals::load(const std::vector<RayObject>& objects)
{
  for (const RayObject& object : objects)
  {
    SceneObject loaded{ {}, object.Casts, object.Receives };
    MeshBuilder mesh;
    mesh.append(object.Surface);
    if (object.Matrix)
    {
      for (Vec3& p : mesh.Points)
      {
        const double in[4] = { p[0], p[1], p[2], 1.0 };
        double out[4];
        object.Matrix->MultiplyPoint(in, out);
        p = { out[0] / out[3], out[1] / out[3], out[2] / out[3] };
      }
    }
    for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
    {
      const auto& ids = mesh.Cells[cell];
      for (std::size_t i = 2; i < ids.size(); ++i)
      {
        SceneTriangle triangle{ { mesh.Points[static_cast<std::size_t>(ids[0])],
                                  mesh.Points[static_cast<std::size_t>(ids[i - 1])],
                                  mesh.Points[static_cast<std::size_t>(ids[i])] },
          static_cast<vtkIdType>(cell) };
        const Vec3 sum = triangle.Corners[0] + triangle.Corners[1] + triangle.Corners[2];
        if (std::isfinite(sum[0] + sum[1] + sum[2]))
        {
          loaded.Triangles.push_back(triangle);
        }
      }
    }
    this->Objects.push_back(std::move(loaded));
  }
}

void RayScene::Internals::normalize()
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  Vec3 low{ Infinity, Infinity, Infinity };
  Vec3 high{ -Infinity, -Infinity, -Infinity };
  for (const SceneObject& object : this->Objects)
  {
    for (const SceneTriangle& triangle : object.Triangles)
    {
      for (const Vec3& corner : triangle.Corners)
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          low[axis] = std::min(low[axis], corner[axis]);
          high[axis] = std::max(high[axis], corner[axis]);
        }
      }
    }
  }
  if (!(low[0] <= high[0]))
  {
    return;
  }
  const Vec3 half = 0.5 * (high - low);
  const double radius = std::sqrt(dot(half, half));
  this->Centre = low + half;
  this->Scale = radius > 0.0 ? 1.0 / radius : 1.0;
  for (SceneObject& object : this->Objects)
  {
    for (SceneTriangle& triangle : object.Triangles)
    {
      for (Vec3& corner : triangle.Corners)
      {
        corner = this->toLocal(corner);
      }
    }
  }
}

void RayScene::Internals::build()
{
  this->Device = rtcNewDevice(nullptr);
  if (!this->Device)
  {
    throw std::runtime_error("RayScene: Embree cannot be started");
  }
  this->Scene = rtcNewScene(this->Device);
  rtcSetSceneFlags(this->Scene,
    static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
  for (std::size_t i = 0; i < this->Objects.size(); ++i)
  {
    const auto& triangles = this->Objects[i].Triangles;
    if (triangles.empty())
    {
      continue;
    }
    RTCGeometry geometry = rtcNewGeometry(this->Device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX,
      0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * triangles.size()));
    auto* indices = static_cast<unsigned int*>(rtcSetNewGeometryBuffer(geometry,
      RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned int), triangles.size()));
    unsigned int next = 0;
    for (const SceneTriangle& triangle : triangles)
    {
      for (const Vec3& corner : triangle.Corners)
      {
        for (double coordinate : corner)
        {
          *vertices++ = static_cast<float>(coordinate);
        }
        *indices++ = next++;
      }
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(this->Scene, geometry, static_cast<unsigned int>(i));
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(this->Scene);
}

bool RayScene::Internals::blocked(
  const Vec3& point, int object, std::size_t triangle, const RayLight& light) const
{
  Vec3 towards{ light[0], light[1], light[2] };
  double length = std::numeric_limits<double>::infinity();
  if (light[3] != 0.0)
  {
    towards = this->toLocal((1.0 / light[3]) * towards) - point;
    length = std::sqrt(dot(towards, towards));
  }
  ShadowContext context{};
  rtcInitIntersectContext(&context.Base);
  context.Base.filter = keepBlockers;
  context.Objects = &this->Objects;
  context.TheRay = { point, normalized(towards) };
  context.Length = length;
  context.FromObject = object;
  context.FromTriangle = triangle;
  RTCRay ray = embreeRay(context.TheRay, length);
  rtcOccluded1(this->Scene, &context.Base, &ray);
  return ray.tfar < 0.0f;
}

RayScene::RayScene(const std::vector<RayObject>& objects)
  : Internal(std::make_unique<Internals>())
{
  this->Internal->load(objects);
  this->Internal->normalize();
  this->Internal->build();
}

RayScene::~RayScene() = default;

int RayScene::objectCount() const
{
  return static_cast<int>(this->Internal->Objects.size());
}

bool RayScene::isBlocked(const Vec3& point, const RayLight& light) const
{
  return this->Internal->blocked(this->Internal->toLocal(point), -1, 0, light);
}

RaySample RayScene::look(const RayView& view, double x, double y, const RayLight& light) const
{
  const double clipX = 2.0 * x / view.Width - 1.0;
  const double clipY = 2.0 * y / view.Height - 1.0;
  Vec3 from = this->Internal->toLocal(unproject(view, clipX, clipY, -1.0));
  const Vec3 to = this->Internal->toLocal(unproject(view, clipX, clipY, 1.0));
  const Vec3 direction = normalized(to - from);

  // Starts where the ray comes to the scene, so that a far eye costs no digits of the float.
  const double closest = -dot(from, direction);
  const double skipped = std::max(0.0, closest - 1.01);
  from = from + skipped * direction;
  const Ray ray{ from, direction };
  const double length = dot(to - from, direction);

  RaySample sample;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit hit{};
  hit.ray = embreeRay(ray, length);
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(this->Internal->Scene, &context, &hit);
  if (length < 0.0 || hit.hit.geomID == RTC_INVALID_GEOMETRY_ID)
  {
    return sample;
  }
  sample.Object = static_cast<int>(hit.hit.geomID);
  const SceneObject& object = this->Internal->Objects[hit.hit.geomID];
  const SceneTriangle& triangle = object.Triangles[hit.hit.primID];
  sample.Cell = triangle.Cell;
  double distance = planeDistance(triangle, ray);
  if (!(std::abs(distance - static_cast<double>(hit.ray.tfar)) < 1e-3))
  {
    // Seen so exactly edge-on that its plane says nothing.
    distance = static_cast<double>(hit.ray.tfar);
  }
  const Vec3 point = from + distance * direction;
  sample.Point = this->Internal->toWorld(point);

  const Vec3 normal =
    cross(triangle.Corners[1] - triangle.Corners[0], triangle.Corners[2] - triangle.Corners[0]);
  Vec3 towards{ light[0], light[1], light[2] };
  if (light[3] != 0.0)
  {
    towards = this->Internal->toLocal((1.0 / light[3]) * towards) - triangle.Corners[0];
  }
  sample.Cosine = std::abs(dot(normalized(normal), normalized(towards)));
  const bool frontIsSeen = dot(normal, direction) <= 0.0;
  const bool frontIsLit = dot(normal, towards) >= 0.0;
  if (!object.Receives)
  {
    sample.Light = Visibility::Lit;
  }
  else if (frontIsSeen != frontIsLit || sample.Cosine == 0.0)
  {
    sample.Light = Visibility::TurnedAway;
  }
  else
  {
    sample.Light = this->Internal->blocked(point, sample.Object, hit.hit.primID, light)
      ? Visibility::Shadow
      : Visibility::Lit;
  }
  return sample;
}

RayPicture RayScene::render(const RayView& view, const RayLight& light) const
{
  RayPicture picture;
  picture.Width = view.Width;
  picture.Height = view.Height;
  for (int y = 0; y < view.Height; ++y)
  {
    for (int x = 0; x < view.Width; ++x)
    {
      picture.Samples.push_back(this->look(view, x + 0.5, y + 0.5, light));
    }
  }
  return picture;
}
}
