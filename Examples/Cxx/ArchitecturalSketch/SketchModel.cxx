#include "SketchModel.h"

#include "Vectors.h"

#include <vtkAppendPolyData.h>
#include <vtkCleanPolyData.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkParametricFunctionSource.h>
#include <vtkParametricTorus.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataNormals.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkTriangleFilter.h>

namespace
{
constexpr double SeatHeight = 0.46;
constexpr double AnimalHeight = 0.40;

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
}

Model MakeModel(const char* animal)
{
  return { MakeChair(), MakeAnimal(animal), MakeGround() };
}
