// What the pass's tolerance in pixels costs, and what the shadow is off by: coarse smooth shapes
// over the ground, against the boundary of the true shape's shadow.
//
// BenchmarkPixelTolerance [folder]: writes pixel-tolerance.csv and pixel-tolerance.png into it.

#include "AnalyticShadow.h"
#include "ChartPicture.h"
#include "ImageChecks.h"
#include "Measure.h"
#include "PlannedSilhouette.h"
#include "RealMeshes.h"
#include "StepTimes.h"
#include "ToleranceScene.h"

#include <vtkChartLegend.h>
#include <vtkDoubleArray.h>
#include <vtkPlot.h>
#include <vtkTable.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace shadowtest;
using benchmarks::ToleranceScene;

constexpr int Rounds = 9;
constexpr double Tolerances[] = { 0.25, 0.5, 1.0, 2.0, 4.0 };
constexpr double ReferenceTolerance = 0.01;

struct NamedLight
{
  const char* Name;
  RayLight Place;
};
constexpr NamedLight Lights[] = { { "direction", { 1.0, 0.5, 4.0, 0.0 } },
  { "lamp", { 0.5, 0.4, 6.0, 1.0 } } };

using ShadowMaker = std::function<std::unique_ptr<AnalyticShadow>(const LightPoint&, const Plane&)>;

struct Shape
{
  const char* Name;
  Mesh Surface;
  ShadowMaker TrueShadow; ///< empty if none is known
};

std::vector<Shape> makeShapes()
{
  const ShadowMaker ring = [](const LightPoint& light, const Plane& receiver) {
    return torusShadow(TorusRadius, TorusTube, light, receiver);
  };
  const ShadowMaker ball = [](const LightPoint& light, const Plane& receiver) {
    const double axes[3] = { 1.0, 1.0, 1.0 };
    return ellipsoidShadow(axes, light, receiver);
  };
  return { { "torus 1.4k", torus(36, 20), ring }, { "torus 10k", torus(96, 52), ring },
    { "sphere 1.3k", icosphere(3), ball }, { "bunny 70k", standing(bunny(), 1), {} } };
}

struct Row
{
  std::string Shape;
  std::string Light;
  std::string Kind;
  double Tolerance = 0.0;
  bool Smooth = false; ///< what was taken
  vtkIdType Points = 0;
  double VolumeTime = 0.0;
  double FrameTime = 0.0;
  double FrameRatio = 0.0; ///< to that of discrete silhouettes
  benchmarks::PixelError Error;
  double Allowed = 0.0; ///< largest error, as the ground is seen under the light
  long Differing = 0;   ///< pixels, from the mask of ReferenceTolerance
};

/// The boundary on the ground in pixels, and by how much rays are aslant there: 1 / cosine at most.
struct TrueBoundary
{
  std::vector<benchmarks::PixelPlace> Places;
  double Slant = 1.0;

  TrueBoundary(const Shape& shape, ToleranceScene& scene)
  {
    if (!shape.TrueShadow)
    {
      return;
    }
    constexpr int count = 20000;
    const Plane receiver{ { 0.0, 0.0, ToleranceScene::GroundHeight }, { 0.0, 0.0, 1.0 } };
    for (const Vec3& point : shape.TrueShadow(scene.Place, receiver)->contour(count))
    {
      const Vec3 shadow = shadowOn(receiver, scene.Place, point);
      this->Places.push_back(scene.toPixel(shadow));
      const Vec3 towards = normalized(
        Vec3{ scene.Place[0], scene.Place[1], scene.Place[2] } - scene.Place[3] * shadow);
      this->Slant = std::max(this->Slant, 1.0 / towards[2]);
    }
  }
};

struct Rival
{
  const char* Kind;
  int Value;
  double Tolerance;
};

/// The reference first, then discrete.
std::vector<Rival> makeRivals()
{
  std::vector<Rival> rivals = { { "smooth", vtkStencilShadowPass::SMOOTH, ReferenceTolerance },
    { "discrete", vtkStencilShadowPass::DISCRETE, 1.0 } };
  for (const double tolerance : Tolerances)
  {
    rivals.push_back({ "smooth", vtkStencilShadowPass::SMOOTH, tolerance });
  }
  for (const double tolerance : Tolerances)
  {
    rivals.push_back({ "automatic", vtkStencilShadowPass::AUTOMATIC, tolerance });
  }
  return rivals;
}

std::vector<Row> measureShape(const Shape& shape, const NamedLight& light)
{
  constexpr std::size_t discrete = 1;
  const std::vector<Rival> rivals = makeRivals();
  std::vector<std::unique_ptr<ToleranceScene>> scenes;
  std::vector<vtkStencilShadowPass*> passes;
  for (const Rival& rival : rivals)
  {
    scenes.push_back(std::make_unique<ToleranceScene>(shape.Surface, light.Place));
    passes.push_back(scenes.back()->Pass);
    passes.back()->SetKind(rival.Value);
    passes.back()->SetPixelTolerance(rival.Tolerance);
  }
  const auto draw = [&](std::size_t i, int round) {
    constexpr int places = 7;
    scenes[i]->placeLight(round % places);
    benchmarks::drawFrame(scenes[i]->Window);
  };
  const benchmarks::Turns frames = benchmarks::measureInTurns(scenes.size(), draw, Rounds);
  const auto steps = benchmarks::measureSteps(passes, draw, Rounds);

  const TrueBoundary boundary(shape, *scenes.front());
  const RayScene rays({ { scenes.front()->Ground }, { shape.Surface } });
  const RayPicture seen =
    rays.render(RayView::fromCamera(scenes.front()->Renderer->GetActiveCamera(),
                  ToleranceScene::Size, ToleranceScene::Size),
      light.Place);
  const auto reference = scenes.front()->mask();
  std::vector<Row> rows;
  for (std::size_t i = 0; i < rivals.size(); ++i)
  {
    const auto mask = scenes[i]->mask();
    const benchmarks::PlannedSilhouette planned(
      passes[i], scenes[i]->Renderer, ToleranceScene::Size, shape.Surface, light.Place);
    Row row{ shape.Name, light.Name, rivals[i].Kind, rivals[i].Tolerance, planned.Tolerance > 0.0,
      planned.Points, steps[i][benchmarks::VOLUMES], frames.median(i),
      frames.ratio(i, discrete, benchmarks::drawsOnProcessor(scenes.front()->Window)), {} };
    if (shape.TrueShadow)
    {
      row.Error = benchmarks::pixelError(benchmarks::maskEdges(mask, seen), boundary.Places);
      row.Allowed = boundary.Slant * rivals[i].Tolerance + 0.5;
    }
    row.Differing = compareImages(reference, mask).Pixels;
    rows.push_back(row);
  }
  return rows;
}

void print(const Row& row)
{
  std::printf("%-12s %-10s %-10s %5.2f %-9s %6lld %8.2f %7.1f %5.2f", row.Shape.c_str(),
    row.Light.c_str(), row.Kind.c_str(), row.Tolerance, row.Smooth ? "smooth" : "discrete",
    static_cast<long long>(row.Points), row.VolumeTime, row.FrameTime, row.FrameRatio);
  if (row.Error.Samples > 0)
  {
    std::printf(" %8.2f %6.2f", row.Error.Largest, row.Error.RootMeanSquare);
    row.Kind == "discrete" ? std::printf(" %8s", "") : std::printf(" %8.2f", row.Allowed);
  }
  else
  {
    std::printf(" %24s", "");
  }
  std::printf(" %7ld%s\n", row.Differing,
    row.Kind != "discrete" && row.Error.Largest > row.Allowed ? "  MORE THAN ALLOWED" : "");
}

bool writeTable(const std::string& name, const std::vector<Row>& rows)
{
  std::ofstream file(name);
  file << "shape,light,kind,pixel tolerance,taken,silhouette points,volume ms,frame ms,"
          "ratio to discrete,largest error in pixels,root mean square,allowed,differing pixels\n";
  for (const Row& row : rows)
  {
    file << row.Shape << ',' << row.Light << ',' << row.Kind << ',' << row.Tolerance << ','
         << (row.Smooth ? "smooth" : "discrete") << ',' << row.Points << ',' << row.VolumeTime
         << ',' << row.FrameTime << ',' << row.FrameRatio << ',' << row.Error.Largest << ','
         << row.Error.RootMeanSquare << ',' << row.Allowed << ',' << row.Differing << '\n';
  }
  return file.good();
}

/// A value of rows over the tolerance, of each shape and kind under the first light.
vtkSmartPointer<vtkChartXY> chartOf(const std::vector<Row>& rows, const char* title,
  const char* axis, const std::array<double, 2>& range,
  const std::function<double(const Row&)>& value, bool withAllowed)
{
  auto chart = vtkSmartPointer<vtkChartXY>::New();
  chart->SetTitle(title);
  chart->GetTitleProperties()->SetFontSize(20);
  benchmarks::styleAxis(chart->GetAxis(vtkAxis::BOTTOM), "log2 of PixelTolerance");
  benchmarks::styleAxis(chart->GetAxis(vtkAxis::LEFT), axis);
  const std::pair<int, std::array<double, 2>> axes[] = { { vtkAxis::BOTTOM, { -2.2, 2.2 } },
    { vtkAxis::LEFT, range } };
  for (const auto& [place, ends] : axes)
  {
    chart->GetAxis(place)->SetBehavior(vtkAxis::FIXED);
    chart->GetAxis(place)->SetRange(ends[0], ends[1]);
  }
  const auto add = [&](const std::string& name, const std::function<bool(const Row&)>& isIn,
                     const std::function<double(const Row&)>& height, std::size_t colour,
                     bool dashed) {
    constexpr std::array<unsigned char, 3> colours[] = { { 217, 95, 2 }, { 27, 158, 119 },
      { 117, 112, 179 }, { 230, 171, 2 }, { 60, 60, 60 } };
    vtkNew<vtkDoubleArray> tolerances;
    tolerances->SetName("tolerance");
    vtkNew<vtkDoubleArray> heights;
    heights->SetName(name.c_str());
    for (const Row& row : rows)
    {
      if (row.Light == Lights[0].Name && row.Tolerance > ReferenceTolerance && isIn(row) &&
        height(row) > 0.0)
      {
        tolerances->InsertNextValue(std::log2(row.Tolerance));
        heights->InsertNextValue(height(row));
      }
    }
    if (heights->GetNumberOfTuples() == 0)
    {
      return;
    }
    vtkNew<vtkTable> table;
    table->AddColumn(tolerances);
    table->AddColumn(heights);
    vtkPlot* plot = chart->AddPlot(vtkChart::LINE);
    plot->SetInputData(table, 0, 1);
    plot->SetColor(colours[colour][0], colours[colour][1], colours[colour][2], 255);
    plot->SetWidth(2.0f);
    plot->GetPen()->SetLineType(dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
  };
  std::vector<std::string> shapes;
  for (const Row& row : rows)
  {
    if (std::find(shapes.begin(), shapes.end(), row.Shape) == shapes.end())
    {
      shapes.push_back(row.Shape);
    }
  }
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    for (const char* kind : { "smooth", "automatic" })
    {
      add(
        shapes[i] + ", " + kind,
        [&](const Row& row) { return row.Shape == shapes[i] && row.Kind == kind; }, value, i,
        std::string(kind) == "automatic");
    }
  }
  if (withAllowed)
  {
    add(
      "allowed",
      [&](const Row& row) { return row.Shape == shapes.front() && row.Kind == "smooth"; },
      [](const Row& row) { return row.Allowed; }, 4, false);
  }
  chart->SetShowLegend(true);
  chart->GetLegend()->SetLabelSize(14);
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::LEFT);
  chart->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
  return chart;
}
}

int main(int argc, char* argv[])
{
  const std::string folder = argc > 1 ? std::string(argv[1]) + "/" : std::string();
  const std::vector<Shape> shapes = makeShapes();
  {
    ToleranceScene first(shapes.front().Surface, Lights[0].Place);
    benchmarks::drawFrame(first.Window);
    std::printf(
      "%d x %d, the light moves; milliseconds, medians of %d frames in turns, volumes timed "
      "with StepTiming; ratio of frames to\ndiscrete; distance in pixels of the shadow's edge "
      "on the ground, halfway between a lit and a dark pixel, from the\ntrue shape's: allowed "
      "is PixelTolerance over the cosine at which rays meet the ground, and half a pixel; "
      "pixels that\ndiffer from a tolerance of %.2f\n%s\n",
      ToleranceScene::Size, ToleranceScene::Size, Rounds, ReferenceTolerance,
      benchmarks::conditions(first.Window).c_str());
  }
  std::printf("%-12s %-10s %-10s %5s %-9s %6s %8s %7s %5s %8s %6s %8s %7s\n", "shape", "light",
    "kind", "toler", "taken", "points", "volume", "frame", "ratio", "largest", "RMS", "allowed",
    "differ");
  std::vector<Row> rows;
  for (const Shape& shape : shapes)
  {
    for (const NamedLight& light : Lights)
    {
      for (const Row& row : measureShape(shape, light))
      {
        print(row);
        rows.push_back(row);
      }
      std::fflush(stdout);
    }
  }
  const std::vector<vtkSmartPointer<vtkChartXY>> charts = {
    chartOf(
      rows, "Largest distance of the shadow's edge from the true one", "pixels", { 0.0, 5.0 },
      [](const Row& row) { return row.Error.Largest; }, true),
    chartOf(
      rows, "Points of the silhouette", "log10 of points", { 1.5, 5.5 },
      [](const Row& row) { return std::log10(static_cast<double>(row.Points)); }, false)
  };
  return writeTable(folder + "pixel-tolerance.csv", rows) &&
      benchmarks::writeCharts(folder + "pixel-tolerance.png", charts)
    ? 0
    : 1;
}
