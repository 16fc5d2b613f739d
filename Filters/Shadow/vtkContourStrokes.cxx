#include "vtkContourStrokes.h"

#include "PolyDataBridge.h"
#include "SMPRangeLoop.h"
#include "StrokeData.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cmath>
#include <utility>

namespace
{
// VTK's limits of settings let through what is not a number. Null if all are finite.
const char* firstNotFinite(const shadow::StrokeSettings& settings)
{
  const std::pair<const char*, double> values[] = { { "Width", settings.width },
    { "Taper", settings.taper }, { "Overshoot", settings.overshoot },
    { "Wobble", settings.wobble }, { "WobbleLength", settings.wobbleLength },
    { "Lift", settings.lift } };
  for (const auto& [name, value] : values)
  {
    if (!std::isfinite(value))
    {
      return name;
    }
  }
  return nullptr;
}
}

vtkStandardNewMacro(vtkContourStrokes);

vtkContourStrokes::vtkContourStrokes() = default;

vtkContourStrokes::~vtkContourStrokes() = default;

int vtkContourStrokes::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  shadow::StrokeView view;
  if (!readLight(this->EyePosition, view.eye))
  {
    vtkErrorMacro("EyePosition (" << this->EyePosition[0] << ", " << this->EyePosition[1] << ", "
                                  << this->EyePosition[2] << ", " << this->EyePosition[3]
                                  << ") must be finite and not all zero.");
    return 0;
  }
  view.inPixels = this->WidthUnit == PIXELS;
  view.projection =
    shadow::unitOrZero({ this->ViewDirection[0], this->ViewDirection[1], this->ViewDirection[2] });
  view.pixelSize = this->PixelSize;
  if (view.inPixels && view.projection == shadow::Vec3(0.0))
  {
    vtkErrorMacro("ViewDirection (" << this->ViewDirection[0] << ", " << this->ViewDirection[1]
                                    << ", " << this->ViewDirection[2]
                                    << ") must be finite and not zero.");
    return 0;
  }
  shadow::StrokeSettings settings;
  settings.width = this->Width;
  settings.taper = this->Taper;
  settings.overshoot = this->Overshoot;
  settings.wobble = this->Wobble;
  settings.wobbleLength = this->WobbleLength;
  settings.seed = static_cast<std::uint64_t>(this->Seed);
  settings.lift = this->Lift;
  if (const char* name = firstNotFinite(settings))
  {
    vtkErrorMacro(<< name << " is not a finite number: set one.");
    return 0;
  }
  const StrokeInput lines = readLines(input, view);
  writeStrokes(
    shadow::makeStrokes(lines.lines, settings, view, smpRangeLoop), lines, input, output);
  return 1;
}

void vtkContourStrokes::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "WidthUnit: " << this->WidthUnit << "\n";
  os << indent << "EyePosition: (" << this->EyePosition[0] << ", " << this->EyePosition[1] << ", "
     << this->EyePosition[2] << ", " << this->EyePosition[3] << ")\n";
  os << indent << "ViewDirection: (" << this->ViewDirection[0] << ", " << this->ViewDirection[1]
     << ", " << this->ViewDirection[2] << ")\n";
  os << indent << "PixelSize: " << this->PixelSize << "\n";
  os << indent << "Taper: " << this->Taper << "\n";
  os << indent << "Overshoot: " << this->Overshoot << "\n";
  os << indent << "Wobble: " << this->Wobble << "\n";
  os << indent << "WobbleLength: " << this->WobbleLength << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Lift: " << this->Lift << "\n";
}
