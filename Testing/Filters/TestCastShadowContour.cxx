#include "ContourOracle.h"
#include "ContourScenes.h"
#include "OutputComparison.h"
#include "PolylineDistance.h"
#include "Random.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCastShadowContour.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace shadowtest;

namespace
{
/// Casters' silhouettes and their contours on receivers.
class Contours
{
public:
  Contours(const std::vector<Mesh>& casters, const std::vector<Mesh>& receivers,
    const LightPosition& light, int kind = vtkSmoothLightSilhouette::DISCRETE)
  {
    for (vtkPolyData* caster : casters)
    {
      auto silhouette = vtkSmartPointer<vtkSmoothLightSilhouette>::New();
      silhouette->SetInputData(caster);
      silhouette->SetKind(kind);
      silhouette->SetTolerance(1e-6);
      silhouette->SetLightPosition(light.data());
      this->Filter->AddSilhouetteConnection(silhouette->GetOutputPort());
      this->Silhouettes.push_back(silhouette);
    }
    for (vtkPolyData* receiver : receivers)
    {
      this->Filter->AddInputData(1, receiver);
    }
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this->Errors);
  }

  vtkPolyData* update()
  {
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  std::vector<vtkSmartPointer<vtkSmoothLightSilhouette>> Silhouettes;
  vtkNew<vtkCastShadowContour> Filter;
  vtkNew<vtkTest::ErrorObserver> Errors;
};

Vec3 pointOf(vtkPolyData* data, vtkIdType id)
{
  Vec3 point;
  data->GetPoint(id, point.data());
  return point;
}

Vec3 vectorOf(vtkPolyData* data, const char* name, vtkIdType id)
{
  Vec3 vector;
  data->GetPointData()->GetArray(name)->GetTuple(id, vector.data());
  return vector;
}

double lengthOf(const Vec3& v)
{
  return std::sqrt(dot(v, v));
}

/// Twice the area that a line encloses, seen from +z.
double doubleArea(vtkPolyData* lines, vtkIdType line)
{
  vtkIdType count;
  const vtkIdType* ids;
  lines->GetLines()->GetCellAtId(line, count, ids);
  double area = 0.0;
  for (vtkIdType i = 0; i + 1 < count; ++i)
  {
    area += cross(pointOf(lines, ids[i]), pointOf(lines, ids[i + 1]))[2];
  }
  return area;
}

/// Where the ray through a point meets z = height.
Vec3 shadowAt(double height, const LightPosition& l, const Vec3& p)
{
  const Vec3 ray = l[3] * p - Vec3{ l[0], l[1], l[2] };
  return p + (height - p[2]) / ray[2] * ray;
}

std::string differentContours(vtkPolyData* first, vtkPolyData* second)
{
  if (!sameBytes(first->GetPoints()->GetData(), second->GetPoints()->GetData()))
  {
    return "points";
  }
  if (!sameBytes(
        first->GetLines()->GetConnectivityArray(), second->GetLines()->GetConnectivityArray()) ||
    !sameBytes(first->GetLines()->GetOffsetsArray(), second->GetLines()->GetOffsetsArray()))
  {
    return "lines";
  }
  const std::string name = differingArray(first->GetPointData(), second->GetPointData());
  return name.empty() ? differingArray(first->GetCellData(), second->GetCellData()) : name;
}

const LightPosition allLights[] = { { 0.2, 0.3, 1.0, 0.0 }, { 2.0, 3.0, 9.0, 1.0 },
  { 0.3, -0.2, 2.5, 1.0 } };
}

TEST(CastShadowContour, SphereOnPlane)
{
  for (const LightPosition& light : allLights)
  {
    for (const int kind : AllKinds)
    {
      Contours contours({ icosphere(4) }, { ground(-2.0, 40.0, 30) }, light, kind);
      vtkPolyData* lines = contours.update();
      ASSERT_EQ(lines->GetNumberOfLines(), 1);
      EXPECT_EQ(lines->GetCellData()->GetArray("Closed")->GetComponent(0, 0), 1.0);
      EXPECT_EQ(fieldValue(lines, "LightPosition"), light[0]);
      ASSERT_GT(lines->GetNumberOfPoints(), 50);
      EXPECT_GT(doubleArea(lines, 0), 0.0); // the shadow is on the left
      Vec3 middle = shadowAt(-2.0, light, { 0.0, 0.0, 0.0 });
      double farthest = 0.0;
      for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
      {
        const Vec3 caster = vectorOf(lines, "CasterPoints", i);
        EXPECT_LT(lengthOf(pointOf(lines, i) - shadowAt(-2.0, light, caster)),
          80.0 * tolerance::SamePoint);
        const Vec3 normal = vectorOf(lines, "ReceiverNormals", i);
        EXPECT_LT(lengthOf(normal - Vec3{ 0.0, 0.0, 1.0 }), tolerance::UnitNormal);
        const Vec3 into = vectorOf(lines, "ShadowDirection", i);
        EXPECT_NEAR(lengthOf(into), 1.0, tolerance::UnitNormal);
        EXPECT_LT(std::fabs(into[2]), tolerance::UnitNormal);
        EXPECT_GT(dot(into, middle - pointOf(lines, i)), 0.0);
        // From the cone that touches the sphere: the sine of the angle to its axis.
        const Vec3 axis{ light[0], light[1], light[2] };
        const Vec3 ray =
          light[3] == 0.0 ? pointOf(lines, i) : pointOf(lines, i) - axis;
        const double offset = light[3] == 0.0
          ? lengthOf(cross(ray, normalized(axis))) - 1.0
          : lengthOf(cross(normalized(ray), axis)) - 1.0;
        farthest = std::max(farthest, std::fabs(offset));
      }
      EXPECT_LT(farthest,
        kind == vtkSmoothLightSilhouette::SMOOTH ? tolerance::SphereContour : 0.05);
    }
  }
}

// Where a contour's segment has almost no length, a receiver's edge is behind it all the same.
TEST(CastShadowContour, SegmentsOfAlmostNoLength)
{
  for (const LightPosition& light :
    { LightPosition{ 0.0, 0.0, 1.0, 0.0 }, LightPosition{ 1.0, 0.0, 1e3, 1.0 } })
  {
    Contours on({ moved(icosphere(4), 1.0, { 1.0, 0.0, 2.5 }) }, { ground(-2.0, 8.0, 3) }, light,
      vtkSmoothLightSilhouette::SMOOTH);
    vtkPolyData* lines = on.update();
    ASSERT_EQ(lines->GetNumberOfLines(), 1);
    EXPECT_NEAR(lengthOfLines(lines), 2.0 * vtkMath::Pi(), 0.1);
  }
}

TEST(CastShadowContour, BoxOverPlane)
{
  // Through whole numbers: nothing is rounded but the points on the receiver's edges.
  Contours contours({ box(1.0, 1.0, 1.0) }, { ground(-4.0, 8.0, 4) }, { 1.0, 2.0, 4.0, 0.0 });
  vtkPolyData* lines = contours.update();
  ASSERT_EQ(lines->GetNumberOfLines(), 1);
  // The box's faces have areas of 4: seen along (1, 2, 4) that is 4 (1 + 2 + 4) over 4.
  EXPECT_NEAR(doubleArea(lines, 0), 2.0 * 7.0, 14.0 * tolerance::SamePoint);
  for (const Vec3& corner : { Vec3{ 1, 1, 1 }, Vec3{ -1, 1, -1 }, Vec3{ -1, -1, 1 } })
  {
    const Vec3 wanted = shadowAt(-4.0, { 1.0, 2.0, 4.0, 0.0 }, corner);
    double nearest = 100.0;
    for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
    {
      nearest = std::min(nearest, lengthOf(pointOf(lines, i) - wanted));
    }
    // Two of the corners are on the outline.
    EXPECT_EQ(nearest < 8.0 * tolerance::SamePoint, corner != (Vec3{ 1, 1, 1 })) << corner[0];
  }
}

// Where a caster stands on the receiver the contour begins and ends at its foot.
TEST(CastShadowContour, BoxOnPlane)
{
  for (const LightPosition& light : { LightPosition{ 1.0, 2.0, 4.0, 0.0 },
         LightPosition{ 2.0, 3.0, 7.0, 1.0 }, LightPosition{ 0.21, 0.37, 0.8, 0.0 } })
  {
    for (const double height : { -1.0, -0.75 })
    {
      Contours contours({ box(1.0, 1.0, 1.0) }, { ground(height, 8.0, 4) }, light);
      vtkPolyData* lines = contours.update();
      ASSERT_EQ(lines->GetNumberOfLines(), 1);
      EXPECT_EQ(lines->GetCellData()->GetArray("Closed")->GetComponent(0, 0), 0.0);
      const vtkIdType last = lines->GetNumberOfPoints() - 1;
      ASSERT_GT(last, 2);
      // The shadow is on the left, so it begins at the corner behind it.
      EXPECT_LT(lengthOf(pointOf(lines, 0) - Vec3{ -1.0, 1.0, height }), tolerance::SamePoint);
      EXPECT_LT(lengthOf(pointOf(lines, last) - Vec3{ 1.0, -1.0, height }), tolerance::SamePoint);
    }
  }
}

// The same where all coordinates are rounded: what stands on the receiver to within that does not
// cast a contour there.
TEST(CastShadowContour, BoxOnRotatedPlane)
{
  int ends = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed)
  {
    SCOPED_TRACE(seed);
    const Vec3 shift{ 300.3, 700.7, 1100.1 };
    const LightPosition light = movedLight(allLights[seed % 3].data(), 1.0, shift, seed);
    const Mesh standingBox = moved(moved(box(), 0.05, { 0.0, 0.0, 0.05 }), 1.0, shift, seed);
    const Mesh plane = moved(ground(0.0, 0.5, 25), 1.0, shift, seed);
    Contours contours({ standingBox }, { plane }, light);
    vtkPolyData* found = contours.update();
    ASSERT_EQ(found->GetNumberOfLines(), 1);
    EXPECT_EQ(found->GetCellData()->GetArray("Closed")->GetComponent(0, 0), 0.0);
    for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i)
    {
      const bool isEnd = i == 0 || i + 1 == found->GetNumberOfPoints();
      const double away = lengthOf(pointOf(found, i) - vectorOf(found, "CasterPoints", i));
      EXPECT_EQ(away < 16.0 * tolerance::SamePoint, isEnd) << i;
      ends += isEnd;
    }
  }
  EXPECT_EQ(ends, 400);
}

TEST(CastShadowContour, NothingBetweenCasterAndLight)
{
  for (const LightPosition& light : allLights)
  {
    EXPECT_EQ(Contours({ icosphere(2) }, { ground(1.5, 10.0, 10) }, light)
                .update()
                ->GetNumberOfLines(),
      0);
  }
  // Of a box below only what faces the light receives.
  Contours below({ icosphere(2) }, { moved(box(9.0, 9.0, 1.0), 1.0, { 0.0, 0.0, -4.0 }) },
    allLights[0]);
  vtkPolyData* lines = below.update();
  ASSERT_EQ(lines->GetNumberOfLines(), 1);
  EXPECT_EQ(pointOf(lines, 0)[2], -3.0);
}

TEST(CastShadowContour, EqualToBruteForce)
{
  Random random(41);
  std::size_t total = 0;
  for (int round = 0; round < 24; ++round)
  {
    LightPosition light = allLights[round % 3];
    const bool isAmong = round % 4 == 3;
    if (isAmong)
    {
      light = { 0.31, -0.12, 2.13, 1.0 };
    }
    SCOPED_TRACE("round " + std::to_string(round));
    std::vector<Mesh> receivers = { terrain(random, 12, isAmong ? 4.0 : 9.0, -1.7, 0.9, false) };
    if (isAmong)
    {
      // Around the light on all sides.
      receivers.push_back(moved(icosphere(2), -5.0, { 0.1, 0.2, 0.3 }, 5));
    }
    const std::vector<Mesh> casters = { starShaped(2, static_cast<std::uint64_t>(round) + 1),
      moved(torus(12, 8), 0.6, { 1.1, 0.4, 0.7 }, 9) };
    Contours contours(casters, receivers, light, AllKinds[round % 3]);
    contours.Silhouettes[0]->SetTolerance(1e-3);
    contours.Silhouettes[1]->SetTolerance(1e-3);
    const SegmentChain found = chainOf(contours.update());
    SegmentChain expected;
    for (const auto& silhouette : contours.Silhouettes)
    {
      for (vtkPolyData* receiver : receivers)
      {
        const SegmentChain one =
          contoursByBruteForce(silhouette->GetOutput(), receiver, light, 0.0);
        expected.Segments.insert(
          expected.Segments.end(), one.Segments.begin(), one.Segments.end());
      }
    }
    const ChainDifference difference = compareChains(expected, found, tolerance::CutContour);
    EXPECT_TRUE(difference.none()) << difference.Message;
    EXPECT_GT(difference.Expected, 50u);
    total += difference.Expected;
  }
  EXPECT_GT(total, 3000u);
}

TEST(CastShadowContour, SameForAllBuildersAndThreads)
{
  Random random(42);
  const std::vector<Mesh> casters = { icosphere(4), moved(torus(40, 20), 1.0, { 2.0, 1.0, 1.0 }) };
  const std::vector<Mesh> receivers = { terrain(random, 80, 9.0, -1.5, 0.2, false), casters[0] };
  for (const LightPosition& light : { allLights[0], LightPosition{ 3.1, -2.2, 0.5, 1.0 } })
  {
    Contours contours(casters, receivers, light);
    vtkNew<vtkPolyData> first;
    const std::string usual = vtkSMPTools::GetBackend();
    std::vector<double> nodes;
    for (const int builder : { vtkCastShadowContour::MORTON, vtkCastShadowContour::UNSORTED,
           vtkCastShadowContour::OBJECT_MEDIAN })
    {
      contours.Filter->SetBuilder(builder);
      vtkNew<vtkPolyData> serial;
      ASSERT_TRUE(vtkSMPTools::SetBackend("Sequential"));
      serial->DeepCopy(contours.update());
      ASSERT_TRUE(vtkSMPTools::SetBackend("STDThread"));
      vtkSMPTools::Initialize(4);
      contours.Filter->Modified();
      EXPECT_EQ(differentContours(serial, contours.update()), "");
      EXPECT_EQ(fieldValue(serial, "NodesVisited"),
        fieldValue(contours.Filter->GetOutput(), "NodesVisited"));
      vtkSMPTools::Initialize(0);
      vtkSMPTools::SetBackend(usual.c_str());
      nodes.push_back(fieldValue(serial, "NodesVisited"));
      ASSERT_GT(serial->GetNumberOfPoints(), 150);
      if (builder == vtkCastShadowContour::MORTON)
      {
        first->DeepCopy(serial);
        continue;
      }
      EXPECT_EQ(first->GetNumberOfPoints(), serial->GetNumberOfPoints());
      EXPECT_EQ(fieldValue(first, "LeavesTested"), fieldValue(serial, "LeavesTested"));
      const ChainDifference chains =
        compareChains(chainOf(first), chainOf(serial), tolerance::SamePoint);
      EXPECT_TRUE(chains.none()) << chains.Message;
    }
    EXPECT_NE(nodes[0], nodes[1]);
    EXPECT_NE(nodes[0], nodes[2]);
    EXPECT_GE(fieldValue(first, "BuildSeconds"), 0.0);
    EXPECT_GT(fieldValue(first, "QuerySeconds"), 0.0);
  }
}

TEST(CastShadowContour, SaysWhoCastsOnWhom)
{
  const LightPosition light{ 0.0, 0.0, 1.0, 0.0 };
  const Mesh left = moved(icosphere(2), 1.0, { -3.0, 0.0, 0.0 });
  const Mesh right = moved(icosphere(2), 1.0, { 3.0, 0.0, 0.0 });
  Contours contours({ left, right }, { ground(-2.0, 8.0), ground(-5.0, 8.0) }, light);
  vtkPolyData* lines = contours.update();
  ASSERT_EQ(lines->GetNumberOfLines(), 4);
  int pairs = 0;
  for (vtkIdType line = 0; line < 4; ++line)
  {
    const auto value = [&](const char* name)
    { return static_cast<int>(lines->GetCellData()->GetArray(name)->GetComponent(line, 0)); };
    vtkIdType count;
    const vtkIdType* ids;
    lines->GetLines()->GetCellAtId(line, count, ids);
    EXPECT_NEAR(pointOf(lines, ids[0])[2], value("Receiver") == 0 ? -2.0 : -5.0,
      16.0 * tolerance::SamePoint);
    EXPECT_EQ(pointOf(lines, ids[0])[0] > 0.0, value("Caster") == 1);
    EXPECT_EQ(value("Loop"), 0);
    EXPECT_EQ(value("Visible"), 1);
    pairs |= 1 << (2 * value("Receiver") + value("Caster"));
  }
  EXPECT_EQ(pairs, 15);
}

TEST(CastShadowContour, OnAGrid)
{
  Contours contours({ icosphere(4) }, { ground(-2.0, 8.0, 40) }, { 0.1, 0.0, 1.0, 0.0 });
  const vtkIdType before = contours.update()->GetNumberOfPoints();
  contours.Filter->SetGridSpacing(0.25);
  vtkPolyData* lines = contours.update();
  ASSERT_GT(lines->GetNumberOfPoints(), 10);
  EXPECT_LT(lines->GetNumberOfPoints(), before / 2);
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    for (const double coordinate : pointOf(lines, i))
    {
      EXPECT_EQ(4.0 * coordinate, std::round(4.0 * coordinate));
    }
    EXPECT_NE(pointOf(lines, i), pointOf(lines, (i + 1) % lines->GetNumberOfPoints()));
  }
  contours.Filter->SetGridSpacing(50.0);
  EXPECT_EQ(contours.update()->GetNumberOfLines(), 0);
}

TEST(CastShadowContour, RefusesWhatIsNoScene)
{
  // At a corner, and in the middle of an edge, of a triangle whose border is its silhouette.
  for (const LightPosition& light :
    { LightPosition{ 1.0, 0.0, 0.0, 1.0 }, LightPosition{ 0.5, 0.0, 0.0, 1.0 } })
  {
    Contours on({ triangle() }, { ground(-2.0, 8.0) }, light);
    on.Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, on.Errors);
    EXPECT_EQ(on.update()->GetNumberOfLines(), 0);
    EXPECT_TRUE(on.Errors->GetError());
    EXPECT_NE(on.Errors->GetErrorMessage().find("lies on a silhouette"), std::string::npos);
  }
  Contours different({ box(), box() }, { ground(-2.0, 8.0) }, { 0.0, 0.0, 1.0, 0.0 });
  different.Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, different.Errors);
  different.Silhouettes[1]->SetLightPosition(0.0, 1.0, 1.0, 0.0);
  EXPECT_EQ(different.update()->GetNumberOfLines(), 0);
  EXPECT_NE(different.Errors->GetErrorMessage().find("different lights"), std::string::npos);

  // The same light, as any multiple of its coordinates is.
  Contours same({ box(), box() }, { ground(-2.0, 8.0) }, { 0.0, 0.0, 1.0, 0.0 });
  same.Silhouettes[1]->SetLightPosition(0.0, 0.0, 3.0, 0.0);
  EXPECT_GT(same.update()->GetNumberOfLines(), 0);

  vtkNew<vtkPolyData> nothing;
  Contours noReceiver({ box() }, { nothing }, { 0.0, 0.0, 1.0, 0.0 });
  EXPECT_EQ(noReceiver.update()->GetNumberOfLines(), 0);
  EXPECT_FALSE(noReceiver.Errors->GetError());
  Contours noCaster({ nothing }, { ground(-2.0, 8.0) }, { 0.0, 0.0, 1.0, 0.0 });
  EXPECT_EQ(noCaster.update()->GetNumberOfLines(), 0);
  EXPECT_FALSE(noCaster.Errors->GetError());
}

// A far light's contours are those of its direction, as nearly as it is far.
TEST(CastShadowContour, FarLightsAreDirections)
{
  Random random(43);
  const Mesh field = terrain(random, 20, 9.0, -1.5, 0.4, false);
  const LightPosition direction{ 0.2, 0.3, 1.0, 0.0 };
  Contours toDirection({ starShaped(3, 4) }, { field }, direction);
  const SegmentChain expected = chainOf(toDirection.update());
  ASSERT_GT(expected.Segments.size(), 50u);
  for (const double distance : { 1e6, 1e9, 1e12, 1e15 })
  {
    SCOPED_TRACE(distance);
    Contours far({ starShaped(3, 4) }, { field },
      { 0.2 * distance, 0.3 * distance, distance, 1.0 });
    const SegmentChain found = chainOf(far.update());
    ASSERT_EQ(found.Segments.size(), expected.Segments.size());
    // Rays turn by the scene's size, some 10, over the distance, over a way of as much.
    const double most =
      tolerance::ContourSlant * (100.0 / distance + 10.0 * tolerance::SamePoint);
    const ChainDifference difference = compareChains(expected, found, most);
    EXPECT_TRUE(difference.none()) << difference.Message;
  }
}

TEST(CastShadowContour, SameAtAnyScaleAndPlace)
{
  Random random(44);
  const Mesh caster = starShaped(3, 6);
  const Mesh field = terrain(random, 20, 9.0, -1.5, 0.4, false);
  for (const LightPosition& light : { allLights[0], allLights[1], LightPosition{ 1, -1, 1.5, 1 } })
  {
    Contours usual({ caster }, { field }, light);
    const SegmentChain expected = chainOf(usual.update());
    ASSERT_GT(expected.Segments.size(), 60u);
    struct Change
    {
      double Scale;
      Vec3 Shift;
      double Tolerance;
    };
    for (const Change& change : { Change{ 1e-9, { 0, 0, 0 }, tolerance::Moved },
           Change{ 1e9, { 0, 0, 0 }, tolerance::Moved },
           Change{ 1e-60, { 0, 0, 0 }, tolerance::Moved },
           Change{ 1.0, { 1e7, -2e7, 3e7 }, tolerance::FarPlace } })
    {
      SCOPED_TRACE(change.Scale);
      const LightPosition movedTo = movedLight(light.data(), change.Scale, change.Shift);
      Contours changed({ moved(caster, change.Scale, change.Shift) },
        { moved(field, change.Scale, change.Shift) }, movedTo);
      SegmentChain found = chainOf(changed.update());
      for (DirectedSegment& segment : found.Segments)
      {
        segment.From = 1.0 / change.Scale * (segment.From - change.Shift);
        segment.To = 1.0 / change.Scale * (segment.To - change.Shift);
      }
      const ChainDifference difference =
        compareChains(expected, found, 10.0 * tolerance::ContourSlant * change.Tolerance);
      EXPECT_TRUE(difference.none()) << difference.Message;
      EXPECT_EQ(fieldValue(changed.Filter->GetOutput(), "LooseEnds"), 0.0);
    }
  }
}

// Lines that were made by hand have the filter's own light.
TEST(CastShadowContour, TakesAnyLines)
{
  vtkNew<vtkPolyData> line;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(-1.0, 0.25, 1.0);
  points->InsertNextPoint(1.0, 0.25, 1.0);
  points->InsertNextPoint(std::nan(""), 0.0, 1.0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1 });
  cells->InsertNextCell({ 0, 2 });
  cells->InsertNextCell({ 0, 7 });
  line->SetPoints(points);
  line->SetLines(cells);
  vtkNew<vtkCastShadowContour> filter;
  filter->SetInputData(0, line);
  filter->SetInputData(1, ground(0.0, 8.0, 2));
  filter->SetLightPosition(0.0, 0.0, 3.0, 1.0);
  filter->Update();
  vtkPolyData* lines = filter->GetOutput();
  ASSERT_EQ(lines->GetNumberOfLines(), 1);
  EXPECT_EQ(lines->GetCellData()->GetArray("Closed")->GetComponent(0, 0), 0.0);
  EXPECT_LT(lengthOf(pointOf(lines, 0) - Vec3{ -1.5, 0.375, 0.0 }), tolerance::SamePoint);
  EXPECT_LT(lengthOf(pointOf(lines, lines->GetNumberOfPoints() - 1) - Vec3{ 1.5, 0.375, 0.0 }),
    tolerance::SamePoint);
}
