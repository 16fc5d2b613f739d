// What the pass takes over from the frame before, and that it takes nothing over that has changed.

#include "ShadowScene.h"
#include "TestMeshes.h"

#include <vtkActor.h>
#include <vtkAssembly.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkCompositeDataDisplayAttributes.h>
#include <vtkCompositePolyDataMapper2.h>
#include <vtkGlyph3DMapper.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLActor.h>
#include <vtkPlane.h>
#include <vtkPlaneSource.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>
#include <utility>

namespace
{
using namespace shadowtest;

struct Reused
{
  bool Depth = false;
  bool Masks = false;

  bool operator==(const Reused& other) const
  {
    return this->Depth == other.Depth && this->Masks == other.Masks;
  }
};

constexpr Reused All = { true, true };
constexpr Reused DepthAlone = { true, false };
constexpr Reused Nothing = { false, false };

void PrintTo(const Reused& reused, std::ostream* os)
{
  *os << (reused.Masks ? "masks" : reused.Depth ? "depth alone" : "nothing");
}

Reused ReusedBy(vtkStencilShadowPass* pass)
{
  Reused reused;
  const auto plan = vtkSmartPointer<vtkTable>::Take(pass->GetPlan());
  auto* decisions = vtkStringArray::SafeDownCast(plan->GetColumnByName("Decision"));
  for (vtkIdType row = 0; row < plan->GetNumberOfRows(); ++row)
  {
    reused.Depth = reused.Depth || decisions->GetValue(row) == "depth of before";
    reused.Masks = reused.Masks || decisions->GetValue(row) == "mask of before";
  }
  return reused;
}

/**
 * A box over the ground under two lights.
 */
struct Stage : Scene
{
  Mesh Box = FloatingBox();
  vtkSmartPointer<vtkActor> Actor;
  vtkSmartPointer<vtkLight> Lamp;
  vtkSmartPointer<vtkLight> Sun;
  vtkSmartPointer<vtkRenderWindow> Window = MakeWindow(240, 180);

  Stage()
  {
    this->Actor = this->Add(this->Box);
    this->Lamp = this->AddLight(PointLight, 0.5);
    this->Sun = this->AddLight(DirectionalLight, 0.5);
    this->Window->AddRenderer(this->Renderer);
  }

  void Draw() { this->Window->Render(); }

  struct Result
  {
    Image Picture;
    Image LampMask;
    Image SunMask;
  };

  Result Look()
  {
    this->Draw();
    return { Grab(this->Window), this->Mask(this->Lamp), this->Mask(this->Sun) };
  }

  /// Draws as it is, more than twice, as VTK modifies what it draws for the first time; then changes something and draws again, with what may be kept from before
  /// and without: the same, bit by bit.
  void ExpectAfter(const std::function<void()>& change, const Reused& reused, const char* what)
  {
    this->Pass->ReuseUnchangedOn();
    this->Draw();
    this->Draw();
    this->Draw();
    EXPECT_EQ(ReusedBy(this->Pass), All) << "before " << what;
    change();
    const Result kept = this->Look();
    EXPECT_EQ(ReusedBy(this->Pass), reused) << what;
    this->Pass->ReuseUnchangedOff();
    const Result anew = this->Look();
    EXPECT_EQ(ReusedBy(this->Pass), Nothing) << what;
    EXPECT_EQ(Differences(kept.Picture, anew.Picture), 0) << what;
    ASSERT_EQ(!kept.LampMask, !anew.LampMask) << what;
    if (kept.LampMask)
    {
      EXPECT_EQ(Differences(kept.LampMask, anew.LampMask), 0) << what;
      EXPECT_EQ(Differences(kept.SunMask, anew.SunMask), 0) << what;
    }
  }
};

/// Might draw anything.
class ActorOfItsOwn : public vtkOpenGLActor
{
public:
  static ActorOfItsOwn* New();
  vtkTypeMacro(ActorOfItsOwn, vtkOpenGLActor);
};
vtkStandardNewMacro(ActorOfItsOwn);

/// In how many pixels the masks before and after a change differ.
long DifferencesBy(Stage& stage, const std::function<void()>& change)
{
  stage.Draw();
  const Image before = stage.Mask(stage.Sun);
  change();
  stage.Draw();
  return Differences(before, stage.Mask(stage.Sun));
}
}

TEST(ShadowPassReuse, NothingIsDrawnAnewAtRest)
{
  Stage stage;
  stage.Draw();
  EXPECT_EQ(ReusedBy(stage.Pass), Nothing);
  stage.ExpectAfter([] {}, All, "nothing");
  EXPECT_EQ(stage.Pass->GetNumberOfVolumesMade(), 0);
}

TEST(ShadowPassReuse, LightsKeepDepths)
{
  Stage stage;
  stage.ExpectAfter([&] { stage.Lamp->SetPosition(1.0, 1.5, 4.0); }, DepthAlone, "a lamp moved");
  stage.ExpectAfter([&] { stage.Sun->SetFocalPoint(0.5, 0.0, 0.0); }, DepthAlone, "a sun turned");
  stage.ExpectAfter([&] { stage.Lamp->SetConeAngle(20.0); }, DepthAlone, "a cone");
  stage.ExpectAfter([&] { stage.Pass->SetLightCasts(stage.Sun, false); stage.Sun = stage.Lamp; },
    DepthAlone, "a switch");
  // The mask is the same, how bright what it lets through is not.
  stage.ExpectAfter([&] { stage.Lamp->SetIntensity(0.2); }, All, "intensity");
  stage.ExpectAfter([&] { stage.Lamp->SetColor(1.0, 0.5, 0.2); }, All, "colour");
}

TEST(ShadowPassReuse, CameraAndWindow)
{
  Stage stage;
  stage.ExpectAfter([&] { stage.Renderer->GetActiveCamera()->Azimuth(3.0); }, Nothing, "camera");
  stage.ExpectAfter([&] { stage.Renderer->GetActiveCamera()->SetClippingRange(0.6, 30.0); },
    Nothing, "clipping range");
  stage.ExpectAfter([&] { stage.Window->SetSize(200, 150); }, Nothing, "size");
  stage.ExpectAfter(
    [&] { stage.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0); }, Nothing, "viewport");
}

TEST(ShadowPassReuse, ActorsThatChange)
{
  Stage stage;
  stage.ExpectAfter([&] { stage.Actor->SetPosition(0.1, 0.0, 0.0); }, Nothing, "moved");
  stage.ExpectAfter([&] { stage.Actor->GetProperty()->SetOpacity(0.5); }, Nothing, "translucent");
  stage.ExpectAfter([&] { stage.Actor->GetProperty()->SetOpacity(1.0); }, Nothing, "opaque");
  stage.ExpectAfter([&] { stage.Actor->VisibilityOff(); }, Nothing, "hidden");
  stage.ExpectAfter([&] { stage.Actor->VisibilityOn(); }, Nothing, "shown");
  stage.ExpectAfter(
    [&]
    {
      double p[3];
      stage.Box->GetPoint(0, p);
      stage.Box->GetPoints()->SetPoint(0, p[0], p[1], p[2] + 0.3);
      stage.Box->GetPoints()->Modified();
    },
    Nothing, "points");
  stage.ExpectAfter([&] { stage.Add(moved(box(), 0.2, { 1.0, 1.0, 0.5 })); }, Nothing, "added");
  stage.ExpectAfter([&] { stage.Renderer->RemoveActor(stage.Actor); }, Nothing, "removed");
}

TEST(ShadowPassReuse, KeysAndMatrices)
{
  Stage stage;
  const auto setKey = [&](vtkInformationIntegerKey* key, int value)
  {
    vtkNew<vtkInformation> keys;
    keys->Set(key, value);
    stage.Actor->SetPropertyKeys(keys);
  };
  EXPECT_GT(DifferencesBy(stage, [&] { setKey(vtkStencilShadowPass::CASTS_SHADOW(), 0); }), 100);
  stage.ExpectAfter(
    [&] { setKey(vtkStencilShadowPass::CASTS_SHADOW(), 1); }, DepthAlone, "casts");
  stage.ExpectAfter(
    [&] { setKey(vtkStencilShadowPass::RECEIVES_SHADOW(), 0); }, DepthAlone, "receives");
  vtkNew<vtkTransform> transform;
  stage.Actor->SetUserTransform(transform);
  stage.ExpectAfter([&] { transform->Translate(0.2, 0.1, 0.0); }, Nothing, "user transform");
  vtkNew<vtkAssembly> assembly;
  vtkNew<vtkAssembly> outer;
  const auto part = MakeActor(moved(box(), 0.2, { 1.0, 1.0, 0.5 }));
  assembly->AddPart(part);
  outer->AddPart(assembly);
  stage.Renderer->AddActor(outer);
  stage.ExpectAfter([&] { outer->SetPosition(0.2, 0.0, 0.0); }, Nothing, "assembly");
  stage.ExpectAfter([&] { assembly->RotateZ(20.0); }, Nothing, "inner assembly");
  stage.ExpectAfter([&] { part->SetScale(2.0); }, Nothing, "part");
  stage.ExpectAfter([&] { part->VisibilityOff(); }, Nothing, "hidden part");
  stage.ExpectAfter([&] { part->VisibilityOn(); }, Nothing, "shown part");
  stage.ExpectAfter([&] { part->GetMapper()->SetInputDataObject(FloatingBox()); }, Nothing,
    "another mesh");
  stage.ExpectAfter([&] { stage.Actor->ForceTranslucentOn(); }, Nothing, "forced translucent");
}

TEST(ShadowPassReuse, WhatMappersDraw)
{
  Stage stage;
  vtkNew<vtkMultiBlockDataSet> inner;
  vtkNew<vtkMultiBlockDataSet> blocks;
  const Mesh cube = moved(box(), 0.3, { -1.2, 0.2, 0.8 }, 5);
  inner->SetBlock(0, cube);
  inner->SetBlock(1, moved(box(), 0.3, { 1.2, 0.2, 0.8 }, 5));
  blocks->SetBlock(0, inner);
  vtkNew<vtkCompositePolyDataMapper2> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Renderer->AddActor(actor);
  stage.ExpectAfter([&] { attributes->SetBlockVisibility(cube, false); }, Nothing, "block hidden");
  stage.ExpectAfter(
    [&]
    {
      attributes->SetBlockVisibility(cube, true);
      cube->GetPoints()->SetPoint(0, -1.0, 0.0, 2.0);
      cube->GetPoints()->Modified();
    },
    Nothing, "block modified");

  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 0.9);
  stage.Actor->GetMapper()->AddClippingPlane(plane);
  stage.ExpectAfter([&] { plane->SetOrigin(0.0, 0.0, 1.0); }, Nothing, "clipping plane");

  vtkNew<vtkSphereSource> source;
  source->SetRadius(0.1);
  vtkNew<vtkPoints> places;
  places->InsertNextPoint(1.0, 1.0, 1.0);
  places->InsertNextPoint(-1.0, -1.0, 1.0);
  vtkNew<vtkPolyData> points;
  points->SetPoints(places);
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(points);
  glyphs->SetSourceConnection(source->GetOutputPort());
  vtkNew<vtkActor> balls;
  balls->SetMapper(glyphs);
  stage.Renderer->AddActor(balls);
  stage.ExpectAfter([&] { source->SetRadius(0.2); }, Nothing, "glyphs' source");
  stage.ExpectAfter(
    [&]
    {
      places->SetPoint(0, 0.5, 1.0, 1.0);
      places->Modified();
    },
    Nothing, "glyphs' places");
  stage.ExpectAfter([&] { glyphs->SetScaleFactor(2.0); }, Nothing, "glyphs' size");
}

/// A pipeline that nobody but the frame brings up to date, of what does not cast.
TEST(ShadowPassReuse, PipelinesOfReceivers)
{
  Stage stage;
  vtkNew<vtkPlaneSource> source;
  source->SetCenter(0.5, -0.5, 0.4);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkInformation> keys;
  keys->Set(vtkStencilShadowPass::CASTS_SHADOW(), 0);
  actor->SetPropertyKeys(keys);
  stage.Renderer->AddActor(actor);
  stage.ExpectAfter([&] { source->SetCenter(0.5, -0.5, 0.7); }, Nothing, "a receiver's source");
}

TEST(ShadowPassReuse, Settings)
{
  Stage stage;
  stage.ExpectAfter([&] { stage.Pass->SetKindToSmooth(); }, DepthAlone, "kind");
  stage.ExpectAfter([&] { stage.Pass->SetCountingToZFail(); }, DepthAlone, "counting");
  stage.ExpectAfter([&] { stage.Pass->SetPixelTolerance(2.0); }, DepthAlone, "tolerance");
}

/// The plan tells whose volumes were made again.
TEST(ShadowPassReuse, ThePlanShowsWhatMoved)
{
  Stage stage;
  const auto other = stage.Add(moved(sphere(8, 16), 0.4, { 1.4, 0.4, 1.0 }));
  stage.Draw();
  stage.Actor->SetPosition(0.1, 0.0, 0.0);
  stage.Draw();
  const auto plan = vtkSmartPointer<vtkTable>::Take(stage.Pass->GetPlan());
  std::map<std::pair<int, int>, bool> isNew;
  for (vtkIdType row = 0; row < plan->GetNumberOfRows(); ++row)
  {
    const std::string decision = plan->GetValueByName(row, "Decision").ToString();
    const bool isOld = decision.find("volume of before") != std::string::npos;
    if (isOld || decision.find("new volume") != std::string::npos)
    {
      isNew[{ plan->GetValueByName(row, "Light").ToInt(),
        plan->GetValueByName(row, "Caster").ToInt() }] = !isOld;
    }
  }
  // Ground, box and ball, under a lamp and a sun. Along the sun's rays a box that is moved has the
  // same volume.
  const std::map<std::pair<int, int>, bool> expected = { { { 0, 0 }, false }, { { 0, 1 }, true },
    { { 0, 2 }, false }, { { 1, 0 }, false }, { { 1, 1 }, false }, { { 1, 2 }, false } };
  EXPECT_EQ(isNew, expected);
  EXPECT_EQ(stage.Pass->GetNumberOfVolumesMade(), 1);
}

/// Others use the pass in between; what is in its buffers is theirs then.
TEST(ShadowPassReuse, RenderersInTurn)
{
  Stage stage;
  vtkNew<vtkRenderer> other;
  other->SetPass(stage.Pass);
  other->AddActor(MakeActor(stage.Box));
  other->AddLight(MakeLight(DirectionalLight));
  stage.Draw();
  const Image before = stage.Mask(stage.Sun);
  stage.Window->AddRenderer(other);
  stage.Draw();
  stage.Window->RemoveRenderer(other);
  stage.Draw();
  EXPECT_EQ(ReusedBy(stage.Pass), Nothing);
  EXPECT_EQ(Differences(stage.Mask(stage.Sun), before), 0);
  stage.Pass->ReleaseGraphicsResources(stage.Window);
  stage.Draw();
  EXPECT_EQ(ReusedBy(stage.Pass), Nothing);
  EXPECT_EQ(Differences(stage.Mask(stage.Sun), before), 0);
}

/// Of which nobody tells what they will draw.
TEST(ShadowPassReuse, UnknownProps)
{
  Stage stage;
  vtkNew<ActorOfItsOwn> actor;
  actor->SetMapper(stage.Actor->GetMapper());
  stage.Renderer->AddActor(actor);
  stage.Draw();
  stage.Draw();
  EXPECT_EQ(ReusedBy(stage.Pass), Nothing) << "an actor of its own";
  stage.Renderer->RemoveActor(actor);
  stage.Draw();
  stage.Draw();
  EXPECT_EQ(ReusedBy(stage.Pass), All);
  vtkNew<vtkCallbackCommand> uniforms;
  stage.Actor->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, uniforms);
  stage.Draw();
  stage.Draw();
  EXPECT_EQ(ReusedBy(stage.Pass), Nothing) << "a shader that is observed";
}

TEST(ShadowPassReuse, CoincidentTopology)
{
  Stage stage;
  stage.ExpectAfter([] { vtkMapper::SetResolveCoincidentTopologyToPolygonOffset(); }, Nothing,
    "coincident topology");
  stage.ExpectAfter([] { vtkMapper::SetResolveCoincidentTopologyToDefault(); }, Nothing,
    "no coincident topology");
}
