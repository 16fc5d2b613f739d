// Which parts of cast contours can be seen, against rays to the light from places along them.

#include "ChainChecks.h"
#include "ContourScenes.h"
#include "HostileMeshes.h"
#include "PolylineDistance.h"
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
    if ((contours->GetCellData()->GetArray("Visible")->GetComponent(line, 0) != 0.0) == visible)
    {
      sum += lengthOfLine(contours, line);
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

/// Calls visit(place, right) at places along visible lines, so many in all; the lit side is on the
/// right.
template <class Visit>
void alongVisible(vtkPolyData* contours, int places, const Visit& visit)
{
  vtkDataArray* normals = contours->GetPointData()->GetArray("ReceiverNormals");
  const double spacing = lengthOf(contours, true) / places;
  double untilNext = 0.5 * spacing;
  for (vtkIdType line = 0; line < contours->GetNumberOfLines(); ++line)
  {
    if (contours->GetCellData()->GetArray("Visible")->GetComponent(line, 0) == 0.0)
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
      Vec3 normal;
      contours->GetPoint(ids[i], from.data());
      contours->GetPoint(ids[i + 1], to.data());
      normals->GetTuple(ids[i], normal.data());
      const Vec3 along = to - from;
      const double length = std::sqrt(dot(along, along));
      for (; untilNext < length; untilNext += spacing)
      {
        visit(from + untilNext / length * along, normalized(cross(along, normal)));
      }
      untilNext -= length;
    }
  }
}

/// How visible contours of a kind differ from the border of the shadow that the mesh itself casts.
struct KindReport
{
  double Visible = 0.0; ///< their length, as a share of that of discrete ones
  double Extra = 0.0;   ///< share of it that has shadow alone on the lit side, as far as is looked
  double Missing = 0.0; ///< share of the visible discrete ones that have none of them as near
};

/// Looks as far as the reach.
KindReport againstDiscrete(HiddenScene scene, int kind, double reach)
{
  const auto discrete = contoursOf(scene);
  scene.Kind = kind;
  const auto contours = contoursOf(scene);
  const RayScene rays({ { merged(scene.Casters) } });
  constexpr int looks = 10000;
  std::vector<Vec3> places;
  int extra = 0;
  alongVisible(contours, looks,
    [&](const Vec3& place, const Vec3& right)
    {
      places.push_back(place);
      constexpr int steps = 50;
      bool isInShadow = true;
      for (int i = 1; i <= steps && isInShadow; ++i)
      {
        isInShadow = rays.isBlocked(place + i * reach / steps * right, scene.Light);
      }
      extra += isInShadow;
    });
  constexpr int discreteLooks = 2000;
  int all = 0;
  int missing = 0;
  alongVisible(discrete, discreteLooks,
    [&](const Vec3& place, const Vec3&)
    {
      ++all;
      missing += std::none_of(places.begin(), places.end(),
        [&](const Vec3& other) { return dot(other - place, other - place) < reach * reach; });
    });
  EXPECT_GT(static_cast<int>(places.size()), looks / 2);
  EXPECT_GT(all, discreteLooks / 2);
  return { lengthOf(contours, true) / lengthOf(discrete, true),
    extra / static_cast<double>(places.size()), missing / static_cast<double>(all) };
}

/// Of visible contours, or hidden ones, that are cast from x below 0.
double lengthFromNegativeX(vtkPolyData* contours, bool visible)
{
  vtkNew<vtkPolyData> part;
  part->DeepCopy(contours);
  vtkDataArray* marks = part->GetCellData()->GetArray("Visible");
  for (vtkIdType line = 0; line < part->GetNumberOfLines(); ++line)
  {
    vtkIdType count;
    const vtkIdType* ids;
    part->GetLines()->GetCellAtId(line, count, ids);
    const double x = part->GetPointData()->GetArray("CasterPoints")->GetComponent(ids[0], 0);
    const bool isWanted = x < 0.0 && (marks->GetComponent(line, 0) != 0.0) == visible;
    marks->SetComponent(line, 0, isWanted ? 1.0 : 0.0);
  }
  return lengthOf(part, true);
}

/// Around z, with flat faces that have smooth rims: a smooth silhouette on the inner ones is within
/// the shadow of the faces, whose edges cut the hole's corners.
Mesh ring(int sides)
{
  const double radii[] = { 1.0, 1.0, 0.6, 0.6 };
  const double heights[] = { -0.2, 0.2, 0.2, -0.2 };
  MeshBuilder mesh;
  for (std::size_t band = 0; band < 4; ++band)
  {
    const std::size_t after = (band + 1) % 4;
    const double outward = heights[after] - heights[band];
    const double upward = radii[band] - radii[after];
    const vtkIdType first = mesh.pointCount();
    for (int i = 0; i < sides; ++i)
    {
      const double angle = 2.0 * 3.14159265358979 * i / sides;
      const Vec3 along{ std::cos(angle), std::sin(angle), 0.0 };
      const Vec3 normal = normalized(outward * along + Vec3{ 0.0, 0.0, upward });
      mesh.addPoint(radii[band] * along + Vec3{ 0.0, 0.0, heights[band] }, normal);
      mesh.addPoint(radii[after] * along + Vec3{ 0.0, 0.0, heights[after] }, normal);
      const vtkIdType at = first + 2 * i;
      const vtkIdType next = first + 2 * ((i + 1) % sides);
      mesh.addQuad(at, next, next + 1, at + 1);
    }
  }
  return mesh.build();
}

/// Open, and bent like an S along the light's rays: on its way down it bends away from them and
/// then towards them, and its shadow ends at either bend.
Mesh sheet(int steps)
{
  constexpr int across = 20;
  MeshBuilder mesh;
  for (int i = 0; i <= steps; ++i)
  {
    const double u = 3.14159265358979 * (2.0 * i / steps - 1.0);
    const double height = u < 0.0 ? 1.0 : 2.0;
    for (int j = 0; j <= across; ++j)
    {
      const Vec3 point{ height * std::sin(u), 4.0 * j / across - 2.0, -u };
      mesh.addPoint(0.4 * point, normalized({ 1.0, 0.0, height * std::cos(u) }));
    }
  }
  for (int i = 0; i < steps; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const vtkIdType at = i * (across + 1) + j;
      mesh.addQuad(at, at + across + 1, at + across + 2, at + 1);
    }
  }
  return mesh.build();
}

/// The part of a sphere whose triangles are above a height, its winding and its normals turned
/// over.
Mesh insideOut(double least)
{
  MeshBuilder mesh;
  mesh.append(icosphere(4));
  for (Vec3& normal : mesh.Normals)
  {
    normal = -1.0 * normal;
  }
  std::vector<std::vector<vtkIdType>> above;
  for (const auto& cell : mesh.Cells)
  {
    if (std::all_of(cell.begin(), cell.end(),
          [&](vtkIdType id) { return mesh.Points[static_cast<std::size_t>(id)][2] >= least; }))
    {
      above.push_back({ cell.rbegin(), cell.rend() });
    }
  }
  mesh.Cells = above;
  return mesh.build();
}

const char* kindName(int kind)
{
  constexpr const char* names[] = { "discrete", "accurate", "smooth" };
  return names[kind];
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

  HiddenScene slanted = scene;
  slanted.Light = { 0.03, 0.02, 1.0, 0.0 };
  const auto discrete = contoursOf(slanted);
  for (const int kind : { vtkSmoothLightSilhouette::ACCURATE, vtkSmoothLightSilhouette::SMOOTH })
  {
    SCOPED_TRACE(kindName(kind));
    slanted.Kind = kind;
    const auto ofKind = contoursOf(slanted);
    for (const bool visible : { true, false })
    {
      const double length = lengthOf(discrete, visible);
      EXPECT_GT(length, 1.0);
      EXPECT_NEAR(lengthOf(ofKind, visible), length, 0.01 * length);
    }
  }
}

// Two large flat triangles hide all that something beside them casts: neither their size nor how
// near they are is a reason not to, whether they are of another caster or of the same mesh.
TEST(HiddenContours, InTheShadowOfALargeFace)
{
  const Mesh large = moved(box(0.5, 0.5, 1.0), 1.0, { 0.5, 0.5, 1.0 });
  const Mesh floor = ground(0.0, 8.0);
  for (const Mesh& small : { moved(box(0.1, 0.1, 0.05), 1.0, { -0.4, 0.8, 0.55 }),
         moved(icosphere(3), 0.1, { -0.4, 0.8, 0.55 }) })
  {
    for (const auto& casters :
      { std::vector<Mesh>{ large, small }, { small, large }, { merged({ large, small }) } })
    {
      double discrete = 0.0;
      for (const int kind : AllKinds)
      {
        SCOPED_TRACE(kindName(kind));
        const auto contours = contoursOf({ casters, { floor }, { 1.0, -1.0, 2.0, 0.0 }, kind });
        EXPECT_EQ(lengthFromNegativeX(contours, true), 0.0);
        EXPECT_GT(lengthFromNegativeX(contours, false), 0.5);
        const double visible = lengthOf(contours, true);
        discrete = kind == vtkSmoothLightSilhouette::DISCRETE ? visible : discrete;
        EXPECT_GT(visible, 1.0);
        EXPECT_NEAR(visible, discrete, tolerance::SameContours * discrete);
      }
    }
  }
}

// Edges of flat faces are silhouettes of all kinds, and faces that meet them may hide what they
// cast.
TEST(HiddenContours, FlatFacesHideTheirOwnEdges)
{
  for (const std::uint64_t seed : { 1, 2, 3, 4 })
  {
    const Mesh mesh = voxels(4, seed);
    for (const LightPosition& light :
      { LightPosition{ 0.5, 0.3, 1.0, 0.0 }, LightPosition{ 1.3, 9.2, 17.0, 1.0 } })
    {
      double discrete = 0.0;
      for (const int kind : AllKinds)
      {
        SCOPED_TRACE(kindName(kind));
        const auto contours = contoursOf({ { mesh }, { ground(-1.0, 30.0), mesh }, light, kind });
        const double visible = lengthOf(contours, true);
        discrete = kind == vtkSmoothLightSilhouette::DISCRETE ? visible : discrete;
        EXPECT_GT(visible, 1.0);
        EXPECT_GT(lengthOf(contours, false), 1.0);
        EXPECT_NEAR(visible, discrete, tolerance::SameContours * discrete);
      }
    }
  }
}

// A silhouette that crosses triangles is within the mesh's own shadow, and what is around it is not
// to hide it; all else is.
TEST(HiddenContours, OtherKindsShowTheShadowsBorder)
{
  struct Case
  {
    const char* name;
    Mesh mesh;
    tolerance::OtherKinds limits;
  };
  for (const auto& [name, mesh, limits] :
    { Case{ "sphere", icosphere(4), tolerance::SmoothShapes },
      { "torus", torus(60, 30), tolerance::SmoothShapes },
      { "cylinder", moved(cylinder(60), 1.0, { 0.0, 0.0, 0.0 }, 5), tolerance::SmoothShapes },
      { "sphere inside out", insideOut(-1.0), tolerance::SmoothShapes },
      { "bowl inside out", insideOut(-0.5), tolerance::SmoothShapes },
      { "sheet", sheet(60), tolerance::Rims },
      { "ring", ring(60), tolerance::Rims },
      { "dragon", dragon(), tolerance::Scans },
      { "bunny", standing(bunny(), 1), tolerance::Scans },
      { "armadillo", standing(cgalMesh("armadillo"), 1), tolerance::Scans } })
  {
    for (const int kind : { vtkSmoothLightSilhouette::ACCURATE, vtkSmoothLightSilhouette::SMOOTH })
    {
      SCOPED_TRACE(std::string(name) + ", " + kindName(kind));
      const KindReport report = againstDiscrete(
        { { mesh }, { ground(-2.0, 8.0) }, { 0.3, 0.2, 1.0, 0.0 } }, kind, meanEdgeLength(mesh));
      ::testing::Test::RecordProperty(std::string(name) + ", " + kindName(kind),
        std::to_string(report.Visible) + " of the discrete length, " +
          std::to_string(report.Extra) + " extra, " + std::to_string(report.Missing) + " missing");
      EXPECT_LE(report.Extra, limits.Extra);
      EXPECT_EQ(report.Missing, 0.0);
      EXPECT_NEAR(report.Visible, 1.0, limits.Visible);
    }
  }
}
