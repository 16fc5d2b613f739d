// A plane with 200 mechanical parts, a few meshes with matrices of their own, under three lights.
#ifndef PartsScene_h
#define PartsScene_h

#include "BenchmarkWindow.h"
#include "Random.h"
#include "RealMeshes.h"
#include "TestMeshes.h"

#include <vtkActor.h>
#include <vtkInformation.h>
#include <vtkInformationIntegerKey.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkStencilShadowPass.h>
#include <vtkTransform.h>

#include <vector>

namespace benchmarks
{
/// What parts are made of, of size 2 around the origin.
struct PartMeshes
{
  std::vector<vtkSmartPointer<vtkPolyData>> Meshes;

  PartMeshes()
  {
    constexpr const char* names[] = { "anchor_dense", "fandisk", "rotor", "turbine", "couplingdown",
      "joint", "pinion", "spool" };
    for (const char* name : names)
    {
      // Its normals are smooth everywhere; parts have creases.
      vtkNew<vtkPolyDataNormals> normals;
      normals->SetInputData(shadowtest::standing(shadowtest::cgalMesh(name), 2));
      normals->SetFeatureAngle(30.0);
      normals->Update();
      this->Meshes.push_back(normals->GetOutput());
    }
  }
};

/**
 * 20 x 10 parts, 2.5 apart. The eye looks along the rows from their middle, so that more than half
 * of them are behind it or beside its view. The last two columns are off the plane's edge, and
 * their parts show no shadows.
 */
class PartsScene
{
public:
  enum Mode
  {
    LIGHTS_MOVE,
    CAMERA_MOVES,
    AT_REST,
    NumberOfModes
  };

  static constexpr int Columns = 20;
  static constexpr int Rows = 10;
  static constexpr int NumberOfParts = Columns * Rows;
  static constexpr double Spacing = 2.5;

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkStencilShadowPass> Pass;
  vtkSmartPointer<vtkRenderWindow> Window;
  std::vector<vtkSmartPointer<vtkActor>> Parts;
  vtkIdType NumberOfTriangles = 0;

  PartsScene(const PartMeshes& meshes, int size)
  {
    this->addGround();
    this->addParts(meshes);
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetBackground(0.5, 0.5, 0.5);
    for (vtkLight* light : { this->Direction.Get(), this->Lamp.Get(), this->Spot.Get() })
    {
      light->SetLightTypeToSceneLight();
      light->SetIntensity(0.4);
      this->Renderer->AddLight(light);
    }
    this->Direction->PositionalOff();
    this->Lamp->PositionalOn();
    this->Lamp->SetConeAngle(180.0);
    this->Spot->PositionalOn();
    this->Spot->SetConeAngle(25.0);
    this->reset();
    this->Window = openWindow(size, this->Renderer);
    this->Renderer->SetPass(this->Pass);
  }

  void reset()
  {
    this->placeLights(0);
    this->placeCamera(0);
  }

  /// To a place that differs from that of the step before.
  void move(Mode mode, int step)
  {
    constexpr int places = 7;
    if (mode == LIGHTS_MOVE)
    {
      this->placeLights(step % places);
    }
    if (mode == CAMERA_MOVES)
    {
      this->placeCamera(step % places);
    }
  }

  /// From where everything was at first.
  vtkSmartPointer<vtkImageData> picture()
  {
    this->reset();
    drawFrame(this->Window);
    return grab(this->Window);
  }

  /// Whose bounds meet the camera's pyramid.
  int countPartsInView()
  {
    double planes[24];
    this->Renderer->GetActiveCamera()->GetFrustumPlanes(1.0, planes);
    int count = 0;
    for (const auto& part : this->Parts)
    {
      const double* b = part->GetBounds();
      bool inside = true;
      for (const double* p = planes; p < planes + 24; p += 4)
      {
        inside = inside &&
          p[0] * b[p[0] > 0.0 ? 1 : 0] + p[1] * b[p[1] > 0.0 ? 3 : 2] +
              p[2] * b[p[2] > 0.0 ? 5 : 4] + p[3] >
            0.0;
      }
      count += inside;
    }
    return count;
  }

private:
  static double columnAt(int column) { return Spacing * (column - 0.5 * (Columns - 1)); }
  static double rowAt(int row) { return Spacing * (row - 0.5 * (Rows - 1)); }

  void addGround()
  {
    // Up to between the last but two columns and the next, for any y.
    const double edge = columnAt(Columns - 3) + 0.5 * Spacing;
    const double half = Spacing * Columns;
    const auto mesh =
      shadowtest::moved(shadowtest::ground(0.0, half, 16), 1.0, { edge - half, 0.0, 0.0 });
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
  }

  void addParts(const PartMeshes& meshes)
  {
    std::vector<vtkSmartPointer<vtkPolyDataMapper>> mappers;
    for (vtkPolyData* mesh : meshes.Meshes)
    {
      mappers.push_back(vtkSmartPointer<vtkPolyDataMapper>::New());
      mappers.back()->SetInputData(mesh);
    }
    shadowtest::Random random(7);
    vtkNew<vtkInformation> receivesNot;
    receivesNot->Set(vtkStencilShadowPass::RECEIVES_SHADOW(), 0);
    for (int i = 0; i < NumberOfParts; ++i)
    {
      const int column = i % Columns;
      vtkPolyDataMapper* mapper = mappers[static_cast<std::size_t>(i) % mappers.size()];
      vtkNew<vtkTransform> place;
      place->PostMultiply();
      place->RotateZ(random.uniform(0.0, 360.0));
      const double scale = random.uniform(0.7, 1.0);
      place->Scale(scale, scale, scale);
      place->Translate(columnAt(column), rowAt(i / Columns),
        -scale * mapper->GetInput()->GetBounds()[4] + random.uniform(0.0, 0.5));
      const auto part = vtkSmartPointer<vtkActor>::New();
      part->SetMapper(mapper);
      part->SetUserMatrix(place->GetMatrix());
      if (column >= Columns - 2)
      {
        part->SetPropertyKeys(receivesNot);
      }
      this->Renderer->AddActor(part);
      this->Parts.push_back(part);
      this->NumberOfTriangles += mapper->GetInput()->GetNumberOfCells();
    }
  }

  void placeLights(int step)
  {
    const double shift = 0.1 * step;
    this->Direction->SetPosition(3.0 + shift, -2.0, 5.0);
    this->Direction->SetFocalPoint(0.0, 0.0, 0.0);
    this->Lamp->SetPosition(4.0, shift, 9.0);
    this->Spot->SetPosition(8.0 + shift, -4.0, 8.0);
    this->Spot->SetFocalPoint(8.0 + shift, 2.0, 0.0);
  }

  void placeCamera(int step)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(-3.0 + 0.05 * step, 0.0, 4.0);
    camera->SetFocalPoint(14.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(60.0);
    this->Renderer->ResetCameraClippingRange();
  }

  vtkNew<vtkLight> Direction;
  vtkNew<vtkLight> Lamp;
  vtkNew<vtkLight> Spot;
};
}

#endif
