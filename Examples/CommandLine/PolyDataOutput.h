/**
 * The VTP files that the commands write.
 */
#ifndef PolyDataOutput_h
#define PolyDataOutput_h

#include "OutputFile.h"

class vtkPolyData;

/// Writes all of the data under the file's temporary name: binary, with every number in the
/// precision that it has. Throws Failure.
void WritePolyData(vtkPolyData* data, OutputFile& file);

#endif
