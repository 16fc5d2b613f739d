#include "ImageChecks.h"

#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace shadowtest
{
namespace
{
std::string shape(vtkImageData* image)
{
  int size[3];
  image->GetDimensions(size);
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
    std::to_string(size[2]) + " pixels of " + std::to_string(image->GetNumberOfScalarComponents()) +
    " components";
}

// All channels of all pixels, whatever the extent starts with.
std::vector<double> channels(vtkImageData* image)
{
  int extent[6];
  image->GetExtent(extent);
  std::vector<double> values;
  for (int z = extent[4]; z <= extent[5]; ++z)
  {
    for (int y = extent[2]; y <= extent[3]; ++y)
    {
      for (int x = extent[0]; x <= extent[1]; ++x)
      {
        for (int c = 0; c < image->GetNumberOfScalarComponents(); ++c)
        {
          values.push_back(image->GetScalarComponentAsDouble(x, y, z, c));
        }
      }
    }
  }
  return values;
}

void requireSameShape(vtkImageData* a, vtkImageData* b)
{
  if (shape(a) != shape(b))
  {
    throw std::runtime_error("images differ in shape: " + shape(a) + " and " + shape(b));
  }
  if (a->GetNumberOfPoints() == 0)
  {
    throw std::runtime_error("images without pixels compared");
  }
}
}

ImageDifference compareImages(vtkImageData* a, vtkImageData* b, double threshold)
{
  requireSameShape(a, b);
  const std::vector<double> left = channels(a);
  const std::vector<double> right = channels(b);
  const auto components = static_cast<std::size_t>(a->GetNumberOfScalarComponents());
  ImageDifference result;
  for (std::size_t pixel = 0; pixel < left.size(); pixel += components)
  {
    bool differs = false;
    for (std::size_t i = pixel; i < pixel + components; ++i)
    {
      const double difference = std::abs(left[i] - right[i]);
      result.Mean += difference;
      result.Largest = std::max(result.Largest, difference);
      differs = differs || difference > threshold;
    }
    result.Pixels += differs;
  }
  result.Mean /= static_cast<double>(left.size());
  result.Fraction =
    static_cast<double>(result.Pixels) / static_cast<double>(a->GetNumberOfPoints());
  return result;
}

vtkSmartPointer<vtkImageData> differenceImage(vtkImageData* a, vtkImageData* b)
{
  const double largest = compareImages(a, b).Largest;
  const std::vector<double> left = channels(a);
  const std::vector<double> right = channels(b);
  int size[3];
  a->GetDimensions(size);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, a->GetNumberOfScalarComponents());
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < left.size(); ++i)
  {
    out[i] = largest > 0.0
      ? static_cast<unsigned char>(std::lround(255.0 * std::abs(left[i] - right[i]) / largest))
      : 0;
  }
  return image;
}

double blackFraction(vtkImageData* mask)
{
  const std::vector<double> values = channels(mask);
  const auto components = static_cast<std::size_t>(mask->GetNumberOfScalarComponents());
  long black = 0;
  for (std::size_t i = 0; i < values.size(); i += components)
  {
    black += values[i] == 0.0;
  }
  return values.empty()
    ? 0.0
    : static_cast<double>(black) / static_cast<double>(mask->GetNumberOfPoints());
}

void writePng(vtkImageData* image, const std::string& path)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
  if (writer->GetErrorCode() != 0 || !std::filesystem::exists(path))
  {
    throw std::runtime_error("cannot write " + path);
  }
}

vtkSmartPointer<vtkImageData> readPng(const std::string& path)
{
  if (!std::filesystem::exists(path))
  {
    throw std::runtime_error("there is no " + path);
  }
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0 || reader->GetOutput()->GetNumberOfPoints() == 0)
  {
    throw std::runtime_error("cannot read " + path + " as PNG");
  }
  vtkSmartPointer<vtkImageData> image = reader->GetOutput();
  return image;
}
}
