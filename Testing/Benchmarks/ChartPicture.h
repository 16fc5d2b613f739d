// Charts, one below the other, as a PNG file.
#ifndef ChartPicture_h
#define ChartPicture_h

#include "BenchmarkWindow.h"

#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkPNGWriter.h>
#include <vtkPen.h>
#include <vtkTextProperty.h>

#include <string>
#include <vector>

namespace benchmarks
{
inline void styleAxis(vtkAxis* axis, const char* title)
{
  axis->SetTitle(title);
  axis->GetTitleProperties()->SetFontSize(18);
  axis->GetTitleProperties()->BoldOff();
  axis->GetLabelProperties()->SetFontSize(15);
  axis->GetGridPen()->SetColor(225, 225, 225);
}

/// False if the file could not be written.
inline bool writeCharts(
  const std::string& name, const std::vector<vtkSmartPointer<vtkChartXY>>& charts)
{
  constexpr int width = 1200;
  constexpr int height = 560; // of one chart
  vtkNew<vtkContextActor> actor;
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  actor->GetScene()->SetRenderer(renderer);
  const int count = static_cast<int>(charts.size());
  for (int i = 0; i < count; ++i)
  {
    vtkChartXY* chart = charts[static_cast<std::size_t>(i)];
    chart->SetAutoSize(false);
    chart->SetSize(vtkRectf(0.0f, static_cast<float>(height * (count - 1 - i)), width, height));
    actor->GetScene()->AddItem(chart);
  }
  const auto window = openWindow(width, renderer);
  window->SetSize(width, height * count);
  // Plots follow a logarithmic axis from the second frame on only.
  window->Render();
  window->Render();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(name.c_str());
  writer->SetInputData(grab(window));
  writer->Write();
  return writer->GetErrorCode() == 0;
}
}

#endif
