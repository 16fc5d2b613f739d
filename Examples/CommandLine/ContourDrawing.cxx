#include "ContourDrawing.h"

#include "DrawingView.h"
#include "Failure.h"
#include "Shading.h"

#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkSmoothLightSilhouette.h>
#include <vtkStripper.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
// The lines that have this value of the cells' array.
vtkSmartPointer<vtkPolyData> LinesWith(vtkPolyData* lines, const char* array, double value)
{
  vtkDataArray* values = lines->GetCellData()->GetArray(array);
  return LinesThat(lines, [&](vtkIdType line) { return values->GetComponent(line, 0) == value; });
}

// Whose coordinates are the largest.
const Mesh& FarthestOf(const std::vector<Mesh>& meshes)
{
  const auto reach = [](const Mesh& mesh) {
    double bounds[6];
    mesh.Data->GetBounds(bounds);
    double largest = 0.0;
    for (const double bound : bounds)
    {
      largest = std::max(largest, std::abs(bound));
    }
    return largest;
  };
  return *std::max_element(meshes.begin(), meshes.end(),
    [&](const Mesh& a, const Mesh& b) { return reach(a) < reach(b); });
}

// Edges that are sharp or a border, joined.
vtkSmartPointer<vtkPolyData> CreasesOf(vtkPolyData* mesh, double featureAngle)
{
  vtkNew<vtkCleanPolyData> welded;
  welded->SetInputData(mesh);
  welded->SetTolerance(0.0);
  welded->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(welded->GetOutputPort());
  edges->SetFeatureAngle(featureAngle);
  edges->ColoringOff();
  vtkNew<vtkStripper> joined;
  joined->SetInputConnection(edges->GetOutputPort());
  joined->JoinContiguousSegmentsOn();
  joined->SetMaximumLength(100000);
  joined->Update();
  return joined->GetOutput();
}

class Drawing
{
public:
  Drawing(const std::vector<Mesh>& meshes, double featureAngle, const DrawingOptions& options)
    : FeatureAngle(featureAngle)
  {
    for (const Mesh& mesh : meshes)
    {
      this->Shaded.push_back(PrepareForShading(mesh.Data, featureAngle).Data);
      if (this->Shaded.back()->GetNumberOfPolys() == 0)
      {
        throw Failure("no triangle has finite points", mesh.File, "write the mesh again");
      }
      this->Surfaces.push_back(this->Shaded.back());
    }
    this->View = Scene(this->Surfaces, options.Scene).View();
  }

  std::vector<DrawnLine> Outlines(const DrawingView& view) const
  {
    std::vector<DrawnLine> lines;
    for (vtkPolyData* surface : this->Surfaces)
    {
      vtkNew<vtkSmoothLightSilhouette> outline;
      outline->SetInputData(surface);
      Homogeneous eye = view.Eye();
      outline->SetLightPosition(eye.data());
      outline->SetFeatureAngle(this->FeatureAngle);
      outline->Update();
      // The smooth surface's outline may lie inside of the mesh.
      const double outwards = 2.0 * outline->ComputeMeshDeviation() + 1e-6 * surface->GetLength();
      Append(lines, view.DrawAll(outline->GetOutput(), outwards));
    }
    return lines;
  }

  std::vector<DrawnLine> Creases(const DrawingView& view) const
  {
    std::vector<DrawnLine> lines;
    for (vtkPolyData* surface : this->Surfaces)
    {
      Append(lines, view.DrawAll(CreasesOf(surface, this->FeatureAngle)));
    }
    return lines;
  }

  std::vector<vtkPolyData*> Surfaces;
  Camera View;

private:
  static void Append(std::vector<DrawnLine>& lines, std::vector<DrawnLine> more)
  {
    std::move(more.begin(), more.end(), std::back_inserter(lines));
  }

  std::vector<vtkSmartPointer<vtkPolyData>> Shaded;
  double FeatureAngle;
};

Json CountPaths(const std::vector<DrawnLine>& lines)
{
  return std::count_if(
    lines.begin(), lines.end(), [](const DrawnLine& line) { return !line.empty(); });
}

// In the size of the picture, or to scale.
SvgDrawing MakeSvg(const DrawingView& view, const DrawingOptions& options)
{
  if (options.Scale == 0.0)
  {
    return SvgDrawing(
      view.Width(), view.Height(), options.Scene.Size[0], options.Scene.Size[1], "");
  }
  const double width = options.Scale * view.Width();
  const double height = options.Scale * view.Height();
  const auto isShown = [](double size) { return std::isfinite(size) && size > 0.0; };
  if (!isShown(width) || !isShown(height))
  {
    std::ostringstream message;
    message << "--scale " << options.ScaleText << ": a sheet of " << view.Width() << " x "
            << view.Height() << " units has no size on paper then, a "
            << (std::isinf(std::max(width, height)) ? "smaller" : "larger") << " scale is wanted";
    throw UsageError(message.str());
  }
  return SvgDrawing(view.Width(), view.Height(), width, height, "mm");
}
}

Json WriteDrawing(vtkPolyData* contours, const std::vector<Mesh>& meshes, double featureAngle,
  const Homogeneous& light, const DrawingOptions& options, OutputFile& file)
{
  DrawingOptions chosen = options;
  chosen.Scene.Lights = { light };
  const Drawing drawing(meshes, featureAngle, chosen);
  const DrawingView view(drawing.View, options.Parallel, options.Scene.Size, drawing.Surfaces);
  if (!std::isfinite(view.Width()) || !std::isfinite(view.Height()))
  {
    throw Failure("the scene is too large for a view of it", FarthestOf(meshes).File,
      "check the meshes' coordinates, or give --eye and --at");
  }

  std::vector<SvgDrawing::Layer> layers = {
    { "hidden-contours", "Shadow contours in shadow", "#7f8fa6", 1.5, true,
      view.DrawAll(LinesWith(contours, "Visible", 0.0)) },
    { "contours", "Shadow contours", "#1f4e8c", 2.0, false,
      view.DrawAll(LinesWith(contours, "Visible", 1.0)) },
  };
  if (options.Outlines)
  {
    layers.push_back({ "creases", "Creases", "#333333", 1.5, false, drawing.Creases(view) });
    layers.push_back({ "outlines", "Outlines", "#000000", 2.5, false, drawing.Outlines(view) });
  }

  Json statistics;
  const Camera& camera = drawing.View;
  statistics["camera"] = { { "eye", camera.Eye }, { "at", camera.At }, { "up", camera.Up },
    { "angle", camera.Angle } };
  statistics["parallel"] = options.Parallel;
  statistics["sheet"] = { view.Width(), view.Height() };
  for (const SvgDrawing::Layer& layer : layers)
  {
    statistics["paths"][layer.Id] = CountPaths(layer.Lines);
  }
  SvgDrawing svg = MakeSvg(view, options);
  for (SvgDrawing::Layer& layer : layers)
  {
    svg.Add(std::move(layer));
  }
  if (!svg.Write(file.TemporaryPath()))
  {
    throw Failure("cannot be written", file.Path(), "check the room there");
  }
  return statistics;
}
