// Polylines and the ribbons along them as vtkPolyData.
#ifndef StrokeData_h
#define StrokeData_h

#include "Strokes.h"

#include "vtkType.h"

class vtkPolyData;

// Lines with where they come from, and what was left out.
struct StrokeInput
{
  std::vector<shadow::StrokeLine> lines;
  std::vector<std::vector<vtkIdType>> ids; // of each line's points
  std::vector<vtkIdType> cells;            // the input's line that each is (part of)
  vtkIdType nonFinitePoints = 0;           // uses of them by lines, as all of these
  vtkIdType hiddenPoints = 0;
  vtkIdType degenerateLines = 0;
};

// Lines are parted and cleaned as vtkContourStrokes documents.
StrokeInput readLines(vtkPolyData* input, const shadow::StrokeView& view);

// All arrays that vtkContourStrokes documents.
void writeStrokes(const shadow::Strokes& strokes, const StrokeInput& lines, vtkPolyData* input,
  vtkPolyData* output);

#endif
