#include "DrawingView.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
// In distances of the point looked at: what is nearer to the eye is not drawn.
constexpr double NearPlane = 1e-3;
// In widths and heights of the sheet, around its middle: nor is what is farther away.
constexpr double DrawnSheets = 3.0;
constexpr double StepsOnSheet = 500.0;
// In heights of the sheet: shorter pieces would be dots, as lines are wider.
constexpr double ShortestPiece = 1e-3;
constexpr int MostSteps = 10000; // on sheets that are much wider than high

Vector3 Mix(const Vector3& a, const Vector3& b, double share)
{
  return { a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]),
    a[2] + share * (b[2] - a[2]) };
}

double LengthOf(const std::vector<Point2>& piece)
{
  double length = 0.0;
  for (std::size_t i = 1; i < piece.size(); ++i)
  {
    length += std::hypot(piece[i][0] - piece[i - 1][0], piece[i][1] - piece[i - 1][1]);
  }
  return length;
}
}

DrawingView::DrawingView(const Camera& camera, bool parallel, const std::array<int, 2>& size,
  const std::vector<vtkPolyData*>& blockers)
  : Position(camera.Eye)
  , Parallel(parallel)
  , Sight(blockers)
{
  const Vector3 gaze = Along(camera.At, -1.0, camera.Eye);
  this->Distance = Length(gaze);
  this->Forward = Unit(gaze);
  this->Right = Unit(Cross(this->Forward, Unit(camera.Up)));
  this->Up = Cross(this->Right, this->Forward);
  const double degree = std::acos(-1.0) / 180.0;
  this->SheetHeight = 2.0 * this->Distance * std::tan(0.5 * camera.Angle * degree);
  this->SheetWidth = this->SheetHeight * size[0] / size[1];
  this->MakeFrame();
}

Homogeneous DrawingView::Eye() const
{
  const Vector3& f = this->Forward;
  const Vector3& p = this->Position;
  return this->Parallel ? Homogeneous{ -f[0], -f[1], -f[2], 0.0 }
                        : Homogeneous{ p[0], p[1], p[2], 1.0 };
}

void DrawingView::MakeFrame()
{
  const double width = 0.5 * DrawnSheets * this->SheetWidth;
  const double height = 0.5 * DrawnSheets * this->SheetHeight;
  for (const auto& [axis, reach] :
    { std::make_pair(this->Right, width), std::make_pair(this->Up, height) })
  {
    for (const double side : { -1.0, 1.0 })
    {
      const Vector3 inwards = { side * axis[0], side * axis[1], side * axis[2] };
      this->Frame.push_back(this->Parallel
          ? HalfSpace{ inwards, -reach }
          : HalfSpace{ Along(inwards, reach / this->Distance, this->Forward), 0.0 });
    }
  }
  if (!this->Parallel)
  {
    this->Frame.push_back({ this->Forward, NearPlane * this->Distance });
  }
}

std::vector<DrawingView::TestedLine> DrawingView::PartsIn(
  const HalfSpace& space, const TestedLine& line) const
{
  const auto depth = [&](const Vector3& point) {
    return Dot(space.Normal, Along(point, -1.0, this->Position)) - space.Least;
  };
  std::vector<TestedLine> parts;
  bool open = false;
  const auto add = [&](const Vector3& point, const Vector3& test) {
    if (!open)
    {
      parts.emplace_back();
      open = true;
    }
    parts.back().Points.push_back(point);
    parts.back().Tests.push_back(test);
  };
  for (std::size_t i = 0; i < line.Points.size(); ++i)
  {
    const double here = depth(line.Points[i]);
    const double before = i > 0 ? depth(line.Points[i - 1]) : here;
    if ((here > 0.0) != (before > 0.0))
    {
      const double share = before / (before - here);
      add(Mix(line.Points[i - 1], line.Points[i], share),
        Mix(line.Tests[i - 1], line.Tests[i], share));
    }
    if (here > 0.0)
    {
      add(line.Points[i], line.Tests[i]);
    }
    else
    {
      open = false;
    }
  }
  return parts;
}

Point2 DrawingView::Project(const Vector3& point) const
{
  const Vector3 ray = Along(point, -1.0, this->Position);
  const double scale = this->Parallel ? 1.0 : this->Distance / Dot(this->Forward, ray);
  return { scale * Dot(this->Right, ray), scale * Dot(this->Up, ray) };
}

DrawnLine DrawingView::Draw(const Polyline3& line, const Polyline3& tests) const
{
  std::vector<TestedLine> parts = { { line, tests.empty() ? line : tests } };
  for (const HalfSpace& space : this->Frame)
  {
    std::vector<TestedLine> kept;
    for (const TestedLine& part : parts)
    {
      const std::vector<TestedLine> in = this->PartsIn(space, part);
      kept.insert(kept.end(), in.begin(), in.end());
    }
    parts = std::move(kept);
  }
  DrawnLine pieces;
  for (const TestedLine& part : parts)
  {
    this->DrawPart(part, pieces);
  }
  return pieces;
}

void DrawingView::DrawPart(const TestedLine& line, DrawnLine& pieces) const
{
  const auto steps = [&](std::size_t i) {
    const double length =
      LengthOf({ this->Project(line.Points[i]), this->Project(line.Points[i + 1]) });
    return static_cast<int>(std::clamp(
      std::ceil(length * StepsOnSheet / this->SheetHeight), 1.0, static_cast<double>(MostSteps)));
  };
  const auto isSeen = [&](std::size_t i, double share) {
    return this->Sight.IsFree(Mix(line.Tests[i], line.Tests[i + 1], share), this->Eye());
  };
  for (const Polyline3& part : PartsOf(line.Points, isSeen, steps))
  {
    std::vector<Point2> piece;
    for (const Vector3& point : part)
    {
      piece.push_back(this->Project(point));
    }
    const double length = LengthOf(piece);
    if (std::isfinite(length) && length >= ShortestPiece * this->SheetHeight)
    {
      pieces.push_back(piece);
    }
  }
}

std::vector<DrawnLine> DrawingView::DrawAll(vtkPolyData* lines, double outwards) const
{
  vtkDataArray* normals = outwards > 0.0 ? lines->GetPointData()->GetArray("Normals") : nullptr;
  std::vector<DrawnLine> drawn;
  ForEachLine(lines, [&](vtkIdType count, const vtkIdType* ids) {
    const Polyline3 line = PointsOf(lines, count, ids);
    Polyline3 tests;
    for (vtkIdType i = 0; normals && i < count; ++i)
    {
      Vector3 normal;
      normals->GetTuple(ids[i], normal.data());
      tests.push_back(Along(line[static_cast<std::size_t>(i)], outwards, normal));
    }
    drawn.push_back(this->Draw(line, tests));
  });
  return drawn;
}
