// What casts: whatever a mapper draws as an opaque surface, where it draws it.

#include "ImageChecks.h"
#include "ShadowScene.h"
#include "TestMeshes.h"

#include "vtkStencilShadowPass.h"

#include <vtkActor.h>
#include <vtkBitArray.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkCompositePolyDataMapper.h>
#include <vtkCompositePolyDataMapper2.h>
#include <vtkDataSetMapper.h>
#include <vtkDoubleArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStripper.h>
#include <vtkTransform.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace
{
using namespace shadowtest;

const std::vector<RayLight> BothLights = { PointLight, DirectionalLight };

/**
 * A scene in a window, to which an actor with a mapper is added.
 */
struct Stage : Scene
{
  vtkSmartPointer<vtkRenderWindow> Window = MakeWindow(240, 180);
  vtkNew<vtkActor> Actor;
  vtkSmartPointer<vtkLight> Light;
  RayLight Position;

  Stage(vtkMapper* mapper, const RayLight& position)
    : Position(position)
  {
    this->Actor->SetMapper(mapper);
    this->Renderer->AddActor(this->Actor);
    this->Light = this->AddLight(position);
    this->Window->AddRenderer(this->Renderer);
  }

  /// Draws, and expects the mask of the objects over the ground.
  void Expect(std::vector<RayObject> objects, const char* what)
  {
    objects.insert(objects.begin(), RayObject{ this->GroundMesh });
    this->Window->Render();
    ExpectMask(*this, this->Light, this->Position, objects, what);
  }

  void ExpectNoShadow(const char* what)
  {
    this->Window->Render();
    const Image mask = this->Mask(this->Light);
    ASSERT_TRUE(mask) << what;
    EXPECT_EQ(blackFraction(mask), 0.0) << what;
  }
};

/// A mesh of lines and nothing else.
Mesh Lines(const Vec3& shift)
{
  auto mesh = Mesh::New();
  mesh->SetPoints(moved(FloatingBox(), 1.0, shift)->GetPoints());
  vtkNew<vtkCellArray> lines;
  for (vtkIdType i = 1; i < mesh->GetNumberOfPoints(); ++i)
  {
    lines->InsertNextCell({ i - 1, i });
  }
  mesh->SetLines(lines);
  return mesh;
}

/**
 * Blocks that do not touch, two of them in a block of their own. Lines are under the ground: seen,
 * they would be in the way of the oracle, which knows of none.
 */
struct Blocks
{
  Mesh Cube = moved(box(), 0.35, { -1.2, 0.2, 0.8 }, 5);
  Mesh Ring = moved(torus(20, 10), 0.45, { 0.1, 0.0, 1.3 }, 3);
  Mesh Ball = moved(sphere(8, 16), 0.35, { 1.3, 0.3, 0.9 });
  vtkNew<vtkMultiBlockDataSet> Inner;
  vtkNew<vtkMultiBlockDataSet> All;

  Blocks()
  {
    this->Inner->SetBlock(0, this->Ring);
    this->Inner->SetBlock(2, this->Ball);
    this->All->SetBlock(0, Lines({ 0.0, 0.0, -3.0 }));
    this->All->SetBlock(1, this->Cube);
    this->All->SetBlock(3, this->Inner);
  }
};
}

TEST(StencilShadowPass, BlocksOfCompositeMappers)
{
  for (const RayLight& position : BothLights)
  {
    const Blocks blocks;
    const std::vector<RayObject> objects = { { blocks.Cube }, { blocks.Ring }, { blocks.Ball } };
    vtkNew<vtkCompositePolyDataMapper> simple;
    simple->SetInputDataObject(blocks.All);
    Stage simpleStage(simple, position);
    simpleStage.Expect(objects, "vtkCompositePolyDataMapper");
    EXPECT_EQ(simpleStage.Pass->GetNumberOfVolumesMade(), 4);
    simpleStage.Expect(objects, "second frame");
    EXPECT_EQ(simpleStage.Pass->GetNumberOfVolumesMade(), 0);

    vtkNew<vtkCompositePolyDataMapper2> mapper;
    mapper->SetInputDataObject(blocks.All);
    Stage stage(mapper, position);
    stage.Actor->RotateZ(20.0);
    stage.Actor->SetScale(1.0, 0.8, 1.1);
    vtkMatrix4x4* matrix = stage.Actor->GetMatrix();
    stage.Expect({ { blocks.Cube, matrix }, { blocks.Ring, matrix }, { blocks.Ball, matrix } },
      "vtkCompositePolyDataMapper2");
    EXPECT_EQ(stage.Pass->GetNumberOfVolumesMade(), 4);
    stage.Look(3.0, -6.0, 5.0);
    stage.Window->Render();
    EXPECT_EQ(stage.Pass->GetNumberOfVolumesMade(), 0);
    blocks.Ring->GetPoints()->Modified();
    stage.Window->Render();
    EXPECT_EQ(stage.Pass->GetNumberOfVolumesMade(), 1);
  }
}

TEST(StencilShadowPass, BlocksOfPartitionedData)
{
  const Blocks blocks;
  vtkNew<vtkPartitionedDataSet> pair;
  pair->SetPartition(0, blocks.Ring);
  pair->SetPartition(1, blocks.Ball);
  vtkNew<vtkPartitionedDataSet> single;
  single->SetPartition(0, blocks.Cube);
  vtkNew<vtkPartitionedDataSetCollection> all;
  all->SetPartitionedDataSet(0, pair);
  all->SetPartitionedDataSet(2, single);
  vtkNew<vtkCompositePolyDataMapper2> mapper;
  mapper->SetInputDataObject(all);
  Stage stage(mapper, PointLight);
  stage.Expect({ { blocks.Cube }, { blocks.Ring }, { blocks.Ball } }, "all");
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  attributes->SetBlockVisibility(pair, false);
  stage.Expect({ { blocks.Cube } }, "one set hidden");
}

TEST(StencilShadowPass, BlocksHiddenAndTranslucent)
{
  const Blocks blocks;
  vtkNew<vtkCompositePolyDataMapper2> mapper;
  mapper->SetInputDataObject(blocks.All);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  Stage stage(mapper, PointLight);
  stage.Expect({ { blocks.Cube }, { blocks.Ring }, { blocks.Ball } }, "all visible");

  attributes->SetBlockVisibility(blocks.Cube, false);
  stage.Expect({ { blocks.Ring }, { blocks.Ball } }, "one hidden");
  EXPECT_EQ(stage.Pass->GetNumberOfVolumesMade(), 0);
  attributes->SetBlockVisibility(blocks.Cube, true);
  attributes->SetBlockVisibility(blocks.Inner, false);
  stage.Expect({ { blocks.Cube } }, "those in a block hidden");
  EXPECT_EQ(stage.Pass->GetNumberOfVolumesMade(), 1);
  attributes->SetBlockVisibility(blocks.Ball, true);
  stage.Expect({ { blocks.Cube }, { blocks.Ball } }, "visible in a hidden one");
  attributes->SetBlockVisibility(blocks.All, false);
  attributes->SetBlockVisibility(blocks.Cube, false);
  attributes->SetBlockVisibility(blocks.Ball, false);
  stage.ExpectNoShadow("all hidden");

  // A translucent block neither casts nor is in the depth that masks are drawn on.
  attributes->RemoveBlockVisibilities();
  attributes->SetBlockOpacity(blocks.Inner, 0.5);
  mapper->Modified();
  stage.Expect({ { blocks.Cube } }, "those in a block translucent");
  attributes->SetBlockOpacity(blocks.Ball, 1.0);
  mapper->Modified();
  stage.Expect({ { blocks.Cube }, { blocks.Ball } }, "opaque in a translucent one");
  attributes->RemoveBlockOpacities();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < blocks.Ring->GetNumberOfPoints(); ++i)
  {
    colors->InsertNextTuple4(200.0, 100.0, 50.0, 128.0);
  }
  blocks.Ring->GetPointData()->SetScalars(colors);
  mapper->Modified();
  stage.Expect({ { blocks.Cube }, { blocks.Ball } }, "translucent by scalars");
}

namespace
{
/**
 * Points with what glyphs are made by, and the glyphs that should come of them.
 */
struct Glyphs
{
  vtkNew<vtkPolyData> Points;
  vtkNew<vtkGlyph3DMapper> Mapper;
  /// Not symmetric in any way: a box with another at a corner, and a ball off the middle.
  Mesh Source = moved(
    merged({ box(0.5, 0.3, 0.2), moved(box(), 0.15, { 0.8, 0.2, 0.3 }) }), 0.6, { 0.0, 0.0, 0.0 });
  Mesh Other = moved(sphere(8, 16), 0.3, { 0.1, 0.1, 0.0 });
  vtkNew<vtkTransform> Transforms[4];
  bool Drawn[4] = { true, true, true, true };
  bool IsOther[4] = { false, false, false, false };

  Glyphs()
  {
    const Vec3 places[4] = { { -1.5, -0.6, 0.8 }, { 0.9, -0.9, 0.7 }, { -0.8, 1.0, 1.1 },
      { 1.4, 0.9, 0.9 } };
    vtkNew<vtkPoints> points;
    for (int i = 0; i < 4; ++i)
    {
      points->InsertNextPoint(places[i].data());
      this->Transforms[i]->Translate(places[i].data());
    }
    this->Points->SetPoints(points);
    this->Mapper->SetInputData(this->Points);
    this->Mapper->SetSourceData(this->Source);
    this->Mapper->OrientOff();
    this->Mapper->ScalingOff();
  }

  void AddArray(const char* name, int components, const std::vector<double>& values)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    for (double value : values)
    {
      array->InsertNextValue(value);
    }
    ASSERT_EQ(array->GetNumberOfTuples(), 4);
    this->Points->GetPointData()->AddArray(array);
  }

  /// The actor's matrix, if it has one, becomes part of the transforms.
  std::vector<RayObject> Objects(vtkMatrix4x4* actor)
  {
    std::vector<RayObject> objects;
    for (int i = 0; i < 4; ++i)
    {
      this->Transforms[i]->PostMultiply();
      this->Transforms[i]->Concatenate(actor);
      if (this->Drawn[i])
      {
        objects.push_back(
          { this->IsOther[i] ? this->Other : this->Source, this->Transforms[i]->GetMatrix() });
      }
    }
    return objects;
  }
};

void ScaleByMagnitude(Glyphs& glyphs)
{
  glyphs.AddArray("size", 1, { 0.5, 1.0, -1.5, 2.0 });
  glyphs.Mapper->ScalingOn();
  glyphs.Mapper->SetScaleFactor(0.8);
  glyphs.Mapper->SetScaleModeToScaleByMagnitude();
  glyphs.Mapper->SetScaleArray("size");
  const double sizes[4] = { 0.4, 0.8, 1.2, 1.6 };
  for (int i = 0; i < 4; ++i)
  {
    glyphs.Transforms[i]->Scale(sizes[i], sizes[i], sizes[i]);
  }
}

void ScaleByComponents(Glyphs& glyphs)
{
  glyphs.AddArray("size", 3, { 1, 2, 1, 0.5, 1.5, 2, 1.5, 1, 1, 1.2, 0.8, 2.5 });
  glyphs.Mapper->ScalingOn();
  glyphs.Mapper->SetScaleModeToScaleByVectorComponents();
  glyphs.Mapper->SetScaleArray("size");
  glyphs.Transforms[0]->Scale(1, 2, 1);
  glyphs.Transforms[1]->Scale(0.5, 1.5, 2);
  glyphs.Transforms[2]->Scale(1.5, 1, 1);
  glyphs.Transforms[3]->Scale(1.2, 0.8, 2.5);
}

void Mirror(Glyphs& glyphs)
{
  glyphs.AddArray("size", 3, { -1, 2, 1, 1, -1.5, 2, 1.5, 1, -1, -1.2, -0.8, -1.5 });
  glyphs.Mapper->ScalingOn();
  glyphs.Mapper->SetScaleModeToScaleByVectorComponents();
  glyphs.Mapper->SetScaleArray("size");
  glyphs.Transforms[0]->Scale(-1, 2, 1);
  glyphs.Transforms[1]->Scale(1, -1.5, 2);
  glyphs.Transforms[2]->Scale(1.5, 1, -1);
  glyphs.Transforms[3]->Scale(-1.2, -0.8, -1.5);
}

void Clamp(Glyphs& glyphs)
{
  glyphs.AddArray("size", 1, { 3.0, 4.0, 5.0, 9.0 });
  glyphs.Mapper->ScalingOn();
  glyphs.Mapper->SetScaleModeToScaleByMagnitude();
  glyphs.Mapper->SetScaleArray("size");
  glyphs.Mapper->ClampingOn();
  glyphs.Mapper->SetRange(2.0, 6.0);
  const double sizes[4] = { 0.25, 0.5, 0.75, 1.0 };
  for (int i = 0; i < 4; ++i)
  {
    glyphs.Transforms[i]->Scale(sizes[i], sizes[i], sizes[i]);
  }
}

/// Zero scales are 1e-10 in the mapper: a disc, a needle and a point.
void Flatten(Glyphs& glyphs)
{
  glyphs.AddArray("size", 3, { 1.5, 1.5, 0, 0, 0, 2, 0, 0, 0, 1, 1, 1 });
  glyphs.Mapper->ScalingOn();
  glyphs.Mapper->SetScaleModeToScaleByVectorComponents();
  glyphs.Mapper->SetScaleArray("size");
  glyphs.Transforms[0]->Scale(1.5, 1.5, 1e-10);
  glyphs.Drawn[1] = false;
  glyphs.Drawn[2] = false;
}

void OrientByRotation(Glyphs& glyphs)
{
  glyphs.AddArray("turn", 3, { 30, 40, 50, 0, 70, 20, -60, 10, 0, 100, -20, 130 });
  glyphs.Mapper->OrientOn();
  glyphs.Mapper->SetOrientationModeToRotation();
  glyphs.Mapper->SetOrientationArray("turn");
  const double turns[4][3] = { { 30, 40, 50 }, { 0, 70, 20 }, { -60, 10, 0 }, { 100, -20, 130 } };
  for (int i = 0; i < 4; ++i)
  {
    glyphs.Transforms[i]->RotateZ(turns[i][2]);
    glyphs.Transforms[i]->RotateX(turns[i][0]);
    glyphs.Transforms[i]->RotateY(turns[i][1]);
  }
}

void OrientByQuaternion(Glyphs& glyphs)
{
  // Half angles of 60 degrees: turns of 120.
  const double c = std::cos(vtkMath::Pi() / 3.0);
  const double s = std::sin(vtkMath::Pi() / 3.0);
  glyphs.AddArray("turn", 4, { c, s, 0, 0, c, 0, s, 0, c, 0, 0, s, c, 0.6 * s, 0.0, 0.8 * s });
  glyphs.Mapper->OrientOn();
  glyphs.Mapper->SetOrientationModeToQuaternion();
  glyphs.Mapper->SetOrientationArray("turn");
  glyphs.Transforms[0]->RotateWXYZ(120.0, 1, 0, 0);
  glyphs.Transforms[1]->RotateWXYZ(120.0, 0, 1, 0);
  glyphs.Transforms[2]->RotateWXYZ(120.0, 0, 0, 1);
  glyphs.Transforms[3]->RotateWXYZ(120.0, 0.6, 0, 0.8);
}

/// The x axis turns into the direction; both by half a turn about the middle between them.
void OrientByDirection(Glyphs& glyphs)
{
  glyphs.AddArray("to", 3, { 0, 2, 0, 1, 1, 1, -3, 0, 0, 0, 0, 0 });
  glyphs.Mapper->OrientOn();
  glyphs.Mapper->SetOrientationModeToDirection();
  glyphs.Mapper->SetOrientationArray("to");
  glyphs.Transforms[0]->RotateWXYZ(180.0, 1, 1, 0);
  glyphs.Transforms[1]->RotateWXYZ(180.0, 1.0 + std::sqrt(3.0), 1, 1);
  glyphs.Transforms[2]->RotateWXYZ(180.0, 0, 1, 0);
}

void OrientAndScale(Glyphs& glyphs)
{
  OrientByRotation(glyphs);
  ScaleByComponents(glyphs);
}

void Mask(Glyphs& glyphs)
{
  vtkNew<vtkBitArray> mask;
  mask->SetName("mask");
  for (int bit : { 1, 0, 0, 1 })
  {
    mask->InsertNextValue(bit);
  }
  glyphs.Points->GetPointData()->AddArray(mask);
  glyphs.Mapper->MaskingOn();
  glyphs.Mapper->SetMaskArray("mask");
  glyphs.Drawn[1] = false;
  glyphs.Drawn[2] = false;
}

/// Values below and above the range take the first and the last source.
void IndexSources(Glyphs& glyphs)
{
  glyphs.AddArray("kind", 1, { 0.0, 0.9, 1.0, 7.0 });
  glyphs.Mapper->SetSourceData(1, glyphs.Other);
  glyphs.Mapper->SourceIndexingOn();
  glyphs.Mapper->SetSourceIndexArray("kind");
  glyphs.Mapper->SetRange(1.0, 3.0);
  glyphs.IsOther[2] = true;
  glyphs.IsOther[3] = true;
}

void SourcesInATable(Glyphs& glyphs)
{
  IndexSources(glyphs);
  vtkNew<vtkMultiBlockDataSet> nested;
  nested->SetBlock(0, glyphs.Other);
  vtkNew<vtkMultiBlockDataSet> table;
  table->SetBlock(0, glyphs.Source);
  table->SetBlock(1, nested);
  glyphs.Mapper->RemoveAllInputConnections(1);
  glyphs.Mapper->SetSourceTableTree(table);
  glyphs.Mapper->UseSourceTableTreeOn();
}

/// The points in two blocks, of which the second is hidden.
void PointsInBlocks(Glyphs& glyphs)
{
  ScaleByMagnitude(glyphs);
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkPolyData> hidden;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 2.0);
  hidden->SetPoints(points);
  blocks->SetBlock(0, glyphs.Points);
  blocks->SetBlock(1, hidden);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  attributes->SetBlockVisibility(hidden, false);
  glyphs.Mapper->SetInputDataObject(blocks);
  glyphs.Mapper->SetBlockAttributes(attributes);
}
}

TEST(StencilShadowPass, GlyphsCastAsTheMapperPlacesThem)
{
  struct Case
  {
    const char* Name;
    std::function<void(Glyphs&)> Prepare;
  };
  for (const Case& test :
    std::vector<Case>{ { "plain", [](Glyphs&) {} }, { "magnitude", ScaleByMagnitude },
      { "components", ScaleByComponents }, { "mirrored", Mirror }, { "clamped", Clamp },
      { "flattened", Flatten }, { "rotation", OrientByRotation },
      { "quaternion", OrientByQuaternion }, { "direction", OrientByDirection },
      { "rotation and components", OrientAndScale }, { "masked", Mask },
      { "indexed", IndexSources }, { "table", SourcesInATable }, { "blocks", PointsInBlocks } })
  {
    SCOPED_TRACE(test.Name);
    for (const RayLight& position : BothLights)
    {
      Glyphs glyphs;
      test.Prepare(glyphs);
      Stage stage(glyphs.Mapper, position);
      stage.Actor->SetPosition(0.2, 0.1, 0.3);
      stage.Actor->RotateX(10.0);
      stage.Actor->SetScale(1.0, 1.1, 0.9);
      stage.Expect(glyphs.Objects(stage.Actor->GetMatrix()), test.Name);
      stage.Look(-2.0, -6.0, 5.0);
      stage.Window->Render();
      EXPECT_EQ(stage.Pass->GetNumberOfVolumesMade(), 0);
    }
  }
}

TEST(StencilShadowPass, GlyphsShareVolumesWhereTheirLightIsTheSame)
{
  // Along a direction glyphs that are only moved see the same light; a lamp each sees elsewhere.
  for (const RayLight& position : BothLights)
  {
    Glyphs glyphs;
    Stage stage(glyphs.Mapper, position);
    stage.Window->Render();
    EXPECT_EQ(stage.Pass->GetNumberOfVolumesMade(), position[3] == 0.0 ? 2 : 5);
  }

  // A glyph that moves is the only one to be made again; one that is masked needs nothing.
  Glyphs glyphs;
  Mask(glyphs);
  Stage stage(glyphs.Mapper, PointLight);
  stage.Window->Render();
  EXPECT_EQ(stage.Pass->GetNumberOfVolumesMade(), 3);
  glyphs.Points->GetPoints()->SetPoint(3, 1.2, 0.9, 1.2);
  glyphs.Points->GetPoints()->Modified();
  glyphs.Transforms[3]->Translate(-0.2, 0.0, 0.3);
  stage.Expect(glyphs.Objects(stage.Actor->GetMatrix()), "moved");
  EXPECT_EQ(stage.Pass->GetNumberOfVolumesMade(), 1);
}

TEST(StencilShadowPass, HundredsOfGlyphs)
{
  // More volumes than the stencil can count, should they all lie around one point.
  vtkNew<vtkPolyData> points;
  vtkNew<vtkPoints> places;
  for (int i = 0; i < 225; ++i)
  {
    places->InsertNextPoint(-1.75 + 0.25 * (i % 15), -1.75 + 0.25 * (i / 15), 0.5 + 0.002 * i);
  }
  points->SetPoints(places);
  const Mesh source = moved(icosphere(1), 0.1, { 0.0, 0.0, 0.0 });
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(points);
  mapper->SetSourceData(source);
  Stage stage(mapper, DirectionalLight);
  std::vector<Mesh> copies;
  for (vtkIdType i = 0; i < places->GetNumberOfPoints(); ++i)
  {
    Vec3 place;
    places->GetPoint(i, place.data());
    copies.push_back(moved(source, 1.0, place));
  }
  stage.Expect({ { merged(copies) } }, "glyphs");
  EXPECT_EQ(stage.Pass->GetNumberOfVolumesMade(), 2);
}

TEST(StencilShadowPass, SurfacesOfDataSets)
{
  // A box of cells with one taken away at a corner, so that inner faces come to the surface.
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 3, 3);
  image->SetSpacing(0.4, 0.5, 0.3);
  image->SetOrigin(-0.6, -0.5, 0.6);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  image->GetPointData()->Initialize();
  const Mesh whole = moved(box(0.6, 0.5, 0.3), 1.0, { 0.0, 0.0, 0.9 });
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners->InsertNextPoint(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 1.3 : 0.5);
  }
  grid->SetPoints(corners);
  for (const std::vector<vtkIdType>& cell : std::vector<std::vector<vtkIdType>>{
         { 0, 3, 5, 6 }, { 1, 0, 3, 5 }, { 2, 0, 6, 3 }, { 4, 0, 5, 6 } })
  {
    grid->InsertNextCell(VTK_TETRA, 4, cell.data());
  }
  // Without corner 7 it is a cube cut along 3, 5, 6.
  MeshBuilder cut;
  for (vtkIdType i = 0; i < 7; ++i)
  {
    Vec3 corner;
    corners->GetPoint(i, corner.data());
    cut.addPoint(corner);
  }
  for (const auto& face :
    std::vector<std::vector<vtkIdType>>{ { 0, 2, 3 }, { 0, 3, 1 }, { 0, 1, 5 }, { 0, 5, 4 },
      { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 5 }, { 2, 6, 3 }, { 4, 5, 6 }, { 3, 6, 5 } })
  {
    cut.addTriangle(face[0], face[1], face[2]);
  }
  const Mesh tetrahedra = cut.build();

  for (const RayLight& position : BothLights)
  {
    vtkNew<vtkDataSetMapper> mapper;
    mapper->SetInputData(image);
    Stage stage(mapper, position);
    stage.Actor->RotateZ(25.0);
    vtkMatrix4x4* matrix = stage.Actor->GetMatrix();
    stage.Expect({ { whole, matrix } }, "image");
    EXPECT_EQ(stage.Pass->GetNumberOfVolumesMade(), 2);
    stage.Expect({ { whole, matrix } }, "image again");
    EXPECT_EQ(stage.Pass->GetNumberOfVolumesMade(), 0);
    mapper->SetInputData(grid);
    stage.Expect({ { tetrahedra, matrix } }, "tetrahedra");
    EXPECT_EQ(stage.Pass->GetNumberOfVolumesMade(), 1);
    const Mesh ball = moved(sphere(8, 16), 0.6, { 0.0, 0.0, 1.0 });
    mapper->SetInputData(ball);
    stage.Expect({ { ball, matrix } }, "polygons");
  }
}

TEST(StencilShadowPass, DataSetsThatTheCameraNeverSaw)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  image->SetOrigin(-0.5, -0.5, 2.0);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(image);
  Stage stage(mapper, PointLight);
  // Down onto the ground from below the box; the renderer culls what is behind.
  stage.Light->SetPosition(1.5, 1.0, 8.0);
  stage.Position = { 1.5, 1.0, 8.0, 1.0 };
  stage.Look(-1.0, -2.0, 1.2);
  stage.Renderer->GetActiveCamera()->SetFocalPoint(-0.3, 0.0, 0.0);
  stage.Expect({ { moved(box(0.5, 0.5, 0.5), 1.0, { 0.0, 0.0, 2.5 }) } }, "behind");
  EXPECT_EQ(mapper->GetPolyDataMapper(), nullptr);
}

TEST(StencilShadowPass, StripsCastAndLinesDoNot)
{
  for (const RayLight& position : BothLights)
  {
    const Mesh mesh = moved(torus(20, 10), 0.7, { 0.0, 0.0, 1.2 }, 3);
    vtkNew<vtkStripper> stripper;
    stripper->SetInputData(mesh);
    stripper->Update();
    ASSERT_GT(stripper->GetOutput()->GetNumberOfStrips(), 0);
    ASSERT_EQ(stripper->GetOutput()->GetNumberOfPolys(), 0);
    vtkNew<vtkPolyDataMapper> strips;
    strips->SetInputData(stripper->GetOutput());
    Stage(strips, position).Expect({ { mesh } }, "strips");

    // On the ring's own points, where they cover next to nothing of it.
    vtkNew<vtkPolyData> mixed;
    mixed->DeepCopy(mesh);
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkCellArray> vertices;
    for (vtkIdType i = 1; i < mesh->GetNumberOfPoints(); i += 7)
    {
      lines->InsertNextCell({ i - 1, i });
      vertices->InsertNextCell({ i });
    }
    mixed->SetLines(lines);
    mixed->SetVerts(vertices);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mixed);
    Stage(mapper, position).Expect({ { mesh } }, "lines on a ring");

    vtkNew<vtkPolyDataMapper> alone;
    alone->SetInputData(Lines({ 0.0, 0.0, 0.0 }));
    Stage(alone, position).ExpectNoShadow("lines");
  }
}

TEST(StencilShadowPass, WireframesPointsAndSplatsDoNotCast)
{
  const Mesh mesh = FloatingBox();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  Stage stage(mapper, PointLight);
  stage.Expect({ { mesh } }, "surface");
  stage.Actor->GetProperty()->SetRepresentationToWireframe();
  stage.ExpectNoShadow("wireframe");
  stage.Actor->GetProperty()->SetRepresentationToPoints();
  stage.ExpectNoShadow("points");
  stage.Actor->GetProperty()->SetRepresentationToSurface();
  stage.Actor->GetProperty()->EdgeVisibilityOn();
  stage.Expect({ { mesh } }, "surface with edges");

  vtkNew<vtkPointGaussianMapper> splats;
  splats->SetInputData(mesh);
  splats->SetScaleFactor(0.05);
  splats->EmissiveOff();
  Stage(splats, PointLight).ExpectNoShadow("splats");
  vtkNew<vtkOpenGLSphereMapper> balls;
  balls->SetInputData(mesh);
  balls->SetRadius(0.05f);
  Stage(balls, PointLight).ExpectNoShadow("balls");
}
