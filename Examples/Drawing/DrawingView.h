/**
 * Lines as they are seen: where points are in the drawing, and which parts of a line are hidden.
 */
#ifndef DrawingView_h
#define DrawingView_h

#include "Camera.h"
#include "LineOfSight.h"
#include "SvgDrawing.h"

class DrawingView
{
public:
  /// Perspective, or a parallel projection along the camera's gaze that shows what is at the point
  /// that it looks at as large. `size` counts by its proportions alone. The blockers hide what is
  /// behind them.
  DrawingView(const Camera& camera, bool parallel, const std::array<int, 2>& size,
    const std::vector<vtkPolyData*>& blockers);

  /// The eye, homogeneous: w = 0 in parallel projection.
  Homogeneous Eye() const;

  /// What the sheet shows of the plane through the point looked at, at right angles to the gaze, in
  /// world units.
  double Width() const { return this->SheetWidth; }
  double Height() const { return this->SheetHeight; }

  /// Where a point before the eye is in that plane, as it is seen.
  Point2 Project(const Vector3& point) const;

  /// The parts of a line that are seen. `tests` are points beside those of the line at which
  /// visibility is looked at, or empty. What is farther outside of the sheet than the sheet is wide
  /// or high is cut off, and in perspective what is nearer to the eye than a 1000th of the way to
  /// the point looked at, along the gaze. Looked at are places at most a 500th of the sheet's
  /// height apart; where it changes in between is then halved down to a 2,000,000th. Pieces shorter
  /// than a 1000th are left out.
  DrawnLine Draw(const Polyline3& line, const Polyline3& tests = {}) const;

  /// All lines of the data; if it has them, with the points moved by `outwards` along `Normals` for
  /// the look.
  std::vector<DrawnLine> DrawAll(vtkPolyData* lines, double outwards = 0.0) const;

private:
  // A line and the places at which to look whether it is seen, as many.
  struct TestedLine
  {
    Polyline3 Points;
    Polyline3 Tests;
  };

  // Of points p for which Normal . (p - Position) is more than Least.
  struct HalfSpace
  {
    Vector3 Normal;
    double Least;
  };

  void MakeFrame();
  std::vector<TestedLine> PartsIn(const HalfSpace& space, const TestedLine& line) const;
  void DrawPart(const TestedLine& line, DrawnLine& pieces) const;

  Vector3 Position;
  Vector3 Forward; // right, up: unit, at right angles
  Vector3 Right;
  Vector3 Up;
  double Distance; // to the point looked at
  bool Parallel;
  double SheetWidth;
  double SheetHeight;
  std::vector<HalfSpace> Frame; // what is drawn is in all of them
  LineOfSight Sight;
};

#endif
