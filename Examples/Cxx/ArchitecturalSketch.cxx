// A sketch as architects draw them, of an animal on a chair in the sun: outlines, creases, the
// contours of cast shadows, and hatching where the sun does not come. As a picture its strokes are
// ribbons drawn as if by hand, over surfaces of paper on which the shadow pass lays a pale wash; as
// an SVG they are plain lines in layers.
//
//     ArchitecturalSketch sketch.png sketch.svg [animal.obj]
//
// The animal's y points upwards. Without one a torus is drawn.

#include "DrawingView.h"
#include "LineOfSight.h"
#include "SvgDrawing.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCamera.h>
#include <vtkCastShadowContour.h>
#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkContourStrokes.h>
#include <vtkCubeSource.h>
#include <vtkCutter.h>
#include <vtkFeatureEdges.h>
#include <vtkImageShrink3D.h>
#include <vtkInformation.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkOffscreenWindows.h>
#include <vtkPNGWriter.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPlane.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkSmoothLightSilhouette.h>
#include <vtkStencilShadowPass.h>
#include <vtkStripper.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
using PolyData = vtkSmartPointer<vtkPolyData>;

constexpr double SeatHeight = 0.46; // metres, as all of the scene
constexpr double AnimalHeight = 0.40;
const Homogeneous Sun = { -0.75, -0.45, 1.0, 0.0 };
const Camera View = { { -0.75, -2.35, 1.35 }, { 0.44, 0.28, 0.43 }, { 0.0, 0.0, 1.0 }, 25.5 };
constexpr std::array<int, 2> Size = { 1200, 1000 };
constexpr int Supersampling = 2;

const Vector3 HatchNormal = { 0.62, -0.62, 0.48 }; // of the planes in which its lines are
constexpr double HatchSpacing = 0.016;
constexpr double HatchStep = 0.004; // shadows that are narrower may be missed
constexpr double ShortestHatch = 0.008;

PolyData OutputOf(vtkPolyDataAlgorithm* filter)
{
  filter->Update();
  return filter->GetOutput();
}

void AddBox(vtkAppendPolyData* boxes, const Vector3& low, const Vector3& high)
{
  vtkNew<vtkCubeSource> box;
  box->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  box->SetBounds(low[0], high[0], low[1], high[1], low[2], high[2]);
  boxes->AddInputConnection(box->GetOutputPort());
}

// Of beams that do not touch each other but at a hair's breadth, as they are glued.
PolyData MakeChair()
{
  const double gap = 1e-4;
  const double beam = 0.045;
  const double width = 0.46;
  const double depth = 0.46;
  const double top = SeatHeight - 0.035;
  vtkNew<vtkAppendPolyData> boxes;
  boxes->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  AddBox(boxes, { 0.0, 0.0, top }, { width, depth - beam - gap, SeatHeight });
  for (const double x : { 0.0, width - beam })
  {
    AddBox(boxes, { x, 0.0, 0.0 }, { x + beam, beam, top - gap });
    AddBox(boxes, { x, depth - beam, 0.0 }, { x + beam, depth, 1.0 });
    AddBox(boxes, { x + 0.01, beam + gap, 0.17 }, { x + beam - 0.01, depth - beam - gap, 0.2 });
  }
  for (const double z : { 0.58, 0.74, 0.9 })
  {
    AddBox(
      boxes, { beam + gap, depth - 0.032, z }, { width - beam - gap, depth - 0.012, z + 0.07 });
  }
  // One mesh of welded boxes, without normals: all its edges are sharp.
  vtkNew<vtkCleanPolyData> welded;
  welded->SetInputConnection(boxes->GetOutputPort());
  welded->SetTolerance(0.0);
  welded->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(welded->GetOutputPort());
  PolyData chair = OutputOf(triangles);
  chair->GetPointData()->Initialize();
  return chair;
}

// On the seat, facing the way it likes.
PolyData MakeAnimal(const char* file)
{
  vtkSmartPointer<vtkPolyDataAlgorithm> source;
  vtkNew<vtkTransform> place;
  place->PostMultiply();
  if (file)
  {
    auto reader = vtkSmartPointer<vtkOBJReader>::New();
    reader->SetFileName(file);
    source = reader;
    place->RotateX(90.0);
    place->RotateZ(25.0);
  }
  else
  {
    vtkNew<vtkParametricTorus> torus;
    torus->SetCrossSectionRadius(0.4);
    auto sampled = vtkSmartPointer<vtkParametricFunctionSource>::New();
    sampled->SetParametricFunction(torus);
    source = sampled;
    place->RotateX(70.0);
    place->RotateZ(25.0);
  }
  vtkNew<vtkCleanPolyData> welded;
  welded->SetInputConnection(source->GetOutputPort());
  welded->SetTolerance(file ? 0.0 : 1e-6);
  welded->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkTransformPolyDataFilter> turned;
  turned->SetInputConnection(welded->GetOutputPort());
  turned->SetTransform(place);
  turned->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  double bounds[6];
  OutputOf(turned)->GetBounds(bounds);
  const double scale = AnimalHeight / (bounds[5] - bounds[4]);
  place->Translate(-0.5 * (bounds[0] + bounds[1]), -0.5 * (bounds[2] + bounds[3]), -bounds[4]);
  place->Scale(scale, scale, scale);
  place->Translate(0.23, 0.2, SeatHeight + 1e-4);
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(turned->GetOutputPort());
  normals->SplittingOff();
  PolyData animal = OutputOf(normals);
  animal->GetPointData()->SetScalars(nullptr);
  return animal;
}

PolyData MakeGround()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->SetOrigin(-4.0, -4.0, 0.0);
  plane->SetPoint1(6.0, -4.0, 0.0);
  plane->SetPoint2(-4.0, 6.0, 0.0);
  return OutputOf(plane);
}

struct Model
{
  PolyData Chair;
  PolyData Animal;
  PolyData Ground;

  std::vector<vtkPolyData*> All() const { return { this->Chair, this->Animal, this->Ground }; }
};

PolyData SilhouetteOf(vtkPolyData* mesh, Homogeneous from, int kind)
{
  vtkNew<vtkSmoothLightSilhouette> silhouette;
  silhouette->SetInputData(mesh);
  silhouette->SetKind(kind);
  silhouette->SetLightPosition(from.data());
  return OutputOf(silhouette);
}

PolyData CreasesOf(vtkPolyData* mesh)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->ColoringOff();
  return OutputOf(edges);
}

PolyData CastContoursOf(const Model& model, const std::vector<vtkPolyData*>& receivers)
{
  vtkNew<vtkCastShadowContour> contour;
  // Discrete, as then what is hidden is told exactly, by the triangles that the hatching is by.
  for (vtkPolyData* caster : { model.Chair.Get(), model.Animal.Get() })
  {
    contour->AddInputDataObject(0, SilhouetteOf(caster, Sun, vtkSmoothLightSilhouette::DISCRETE));
    contour->AddInputDataObject(2, caster);
  }
  for (vtkPolyData* receiver : receivers)
  {
    contour->AddInputDataObject(1, receiver);
  }
  return OutputOf(contour);
}

std::vector<Polyline3> LinesOf(vtkPolyData* data)
{
  std::vector<Polyline3> lines;
  for (vtkIdType cell = 0; cell < data->GetNumberOfLines(); ++cell)
  {
    vtkIdType count;
    const vtkIdType* ids;
    data->GetLines()->GetCellAtId(cell, count, ids);
    Polyline3 line(static_cast<std::size_t>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      data->GetPoint(ids[i], line[static_cast<std::size_t>(i)].data());
    }
    lines.push_back(line);
  }
  return lines;
}

PolyData DataOf(const std::vector<Polyline3>& lines)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Polyline3& line : lines)
  {
    cells->InsertNextCell(static_cast<int>(line.size()));
    for (const Vector3& point : line)
    {
      cells->InsertCellPoint(points->InsertNextPoint(point.data()));
    }
  }
  auto data = PolyData::New();
  data->SetPoints(points);
  data->SetLines(cells);
  return data;
}

double LengthOf(const Polyline3& line)
{
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    length += std::hypot(
      line[i][0] - line[i - 1][0], line[i][1] - line[i - 1][1], line[i][2] - line[i - 1][2]);
  }
  return length;
}

// The lines that are at least so long: a scanned surface has many short ones, which no hand draws.
PolyData WithoutShort(vtkPolyData* data, double shortest)
{
  const std::vector<Polyline3> lines = LinesOf(data);
  vtkNew<vtkCellArray> cells;
  for (vtkIdType cell = 0; cell < data->GetNumberOfLines(); ++cell)
  {
    if (LengthOf(lines[static_cast<std::size_t>(cell)]) >= shortest)
    {
      vtkIdType count;
      const vtkIdType* ids;
      data->GetLines()->GetCellAtId(cell, count, ids);
      cells->InsertNextCell(count, ids);
    }
  }
  auto kept = PolyData::New();
  kept->SetPoints(data->GetPoints());
  kept->GetPointData()->ShallowCopy(data->GetPointData());
  kept->SetLines(cells);
  return kept;
}

// Lines of a surface in parallel planes.
std::vector<Polyline3> LinesInPlanes(vtkPolyData* surface)
{
  vtkNew<vtkPlane> plane;
  Vector3 normal = HatchNormal;
  plane->SetNormal(normal.data());
  vtkNew<vtkCutter> cutter;
  cutter->SetInputData(surface);
  cutter->SetCutFunction(plane);
  cutter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  cutter->GenerateTrianglesOff();
  const int planes = static_cast<int>(6.0 / HatchSpacing);
  cutter->GenerateValues(planes, -3.0, -3.0 + (planes - 1) * HatchSpacing);
  vtkNew<vtkStripper> joined;
  joined->SetInputConnection(cutter->GetOutputPort());
  joined->JoinContiguousSegmentsOn();
  joined->SetMaximumLength(100000);
  return LinesOf(OutputOf(joined));
}

// What of these lines the sun does not reach: in cast shadows, and where a surface faces away from
// it, as it is then in its own way.
std::vector<Polyline3> Hatching(const Model& model)
{
  const LineOfSight sight(model.All());
  std::vector<Polyline3> hatching;
  for (vtkPolyData* surface : model.All())
  {
    for (const Polyline3& line : LinesInPlanes(surface))
    {
      const auto isDark = [&](std::size_t i, double share) {
        const Vector3& a = line[i];
        const Vector3& b = line[i + 1];
        return !sight.IsFree({ a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1]),
                               a[2] + share * (b[2] - a[2]) },
          Sun);
      };
      const auto steps = [&](std::size_t i) {
        return 1 + static_cast<int>(LengthOf({ line[i], line[i + 1] }) / HatchStep);
      };
      for (const Polyline3& part : PartsOf(line, isDark, steps))
      {
        if (LengthOf(part) > ShortestHatch)
        {
          hatching.push_back(part);
        }
      }
    }
  }
  return hatching;
}

// How the lines of a layer are drawn.
struct Pen
{
  std::string Id;
  std::string Label;
  double Width; // pixels
  double Taper;
  double Overshoot;
  double Wobble;
  double Lift;
  double Grey;
};

struct Layer
{
  Pen How;
  PolyData Lines;
};

std::vector<Layer> MakeLayers(const Model& model)
{
  const Homogeneous eye = { View.Eye[0], View.Eye[1], View.Eye[2], 1.0 };
  return {
    { { "hatching", "Hatching", 1.1, 0.1, 2.0, 0.5, 2.0, 0.42 }, DataOf(Hatching(model)) },
    { { "contours", "Shadow contours", 1.5, 0.05, 2.0, 0.4, 0.5, 0.20 },
      CastContoursOf(model, { model.Chair, model.Ground }) },
    { { "animal-contours", "Shadow contours on the animal", 1.5, 0.1, 0.0, 0.3, 0.5, 0.20 },
      WithoutShort(CastContoursOf(model, { model.Animal }), 0.025) },
    { { "creases", "Creases", 1.7, 0.02, 6.0, 0.6, 2.0, 0.12 }, CreasesOf(model.Chair) },
    { { "outlines", "Outlines", 2.4, 0.1, 1.0, 0.3, 5.0, 0.05 },
      WithoutShort(SilhouetteOf(model.Animal, eye, vtkSmoothLightSilhouette::SMOOTH), 0.05) },
  };
}

bool WriteSvg(const Model& model, const std::vector<Layer>& layers, const char* file)
{
  const DrawingView view(View, false, Size, model.All());
  SvgDrawing drawing(view.Width(), view.Height(), Size[0], Size[1], "");
  const double pixels = 1e3 / Size[1]; // in thousandths of the height
  for (const Layer& layer : layers)
  {
    const int grey = static_cast<int>(255.0 * layer.How.Grey);
    const std::string level = std::to_string(grey);
    drawing.Add({ layer.How.Id, layer.How.Label, "rgb(" + level + "," + level + "," + level + ")",
      layer.How.Width * pixels, false, view.DrawAll(layer.Lines, 1e-3) });
  }
  return drawing.Write(file);
}

// Paper: white where the light comes from above, a little less on other sides and in shadow.
vtkNew<vtkActor> PaperActor(vtkPolyData* mesh)
{
  const double cosine = Sun[2] / std::sqrt(Sun[0] * Sun[0] + Sun[1] * Sun[1] + Sun[2] * Sun[2]);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  actor->GetProperty()->SetAmbient(0.88);
  actor->GetProperty()->SetDiffuse(0.12 / cosine);
  return actor;
}

vtkNew<vtkActor> StrokeActor(const Layer& layer, vtkCamera* camera)
{
  vtkNew<vtkContourStrokes> strokes;
  strokes->SetInputData(layer.Lines);
  strokes->SetWidthUnitToPixels();
  strokes->SetWidth(Supersampling * layer.How.Width);
  Vector3 eye = View.Eye;
  strokes->SetEyePosition(eye[0], eye[1], eye[2], 1.0);
  strokes->SetViewDirection(camera->GetDirectionOfProjection());
  const double tangent = std::tan(0.5 * View.Angle * std::acos(-1.0) / 180.0);
  strokes->SetPixelSize(2.0 * tangent / (Supersampling * Size[1]));
  strokes->SetTaper(layer.How.Taper);
  strokes->SetOvershoot(layer.How.Overshoot);
  strokes->SetWobble(layer.How.Wobble);
  strokes->SetLift(layer.How.Lift);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(OutputOf(strokes));
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(layer.How.Grey, layer.How.Grey, layer.How.Grey);
  vtkNew<vtkInformation> keys;
  keys->Set(vtkStencilShadowPass::CASTS_SHADOW(), 0);
  keys->Set(vtkStencilShadowPass::RECEIVES_SHADOW(), 0);
  actor->SetPropertyKeys(keys);
  return actor;
}

bool WritePicture(const Model& model, const std::vector<Layer>& layers, const char* file)
{
  const auto window = vtkSmartPointer<vtkRenderWindow>::Take(vtkOffscreenWindows::NewWindow("egl"));
  if (!window)
  {
    std::cerr << vtkOffscreenWindows::GetLastReason() << std::endl;
    return false;
  }
  window->SetMultiSamples(0);
  window->SetSize(Supersampling * Size[0], Supersampling * Size[1]);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(View.Eye.data());
  camera->SetFocalPoint(View.At.data());
  camera->SetViewUp(View.Up.data());
  camera->SetViewAngle(View.Angle);
  for (vtkPolyData* mesh : model.All())
  {
    renderer->AddActor(PaperActor(mesh));
  }
  for (const Layer& layer : layers)
  {
    renderer->AddActor(StrokeActor(layer, camera));
  }
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  sun->SetPosition(Sun[0], Sun[1], Sun[2]);
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->AddLight(sun);
  vtkNew<vtkStencilShadowPass> shadows;
  renderer->SetPass(shadows);
  window->AddRenderer(renderer);
  renderer->ResetCameraClippingRange();
  window->Render();

  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  capture->ReadFrontBufferOff();
  vtkNew<vtkImageShrink3D> smaller;
  smaller->SetInputConnection(capture->GetOutputPort());
  smaller->SetShrinkFactors(Supersampling, Supersampling, 1);
  smaller->AveragingOn();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(smaller->GetOutputPort());
  writer->SetFileName(file);
  writer->Write();
  return writer->GetErrorCode() == 0;
}
}

int main(int argc, char* argv[])
{
  if (argc != 3 && argc != 4)
  {
    std::cerr << "usage: ArchitecturalSketch sketch.png sketch.svg [animal.obj]" << std::endl;
    return 2;
  }
  const Model model = { MakeChair(), MakeAnimal(argc == 4 ? argv[3] : nullptr), MakeGround() };
  if (model.Animal->GetNumberOfPolys() == 0)
  {
    std::cerr << "ArchitecturalSketch: error: no mesh, in " << argv[3] << std::endl;
    return 1;
  }
  const std::vector<Layer> layers = MakeLayers(model);
  for (const Layer& layer : layers)
  {
    std::cout << layer.How.Id << ": " << layer.Lines->GetNumberOfLines() << " lines" << std::endl;
  }
  const auto written = [](bool done, const char* file) {
    if (!done)
    {
      std::cerr << "ArchitecturalSketch: error: no drawing, in " << file << std::endl;
    }
    return done;
  };
  return written(WritePicture(model, layers, argv[1]), argv[1]) &&
      written(WriteSvg(model, layers, argv[2]), argv[2])
    ? 0
    : 1;
}
