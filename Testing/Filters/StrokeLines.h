/**
 * @brief Lines for the tests of strokes, and what ribbons made of them are like.
 */
#ifndef shadowtest_StrokeLines_h
#define shadowtest_StrokeLines_h

#include "MeshBuilder.h"
#include "Random.h"

#include <vtkContourStrokes.h>
#include <vtkNew.h>

#include <vector>

namespace shadowtest
{
using Line = std::vector<Vec3>;

/// Lines that share no points; a closed one returns to the id of its first point.
vtkSmartPointer<vtkPolyData> linesOf(const std::vector<Line>& lines, bool closed = false);

/// In z = 0, with turns of all kinds, sharp and short ones among them.
Line zigzag(Random& random, int corners);

/// In z = 0 around the origin; its first point does not come again.
Line circle(int count, double radius);

/// In a cube around the origin.
Vec3 randomPoint(Random& random, double half);

Vec3 pointOf(vtkPolyData* data, vtkIdType id);
double lengthOf(const Vec3& v);
double distanceToLine(const Vec3& p, const Line& line, bool closed);

/// Twice the signed area of each triangle as seen from +z.
std::vector<double> doubleAreas(vtkPolyData* ribbons);

/// Whether a triangle has the point (x, y), seen from +z.
bool covers(vtkPolyData* ribbons, const Vec3& p);

/// What a stroke of a single segment is: at each end its middle and two points to its sides.
struct End
{
  Vec3 middle;
  std::vector<Vec3> offsets;
};

/// Expects a ribbon to be such a stroke, and gives its ends.
std::vector<End> endsOf(vtkPolyData* ribbon, const Line& segment);

/// Of a width in world units, seen from +z, without Lift.
vtkNew<vtkContourStrokes> strokesOf(vtkPolyData* lines, double width);

/// Held, as the filter may be gone.
vtkSmartPointer<vtkPolyData> update(vtkContourStrokes* strokes);

/// The points in the middle, in their order.
Line middlesOf(vtkPolyData* ribbon);
}

#endif
