#include "Scene.h"

#include "Vectors.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// The picture's defaults, in radii of the meshes where they are lengths.
constexpr Vector3 LightOffset = { -4.2, 5.6, 2.3 };
constexpr Vector3 EyeDirection = { 0.30, 0.55, 1.0 };
constexpr double LongestShadow = 2.2; // what reaches farther may leave the picture
constexpr double GroundHalfWidth = 25.0;
constexpr double Margin = 1.08;

// z is in front where y is up, -y where z is.
std::array<Vector3, 3> FrameAxes(const Vector3& upwards)
{
  const Vector3 up = Unit(upwards);
  const Vector3 front = std::abs(up[2]) < 0.7 ? Vector3{ 0, 0, 1 } : Vector3{ 0, -1, 0 };
  const Vector3 right = Unit(Cross(up, front));
  return { right, up, Cross(right, up) };
}
}

Scene::Scene(const std::vector<vtkPolyData*>& meshes, const SceneOptions& options)
  : Options(options)
  , Axes(FrameAxes(options.Up))
{
  const double infinity = std::numeric_limits<double>::infinity();
  Vector3 low = { infinity, infinity, infinity };
  Vector3 high = { -infinity, -infinity, -infinity };
  for (vtkPolyData* mesh : meshes)
  {
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      Vector3 world;
      mesh->GetPoint(i, world.data());
      const Vector3 point = this->ToFrame(world);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], point[axis]);
        high[axis] = std::max(high[axis], point[axis]);
      }
      this->Content.push_back(point);
    }
  }
  this->MeshPoints = this->Content.size();
  this->Centre = { 0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2]) };
  this->Lowest = low[1];
  const Vector3 diagonal = Along(high, -1.0, low);
  this->Radius = 0.5 * Length(diagonal);
  if (this->Radius == 0.0)
  {
    this->Radius = 1.0;
  }

  this->LightList = options.Lights;
  if (this->LightList.empty())
  {
    const Vector3 light = this->ToWorld(Along(this->Centre, this->Radius, LightOffset));
    this->LightList.push_back({ light[0], light[1], light[2], 1.0 });
  }
  if (options.Ground)
  {
    this->AddShadows();
  }
}

Vector3 Scene::ToFrame(const Vector3& world) const
{
  return { Dot(world, this->Axes[0]), Dot(world, this->Axes[1]), Dot(world, this->Axes[2]) };
}

Vector3 Scene::ToWorld(const Vector3& frame) const
{
  Vector3 world = { 0.0, 0.0, 0.0 };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    world = Along(world, frame[axis], this->Axes[axis]);
  }
  return world;
}

void Scene::AddShadows()
{
  for (const Homogeneous& light : this->LightList)
  {
    const Vector3 source = this->ToFrame({ light[0], light[1], light[2] });
    for (std::size_t i = 0; i < this->MeshPoints; ++i)
    {
      const Vector3 point = this->Content[i];
      const Vector3 ray = { light[3] * point[0] - source[0], light[3] * point[1] - source[1],
        light[3] * point[2] - source[2] };
      if (ray[1] >= 0.0)
      {
        continue; // upwards: its shadow never meets the ground
      }
      const double travel = (this->Lowest - point[1]) / ray[1];
      Vector3 shadow = { point[0] + travel * ray[0], this->Lowest, point[2] + travel * ray[2] };
      const double x = shadow[0] - this->Centre[0];
      const double z = shadow[2] - this->Centre[2];
      const double reach = LongestShadow * this->Radius / std::hypot(x, z);
      if (reach < 1.0)
      {
        shadow = { this->Centre[0] + reach * x, this->Lowest, this->Centre[2] + reach * z };
      }
      if (std::isfinite(shadow[0]) && std::isfinite(shadow[2]))
      {
        this->Content.push_back(shadow);
      }
    }
  }
}

Ground Scene::GroundSquare() const
{
  const double half = GroundHalfWidth * this->Radius;
  const double x = this->Centre[0];
  const double z = this->Centre[2];
  // Seen from above its corners run against the clock: its normal is up.
  return { this->ToWorld({ x - half, this->Lowest, z + half }),
    this->ToWorld({ x + half, this->Lowest, z + half }),
    this->ToWorld({ x - half, this->Lowest, z - half }) };
}

Camera Scene::View() const
{
  Camera camera = this->FittingView();
  if (this->Options.At)
  {
    camera.Eye = Along(Along(camera.Eye, -1.0, camera.At), 1.0, *this->Options.At);
    camera.At = *this->Options.At;
  }
  if (this->Options.Eye)
  {
    camera.Eye = *this->Options.Eye;
    if (camera.Eye == camera.At)
    {
      camera.At = Along(camera.Eye, -1.0, this->Axes[2]);
    }
  }
  // Looking along Up leaves no way to be upright: what is behind is then up in the picture.
  const Vector3 gaze = Unit(Along(camera.At, -1.0, camera.Eye));
  const bool vertical = std::abs(Dot(gaze, this->Axes[1])) > 1.0 - 1e-9;
  camera.Up =
    vertical ? Vector3{ -this->Axes[2][0], -this->Axes[2][1], -this->Axes[2][2] } : this->Axes[1];
  return camera;
}

// With the directions fixed, the nearest eye is given by the four planes of the view's pyramid,
// each pushed inwards until it touches the content.
Camera Scene::FittingView() const
{
  const Vector3 backwards = Unit(EyeDirection);
  const Vector3 right = Unit(Cross({ 0.0, 1.0, 0.0 }, backwards));
  const Vector3 up = Cross(backwards, right);
  const double degree = std::acos(-1.0) / 180.0;
  const double tangent = std::tan(0.5 * this->Options.Angle * degree) / Margin;
  const double aspect = static_cast<double>(this->Options.Size[0]) / this->Options.Size[1];
  const std::array<double, 2> slope = { tangent * aspect, tangent };

  const double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> low = { infinity, infinity };    // the least x + slope * depth
  std::array<double, 2> high = { -infinity, -infinity }; // the greatest x - slope * depth
  double nearest = infinity;
  for (const Vector3& point : this->Content)
  {
    const double depth = -Dot(point, backwards);
    const std::array<double, 2> across = { Dot(point, right), Dot(point, up) };
    for (std::size_t i = 0; i < 2; ++i)
    {
      low[i] = std::min(low[i], across[i] + slope[i] * depth);
      high[i] = std::max(high[i], across[i] - slope[i] * depth);
    }
    nearest = std::min(nearest, depth);
  }
  const double depth = std::min({ (low[0] - high[0]) / (2.0 * slope[0]),
    (low[1] - high[1]) / (2.0 * slope[1]), nearest - 0.05 * this->Radius });
  Vector3 eye = { 0.0, 0.0, 0.0 };
  eye = Along(eye, 0.5 * (low[0] + high[0]), right);
  eye = Along(eye, 0.5 * (low[1] + high[1]), up);
  eye = Along(eye, -depth, backwards);
  const double distance = std::max(Dot(Along(eye, -1.0, this->Centre), backwards), this->Radius);

  Camera camera;
  camera.Eye = this->ToWorld(eye);
  camera.At = this->ToWorld(Along(eye, -distance, backwards));
  camera.Up = this->Axes[1];
  camera.Angle = this->Options.Angle;
  return camera;
}
