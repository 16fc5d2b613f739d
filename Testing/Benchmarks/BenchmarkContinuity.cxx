// How far silhouettes move while a directional light turns in 1,000 steps of a thousandth radian:
// the Hausdorff distance between two successive ones over the step. On a convex shape the true
// contour never changes its topology.
//
// BenchmarkContinuity [folder]: writes continuity.csv and continuity.png into it.

#include "AnalyticShadow.h"
#include "ChartPicture.h"
#include "LightWalk.h"
#include "TestMeshes.h"

#include <vtkAxis.h>
#include <vtkCellArray.h>
#include <vtkChartLegend.h>
#include <vtkChartXY.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkPoints.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace
{
using namespace shadowtest;

struct Series
{
  std::string Name;
  std::vector<double> Movements; ///< of each step
  std::array<unsigned char, 3> Colour;
};

struct Walk
{
  std::string Title;
  std::vector<Series> Lines;
};

/// The exact contour of an ellipsoid as a closed polyline.
vtkSmartPointer<vtkPolyData> trueContour(const double axes[3], const LightPosition& light)
{
  constexpr int Count = 400;
  const Plane receiver{ { -10.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } };
  const std::vector<Vec3> contour = ellipsoidShadow(axes, light, receiver)->contour(Count);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(Count + 1);
  for (const Vec3& p : contour)
  {
    lines->InsertCellPoint(points->InsertNextPoint(p.data()));
  }
  lines->InsertCellPoint(0);
  vtkNew<vtkPolyData> polyline;
  polyline->SetPoints(points);
  polyline->SetLines(lines);
  return polyline;
}

Walk walk(const std::string& title, vtkPolyData* mesh, const double axes[3])
{
  return { title + ", " + std::to_string(mesh->GetNumberOfCells()) + " triangles",
    { { "discrete (at rest in the other steps)",
        movementsOf(mesh, vtkSmoothLightSilhouette::DISCRETE), { 217, 95, 2 } },
      { "smooth", movementsOf(mesh, vtkSmoothLightSilhouette::SMOOTH), { 27, 158, 119 } },
      { "accurate", movementsOf(mesh, vtkSmoothLightSilhouette::ACCURATE), { 117, 112, 179 } },
      { "true contour",
        movementsOf([&](const LightPosition& light) { return trueContour(axes, light); }),
        { 60, 60, 60 } } } };
}

void print(const Walk& walk)
{
  std::printf("%s\n", walk.Title.c_str());
  for (const Series& line : walk.Lines)
  {
    std::vector<double> sorted = line.Movements;
    std::sort(sorted.begin(), sorted.end());
    std::printf("  %-38s %10.3f %10.3f %10.3f\n", line.Name.c_str(), sorted[sorted.size() / 2],
      sorted[sorted.size() * 99 / 100], sorted.back());
  }
}

bool writeTable(const std::string& name, const std::vector<Walk>& walks)
{
  std::ofstream file(name);
  file << "step";
  for (const Walk& walk : walks)
  {
    for (const Series& line : walk.Lines)
    {
      file << ",\"" << walk.Title << ": " << line.Name << '"';
    }
  }
  file << '\n';
  for (std::size_t step = 0; step < WalkSteps; ++step)
  {
    file << step + 1;
    for (const Walk& walk : walks)
    {
      for (const Series& line : walk.Lines)
      {
        file << ',' << line.Movements[step];
      }
    }
    file << '\n';
  }
  return file.good();
}

/// Only steps that moved something: zero has no place on a logarithmic axis.
vtkSmartPointer<vtkTable> tableOf(const Series& line)
{
  vtkNew<vtkDoubleArray> steps;
  steps->SetName("step");
  vtkNew<vtkDoubleArray> movements;
  movements->SetName(line.Name.c_str());
  for (std::size_t i = 0; i < line.Movements.size(); ++i)
  {
    if (line.Movements[i] > 0.0)
    {
      steps->InsertNextValue(static_cast<double>(i + 1));
      movements->InsertNextValue(line.Movements[i]);
    }
  }
  auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(steps);
  table->AddColumn(movements);
  return table;
}

vtkSmartPointer<vtkChartXY> chartOf(const Walk& walk)
{
  auto chart = vtkSmartPointer<vtkChartXY>::New();
  chart->SetTitle(walk.Title);
  chart->GetTitleProperties()->SetFontSize(20);
  benchmarks::styleAxis(chart->GetAxis(vtkAxis::BOTTOM), "step of the light (1/1000 radian each)");
  vtkAxis* left = chart->GetAxis(vtkAxis::LEFT);
  benchmarks::styleAxis(left, "movement in the step / step");
  left->LogScaleOn();
  left->SetBehavior(vtkAxis::FIXED);
  left->SetRange(0.1, 2000.0);
  chart->GetAxis(vtkAxis::BOTTOM)->SetBehavior(vtkAxis::FIXED);
  chart->GetAxis(vtkAxis::BOTTOM)->SetRange(0.0, WalkSteps);
  for (const Series& line : walk.Lines)
  {
    const bool jumps = &line == &walk.Lines.front();
    const bool exact = &line == &walk.Lines.back();
    vtkPlot* plot = chart->AddPlot(jumps ? vtkChart::POINTS : vtkChart::LINE);
    plot->SetInputData(tableOf(line), 0, 1);
    plot->SetColor(line.Colour[0], line.Colour[1], line.Colour[2], 255);
    plot->SetWidth(jumps ? 3.0f : 2.0f);
    plot->GetPen()->SetLineType(exact ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
    if (jumps)
    {
      static_cast<vtkPlotPoints*>(plot)->SetMarkerStyle(vtkPlotPoints::CIRCLE);
    }
  }
  chart->SetShowLegend(true);
  chart->GetLegend()->SetLabelSize(15);
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  chart->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
  return chart;
}
}

int main(int argc, char* argv[])
{
  const std::string folder = argc > 1 ? std::string(argv[1]) + "/" : std::string();
  const double ball[3] = { 1.0, 1.0, 1.0 };
  const std::vector<Walk> walks = { walk("Jittered sphere", icosphere(3, 3), ball),
    walk("Jittered ellipsoid (2, 1, 0.5)", icoEllipsoid(3, 3), EllipsoidAxes) };
  std::printf("Movement in a step of 1/1000 radian, over the step\n%-40s %10s %10s %10s\n", "",
    "median", "99%", "most");
  for (const Walk& walk : walks)
  {
    print(walk);
  }
  std::vector<vtkSmartPointer<vtkChartXY>> charts;
  for (const Walk& walk : walks)
  {
    charts.push_back(chartOf(walk));
  }
  return writeTable(folder + "continuity.csv", walks) &&
      benchmarks::writeCharts(folder + "continuity.png", charts)
    ? 0
    : 1;
}
