#include "DrawingView.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace
{
// In sizes of the scene: a line lies on the surface, from which rays to the eye begin this far away.
constexpr double Bias = 1e-5;
// In distances of the point looked at: what is nearer to the eye is not drawn.
constexpr double NearPlane = 1e-3;
constexpr double StepsOnSheet = 500.0;
// In heights of the sheet: shorter pieces would be dots, as lines are wider.
constexpr double ShortestPiece = 1e-3;
constexpr int Halvings = 12;
constexpr int MostSteps = 10000; // a segment that comes near to the eye is seen very long

double Dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3 Cross(const Vector3& a, const Vector3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Vector3 Mix(const Vector3& a, const Vector3& b, double share)
{
  return { a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]),
    a[2] + share * (b[2] - a[2]) };
}

Vector3 Along(const Vector3& a, double s, const Vector3& b)
{
  return { a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2] };
}

Vector3 Unit(const Vector3& a)
{
  const double length = std::sqrt(Dot(a, a));
  return { a[0] / length, a[1] / length, a[2] / length };
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

DrawingView::DrawingView(const Camera& camera, bool parallel, const std::array<int, 2>& size)
  : Position(camera.Eye)
  , Parallel(parallel)
{
  const Vector3 gaze = Along(camera.At, -1.0, camera.Eye);
  this->Distance = std::sqrt(Dot(gaze, gaze));
  this->Forward = Unit(gaze);
  this->Right = Unit(Cross(this->Forward, Unit(camera.Up)));
  this->Up = Cross(this->Right, this->Forward);
  const double degree = std::acos(-1.0) / 180.0;
  this->SheetHeight = 2.0 * this->Distance * std::tan(0.5 * camera.Angle * degree);
  this->SheetWidth = this->SheetHeight * size[0] / size[1];
}

void DrawingView::SetBlockers(const std::vector<vtkPolyData*>& meshes)
{
  vtkNew<vtkAppendPolyData> all;
  all->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (vtkPolyData* mesh : meshes)
  {
    all->AddInputData(mesh);
  }
  all->Update();
  this->Blockers->SetPoints(all->GetOutput()->GetPoints());
  this->Blockers->SetPolys(all->GetOutput()->GetPolys());
  this->Size = this->Blockers->GetLength();
  this->Locator->SetDataSet(this->Blockers);
  this->Locator->BuildLocator();
}

Homogeneous DrawingView::Eye() const
{
  const Vector3& f = this->Forward;
  const Vector3& p = this->Position;
  return this->Parallel ? Homogeneous{ -f[0], -f[1], -f[2], 0.0 }
                        : Homogeneous{ p[0], p[1], p[2], 1.0 };
}

bool DrawingView::IsBefore(const Vector3& point) const
{
  return this->Parallel ||
    Dot(this->Forward, Along(point, -1.0, this->Position)) > NearPlane * this->Distance;
}

Point2 DrawingView::Project(const Vector3& point) const
{
  const Vector3 ray = Along(point, -1.0, this->Position);
  const double scale = this->Parallel ? 1.0 : this->Distance / Dot(this->Forward, ray);
  return { scale * Dot(this->Right, ray), scale * Dot(this->Up, ray) };
}

bool DrawingView::IsSeen(const Vector3& point) const
{
  if (!this->IsBefore(point))
  {
    return false;
  }
  if (this->Size == 0.0)
  {
    return true;
  }
  // Of parallel projection the eye is beyond all that could block.
  const Vector3 away = Along(point, -1.0, this->Position);
  const Vector3 eye = this->Parallel
    ? Along(point, -2.0 * (this->Size + std::sqrt(Dot(away, away))), this->Forward)
    : this->Position;
  Vector3 start = Along(point, Bias * this->Size, Unit(Along(eye, -1.0, point)));
  Vector3 end = eye;
  double at;
  Vector3 hit;
  double parametric[3];
  int part;
  vtkIdType cell;
  return this->Locator->IntersectWithLine(
           start.data(), end.data(), 0.0, at, hit.data(), parametric, part, cell) == 0;
}

DrawnLine DrawingView::Draw(
  const std::vector<Vector3>& line, const std::vector<Vector3>& tests) const
{
  const std::vector<Vector3>& looked = tests.empty() ? line : tests;
  DrawnLine pieces;
  bool seen = !line.empty() && this->IsSeen(looked[0]);
  if (seen)
  {
    pieces.push_back({ this->Project(line[0]) });
  }
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    const auto isSeen = [&](double share)
    { return this->IsSeen(Mix(looked[i], looked[i + 1], share)); };
    const auto place = [&](double share)
    { return this->Project(Mix(line[i], line[i + 1], share)); };
    int steps = MostSteps;
    if (this->IsBefore(line[i]) && this->IsBefore(line[i + 1]))
    {
      const Point2 from = place(0.0);
      const Point2 to = place(1.0);
      const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
      steps = static_cast<int>(std::clamp(std::ceil(length * StepsOnSheet / this->SheetHeight), 1.0,
        static_cast<double>(MostSteps)));
    }
    for (int step = 1; step <= steps; ++step)
    {
      double before = static_cast<double>(step - 1) / steps;
      double after = static_cast<double>(step) / steps;
      if (isSeen(after) == seen)
      {
        continue;
      }
      for (int halving = 0; halving < Halvings; ++halving)
      {
        const double middle = 0.5 * (before + after);
        (isSeen(middle) == seen ? before : after) = middle;
      }
      const double change = seen ? before : after;
      if (seen)
      {
        pieces.back().push_back(place(change));
      }
      else
      {
        pieces.push_back({ place(change) });
      }
      seen = !seen;
    }
    if (seen)
    {
      pieces.back().push_back(place(1.0));
    }
  }
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                 [this](const std::vector<Point2>& piece)
                 { return LengthOf(piece) < ShortestPiece * this->SheetHeight; }),
    pieces.end());
  return pieces;
}

std::vector<DrawnLine> DrawingView::DrawAll(vtkPolyData* lines, double outwards) const
{
  vtkDataArray* normals =
    outwards > 0.0 ? lines->GetPointData()->GetArray("Normals") : nullptr;
  std::vector<DrawnLine> drawn;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfLines(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    lines->GetLines()->GetCellAtId(cell, count, ids);
    std::vector<Vector3> line;
    std::vector<Vector3> tests;
    for (vtkIdType i = 0; i < count; ++i)
    {
      Vector3 point;
      lines->GetPoint(ids[i], point.data());
      line.push_back(point);
      if (normals)
      {
        Vector3 normal;
        normals->GetTuple(ids[i], normal.data());
        tests.push_back(Along(point, outwards, normal));
      }
    }
    drawn.push_back(this->Draw(line, tests));
  }
  return drawn;
}
