// Which parts of cast contours can be seen, against rays to the light from places along them.

#include "ChainChecks.h"
#include "ContourScenes.h"
#include "Random.h"
#include "RayCast.h"
#include "RealMeshes.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCastShadowContour.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace shadowtest;

namespace
{
struct HiddenScene
{
  std::vector<Mesh> Casters;
  std::vector<Mesh> Receivers;
  LightPosition Light;
  int Kind = vtkSmoothLightSilhouette::DISCRETE;
};

struct HiddenReport
{
  double Length = 0.0;
  double Visible = 0.0;
  double Wrong = 0.0; ///< of the length that was looked at
  int Looks = 0;
  int LeftOut = 0; ///< where two rays beside each other do not see the same
};

vtkSmartPointer<vtkCastShadowContour> filterOf(const HiddenScene& scene)
{
  auto filter = vtkSmartPointer<vtkCastShadowContour>::New();
  for (vtkPolyData* caster : scene.Casters)
  {
    vtkNew<vtkSmoothLightSilhouette> silhouette;
    silhouette->SetInputData(caster);
    silhouette->SetKind(scene.Kind);
    silhouette->SetLightPosition(scene.Light.data());
    filter->AddSilhouetteConnection(silhouette->GetOutputPort());
    filter->AddInputData(2, caster);
  }
  for (vtkPolyData* receiver : scene.Receivers)
  {
    filter->AddInputData(1, receiver);
  }
  return filter;
}

vtkSmartPointer<vtkPolyData> contoursOf(const HiddenScene& scene)
{
  const auto filter = filterOf(scene);
  filter->KeepHiddenOn();
  filter->Update();
  return filter->GetOutput();
}

/// Of the lines that are as visible as asked for.
double lengthOf(vtkPolyData* contours, bool visible)
{
  double sum = 0.0;
  for (vtkIdType line = 0; line < contours->GetNumberOfLines(); ++line)
  {
    if ((contours->GetCellData()->GetArray("Visible")->GetComponent(line, 0) != 0.0) != visible)
    {
      continue;
    }
    vtkIdType count;
    const vtkIdType* ids;
    contours->GetLines()->GetCellAtId(line, count, ids);
    for (vtkIdType i = 0; i + 1 < count; ++i)
    {
      Vec3 from;
      Vec3 to;
      contours->GetPoint(ids[i], from.data());
      contours->GetPoint(ids[i + 1], to.data());
      sum += std::sqrt(dot(to - from, to - from));
    }
  }
  return sum;
}

/// Where rays to the light begin, in steps of those aside: so far off the receiver, and so far
/// ahead on their way.
struct RayStart
{
  double Off = 0.0;
  double Ahead = 0.0;
};

enum class Verdict
{
  Visible,
  Hidden,
  Unclear ///< something begins beside the contour
};

/// Says of places on contours whether they are visible.
class ContourRays
{
public:
  explicit ContourRays(const HiddenScene& scene)
    : Light(scene.Light)
    , Casters(merged(scene.Casters))
    , Step(tolerance::BesideContour * this->Casters->GetLength())
    , Rays({ { this->Casters } })
  {
  }

  /// Looks beside the place, on the side that is lit, one and two steps away. Where that is not
  /// what was expected an exact ray at a thousandth of it has the last word.
  Verdict look(const Vec3& place, const Vec3& normal, const Vec3& right, const RayStart& start,
    bool expectVisible)
  {
    const Vec3 towards =
      normalized(Vec3{ this->Light[0], this->Light[1], this->Light[2] } - this->Light[3] * place);
    const Vec3 move = this->Step * (start.Off * normal + start.Ahead * towards);
    const Vec3 aside = this->Step * right;
    const bool near = this->Rays.isBlocked(place + move + aside, this->Light);
    const bool far = this->Rays.isBlocked(place + move + 2.0 * aside, this->Light);
    if (near != far)
    {
      return Verdict::Unclear;
    }
    if (near == expectVisible && this->ExactRays < mostExactRays)
    {
      ++this->ExactRays;
      const Vec3 nearer = place + 1e-3 * (move + aside);
      if ((blockersTowards(this->Casters, nearer.data(), this->Light.data()).Count > 0) != near)
      {
        return Verdict::Unclear;
      }
    }
    return near ? Verdict::Hidden : Verdict::Visible;
  }

private:
  /// These look at all triangles: where so many are needed the contours are wrong.
  static constexpr int mostExactRays = 500;

  LightPosition Light;
  int ExactRays = 0;
  Mesh Casters;
  double Step;
  RayScene Rays;
};

/// Looks from places `spacing` apart along all lines. A place counts as wrong if no start of its
/// rays says otherwise.
HiddenReport lookAlong(ContourRays& rays, vtkPolyData* contours, double spacing,
  const std::vector<RayStart>& starts)
{
  vtkDataArray* visible = contours->GetCellData()->GetArray("Visible");
  vtkDataArray* normals = contours->GetPointData()->GetArray("ReceiverNormals");
  HiddenReport report;
  double untilNext = 0.5 * spacing;
  for (vtkIdType line = 0; line < contours->GetNumberOfLines(); ++line)
  {
    vtkIdType count;
    const vtkIdType* ids;
    contours->GetLines()->GetCellAtId(line, count, ids);
    const bool isVisible = visible->GetComponent(line, 0) != 0.0;
    const Verdict own = isVisible ? Verdict::Visible : Verdict::Hidden;
    for (vtkIdType i = 0; i + 1 < count; ++i)
    {
      Vec3 from;
      Vec3 to;
      Vec3 normal;
      contours->GetPoint(ids[i], from.data());
      contours->GetPoint(ids[i + 1], to.data());
      normals->GetTuple(ids[i], normal.data());
      const Vec3 along = to - from;
      const double length = std::sqrt(dot(along, along));
      const Vec3 right = normalized(cross(along, normal));
      report.Length += length;
      report.Visible += isVisible ? length : 0.0;
      for (; untilNext < length; untilNext += spacing)
      {
        const Vec3 place = from + untilNext / length * along;
        std::vector<Verdict> verdicts;
        for (const RayStart& start : starts)
        {
          verdicts.push_back(rays.look(place, normal, right, start, isVisible));
        }
        ++report.Looks;
        const bool isRight = std::count(verdicts.begin(), verdicts.end(), own) > 0;
        const bool isLeftOut =
          !isRight && std::count(verdicts.begin(), verdicts.end(), Verdict::Unclear) > 0;
        report.LeftOut += isLeftOut;
        report.Wrong += !isRight && !isLeftOut ? spacing : 0.0;
      }
      untilNext -= length;
    }
  }
  return report;
}

void expectRight(
  const char* name, const HiddenScene& scene, const std::vector<RayStart>& starts = { {} })
{
  SCOPED_TRACE(name);
  constexpr int looks = 50000;
  ContourRays rays(scene);
  const auto contours = contoursOf(scene);
  const double length = lookAlong(rays, contours, 1e30, starts).Length;
  ASSERT_GT(length, 0.0);
  const HiddenReport report = lookAlong(rays, contours, length / looks, starts);
  ::testing::Test::RecordProperty(name,
    std::to_string(report.Wrong / report.Length) + " of the length is wrong, " +
      std::to_string(report.LeftOut) + " looks left out");
  EXPECT_LE(report.Wrong, tolerance::HiddenLength * report.Length);
  EXPECT_GT(report.Looks, looks / 2);
  EXPECT_LT(report.LeftOut, looks / 100);
  EXPECT_GT(report.Visible, 0.01 * report.Length);
  EXPECT_LT(report.Visible, 0.99 * report.Length);
}

Mesh dragon()
{
  return standing(cgalMesh("ChineseDragon-10kv"), 1);
}
}

TEST(HiddenContours, RealMeshesOverReceivers)
{
  Random random(51);
  const Mesh field = terrain(random, 40, 4.0, -1.1, 0.2, false);
  const LightPosition direction{ 0.3, 0.2, 1.0, 0.0 };
  const LightPosition lamp{ 1.2, -0.8, 3.5, 1.0 };
  for (const auto& [name, mesh] : { std::pair<const char*, Mesh>{ "dragon", dragon() },
         { "bunny", standing(bunny(), 1) }, { "armadillo", standing(cgalMesh("armadillo"), 1) } })
  {
    expectRight(name, { { mesh }, { ground(-1.2, 4.0) }, direction });
    expectRight(name, { { mesh }, { field }, lamp });
  }
}

// Their shadows hide each other, and one stands in the ground.
TEST(HiddenContours, ThreeCasters)
{
  Random random(52);
  const Mesh field = terrain(random, 40, 4.0, -0.7, 0.2, false);
  const std::vector<Mesh> casters = { dragon(),
    moved(standing(cgalMesh("armadillo"), 1), 0.7, { 0.9, 0.7, 0.3 }, 3),
    moved(starShaped(4, 5), 0.6, { -0.9, -0.4, -0.7 }) };
  for (const LightPosition& light :
    { LightPosition{ 0.3, 0.2, 1.0, 0.0 }, LightPosition{ 1.2, -0.8, 3.5, 1.0 } })
  {
    expectRight("three casters", { casters, { field, ground(-0.8, 4.0) }, light });
  }
}

// With the light among the receivers, all around of a caster.
TEST(HiddenContours, LightAmongReceivers)
{
  const Mesh room = moved(icosphere(4), -4.0, { 0.0, 0.0, 0.0 });
  const std::vector<Mesh> casters = { dragon(), moved(dragon(), 0.8, { 0.4, 1.9, 0.7 }, 4) };
  expectRight("light among receivers", { casters, { room }, { -0.3, 1.2, 1.3, 1.0 } });
}

// Casters on their own surface.
TEST(HiddenContours, CastersAsReceivers)
{
  for (const auto& [name, mesh] :
    { std::pair<const char*, Mesh>{ "own receiver, dragon", dragon() },
      { "own receiver, armadillo", standing(cgalMesh("armadillo"), 1) } })
  {
    // Beside a contour that runs along a hollow a ray that begins on the receiver's plane begins
    // under the hollow's other side; one that begins ahead may be beyond what is close above.
    expectRight(
      name, { { mesh }, { mesh }, { 0.3, 0.2, 1.0, 0.0 } }, { { 0.5, 0.0 }, { 0.0, 10.0 } });
  }
}

// A sphere in front of another one: of the two rims' shadows the union's outline is visible.
TEST(HiddenContours, TwoSpheres)
{
  const HiddenScene scene{ { icosphere(4), moved(icosphere(4), 1.0, { 1.0, 0.0, 2.5 }) },
    { ground(-2.0, 8.0, 3) }, { 0.0, 0.0, 1.0, 0.0 } };
  const auto filter = filterOf(scene);
  filter->Update();
  vtkPolyData* contours = filter->GetOutput();
  EXPECT_EQ(lengthOf(contours, false), 0.0);
  // Each circle has a third of it within the other one; polygons of some 80 sides are 3e-4 shorter.
  const double both = 2.0 * 2.0 * 3.14159265358979 / 3.0 * 2.0;
  EXPECT_NEAR(lengthOf(contours, true), both, 0.01 * both);
  EXPECT_EQ(contours->GetNumberOfLines(), 2);

  filter->KeepHiddenOn();
  filter->Update();
  EXPECT_NEAR(lengthOf(filter->GetOutput(), true), both, 0.01 * both);
  EXPECT_NEAR(lengthOf(filter->GetOutput(), false), 0.5 * both, 0.01 * both);
  EXPECT_GT(fieldValue(filter->GetOutput(), "HiddenSeconds"), 0.0);

  filter->RemoveHiddenOff();
  filter->Update();
  EXPECT_EQ(lengthOf(filter->GetOutput(), false), 0.0);
  EXPECT_NEAR(lengthOf(filter->GetOutput(), true), 1.5 * both, 0.01 * both);
  EXPECT_EQ(fieldValue(filter->GetOutput(), "HiddenSeconds"), 0.0);
}

// Without the edges of the mesh a silhouette has the mesh on both sides, which is not to hide it.
TEST(HiddenContours, OtherKindsShowWhatDiscreteOnesShow)
{
  for (const auto& [name, mesh] : { std::pair<const char*, Mesh>{ "sphere", icosphere(4) },
         { "torus", torus(60, 30) } })
  {
    SCOPED_TRACE(name);
    std::array<double, 3> visible;
    for (const int kind : AllKinds)
    {
      visible[static_cast<std::size_t>(kind)] = lengthOf(
        contoursOf({ { mesh }, { ground(-2.0, 8.0) }, { 0.3, 0.2, 1.0, 0.0 }, kind }), true);
    }
    EXPECT_GT(visible[0], 1.0);
    EXPECT_NEAR(visible[1], visible[0], 0.01 * visible[0]);
    EXPECT_NEAR(visible[2], visible[0], 0.01 * visible[0]);
  }
}
