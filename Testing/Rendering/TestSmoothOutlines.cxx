// Meshes drawn with the gap to their smooth outline cover what the outline encloses, without holes.

#include "RealMeshes.h"
#include "ShadowScene.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include "vtkShadowVolumeExtruder.h"
#include "vtkSilhouetteGap.h"
#include "vtkSmoothLightSilhouette.h"

#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkQuadricDecimation.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace shadowtest;

constexpr int Size = 500;

/// A mesh in green and its gap in red, seen from a place at the origin.
class OutlineScene
{
public:
  OutlineScene(vtkPolyData* mesh, const Vec3& eye, bool parallel)
  {
    this->Renderer->AutomaticLightCreationOff();
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(eye.data());
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(1.6);
    vtkNew<vtkSmoothLightSilhouette> outline;
    outline->SetInputData(mesh);
    outline->SetLightPosition(eye[0], eye[1], eye[2], parallel ? 0.0 : 1.0);
    vtkNew<vtkSilhouetteGap> gap;
    gap->SetInputData(mesh);
    gap->SetSilhouetteConnection(outline->GetOutputPort());
    gap->Update();
    this->Rims->SetInputData(mesh);
    this->Rims->SetSilhouetteConnection(outline->GetOutputPort());
    this->Rims->SetExtentToNearEnd();
    this->Rims->SetCapsToNone();
    this->Rims->Update();
    this->Surface = this->Add(mesh);
    this->Surface->GetProperty()->SetColor(0.0, 1.0, 0.0);
    this->Gap = this->Add(gap->GetOutput());
    this->Gap->GetProperty()->SetColor(1.0, 0.0, 0.0);
    this->Renderer->ResetCameraClippingRange();
    this->Window = MakeWindow(Size, Size);
    this->Window->AddRenderer(this->Renderer);
  }

  /// All white and matt, under the light alone, of which the mesh casts smooth shadows.
  Image DrawLit(const RayLight& light)
  {
    vtkNew<vtkStencilShadowPass> pass;
    pass->SetKindToSmooth();
    this->Renderer->SetPass(pass);
    vtkNew<vtkInformation> keys;
    keys->Set(vtkStencilShadowPass::CASTS_SHADOW(), 0);
    this->Gap->SetPropertyKeys(keys);
    this->Renderer->AddLight(MakeLight(light));
    for (vtkActor* actor : { this->Surface.Get(), this->Gap.Get() })
    {
      actor->GetProperty()->LightingOn();
      actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
    }
    return this->Draw(true);
  }

  Image Draw(bool withGap)
  {
    this->Gap->SetVisibility(withGap);
    this->Window->Render();
    return Grab(this->Window);
  }

  /// In pixels.
  std::array<double, 2> Project(const Vec3& point) const
  {
    double view[3] = { point[0], point[1], point[2] };
    this->Renderer->WorldToView(view[0], view[1], view[2]);
    return { 0.5 * (view[0] + 1.0) * Size, 0.5 * (view[1] + 1.0) * Size };
  }

  RayView View() const
  {
    return RayView::fromCamera(this->Renderer->GetActiveCamera(), Size, Size);
  }

  /// The silhouette, but where the surface is concave along the line of sight, and hides it.
  vtkNew<vtkShadowVolumeExtruder> Rims;

private:
  vtkSmartPointer<vtkActor> Add(vtkPolyData* data)
  {
    vtkSmartPointer<vtkActor> actor = MakeActor(data);
    actor->GetProperty()->LightingOff();
    this->Renderer->AddActor(actor);
    return actor;
  }

  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkActor> Surface;
  vtkSmartPointer<vtkActor> Gap;
  vtkSmartPointer<vtkRenderWindow> Window;
};

bool isCovered(vtkImageData* image, int x, int y)
{
  return Byte(image, x, y, 0) > 0 || Byte(image, x, y, 1) > 0;
}

long redPixels(vtkImageData* image)
{
  long count = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      count += Byte(image, x, y, 0) > 0;
    }
  }
  return count;
}

/// How often the outline winds around each pixel's middle, and whether it passes
/// within so many pixels of it.
class OutlineWinding
{
public:
  OutlineWinding(const OutlineScene& scene, double near)
    : Near(near)
  {
    vtkPolyData* lines = scene.Rims->GetOutput();
    vtkDataArray* multiplicity = lines->GetCellData()->GetArray("Multiplicity");
    for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
    {
      vtkIdType count;
      const vtkIdType* ids;
      lines->GetLines()->GetCellAtId(line, count, ids);
      Vec3 point;
      lines->GetPoint(ids[0], point.data());
      std::array<double, 2> before = scene.Project(point);
      for (vtkIdType i = 1; i < count; ++i)
      {
        lines->GetPoint(ids[i], point.data());
        const std::array<double, 2> after = scene.Project(point);
        this->Add(before, after, static_cast<int>(multiplicity->GetComponent(line, 0)));
        before = after;
      }
    }
  }

  int At(int x, int y) const
  {
    int winding = 0;
    for (int left = 0; left <= x; ++left)
    {
      winding += this->Rows[Place(left, y)];
    }
    return winding;
  }

  bool IsNear(int x, int y) const { return this->Passed[Place(x, y)]; }

private:
  using Point2 = std::array<double, 2>;

  static std::size_t Place(int x, int y) { return static_cast<std::size_t>(y * Size + x); }

  /// Crossings of a row's middle line count for all pixels to their right.
  void Add(const Point2& a, const Point2& b, int multiplicity)
  {
    const double low = std::min(a[1], b[1]);
    const double high = std::max(a[1], b[1]);
    for (int y = std::max(0, static_cast<int>(low - 1.0)); y < std::min<double>(Size, high + 1.0);
         ++y)
    {
      const double middle = y + 0.5;
      if ((a[1] > middle) != (b[1] > middle))
      {
        const double at = a[0] + (middle - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
        const int x = std::max(0, static_cast<int>(std::ceil(at - 0.5)));
        if (x < Size)
        {
          // Downwards the inside is to the right.
          this->Rows[Place(x, y)] += a[1] > b[1] ? multiplicity : -multiplicity;
        }
      }
      for (int x = std::max(0, static_cast<int>(std::min(a[0], b[0]) - 1.0));
           x < std::min<double>(Size, std::max(a[0], b[0]) + 1.0); ++x)
      {
        const Point2 along = { b[0] - a[0], b[1] - a[1] };
        const Point2 away = { x + 0.5 - a[0], middle - a[1] };
        const double squared = along[0] * along[0] + along[1] * along[1];
        const double s = squared > 0.0
          ? std::clamp((away[0] * along[0] + away[1] * along[1]) / squared, 0.0, 1.0)
          : 0.0;
        if (std::hypot(away[0] - s * along[0], away[1] - s * along[1]) < this->Near)
        {
          this->Passed[Place(x, y)] = true;
        }
      }
    }
  }

  double Near;
  std::vector<int> Rows = std::vector<int>(Size * Size, 0);
  std::vector<bool> Passed = std::vector<bool>(Size * Size, false);
};

/// Expects all that the outline encloses to be covered, and the gap to be needed for that.
void expectNoHoles(vtkPolyData* mesh, const Vec3& eye, bool parallel)
{
  OutlineScene scene(mesh, eye, parallel);
  const Image filled = scene.Draw(true);
  const Image meshAlone = scene.Draw(false);
  const OutlineWinding winding(scene, tolerance::RasterSnap);
  long enclosed = 0;
  long holes = 0;
  long withoutGap = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      if (!winding.IsNear(x, y) && winding.At(x, y) > 0)
      {
        ++enclosed;
        holes += !isCovered(filled, x, y);
        withoutGap += !isCovered(meshAlone, x, y);
      }
    }
  }
  EXPECT_GT(enclosed, 15000);
  EXPECT_GT(withoutGap, 200);
  EXPECT_EQ(holes, 0);
}

const std::array<Vec3, 3> Eyes = { { { 1.0, -5.0, 2.5 }, { 4.0, 3.0, -1.5 }, { 0.4, 0.3, 6.0 } } };

/// Of the bunny with a 200th of its triangles.
Mesh coarseBunny()
{
  vtkNew<vtkQuadricDecimation> coarse;
  coarse->SetInputData(standing(bunny(), 1));
  coarse->SetTargetReduction(0.995);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(coarse->GetOutputPort());
  normals->SplittingOff();
  normals->Update();
  return normals->GetOutput();
}
}

// Seen from there a sphere's outline is a circle.
TEST(SmoothOutlines, OfACoarseSphereAreACircle)
{
  for (const bool parallel : { true, false })
  {
    for (const Vec3& eye : Eyes)
    {
      OutlineScene scene(sphere(8, 12), eye, parallel);
      const Image filled = scene.Draw(true);
      const Image meshAlone = scene.Draw(false);
      const double distance = std::sqrt(dot(eye, eye));
      // Half of the picture shows 1.6 in parallel projection, the tangent of 15 degrees else.
      const double tangent = std::tan(std::acos(-1.0) / 12.0);
      const double radius = 0.5 * Size *
        (parallel ? 1.0 / 1.6 : 1.0 / (std::sqrt(distance * distance - 1.0) * tangent));
      long wrong = 0;
      long wrongWithoutGap = 0;
      for (int y = 0; y < Size; ++y)
      {
        for (int x = 0; x < Size; ++x)
        {
          const double from = std::hypot(x + 0.5 - 0.5 * Size, y + 0.5 - 0.5 * Size);
          if (std::abs(from - radius) > tolerance::MaskPixels)
          {
            wrong += isCovered(filled, x, y) != (from < radius);
            wrongWithoutGap += isCovered(meshAlone, x, y) != (from < radius);
          }
        }
      }
      EXPECT_EQ(wrong, 0) << "parallel " << parallel;
      EXPECT_GT(wrongWithoutGap, 1000) << "parallel " << parallel;
      EXPECT_GT(redPixels(filled), 1000);
    }
  }
}

// Of a finer mesh with the same surface, but around the hole, where the coarse one is in the way.
TEST(SmoothOutlines, OfACoarseTorusAreTheFineOnes)
{
  const RayScene fine({ { torus(512, 256) } });
  for (const Vec3& eye : Eyes)
  {
    OutlineScene scene(torus(18, 10), eye, false);
    const Image filled = scene.Draw(true);
    const Image meshAlone = scene.Draw(false);
    const RayPicture truth = fine.render(scene.View(), { eye[0], eye[1], eye[2], 1.0 });
    long missing = 0;
    long missingWithoutGap = 0;
    long beyond = 0;
    for (int y = 1; y < Size - 1; ++y)
    {
      for (int x = 1; x < Size - 1; ++x)
      {
        int inside = 0;
        for (int i = 0; i < 9; ++i)
        {
          inside += truth.at(x - 1 + i % 3, y - 1 + i / 3).Light != Visibility::Background;
        }
        missing += inside == 9 && !isCovered(filled, x, y);
        missingWithoutGap += inside == 9 && !isCovered(meshAlone, x, y);
        beyond += inside == 0 && isCovered(filled, x, y) && !isCovered(meshAlone, x, y);
      }
    }
    EXPECT_EQ(missing, 0);
    EXPECT_GT(missingWithoutGap, 500);
    EXPECT_EQ(beyond, 0);
  }
}

TEST(SmoothOutlines, LeaveNoHoles)
{
  const Mesh bunny = coarseBunny();
  for (const bool parallel : { true, false })
  {
    for (const Vec3& eye : Eyes)
    {
      expectNoHoles(icosphere(1, 3), eye, parallel);
      expectNoHoles(torus(14, 8, 5), eye, parallel);
      expectNoHoles(starShaped(2, 3), eye, parallel);
      expectNoHoles(cylinder(7), eye, parallel);
      expectNoHoles(bunny, eye, parallel);
    }
  }
}

// As the sphere is that the mesh stands for, all along its outline, in light and shadow.
TEST(SmoothOutlines, AreShadedLikeTheSurface)
{
  const double radius = 0.5 * Size / 1.6;
  for (const Vec3& from :
    { Vec3{ 0.8, -0.3, 0.5 }, Vec3{ -0.6, 0.7, 0.4 }, Vec3{ 0.1, -1.0, 0.2 } })
  {
    const Vec3 light = normalized(from);
    OutlineScene scene(sphere(8, 12), { 0.0, -5.0, 0.0 }, true);
    const Image parts = scene.Draw(true);
    const Image lit = scene.DrawLit({ light[0], light[1], light[2], 0.0 });
    long inGap = 0;
    double worst = 0.0;
    for (int y = 0; y < Size; ++y)
    {
      for (int x = 0; x < Size; ++x)
      {
        const double right = (x + 0.5 - 0.5 * Size) / radius;
        const double up = (y + 0.5 - 0.5 * Size) / radius;
        const double away = std::hypot(right, up);
        if (Byte(parts, x, y, 0) > 0 && away < 1.0)
        {
          const Vec3 normal = { right, -std::sqrt(1.0 - away * away), up };
          const double expected = std::max(0.0, dot(normal, light));
          worst = std::max(worst, std::abs(Byte(lit, x, y) / 255.0 - expected));
          ++inGap;
        }
      }
    }
    EXPECT_GT(inGap, 1000);
    EXPECT_LT(worst, tolerance::GapShade);
  }
}
