/**
 * @brief Differences of pictures and masks, and PNG files to look at when a test fails.
 */
#ifndef shadowtest_ImageChecks_h
#define shadowtest_ImageChecks_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace shadowtest
{
struct ImageDifference
{
  /// Pixels of which a channel differs by more than the threshold, and their share of all.
  long Pixels = 0;
  double Fraction = 0.0;
  /// Greatest and mean difference of a channel.
  double Largest = 0.0;
  double Mean = 0.0;
};

/// Both of the same dimensions and number of components; throws std::runtime_error otherwise, and
/// if there are no pixels. Channels are compared as numbers of whatever type they have.
ImageDifference compareImages(vtkImageData* a, vtkImageData* b, double threshold = 0.0);

/// Picture of |a - b|, scaled to 0..255 by its largest value; the same conditions.
vtkSmartPointer<vtkImageData> differenceImage(vtkImageData* a, vtkImageData* b);

/// Share of pixels whose first channel is 0: that of the shadow in a mask.
double blackFraction(vtkImageData* mask);

/// 8-bit images of 1 to 4 channels. Both throw std::runtime_error that names the file.
void writePng(vtkImageData* image, const std::string& path);
vtkSmartPointer<vtkImageData> readPng(const std::string& path);
}

#endif
