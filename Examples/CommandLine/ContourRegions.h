/**
 * `smoothshadow contour --regions`: the receivers split along the contours, and how much of each is in
 * shadow.
 */
#ifndef ContourRegions_h
#define ContourRegions_h

#include "MeshReader.h"
#include "OutputFile.h"
#include "Statistics.h"

class vtkCastShadowContour;

/// Takes the inputs of the filter of contours and writes what vtkShadowedReceiver makes of them.
/// Appends areas to the statistics of the receivers. Errors are left to FirstError().
void WriteRegions(vtkCastShadowContour* contours, OutputFile& file, Json& statistics);

#endif
