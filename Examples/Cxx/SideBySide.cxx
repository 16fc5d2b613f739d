// Puts pictures of one size beside each other, each with a caption at its top.
//
//     SideBySide strip.png picture.png caption [picture.png caption]...

#include <vtkImageAppend.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkSmartPointer.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <iostream>

namespace
{
// Draws the text on to the picture, dark on what is there.
void Write(vtkImageData* picture, const char* caption)
{
  vtkNew<vtkTextProperty> style;
  style->SetFontFamilyToArial();
  style->SetFontSize(18);
  style->SetColor(0.1, 0.1, 0.1);
  vtkNew<vtkImageData> text;
  int dimensions[2] = {};
  const int dotsPerInch = 72;
  if (!vtkTextRenderer::GetInstance()->RenderString(
        style, vtkStdString(caption), text, dimensions, dotsPerInch))
  {
    return;
  }
  int size[3];
  picture->GetDimensions(size);
  const int margin = 12;
  const int width = std::min(dimensions[0], size[0] - margin);
  const int height = std::min(dimensions[1], size[1] - margin);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const auto* ink = static_cast<const unsigned char*>(
        text->GetScalarPointer(text->GetExtent()[0] + x, text->GetExtent()[2] + y, 0));
      auto* pixel = static_cast<unsigned char*>(
        picture->GetScalarPointer(margin + x, size[1] - margin - dimensions[1] + y, 0));
      for (int channel = 0; channel < picture->GetNumberOfScalarComponents(); ++channel)
      {
        const int mixed = ink[3] * ink[channel % 3] + (255 - ink[3]) * pixel[channel];
        pixel[channel] = static_cast<unsigned char>(mixed / 255);
      }
    }
  }
}
}

int main(int argc, char* argv[])
{
  if (argc < 4 || argc % 2 != 0)
  {
    std::cerr << "usage: SideBySide strip.png picture.png caption [picture.png caption]..."
              << std::endl;
    return 2;
  }
  vtkNew<vtkImageAppend> strip;
  strip->SetAppendAxis(0);
  for (int i = 2; i < argc; i += 2)
  {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(argv[i]);
    reader->Update();
    vtkImageData* picture = reader->GetOutput();
    if (picture->GetNumberOfPoints() == 0 || picture->GetScalarType() != VTK_UNSIGNED_CHAR)
    {
      std::cerr << "SideBySide: error: no picture, in " << argv[i] << std::endl;
      return 1;
    }
    Write(picture, argv[i + 1]);
    strip->AddInputData(picture);
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(strip->GetOutputPort());
  writer->SetFileName(argv[1]);
  writer->Write();
  return writer->GetErrorCode() == 0 ? 0 : 1;
}
