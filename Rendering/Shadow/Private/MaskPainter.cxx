#include "MaskPainter.h"

#include "OpenGLFunctions.h"
#include "SceneBounds.h"
#include "SilhouetteChoice.h"

#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkStencilShadowPass.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace
{
Matrix4 FindWorldToClip(vtkRenderer* renderer)
{
  auto* camera = static_cast<vtkOpenGLCamera*>(renderer->GetActiveCamera());
  vtkMatrix4x4* worldToView;
  vtkMatrix3x3* normals;
  vtkMatrix4x4* viewToClip;
  vtkMatrix4x4* worldToClip;
  camera->GetKeyMatrices(renderer, worldToView, normals, viewToClip, worldToClip);

  // The camera keeps its matrices as OpenGL reads them, column by column.
  return Transposed(ToMatrix4(worldToClip));
}

/**
 * A plane of the world in the mesh's coordinates.
 */
std::array<double, 4> MovePlane(const std::array<double, 4>& plane, const Matrix4& toWorld)
{
  std::array<double, 4> moved;
  vtkMatrix4x4::MultiplyPoint(Transposed(toWorld).data(), plane.data(), moved.data());
  return moved;
}

/**
 * How much longer a matrix makes what it makes longest.
 */
double FindGreatestScale(const Matrix4& matrix)
{
  double linear[3][3];
  for (std::size_t row = 0; row < 3; ++row)
  {
    std::copy_n(&matrix[4 * row], 3, linear[row]);
  }
  double left[3][3];
  double scales[3];
  double right[3][3];
  vtkMath::SingularValueDecomposition3x3(linear, left, scales, right);
  return std::max({ std::abs(scales[0]), std::abs(scales[1]), std::abs(scales[2]) });
}

SceneRecord RecordScene(const PlanReceivers& receivers, const std::vector<ShadowLight>& lights,
  const std::vector<ShadowCaster>& casters)
{
  SceneRecord record;
  record.Add(receivers.AllBounds);
  record.Add(static_cast<vtkTypeUInt64>(receivers.Bounded));
  for (const std::array<double, 6>& bounds : receivers.Bounds)
  {
    record.Add(bounds);
  }
  for (const ShadowLight& light : lights)
  {
    record.Add(light.Position);
    record.Add(light.Direction);
    record.Add(light.ConeAngle);
  }
  for (const ShadowCaster& caster : casters)
  {
    record.Add(caster.Mesh, caster.Mesh->GetMTime());
    record.Add(caster.ToWorld);
  }
  return record;
}
}

bool MaskPainter::Prepare(vtkOpenGLRenderWindow* window, const std::array<int, 2>& size, int lights,
  std::string& error)
{
  this->Window = window;
  if (!this->Target.Fits(size[0], size[1], lights))
  {
    this->DepthRecord = SceneRecord();
    this->MaskRecord = SceneRecord();
  }
  return this->Target.Allocate(window->GetState(), size[0], size[1], lights, error) &&
    this->Counter.Prepare(window, error);
}

void MaskPainter::Release()
{
  this->Volumes.Release();
  this->Counter.Release();
  this->Target.Release();
  this->DepthRecord = SceneRecord();
  this->MaskRecord = SceneRecord();
  this->Plan.clear();
}

void MaskPainter::BeginFrame(vtkRenderer* renderer, const std::vector<ShadowLight>& lights,
  const SceneRecord& occluders, const MaskSettings& settings, vtkMTimeType settingsTime)
{
  this->Settings = settings;
  this->Lights = lights;
  this->Casters = CollectShadowCasters(renderer, this->Surfaces);
  this->Receivers = FindReceivers(renderer, this->ReceivingProps);
  this->View = { FindWorldToClip(renderer), this->Target.GetWidth(), this->Target.GetHeight() };

  SceneRecord depth;
  depth.Add(renderer, 0);
  depth.Add(this->View.WorldToClip);
  depth.Append(occluders);
  SceneRecord masks = RecordScene(this->Receivers, this->Lights, this->Casters);
  masks.Add(static_cast<vtkTypeUInt64>(settingsTime));
  this->DepthIsOld = !settings.ReuseUnchanged || !depth.IsSameAs(this->DepthRecord);
  this->MasksAreOld = this->DepthIsOld || !masks.IsSameAs(this->MaskRecord);
  this->DepthRecord = std::move(depth);
  this->MaskRecord = std::move(masks);
}

std::string MaskPainter::Paint(vtkRenderer* renderer, int unit)
{
  std::string tooFewBits;
  if (!this->MasksAreOld)
  {
    for (std::size_t i = 0; i < this->Lights.size(); ++i)
    {
      this->Plan.push_back({ static_cast<int>(i), -1, "mask of before", "nothing has changed" });
    }
    return tooFewBits;
  }
  const ShadowPlan plan(this->View, this->Receivers, this->Settings.Rules);
  this->MeasureCasters();
  this->Volumes.BeginFrame();
  for (std::size_t i = 0; i < this->Lights.size(); ++i)
  {
    const std::string reason = this->PaintMask(renderer, plan, static_cast<int>(i), unit);
    tooFewBits = reason.empty() ? tooFewBits : reason;
  }
  this->Volumes.EndFrame(renderer);
  return tooFewBits;
}

void MaskPainter::MeasureCasters()
{
  std::unordered_map<vtkProp*, std::size_t> receiverOf;
  for (std::size_t i = 0; i < this->ReceivingProps.size(); ++i)
  {
    receiverOf.emplace(this->ReceivingProps[i], i);
  }
  this->Boxes.clear();
  for (const ShadowCaster& caster : this->Casters)
  {
    const std::array<double, 6> bounds = FindFiniteBounds(caster.Mesh);
    const auto own = receiverOf.find(caster.Prop);
    this->Boxes.push_back({ bounds, FindDiagonal(bounds),
      own != receiverOf.end() ? own->second : ShadowPlan::NoReceiver });
  }
}

std::string MaskPainter::PaintMask(
  vtkRenderer* renderer, const ShadowPlan& plan, int mask, int unit)
{
  const ShadowLight& light = this->Lights[static_cast<std::size_t>(mask)];
  vtkOpenGLState* state = this->Window->GetState();
  std::vector<PlannedVolume> volumes;
  std::int64_t depth = 0;
  for (std::size_t j = 0; j < this->Casters.size(); ++j)
  {
    const double start = vtkTimerLog::GetUniversalTime();
    volumes.push_back(
      this->PlanVolume(renderer, plan, light, this->Casters[j], this->Boxes[j]));
    const PlannedVolume& planned = volumes.back();
    depth += planned.Buffers ? planned.Buffers->GetGreatestDepth() : 0;
    this->AddStep(
      { mask, static_cast<int>(j), planned.Plan.Decision, planned.Plan.Reason }, start);
  }
  const double start = vtkTimerLog::GetUniversalTime();
  std::string error;
  this->Target.BeginMask(state, mask);
  const bool inFloats =
    depth > VolumeCounter::GreatestStencilDepth && this->Target.BeginCounts(state, error);
  inFloats ? this->Counter.BeginCountingInFloats(state)
           : this->Counter.BeginCountingInStencil(state);
  for (std::size_t j = 0; j < this->Casters.size(); ++j)
  {
    this->CountVolume(volumes[j], light, this->Casters[j]);
  }
  this->Counter.EndCounting(state);
  this->Target.OpenMask(state, mask);
  inFloats ? this->Counter.WriteMaskOfFloats(state, this->Target.GetCounts(), unit)
           : this->Counter.WriteMaskOfStencil(state);
  const char* where = inFloats ? "volumes counted in floats" : "volumes counted in the stencil";
  this->AddStep({ mask, -1, where, "something has changed" }, start);
  return error;
}

MaskPainter::PlannedVolume MaskPainter::PlanVolume(vtkRenderer* renderer, const ShadowPlan& plan,
  const ShadowLight& light, const ShadowCaster& caster, const CasterBox& box)
{
  PlannedVolume planned;
  planned.Plan = this->Decide(renderer, plan, light, caster, box);
  if (planned.Plan.Skip)
  {
    return planned;
  }
  const int made = this->Volumes.GetNumberMade();
  const VolumeCache::Quality quality =
    this->ChooseQuality(renderer, caster, box, planned.Plan);
  const VolumeBuffers& buffers = this->Volumes.Get(renderer, caster.Mesh,
    caster.MoveIntoMesh(light.Position), quality, this->Counter.GetAttribute());
  if (buffers.IsEmpty())
  {
    planned.Plan.Decision = "skip";
    planned.Plan.Reason = "it has no volume";
    return planned;
  }
  planned.Buffers = &buffers;
  static const char* const kinds[] = { ", discrete", ", accurate", ", smooth" };
  planned.Plan.Decision += kinds[quality.Kind];
  planned.Plan.Decision +=
    this->Volumes.GetNumberMade() == made ? ", volume of before" : ", new volume";
  return planned;
}

/**
 * By bounds with room for contours that leave the mesh. How much they need takes time to find, once
 * for a mesh: not for one that would be skipped with as much as it is large.
 */
CasterPlan MaskPainter::Decide(vtkRenderer* renderer, const ShadowPlan& plan,
  const ShadowLight& light, const ShadowCaster& caster, const CasterBox& box)
{
  constexpr double share = 0.1;
  const PlanLight planLight{ light.Position, light.Direction, light.ConeAngle };
  const auto decide = [&](double room) {
    return plan.Decide(
      planLight, CornersOf(WithRoom(box.Bounds, room), caster.ToWorld), box.Receiver);
  };
  const bool isSmooth = this->Settings.Kind == vtkStencilShadowPass::AUTOMATIC ||
    this->Settings.Kind == vtkStencilShadowPass::SMOOTH;
  if (!isSmooth)
  {
    return decide(share * box.Size);
  }
  if (!this->Volumes.KnowsMeshDeviation(caster.Mesh))
  {
    const CasterPlan roomy = decide(box.Size);
    if (roomy.Skip)
    {
      return roomy;
    }
  }
  return decide(share * box.Size + 2.0 * this->Volumes.GetMeshDeviation(renderer, caster.Mesh));
}

/**
 * Tolerances are bounded below: where the eye touches something a pixel may be as small as one
 * likes.
 */
VolumeCache::Quality MaskPainter::ChooseQuality(vtkRenderer* renderer, const ShadowCaster& caster,
  const CasterBox& box, CasterPlan& plan)
{
  constexpr double finest = 1e-6;
  VolumeCache::Quality quality{ this->Settings.Kind, 1.0, !plan.ZPass };
  const bool isChosen = quality.Kind == vtkStencilShadowPass::AUTOMATIC;
  if (!isChosen && quality.Kind != vtkStencilShadowPass::SMOOTH)
  {
    return quality;
  }
  // All in the unit that the mesh's diagonal is.
  const double pixel = plan.Pixel / (FindGreatestScale(caster.ToWorld) * box.Size);
  const double deviation = isChosen
    ? this->Volumes.GetMeshDeviation(renderer, caster.Mesh) / box.Size
    : std::numeric_limits<double>::quiet_NaN();
  const SilhouetteChoice choice =
    ChooseSilhouette(deviation, pixel, this->Settings.PixelTolerance);
  if (isChosen)
  {
    quality.Kind = choice.Smooth ? vtkStencilShadowPass::SMOOTH : vtkStencilShadowPass::DISCRETE;
    plan.Reason += "; " + choice.Reason;
  }
  if (choice.Smooth)
  {
    quality.Tolerance = std::clamp(choice.Tolerance, finest, 1.0);
  }
  return quality;
}

void MaskPainter::CountVolume(
  const PlannedVolume& volume, const ShadowLight& light, const ShadowCaster& caster)
{
  const std::array<int, 4>& scissor = volume.Plan.Scissor;
  if (!volume.Buffers || scissor[2] <= 0 || scissor[3] <= 0)
  {
    return;
  }
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(scissor[0], scissor[1], scissor[2], scissor[3]);
  this->Counter.Count(state, *volume.Buffers,
    { this->View.WorldToClip * caster.ToWorld, caster.MoveIntoMesh(light.Position),
      MovePlane(volume.Plan.End, caster.ToWorld), volume.Plan.DepthRange },
    volume.Plan.ZPass);
}

void MaskPainter::AddStep(PlanRow row, double start)
{
  if (this->Settings.WaitAfterSteps)
  {
    this->Window->WaitForCompletion();
  }
  row.Milliseconds = 1e3 * (vtkTimerLog::GetUniversalTime() - start);
  this->Plan.push_back(std::move(row));
}
