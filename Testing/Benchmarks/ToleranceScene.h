// A shape over the ground, drawn with the pass, and where the shadow's boundary is there in pixels.
#ifndef ToleranceScene_h
#define ToleranceScene_h

#include "AnalyticShadow.h"
#include "BenchmarkWindow.h"
#include "RayCast.h"
#include "TestMeshes.h"

#include <vtkActor.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkStencilShadowPass.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace benchmarks
{
using PixelPlace = std::array<double, 2>;

struct ToleranceScene
{
  static constexpr int Size = 768;
  static constexpr double GroundHeight = -2.0;

  shadowtest::Mesh Ground = shadowtest::ground(GroundHeight, 8.0, 8);
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkLight> Light;
  vtkNew<vtkStencilShadowPass> Pass;
  vtkSmartPointer<vtkRenderWindow> Window;
  shadowtest::RayLight Place;

  ToleranceScene(vtkPolyData* mesh, const shadowtest::RayLight& place)
    : Place(place)
  {
    for (vtkPolyData* surface : { this->Ground.Get(), mesh })
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputData(surface);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      this->Renderer->AddActor(actor);
    }
    this->Renderer->AutomaticLightCreationOff();
    this->Light->SetLightTypeToSceneLight();
    this->Light->SetPositional(place[3] != 0.0);
    this->Light->SetConeAngle(180.0);
    this->Light->SetFocalPoint(0.0, 0.0, 0.0);
    this->Renderer->AddLight(this->Light);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(2.0, -5.0, 4.0);
    camera->SetFocalPoint(0.0, 0.0, -1.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    this->Renderer->ResetCameraClippingRange();
    this->Renderer->SetPass(this->Pass);
    this->Window = openWindow(Size, this->Renderer);
    this->placeLight(0);
  }

  void placeLight(int step)
  {
    this->Light->SetPosition(this->Place[0] + 0.02 * step, this->Place[1], this->Place[2]);
  }

  vtkSmartPointer<vtkImageData> mask()
  {
    this->placeLight(0);
    drawFrame(this->Window);
    return vtkSmartPointer<vtkImageData>::Take(this->Pass->GetMask(this->Light));
  }

  PixelPlace toPixel(const shadowtest::Vec3& point)
  {
    const double in[4] = { point[0], point[1], point[2], 1.0 };
    double clip[4];
    this->Renderer->GetActiveCamera()
      ->GetCompositeProjectionTransformMatrix(1.0, -1.0, 1.0)
      ->MultiplyPoint(in, clip);
    return { 0.5 * Size * (1.0 + clip[0] / clip[3]), 0.5 * Size * (1.0 + clip[1] / clip[3]) };
  }
};

/// Places halfway between neighbouring pixels of which one is lit and one in shadow, both on object
/// 0 of the ray cast, and so are all around them. What is between is within half a pixel of there.
inline std::vector<PixelPlace> maskEdges(vtkImageData* mask, const shadowtest::RayPicture& objects)
{
  constexpr int size = ToleranceScene::Size;
  const auto* values = static_cast<const unsigned char*>(mask->GetScalarPointer());
  const auto at = [&](int x, int y) { return values[y * size + x]; };
  const auto isGround = [&](int x, int y) {
    for (int j = -1; j <= 1; ++j)
    {
      for (int i = -1; i <= 1; ++i)
      {
        if (objects.at(x + i, y + j).Object != 0)
        {
          return false;
        }
      }
    }
    return true;
  };
  std::vector<PixelPlace> edges;
  for (int y = 1; y + 2 < size; ++y)
  {
    for (int x = 1; x + 2 < size; ++x)
    {
      if (at(x, y) != at(x + 1, y) && isGround(x, y) && isGround(x + 1, y))
      {
        edges.push_back({ x + 1.0, y + 0.5 });
      }
      if (at(x, y) != at(x, y + 1) && isGround(x, y) && isGround(x, y + 1))
      {
        edges.push_back({ x + 0.5, y + 1.0 });
      }
    }
  }
  return edges;
}

struct PixelError
{
  double Largest = 0.0;
  double RootMeanSquare = 0.0;
  std::size_t Samples = 0;
};

/// Distances from the boundary, which is given by points much closer to each other than a pixel.
inline PixelError pixelError(
  const std::vector<PixelPlace>& edges, const std::vector<PixelPlace>& boundary)
{
  PixelError error;
  double sum = 0.0;
  for (const PixelPlace& edge : edges)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const PixelPlace& place : boundary)
    {
      const double x = place[0] - edge[0];
      const double y = place[1] - edge[1];
      nearest = std::min(nearest, x * x + y * y);
    }
    error.Largest = std::max(error.Largest, std::sqrt(nearest));
    sum += nearest;
  }
  error.Samples = edges.size();
  error.RootMeanSquare = edges.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(edges.size()));
  return error;
}
}

#endif
