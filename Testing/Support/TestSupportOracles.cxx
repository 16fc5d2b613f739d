// The oracles against closed formulas, and for seeing what is wrong.

#include "AnalyticShadow.h"
#include "ImageChecks.h"
#include "MaskComparison.h"
#include "Random.h"
#include "RandomMeshes.h"
#include "RayCast.h"
#include "SilhouetteOracle.h"
#include "TestMeshes.h"

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace shadowtest;

namespace
{
bool balanced(const SegmentChain& chain)
{
  std::map<Vec3, int> balance;
  for (const DirectedSegment& segment : chain.Segments)
  {
    balance[segment.From] -= segment.Multiplicity;
    balance[segment.To] += segment.Multiplicity;
  }
  for (const auto& entry : balance)
  {
    if (entry.second != 0)
    {
      return false;
    }
  }
  return true;
}

Mesh linesOf(const SegmentChain& chain)
{
  MeshBuilder builder;
  vtkNew<vtkCellArray> lines;
  for (const DirectedSegment& segment : chain.Segments)
  {
    const vtkIdType ids[2] = { builder.addPoint(segment.From), builder.addPoint(segment.To) };
    lines->InsertNextCell(2, ids);
  }
  Mesh mesh = builder.build();
  mesh->SetLines(lines);
  return mesh;
}

const double SphereAxes[3] = { 1.0, 1.0, 1.0 };
}

namespace
{
struct SphereOverGround
{
  explicit SphereOverGround(const Vec3& shift = { 0, 0, 0 }, double scale = 1.0)
  {
    const Vec3 up{ 0.0, 0.0, 1.0 };
    this->Objects.push_back({ moved(icosphere(6), scale, shift) });
    this->Objects.push_back({ moved(ground(-1.5, 20.0, 4), scale, shift) });
    vtkNew<vtkCamera> camera;
    const Vec3 eye = scale * Vec3{ 6.0, -5.0, 6.0 } + shift;
    camera->SetPosition(eye.data());
    camera->SetFocalPoint(shift.data());
    camera->SetViewUp(up.data());
    camera->SetClippingRange(scale * 0.1, scale * 100.0);
    this->View = RayView::fromCamera(camera, 320, 240);
  }

  std::vector<RayObject> Objects;
  RayView View;
};
}

TEST(RayCast, SphereOverGroundIsTheAnalyticShadow)
{
  for (const RayLight& light : { RayLight{ 2.0, 1.0, 5.0, 1.0 }, RayLight{ 1.0, 1.0, 2.0, 0.0 } })
  {
    const SphereOverGround setting;
    const RayScene scene(setting.Objects);
    const RayPicture picture = scene.render(setting.View, light);
    // A mask made from the formulas alone must agree.
    vtkSmartPointer<vtkImageData> mask = picture.mask();
    long shadowed[2] = { 0, 0 };
    long lit[2] = { 0, 0 };
    for (int y = 0; y < picture.Height; ++y)
    {
      for (int x = 0; x < picture.Width; ++x)
      {
        const RaySample& sample = picture.at(x, y);
        if (sample.Object < 0)
        {
          continue;
        }
        // The sphere's own points: turned away from the light, or not.
        const Vec3 p = sample.Point;
        const bool hidden = sample.Object == 1
          ? ellipsoidHides(SphereAxes, p, light)
          : dot(p, Vec3{ light[0], light[1], light[2] } - light[3] * p) < 0.0;
        ++(hidden ? shadowed : lit)[sample.Object];
        mask->SetScalarComponentFromDouble(x, y, 0, 0, hidden ? 0.0 : 255.0);
      }
    }
    EXPECT_GT(shadowed[0], 100);
    EXPECT_GT(shadowed[1], 100);
    EXPECT_GT(lit[0], 100);
    EXPECT_GT(lit[1], 1000);
    MaskComparison comparison =
      compareMask(scene, setting.View, light, mask, TurnedAwayPixels::Shadow);
    EXPECT_EQ(comparison.total().WrongBeyond, 0) << comparison.describe();
    EXPECT_GT(comparison.total().Compared, 320 * 200);
    EXPECT_GT(comparison.Objects[1].Shadowed, 100);
    EXPECT_EQ(compareMask(scene, setting.View, light, picture.mask(), TurnedAwayPixels::Shadow)
                .total()
                .Wrong,
      0);

    // Wrong pixels in the middle of areas are seen.
    mask->SetScalarComponentFromDouble(
      10, 10, 0, 0, 255.0 - mask->GetScalarComponentAsDouble(10, 10, 0, 0));
    comparison = compareMask(scene, setting.View, light, mask);
    EXPECT_EQ(comparison.total().WrongBeyond, 1) << comparison.describe();
    ASSERT_EQ(comparison.FirstBeyond.size(), 1u);
    EXPECT_EQ(comparison.FirstBeyond[0].X, 10);
    EXPECT_EQ(comparison.FirstBeyond[0].Y, 10);
  }
}

TEST(RayCast, LitFacesOfConvexMeshesNeverShadowThemselves)
{
  // Grazing light on most of the sphere; every float offset would fail somewhere.
  const SphereOverGround setting;
  const RayScene scene({ setting.Objects[0] });
  for (int i = 0; i < 5; ++i)
  {
    Random random(static_cast<std::uint64_t>(i));
    Vec3 l;
    random.direction(l.data());
    const RayPicture picture = scene.render(setting.View, { l[0], l[1], l[2], 0.0 });
    long shadow = 0;
    long seen = 0;
    for (const RaySample& sample : picture.Samples)
    {
      shadow += sample.Light == Visibility::Shadow;
      seen += sample.Object == 0;
    }
    EXPECT_GT(seen, 1000);
    EXPECT_EQ(shadow, 0);
  }
}

TEST(RayCast, ClosedMeshesAreTight)
{
  // No light passes between the triangles of a box of many triangles on to a ground inside of it.
  const RayScene scene({ { moved(icosphere(5, 3), 3.0, { 0, 0, 0 }) }, { ground(0.0, 0.5) } });
  RayView view;
  view.Width = 300;
  view.Height = 300;
  vtkNew<vtkMatrix4x4> matrix;
  matrix->Identity();
  matrix->SetElement(0, 0, 0.5);
  matrix->SetElement(1, 1, 0.5);
  matrix->SetElement(2, 2, -1.0); // looks down, as clip coordinates are left-handed
  vtkMatrix4x4::DeepCopy(view.ClipToWorld, matrix);
  const RayPicture picture = scene.render(view, { 3.0, 4.0, 20.0, 1.0 });
  for (const RaySample& sample : picture.Samples)
  {
    ASSERT_EQ(sample.Object, 1);
    ASSERT_EQ(sample.Light, Visibility::Shadow);
  }
}

TEST(RayCast, PlaceAndSizeDoNotMatter)
{
  const SphereOverGround here;
  const RayLight light{ 2.0, 1.0, 5.0, 1.0 };
  const RayPicture picture = RayScene(here.Objects).render(here.View, light);
  const Vec3 shift{ 1e4, -2e4, 3e4 };
  const double scale = 1e-2;
  const SphereOverGround there(shift, scale);
  const auto lightThere = movedLight(light.data(), scale, shift);
  const RayPicture other = RayScene(there.Objects).render(there.View, lightThere);
  EXPECT_GT(blackFraction(picture.mask()), 0.02);
  EXPECT_LT(compareImages(picture.mask(), other.mask()).Fraction, 1e-3);
}

TEST(RayCast, MatricesAndRolesAreUsed)
{
  const SphereOverGround setting;
  const RayLight light{ 0.0, 0.0, 1.0, 0.0 };
  const double before = blackFraction(RayScene(setting.Objects).render(setting.View, light).mask());
  vtkNew<vtkMatrix4x4> up;
  up->SetElement(2, 3, 100.0); // out of sight, its shadow stays
  std::vector<RayObject> objects = setting.Objects;
  objects[0].Matrix = up;
  const double lifted = blackFraction(RayScene(objects).render(setting.View, light).mask());
  EXPECT_GT(lifted, 0.01);
  EXPECT_NE(lifted, before);
  objects[0].Casts = false;
  EXPECT_EQ(blackFraction(RayScene(objects).render(setting.View, light).mask()), 0.0);
  objects[0].Casts = true;
  objects[1].Receives = false;
  EXPECT_EQ(blackFraction(RayScene(objects).render(setting.View, light).mask()), 0.0);
}

TEST(AnalyticShadow, KnownOutlinesByLightFromAbove)
{
  const LightPoint down{ 0.0, 0.0, 1.0, 0.0 };
  const Plane floor{ { 5.0, 6.0, -2.0 }, { 0.0, 0.0, 1.0 } };
  const auto egg = ellipsoidShadow(EllipsoidAxes, down, floor);
  EXPECT_NEAR(egg->distance({ 2.1, 0.0, 0.0 }).Value, 0.1, 1e-13);
  EXPECT_NEAR(egg->distance({ 0.0, -0.97, 0.3 }).Value, 0.03, 1e-13);
  const auto ring = torusShadow(TorusRadius, TorusTube, down, floor);
  EXPECT_NEAR(ring->distance({ 1.45, 0.0, 0.0 }).Value, 0.05, 1e-12);
  EXPECT_NEAR(ring->distance({ 0.42, 0.42, 0.0 }).Value, 0.6 - 0.42 * std::sqrt(2.0), 1e-12);
  // A sphere at height h under a light at height H: radius by similar triangles.
  const auto ball = ellipsoidShadow(SphereAxes, { 0.0, 0.0, 3.0, 1.0 }, floor);
  const double tangent = 1.0 / std::sqrt(8.0);
  const Vec3 onBoundary{ 5.0 * tangent + 0.01, 0.0, -2.0 };
  EXPECT_NEAR(ball->distance(onBoundary).Value, 0.01, 1e-13);
}

TEST(AnalyticShadow, ContoursAreOnTheBoundary)
{
  const Plane floor{ { 0.0, 0.0, -3.0 }, { 0.1, 0.2, 1.0 } };
  for (const LightPoint& light :
    { LightPoint{ 0.7, 0.4, 1.0, 0.0 }, LightPoint{ 1.0, -2.0, 4.0, 1.0 } })
  {
    const auto egg = ellipsoidShadow(EllipsoidAxes, light, floor);
    const auto ring = torusShadow(TorusRadius, TorusTube, light, floor);
    for (const AnalyticShadow* shadow : { egg.get(), ring.get() })
    {
      int valid = 0;
      for (const Vec3& p : shadow->contour(500))
      {
        const BoundaryDistance distance = shadow->distance(p);
        if (distance.Valid)
        {
          ++valid;
          EXPECT_TRUE(distance.Converged);
          EXPECT_LT(distance.Value, 1e-11);
        }
      }
      EXPECT_GT(valid, 300);
    }
  }
}

TEST(AnalyticShadow, AccurateSilhouettesAreOfSecondOrder)
{
  const Plane floor{ { 0.0, 0.0, -3.0 }, { 0.0, 0.0, 1.0 } };
  for (const LightPoint& light :
    { LightPoint{ 0.5, 0.3, 1.0, 0.0 }, LightPoint{ 1.0, -1.0, 5.0, 1.0 } })
  {
    for (const bool isTorus : { false, true })
    {
      std::vector<double> h;
      std::vector<double> error;
      for (const int n : { 16, 32, 64, 128 })
      {
        const Mesh mesh = isTorus ? torus(2 * n, n, 5) : ellipsoid(n, 2 * n, 5);
        const auto shadow = isTorus ? torusShadow(TorusRadius, TorusTube, light, floor)
                                    : ellipsoidShadow(EllipsoidAxes, light, floor);
        const SegmentChain chain = accurateSilhouette(mesh, light.data());
        const ShadowError measured = shadowError(linesOf(chain), *shadow, 3);
        EXPECT_GT(measured.Samples, 100);
        EXPECT_EQ(measured.Failed, 0) << (isTorus ? "torus " : "ellipsoid ") << n;
        EXPECT_LT(measured.LeftOut, measured.Samples / 2);
        EXPECT_LE(measured.RootMeanSquare, measured.Largest);
        h.push_back(meanEdgeLength(mesh));
        error.push_back(measured.Largest);
      }
      EXPECT_NEAR(fitOrder(h, error), 2.0, 0.3) << error.front() << " to " << error.back();
    }
  }
}

TEST(AnalyticShadow, OrderIsFitted)
{
  EXPECT_NEAR(fitOrder({ 1.0, 0.5, 0.25 }, { 3.0, 3.0 / 8.0, 3.0 / 64.0 }), 3.0, 1e-12);
}

TEST(SilhouetteOracle, BoxUnderAxisAlignedLight)
{
  const double down[4] = { 0.0, 0.0, 1.0, 0.0 };
  // The sides' field is zero, which is lit: the silhouette runs around the bottom.
  const SegmentChain chain = discreteSilhouette(weldedBox(), down);
  ASSERT_EQ(chain.Segments.size(), 4u);
  for (const DirectedSegment& segment : chain.Segments)
  {
    EXPECT_EQ(segment.From[2], -1.0);
    EXPECT_EQ(segment.To[2], -1.0);
    EXPECT_EQ(segment.Multiplicity, 1);
  }
  EXPECT_TRUE(compareChains(chain, discreteSilhouette(box(), down), 1e-12).none());
  EXPECT_TRUE(compareChains(chain, accurateSilhouette(box(), down), 1e-12).none());
}

TEST(SilhouetteOracle, SingleTriangleIsItsBorderFromBothSides)
{
  for (const double side : { 1.0, -1.0 })
  {
    const double light[4] = { 0.0, 0.0, side, 0.0 };
    for (const SegmentChain& chain :
      { discreteSilhouette(triangle(), light), accurateSilhouette(triangle(), light) })
    {
      ASSERT_EQ(chain.Segments.size(), 3u);
      // Counter-clockwise as the light sees it.
      Vec3 area{ 0.0, 0.0, 0.0 };
      for (const DirectedSegment& segment : chain.Segments)
      {
        area = area + cross(segment.From, segment.To);
      }
      EXPECT_EQ(area[2], side);
    }
  }
}

TEST(SilhouetteOracle, ChainsOfRandomMeshesAreClosed)
{
  std::size_t segments = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed)
  {
    const RandomMesh drawn = randomMesh(seed);
    SCOPED_TRACE(drawn.Kind + " " + std::to_string(seed));
    const SegmentChain discrete = discreteSilhouette(drawn.Surface, drawn.Light.data());
    EXPECT_TRUE(balanced(discrete));
    segments += discrete.Segments.size();
    if (drawn.Surface->GetPointData()->GetNormals())
    {
      const SegmentChain accurate = accurateSilhouette(drawn.Surface, drawn.Light.data());
      // Crossings are computed per side, so ends meet to rounding only.
      const ChainDifference self = compareChains(accurate, accurate, 1e-12);
      EXPECT_TRUE(self.none()) << self.Message;
      const double size = drawn.Surface->GetLength();
      SegmentChain snapped = accurate;
      std::vector<Vec3*> ends;
      for (DirectedSegment& segment : snapped.Segments)
      {
        for (Vec3* p : { &segment.From, &segment.To })
        {
          for (double& x : *p)
          {
            x = std::round(x / size * 1e9 + 0.123456789);
          }
        }
      }
      EXPECT_TRUE(balanced(snapped));
      segments += accurate.Segments.size();
    }
  }
  EXPECT_GT(segments, 10000u);
}

TEST(SilhouetteOracle, ComparisonSeesDifferencesOnly)
{
  const double light[4] = { 1.0, 2.0, 3.0, 0.0 };
  const SegmentChain chain = accurateSilhouette(icosphere(2, 1), light);
  ASSERT_GT(chain.Segments.size(), 10u);
  SegmentChain other = chain;
  std::reverse(other.Segments.begin(), other.Segments.end());
  // A segment in two pieces.
  DirectedSegment& cut = other.Segments[3];
  const Vec3 middle = 0.5 * (cut.From + cut.To);
  other.Segments.push_back({ middle, cut.To, 1 });
  other.Segments[3].To = middle;
  EXPECT_TRUE(compareChains(chain, other, 1e-12).none());
  std::swap(other.Segments[5].From, other.Segments[5].To);
  EXPECT_EQ(compareChains(chain, other, 1e-12).Differing, 1u);
  other = chain;
  other.Segments.pop_back();
  EXPECT_EQ(compareChains(chain, other, 1e-12).Differing, 1u);
}
