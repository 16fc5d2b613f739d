#include "PolylineDistance.h"

#include <vtkCellArray.h>
#include <vtkLine.h>
#include <vtkMath.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shadowtest
{
namespace
{
/// Calls visit(p, q) with the ends of each segment of a line.
template <class Visit>
void forEachSegment(vtkPolyData* polylines, vtkIdType line, const Visit& visit)
{
  vtkIdType size;
  const vtkIdType* ids;
  polylines->GetLines()->GetCellAtId(line, size, ids);
  for (vtkIdType i = 0; i + 1 < size; ++i)
  {
    double p[3];
    double q[3];
    polylines->GetPoint(ids[i], p);
    polylines->GetPoint(ids[i + 1], q);
    visit(p, q);
  }
}

/// The same for all lines.
template <class Visit>
void forEachSegment(vtkPolyData* polylines, const Visit& visit)
{
  for (vtkIdType line = 0; line < polylines->GetLines()->GetNumberOfCells(); ++line)
  {
    forEachSegment(polylines, line, visit);
  }
}

double farthestFrom(vtkPolyData* polylines, vtkPolyData* points)
{
  double farthest = 0.0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double point[3];
    points->GetPoint(i, point);
    farthest = std::max(farthest, distanceToLines(polylines, point));
  }
  return farthest;
}
}

double distanceToLines(vtkPolyData* polylines, const double point[3])
{
  double least = std::numeric_limits<double>::infinity();
  forEachSegment(polylines,
    [&](const double p[3], const double q[3])
    {
      double t;
      least = std::min(least, vtkLine::DistanceToLine(point, p, q, t, nullptr));
    });
  return std::sqrt(least);
}

double lengthOfLine(vtkPolyData* polylines, vtkIdType line)
{
  double length = 0.0;
  forEachSegment(polylines, line,
    [&](const double p[3], const double q[3])
    { length += std::sqrt(vtkMath::Distance2BetweenPoints(p, q)); });
  return length;
}

double lengthOfLines(vtkPolyData* polylines)
{
  double length = 0.0;
  for (vtkIdType line = 0; line < polylines->GetLines()->GetNumberOfCells(); ++line)
  {
    length += lengthOfLine(polylines, line);
  }
  return length;
}

double hausdorffDistance(vtkPolyData* a, vtkPolyData* b)
{
  return std::max(farthestFrom(a, b), farthestFrom(b, a));
}
}
