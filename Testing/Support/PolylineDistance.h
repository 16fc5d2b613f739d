/**
 * @brief How long polylines are, and how far apart.
 */
#ifndef shadowtest_PolylineDistance_h
#define shadowtest_PolylineDistance_h

#include <vtkType.h>

class vtkPolyData;

namespace shadowtest
{
/// Distance of a point from the nearest place on any line of the polydata; infinite without lines.
double distanceToLines(vtkPolyData* polylines, const double point[3]);

/// The length of one line of the polydata.
double lengthOfLine(vtkPolyData* polylines, vtkIdType line);

/// The length of all lines of the polydata.
double lengthOfLines(vtkPolyData* polylines);

/// Hausdorff distance, measured at the points of both.
double hausdorffDistance(vtkPolyData* a, vtkPolyData* b);
}

#endif
