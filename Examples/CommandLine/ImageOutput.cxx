#include "ImageOutput.h"

#include "Failure.h"
#include "Messages.h"

#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <fstream>

vtkSmartPointer<vtkImageData> ShrinkImage(vtkImageData* image, int factor)
{
  if (factor == 1)
  {
    return image;
  }
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputData(image);
  shrink->SetShrinkFactors(factor, factor, 1);
  shrink->MeanOn();
  shrink->Update();
  return shrink->GetOutput();
}

void WriteImage(vtkImageData* image, OutputFile& file)
{
  ClearMessages();
  // In memory, as libpng prints its own messages when a file cannot take the picture.
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (!bytes || !FirstError().empty())
  {
    throw Failure("no PNG (" + FirstError() + ")", file.Path(), "give a smaller --size");
  }
  std::ofstream stream(file.TemporaryPath(), std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes->GetPointer(0)), bytes->GetNumberOfValues());
  stream.close();
  if (!stream)
  {
    throw Failure("cannot be written", file.Path(), "check the room there");
  }
}
