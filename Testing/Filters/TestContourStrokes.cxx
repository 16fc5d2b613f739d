#include "MeshBuilder.h"
#include "OutputComparison.h"
#include "Random.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCastShadowContour.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkContourStrokes.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace shadowtest;

namespace
{
using Line = std::vector<Vec3>;

/// Lines that share no points; a closed one returns to the id of its first point.
vtkSmartPointer<vtkPolyData> linesOf(const std::vector<Line>& lines, bool closed = false)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Line& line : lines)
  {
    std::vector<vtkIdType> ids;
    for (const Vec3& point : line)
    {
      ids.push_back(points->InsertNextPoint(point.data()));
    }
    if (closed)
    {
      ids.push_back(ids.front());
    }
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

Vec3 pointOf(vtkPolyData* data, vtkIdType id)
{
  Vec3 point;
  data->GetPoint(id, point.data());
  return point;
}

double lengthOf(const Vec3& v)
{
  return std::sqrt(dot(v, v));
}

double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 way = b - a;
  const double share = std::clamp(dot(p - a, way) / dot(way, way), 0.0, 1.0);
  return lengthOf(p - a - share * way);
}

double distanceToLine(const Vec3& p, const Line& line, bool closed)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < line.size(); ++i)
  {
    nearest = std::min(nearest, distanceToSegment(p, line[i], line[(i + 1) % line.size()]));
  }
  return nearest;
}

/// Twice the signed area of each triangle as seen from +z.
std::vector<double> doubleAreas(vtkPolyData* ribbons)
{
  std::vector<double> areas;
  for (vtkIdType cell = 0; cell < ribbons->GetNumberOfPolys(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    ribbons->GetPolys()->GetCellAtId(cell, count, ids);
    EXPECT_EQ(count, 3);
    const Vec3 a = pointOf(ribbons, ids[0]);
    areas.push_back(cross(pointOf(ribbons, ids[1]) - a, pointOf(ribbons, ids[2]) - a)[2]);
  }
  return areas;
}

/// Whether a triangle has the point (x, y), seen from +z.
bool covers(vtkPolyData* ribbons, const Vec3& p)
{
  for (vtkIdType cell = 0; cell < ribbons->GetNumberOfPolys(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    ribbons->GetPolys()->GetCellAtId(cell, count, ids);
    bool inside = true;
    for (int i = 0; i < 3 && inside; ++i)
    {
      const Vec3 a = pointOf(ribbons, ids[i]);
      inside = cross(pointOf(ribbons, ids[(i + 1) % 3]) - a, p - a)[2] >= 0.0;
    }
    if (inside)
    {
      return true;
    }
  }
  return false;
}

/// What a stroke of a single segment is: at each end its middle and two points to its sides.
struct End
{
  Vec3 middle;
  std::vector<Vec3> offsets;
};

std::vector<End> endsOf(vtkPolyData* ribbon, const Line& segment)
{
  std::vector<End> ends(2);
  EXPECT_EQ(ribbon->GetNumberOfPoints(), 6);
  EXPECT_EQ(ribbon->GetNumberOfPolys(), 4);
  for (std::size_t i = 0; i < 2; ++i)
  {
    ends[i].middle = segment[i];
    for (vtkIdType id = 0; id < ribbon->GetNumberOfPoints(); ++id)
    {
      const Vec3 offset = pointOf(ribbon, id) - segment[i];
      if (lengthOf(offset) < lengthOf(pointOf(ribbon, id) - segment[1 - i]) &&
        offset != Vec3{ 0.0, 0.0, 0.0 })
      {
        ends[i].offsets.push_back(offset);
      }
    }
    EXPECT_EQ(ends[i].offsets.size(), 2u);
  }
  return ends;
}

Vec3 randomPoint(Random& random, double half)
{
  return { random.uniform(-half, half), random.uniform(-half, half), random.uniform(-half, half) };
}

/// A line in z = 0 with turns of all kinds, sharp and short ones among them.
Line zigzag(Random& random, int corners)
{
  Line line{ { 0.0, 0.0, 0.0 } };
  double heading = 0.0;
  for (int i = 0; i < corners; ++i)
  {
    heading += random.uniform(-3.1, 3.1);
    const double step = random.chance(0.3) ? random.uniform(0.01, 0.1) : random.uniform(0.5, 3.0);
    line.push_back(line.back() + Vec3{ step * std::cos(heading), step * std::sin(heading), 0.0 });
  }
  return line;
}

Line circle(int count, double radius)
{
  Line line;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / count;
    line.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0.0 });
  }
  return line;
}

vtkNew<vtkContourStrokes> strokesOf(vtkPolyData* lines, double width)
{
  vtkNew<vtkContourStrokes> strokes;
  strokes->SetInputData(lines);
  strokes->SetWidth(width);
  strokes->SetLift(0.0);
  return strokes;
}

/// Held, as the filter may be gone.
vtkSmartPointer<vtkPolyData> update(vtkContourStrokes* strokes)
{
  strokes->Update();
  return strokes->GetOutput();
}

/// The points in the middle, in their order.
Line middlesOf(vtkPolyData* ribbon)
{
  Line middles;
  vtkDataArray* across = ribbon->GetPointData()->GetArray("Across");
  for (vtkIdType id = 0; id < ribbon->GetNumberOfPoints(); ++id)
  {
    if (across->GetComponent(id, 0) == 0.0)
    {
      middles.push_back(pointOf(ribbon, id));
    }
  }
  return middles;
}
}

TEST(ContourStrokes, WidthIsExactInWorldUnits)
{
  Random random(1);
  for (int round = 0; round < 50; ++round)
  {
    const Line segment = { randomPoint(random, 1.0), randomPoint(random, 1.0) };
    const Vec3 eye = randomPoint(random, 5.0);
    const bool isPoint = round % 2 == 0;
    const double width = random.uniform(0.001, 0.1);
    const auto strokes = strokesOf(linesOf({ segment }), width);
    strokes->SetEyePosition(eye[0], eye[1], eye[2], isPoint ? 1.0 : 0.0);
    auto ribbon = update(strokes);
    for (const End& end : endsOf(ribbon, segment))
    {
      const Vec3 sight = normalized(isPoint ? eye - end.middle : eye);
      for (const Vec3& offset : end.offsets)
      {
        EXPECT_NEAR(lengthOf(offset), 0.5 * width, tolerance::SamePoint);
        EXPECT_NEAR(dot(offset, sight), 0.0, tolerance::SamePoint);
        EXPECT_NEAR(dot(offset, segment[1] - segment[0]), 0.0, tolerance::SamePoint);
      }
      EXPECT_LT(lengthOf(end.offsets[0] + end.offsets[1]), tolerance::SamePoint);
    }
    // It faces the eye.
    for (vtkIdType cell = 0; cell < ribbon->GetNumberOfPolys(); ++cell)
    {
      vtkIdType count;
      const vtkIdType* ids;
      ribbon->GetPolys()->GetCellAtId(cell, count, ids);
      const Vec3 a = pointOf(ribbon, ids[0]);
      const Vec3 normal = cross(pointOf(ribbon, ids[1]) - a, pointOf(ribbon, ids[2]) - a);
      EXPECT_GT(dot(normal, isPoint ? eye - a : eye), 0.0);
    }
  }
}

TEST(ContourStrokes, WidthIsExactInPixels)
{
  Random random(2);
  for (int round = 0; round < 50; ++round)
  {
    const bool isPoint = round % 2 == 0;
    Vec3 forward;
    random.direction(forward.data());
    const Vec3 right = normalized(cross(forward, { 0.3, 0.5, 0.7 }));
    const Vec3 up = cross(right, forward);
    const Vec3 eye = randomPoint(random, 1.0) - 8.0 * forward;
    const Line segment = { randomPoint(random, 2.0), randomPoint(random, 2.0) };
    const double pixel = random.uniform(0.001, 0.01);
    const auto strokes = strokesOf(linesOf({ segment }), 3.0);
    strokes->SetWidthUnitToPixels();
    strokes->SetEyePosition(isPoint ? eye[0] : -forward[0], isPoint ? eye[1] : -forward[1],
      isPoint ? eye[2] : -forward[2], isPoint ? 1.0 : 0.0);
    strokes->SetViewDirection(2.0 * forward[0], 2.0 * forward[1], 2.0 * forward[2]);
    strokes->SetPixelSize(pixel);
    const auto inPicture = [&](const Vec3& point) {
      const Vec3 ray = point - eye;
      const double scale = pixel * (isPoint ? dot(ray, forward) : 1.0);
      return Vec3{ dot(ray, right) / scale, dot(ray, up) / scale, 0.0 };
    };
    for (const End& end : endsOf(update(strokes), segment))
    {
      const Vec3 along = normalized(inPicture(segment[1]) - inPicture(segment[0]));
      for (const Vec3& offset : end.offsets)
      {
        const Vec3 seen = inPicture(end.middle + offset) - inPicture(end.middle);
        EXPECT_NEAR(lengthOf(seen), 1.5, 1e4 * tolerance::SamePoint);
        EXPECT_NEAR(dot(seen, along), 0.0, 1e4 * tolerance::SamePoint);
      }
    }
  }
}

// No gap at any corner, nothing turned over, and nothing farther away than the longest mitre.
TEST(ContourStrokes, CornersAreFilled)
{
  Random random(3);
  const double width = 0.2;
  int sampled = 0;
  for (int round = 0; round < 40; ++round)
  {
    SCOPED_TRACE("round " + std::to_string(round));
    const Line line = zigzag(random, 9);
    const bool closed = round % 2 == 1;
    auto ribbon = update(strokesOf(linesOf({ line }, closed), width));
    for (const double area : doubleAreas(ribbon))
    {
      EXPECT_GE(area, -width * tolerance::SamePoint);
    }
    double farthest = 0.0;
    for (vtkIdType id = 0; id < ribbon->GetNumberOfPoints(); ++id)
    {
      farthest = std::max(farthest, distanceToLine(pointOf(ribbon, id), line, closed));
    }
    EXPECT_LT(farthest, width * (1.0 + tolerance::SamePoint));
    EXPECT_GT(farthest, 0.5 * width * (1.0 - tolerance::SamePoint));
    for (int i = 0; i < 300; ++i)
    {
      // Around corners above all, which are round to a fiftieth: cos(pi / 16).
      const auto corner =
        static_cast<std::size_t>(random.integer(0, static_cast<int>(line.size()) - 1));
      const Vec3 place =
        line[corner] + Vec3{ random.uniform(-width, width), random.uniform(-width, width), 0.0 };
      const bool isAtEnd = !closed &&
        std::min(lengthOf(place - line.front()), lengthOf(place - line.back())) < 0.5 * width;
      if (!isAtEnd && distanceToLine(place, line, closed) < 0.49 * width)
      {
        EXPECT_TRUE(covers(ribbon, place)) << place[0] << ", " << place[1];
        ++sampled;
      }
    }
  }
  EXPECT_GT(sampled, 2000);
}

// The same of lines in space, in both units: seen from the eye each triangle is counter-clockwise.
TEST(ContourStrokes, NothingIsTurnedOver)
{
  Random random(5);
  vtkIdType triangles = 0;
  for (int round = 0; round < 200; ++round)
  {
    SCOPED_TRACE("round " + std::to_string(round));
    Line line;
    for (int i = 0; i < 12; ++i)
    {
      const bool isShort = i > 0 && random.chance(0.4);
      line.push_back(isShort ? line.back() + randomPoint(random, 0.03) : randomPoint(random, 1.0));
    }
    const auto strokes = strokesOf(linesOf({ line }, round % 3 == 0), 0.05);
    const Vec3 eye = { 0.0, 0.0, 4.0 };
    strokes->SetEyePosition(eye[0], eye[1], eye[2], 1.0);
    if (round % 2 == 0)
    {
      strokes->SetWidthUnitToPixels();
      strokes->SetWidth(6.0);
      strokes->SetPixelSize(0.002);
    }
    strokes->SetTaper(round % 5 == 0 ? 0.4 : 0.0);
    strokes->SetWobble(round % 7 == 0 ? 0.3 : 0.0);
    const auto ribbon = update(strokes);
    triangles += ribbon->GetNumberOfPolys();
    for (vtkIdType cell = 0; cell < ribbon->GetNumberOfPolys(); ++cell)
    {
      vtkIdType count;
      const vtkIdType* ids;
      ribbon->GetPolys()->GetCellAtId(cell, count, ids);
      const Vec3 a = pointOf(ribbon, ids[0]);
      const Vec3 normal = cross(pointOf(ribbon, ids[1]) - a, pointOf(ribbon, ids[2]) - a);
      EXPECT_GT(dot(normal, eye - a), -tolerance::SamePoint);
    }
  }
  EXPECT_GT(triangles, 10000);
}

TEST(ContourStrokes, MitredAndRoundCorners)
{
  // A right angle has its mitre's tip; a turn of 160 degrees none.
  for (const bool sharp : { false, true })
  {
    const double angle = (sharp ? 20.0 : 90.0) * std::acos(-1.0) / 180.0;
    const Line line = { { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 },
      { std::cos(angle), std::sin(angle), 0.0 } };
    auto ribbon = update(strokesOf(linesOf({ line }), 0.2));
    double farthest = 0.0;
    for (vtkIdType id = 0; id < ribbon->GetNumberOfPoints(); ++id)
    {
      farthest = std::max(farthest, distanceToLine(pointOf(ribbon, id), line, false));
    }
    EXPECT_NEAR(farthest, sharp ? 0.1 : 0.1 * std::sqrt(2.0), tolerance::SamePoint);
    EXPECT_EQ(ribbon->GetNumberOfPolys() > 8, sharp);
  }
}

TEST(ContourStrokes, ClosedLinesClose)
{
  const Line line = circle(60, 2.0);
  for (const bool closed : { false, true })
  {
    auto ribbon = update(strokesOf(linesOf({ line }, closed), 0.1));
    EXPECT_EQ(ribbon->GetNumberOfPolys(), 4 * (closed ? 60 : 59));
    EXPECT_EQ(ribbon->GetNumberOfPoints(), 180);
    // Between the first and the last point.
    EXPECT_EQ(covers(ribbon, 0.5 * (line.front() + line.back())), closed);
    double area = 0.0;
    for (const double part : doubleAreas(ribbon))
    {
      EXPECT_GT(part, 0.0);
      area += 0.5 * part;
    }
    const double side = lengthOf(line[1] - line[0]);
    EXPECT_EQ(std::fabs(area - 60.0 * side * 0.1) < 60.0 * tolerance::SamePoint, closed);
  }
  // Equal coordinates close a line, too. Neither taper nor overshoot has an end to be at.
  Line repeated = line;
  repeated.push_back(line.front());
  const auto strokes = strokesOf(linesOf({ repeated }), 0.1);
  strokes->SetTaper(0.3);
  strokes->SetOvershoot(2.0);
  EXPECT_EQ(update(strokes)->GetNumberOfPolys(), 240);
}

TEST(ContourStrokes, LeavesOutWhatCannotBeDrawn)
{
  vtkNew<vtkPolyData> nothing;
  EXPECT_EQ(update(strokesOf(nothing, 1.0))->GetNumberOfCells(), 0);

  const double nan = std::nan("");
  const Vec3 a{ 0.0, 0.0, 0.0 };
  const Vec3 b{ 1.0, 0.0, 0.0 };
  const Vec3 c{ 2.0, 0.0, 0.0 };
  // Twice without length, once repeated points, once parted, once twice not finite.
  const auto lines =
    linesOf({ { a }, { b, b, b }, { a, a, b, b, c }, { a, b, { nan, 0.0, 0.0 }, a, c },
      { { 0.0, nan, 0.0 }, { 0.0, 0.0, std::numeric_limits<double>::infinity() } } });
  lines->GetLines()->InsertNextCell({ 0, 4, 999, -1 });
  lines->GetLines()->InsertNextCell(0);
  const auto strokes = strokesOf(lines, 0.1);
  auto ribbons = update(strokes);
  std::vector<int> triangles(7);
  for (vtkIdType cell = 0; cell < ribbons->GetNumberOfPolys(); ++cell)
  {
    const double line = ribbons->GetCellData()->GetArray("Line")->GetComponent(cell, 0);
    ++triangles.at(static_cast<std::size_t>(line));
  }
  // The last one has two points at one place.
  EXPECT_EQ(triangles, (std::vector<int>{ 0, 0, 8, 8, 0, 0, 0 }));
  EXPECT_EQ(fieldValue(ribbons, "NonFinitePoints"), 5.0);
  EXPECT_EQ(fieldValue(ribbons, "DegenerateLines"), 3.0);
  EXPECT_EQ(fieldValue(ribbons, "HiddenPoints"), 0.0);
  for (vtkIdType id = 0; id < ribbons->GetNumberOfPoints(); ++id)
  {
    EXPECT_TRUE(std::isfinite(lengthOf(pointOf(ribbons, id))));
  }

  // A closed line without one of its points is one piece that starts behind that.
  Line broken = circle(20, 1.0);
  broken[7][1] = nan;
  ribbons = update(strokesOf(linesOf({ broken }, true), 0.1));
  EXPECT_EQ(ribbons->GetNumberOfPolys(), 4 * 18);
  EXPECT_EQ(fieldValue(ribbons, "NonFinitePoints"), 1.0);

  // Along the line of sight nothing is seen of it, and nothing breaks.
  const Line bent = { a, { 0.0, 0.0, 1.0 }, { 1.0, 0.0, 1.0 } };
  const auto sight = strokesOf(linesOf({ bent }), 0.1);
  ribbons = update(sight);
  ASSERT_EQ(ribbons->GetNumberOfPoints(), 9);
  for (vtkIdType id = 0; id < 9; ++id)
  {
    const double across = ribbons->GetPointData()->GetArray("Across")->GetComponent(id, 0);
    EXPECT_NEAR(distanceToLine(pointOf(ribbons, id), bent, false), across == 0.0 ? 0.0 : 0.05,
      tolerance::SamePoint);
  }
  sight->SetWobble(0.5);
  ribbons = update(sight);
  ASSERT_GT(ribbons->GetNumberOfPolys(), 8);
  for (vtkIdType id = 0; id < ribbons->GetNumberOfPoints(); ++id)
  {
    EXPECT_TRUE(std::isfinite(lengthOf(pointOf(ribbons, id))));
  }
}

TEST(ContourStrokes, PixelsNeedPointsBeforeTheEye)
{
  const auto strokes = strokesOf(
    linesOf({ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, 0.0, 9.0 }, { 0.0, 1.0, 5.0 } } }),
    2.0);
  strokes->SetWidthUnitToPixels();
  strokes->SetEyePosition(0.0, 0.0, 5.0, 1.0);
  auto ribbon = update(strokes);
  EXPECT_EQ(fieldValue(ribbon, "HiddenPoints"), 2.0);
  EXPECT_EQ(ribbon->GetNumberOfPolys(), 4);

  vtkNew<vtkTest::ErrorObserver> errors;
  strokes->AddObserver(vtkCommand::ErrorEvent, errors);
  strokes->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  strokes->SetViewDirection(0.0, 0.0, 0.0);
  EXPECT_EQ(update(strokes)->GetNumberOfCells(), 0);
  EXPECT_NE(errors->GetErrorMessage().find("ViewDirection (0, 0, 0)"), std::string::npos);
  errors->Clear();
  strokes->SetWidthUnitToWorld();
  EXPECT_GE(update(strokes)->GetNumberOfPolys(), 12);
  strokes->SetEyePosition(0.0, std::nan(""), 0.0, 1.0);
  EXPECT_EQ(update(strokes)->GetNumberOfCells(), 0);
  EXPECT_NE(errors->GetErrorMessage().find("EyePosition (0, nan, 0, 1)"), std::string::npos);
}

TEST(ContourStrokes, SameForAnyNumberOfThreads)
{
  Random random(4);
  std::vector<Line> lines;
  for (int i = 0; i < 300; ++i)
  {
    lines.push_back(zigzag(random, random.integer(1, 20)));
  }
  const auto strokes = strokesOf(linesOf(lines), 0.1);
  strokes->SetWobble(0.4);
  strokes->SetTaper(0.2);
  strokes->SetOvershoot(1.0);
  const std::string usual = vtkSMPTools::GetBackend();
  ASSERT_TRUE(vtkSMPTools::SetBackend("Sequential"));
  vtkNew<vtkPolyData> serial;
  serial->DeepCopy(update(strokes));
  ASSERT_TRUE(vtkSMPTools::SetBackend("STDThread"));
  vtkSMPTools::Initialize(4);
  strokes->Modified();
  auto threaded = update(strokes);
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(usual.c_str());
  ASSERT_GT(serial->GetNumberOfPolys(), 3000);
  EXPECT_TRUE(sameBytes(serial->GetPoints()->GetData(), threaded->GetPoints()->GetData()));
  EXPECT_TRUE(sameBytes(
    serial->GetPolys()->GetConnectivityArray(), threaded->GetPolys()->GetConnectivityArray()));
  EXPECT_EQ(differingArray(serial->GetCellData(), threaded->GetCellData()), "");
}

TEST(ContourStrokes, WobbleStaysWithinItsBound)
{
  // Two lines of 500 widths.
  const double width = 0.02;
  const Line segment = { { 0.0, 0.0, 0.0 }, { 10.0, 0.0, 0.0 } };
  const auto strokes = strokesOf(linesOf({ segment, segment }), width);
  strokes->SetWobble(1.5);
  std::set<Line> different;
  for (const int seed : { 1, 2, 1 })
  {
    strokes->SetSeed(seed);
    strokes->Modified();
    const Line middles = middlesOf(update(strokes));
    ASSERT_GT(middles.size(), 2u * 8u * 12u);
    double least = 0.0;
    double most = 0.0;
    for (const Vec3& point : middles)
    {
      least = std::min(least, point[1]);
      most = std::max(most, point[1]);
      EXPECT_EQ(point[2], 0.0);
    }
    EXPECT_LE(most, 1.5 * width);
    EXPECT_GE(least, -1.5 * width);
    EXPECT_GT(most, 0.7 * width);
    EXPECT_LT(least, -0.7 * width);
    different.insert(middles);
    // Each line has its own: no point but by chance is there twice.
    EXPECT_EQ(std::set<Vec3>(middles.begin(), middles.end()).size(), middles.size());
  }
  EXPECT_EQ(different.size(), 2u);
  // Where it is asked for less often there are fewer points.
  const vtkIdType before = strokes->GetOutput()->GetNumberOfPoints();
  strokes->SetWobbleLength(160.0);
  EXPECT_LT(update(strokes)->GetNumberOfPoints(), before / 2);

  // All around a closed line it is smooth: over a segment, 1.6 widths, it changes by no more than
  // 1.5 times as much as it would evenly from -1 to 1 over 40 widths.
  const auto around = strokesOf(linesOf({ circle(400, 2.0) }, true), width);
  around->SetWobble(1.0);
  std::vector<double> radii;
  for (const Vec3& point : middlesOf(update(around)))
  {
    radii.push_back(lengthOf(point));
  }
  ASSERT_GT(radii.size(), 400u);
  const auto [low, high] = std::minmax_element(radii.begin(), radii.end());
  EXPECT_GT(*high - *low, width);
  EXPECT_LE(*high, 2.0 + width);
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    EXPECT_LT(std::fabs(radii[i] - radii[(i + 1) % radii.size()]), 0.12 * width);
  }
}

// A short line is hardly unsteady: over a tenth of the way from one random number to the next the
// curve moves by less than 3% of the way between them, which is at most 2.
TEST(ContourStrokes, ShortLinesAreSteady)
{
  const double width = 0.02;
  std::vector<Line> lines;
  for (int i = 0; i < 50; ++i)
  {
    lines.push_back({ { 0.0, 0.1 * i, 0.0 }, { 4.0 * width, 0.1 * i, 0.0 } });
  }
  const auto strokes = strokesOf(linesOf(lines), width);
  strokes->SetWobble(1.0);
  const Line middles = middlesOf(update(strokes));
  ASSERT_EQ(middles.size(), 2 * lines.size());
  double most = 0.0;
  for (std::size_t i = 0; i < middles.size(); i += 2)
  {
    const double change = (middles[i + 1] - lines[i / 2][1])[1] - (middles[i] - lines[i / 2][0])[1];
    most = std::max(most, std::fabs(change));
  }
  EXPECT_GT(most, 0.02 * width);
  EXPECT_LT(most, 0.06 * width);
}

// Coordinates and widths at the ends of what doubles hold neither hang nor give what is not finite.
TEST(ContourStrokes, ExtremeLengths)
{
  for (const double size : { 1e-200, 1e150, 1e300 })
  {
    for (const double width : { 1e-300, 1.0, 1e200 })
    {
      const auto strokes = strokesOf(
        linesOf({ { { 0.0, 0.0, 0.0 }, { size, 0.0, 0.0 }, { size, size, 0.0 } } }), width);
      strokes->SetWobble(0.5);
      strokes->SetTaper(0.2);
      strokes->SetOvershoot(1.0);
      strokes->SetLift(0.5);
      const auto ribbon = update(strokes);
      EXPECT_GE(ribbon->GetNumberOfPoints(), 3);
      EXPECT_LT(ribbon->GetNumberOfPoints(), 200000);
      for (vtkIdType id = 0; id < ribbon->GetNumberOfPoints(); ++id)
      {
        for (const double coordinate : pointOf(ribbon, id))
        {
          EXPECT_TRUE(std::isfinite(coordinate)) << size << ", " << width;
        }
      }
    }
  }
}

TEST(ContourStrokes, TapersFromNothing)
{
  const Line line = { { 0.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 10.0, 0.0, 0.0 } };
  const auto strokes = strokesOf(linesOf({ line }), 0.3);
  for (const double taper : { 0.25, 0.5 })
  {
    strokes->SetTaper(taper);
    auto ribbon = update(strokes);
    std::set<double> places;
    for (vtkIdType id = 0; id < ribbon->GetNumberOfPoints(); ++id)
    {
      const Vec3 point = pointOf(ribbon, id);
      const double share = std::min(1.0, std::min(point[0], 10.0 - point[0]) / (10.0 * taper));
      places.insert(point[0]);
      const double across = ribbon->GetPointData()->GetArray("Across")->GetComponent(id, 0);
      EXPECT_NEAR(point[1], 0.15 * share * across, tolerance::SamePoint);
    }
    EXPECT_EQ(places.size(), taper == 0.25 ? 5u : 4u); // ends, middle, and where it is wide
    for (const double area : doubleAreas(ribbon))
    {
      EXPECT_GT(area, 0.0);
    }
    double area = 0.0;
    for (const double part : doubleAreas(ribbon))
    {
      area += 0.5 * part;
    }
    EXPECT_NEAR(area, 0.3 * 10.0 * (1.0 - taper), 10.0 * tolerance::SamePoint);
  }
}

TEST(ContourStrokes, OvershootsByWidths)
{
  const Line line = { { 0.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 4.0, 3.0, 0.0 } };
  const auto strokes = strokesOf(linesOf({ line }), 0.1);
  strokes->SetOvershoot(2.5);
  auto ribbon = update(strokes);
  EXPECT_NEAR(ribbon->GetBounds()[0], -0.25, tolerance::SamePoint);
  EXPECT_NEAR(ribbon->GetBounds()[3], 3.25, tolerance::SamePoint);
  EXPECT_NEAR(ribbon->GetBounds()[1], 4.05, tolerance::SamePoint);
  EXPECT_EQ(ribbon->GetNumberOfPolys(), 8);
}

TEST(ContourStrokes, LiftedOffTheReceiverIntoTheShadow)
{
  vtkNew<vtkSmoothLightSilhouette> silhouette;
  silhouette->SetInputData(icosphere(3));
  silhouette->SetLightPosition(0.4, 0.3, 1.0, 0.0);
  vtkNew<vtkCastShadowContour> contour;
  contour->SetSilhouetteConnection(silhouette->GetOutputPort());
  contour->AddInputData(1, ground(-2.0, 8.0, 5));
  contour->Update();
  vtkPolyData* line = contour->GetOutput();
  ASSERT_EQ(line->GetNumberOfLines(), 1);
  const double width = 0.05;
  const auto strokes = strokesOf(line, width);
  strokes->SetLift(0.5);
  strokes->SetEyePosition(3.0, -9.0, 4.0, 1.0);
  auto ribbon = update(strokes);
  ASSERT_EQ(middlesOf(ribbon).size(), static_cast<std::size_t>(line->GetNumberOfPoints()));
  EXPECT_GT(ribbon->GetBounds()[4], -2.0); // no part of it is under the ground
  for (vtkIdType id = 0; id < line->GetNumberOfPoints(); ++id)
  {
    Vec3 into;
    line->GetPointData()->GetArray("ShadowDirection")->GetTuple(id, into.data());
    const Vec3 wanted = pointOf(line, id) + 0.5 * width * (into + Vec3{ 0.0, 0.0, 1.0 });
    EXPECT_LT(lengthOf(middlesOf(ribbon)[static_cast<std::size_t>(id)] - wanted),
      10.0 * tolerance::SamePoint);
  }
  // The contour's own data come along.
  EXPECT_EQ(ribbon->GetCellData()->GetArray("Visible")->GetComponent(7, 0), 1.0);
  EXPECT_NE(ribbon->GetPointData()->GetArray("CasterPoints"), nullptr);
  EXPECT_EQ(fieldValue(ribbon, "LightPosition"), 0.4);

  // Other lines come nearer to the eye.
  const Line segment = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } };
  const auto towards = strokesOf(linesOf({ segment }), 0.2);
  towards->SetLift(0.75);
  towards->SetEyePosition(0.0, 0.0, 6.0, 0.0);
  EXPECT_NEAR(update(towards)->GetBounds()[4], 0.15, tolerance::SamePoint);
  EXPECT_NEAR(towards->GetOutput()->GetBounds()[5], 0.15, tolerance::SamePoint);
}

TEST(ContourStrokes, DataComeAlong)
{
  const auto lines =
    linesOf({ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 }, { 1.0, 1.0, 0.0 } } });
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  lines->SetVerts(vertices);
  vtkNew<vtkDoubleArray> values;
  values->SetName("X");
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType id = 0; id < 4; ++id)
  {
    values->InsertNextValue(pointOf(lines, id)[0]);
  }
  for (const int number : { 5, 6, 7 })
  {
    numbers->InsertNextValue(number);
  }
  lines->GetPointData()->AddArray(values);
  lines->GetCellData()->AddArray(numbers);
  const auto strokes = strokesOf(lines, 0.01);
  strokes->SetTaper(0.3);
  auto ribbons = update(strokes);
  ASSERT_EQ(
    ribbons->GetPointData()->GetArray("X")->GetNumberOfTuples(), ribbons->GetNumberOfPoints());
  for (vtkIdType id = 0; id < ribbons->GetNumberOfPoints(); ++id)
  {
    EXPECT_NEAR(ribbons->GetPointData()->GetArray("X")->GetComponent(id, 0),
      pointOf(ribbons, id)[0], tolerance::SamePoint);
  }
  std::set<double> found;
  for (vtkIdType cell = 0; cell < ribbons->GetNumberOfPolys(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    ribbons->GetPolys()->GetCellAtId(cell, count, ids);
    const double number = ribbons->GetCellData()->GetArray("Number")->GetComponent(cell, 0);
    EXPECT_EQ(number, pointOf(ribbons, ids[0])[1] > 0.5 ? 7.0 : 6.0);
    EXPECT_EQ(ribbons->GetCellData()->GetArray("Line")->GetComponent(cell, 0), number - 6.0);
    found.insert(number);
  }
  EXPECT_EQ(found.size(), 2u);
}

/// Arrays that have too few values are left out, not read beyond their end.
TEST(ContourStrokes, ArraysThatAreTooShort)
{
  const auto lines = linesOf({ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 2.0, 1.0, 0.0 } } });
  for (const char* name : { "ReceiverNormals", "ShadowDirection", "Other" })
  {
    vtkNew<vtkDoubleArray> vectors;
    vectors->SetName(name);
    vectors->SetNumberOfComponents(3);
    vectors->InsertNextTuple3(0.0, 0.0, 1.0);
    lines->GetPointData()->AddArray(vectors);
  }
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Numbers");
  lines->GetCellData()->AddArray(numbers);
  vtkNew<vtkContourStrokes> strokes;
  strokes->SetInputData(lines);
  strokes->SetWidthUnitToWorld();
  strokes->SetWidth(0.1);
  strokes->SetEyePosition(0.0, 0.0, 10.0, 1.0);
  strokes->Update();
  vtkPolyData* ribbons = strokes->GetOutput();
  ASSERT_GT(ribbons->GetNumberOfPolys(), 0);
  EXPECT_FALSE(ribbons->GetPointData()->HasArray("Other"));
  EXPECT_FALSE(ribbons->GetCellData()->HasArray("Numbers"));
  double bounds[6];
  ribbons->GetBounds(bounds);
  EXPECT_LT(bounds[1] - bounds[0], 2.5);
}

/// VTK's limits of settings let NaN through.
TEST(ContourStrokes, SettingsThatAreNotFinite)
{
  const auto lines = linesOf({ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } } });
  vtkNew<vtkContourStrokes> strokes;
  vtkNew<vtkTest::ErrorObserver> errors;
  strokes->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  strokes->AddObserver(vtkCommand::ErrorEvent, errors);
  strokes->SetInputData(lines);
  strokes->SetLift(std::numeric_limits<double>::quiet_NaN());
  strokes->Update();
  EXPECT_TRUE(errors->GetError());
  EXPECT_NE(errors->GetErrorMessage().find("Lift"), std::string::npos);
  EXPECT_EQ(strokes->GetOutput()->GetNumberOfPolys(), 0);
}
