/**
 * The PNG pictures that the commands write.
 */
#ifndef ImageOutput_h
#define ImageOutput_h

#include "OutputFile.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

/// Means of squares of `factor` x `factor` pixels.
vtkSmartPointer<vtkImageData> ShrinkImage(vtkImageData* image, int factor);

/// Writes the picture under the file's temporary name. Throws Failure.
void WriteImage(vtkImageData* image, OutputFile& file);

#endif
