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
}

void MaskPainter::BeginFrame(vtkRenderer* renderer, const std::vector<ShadowLight>& lights,
  const SceneRecord& occluders, const MaskSettings& settings, vtkMTimeType settingsTime)
{
  this->Settings = settings;
  this->Plan.clear();
  this->Lights = lights;
  this->Casters = CollectShadowCasters(renderer, this->Surfaces);
  this->Receivers = FindReceivers(renderer);
  this->View = { FindWorldToClip(renderer), this->Target.GetWidth(), this->Target.GetHeight() };

  SceneRecord depth;
  depth.Add(renderer, 0);
  depth.Add(this->View.WorldToClip);
  depth.Append(occluders);
  SceneRecord masks = depth;
  masks.Add(static_cast<vtkTypeUInt64>(settingsTime));
  masks.Append(RecordScene(this->Receivers, this->Lights, this->Casters));
  this->DepthIsOld = !settings.ReuseUnchanged || !depth.IsSameAs(this->DepthRecord);
  this->MasksAreOld = !settings.ReuseUnchanged || !masks.IsSameAs(this->MaskRecord);
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
  this->Volumes.BeginFrame();
  for (std::size_t i = 0; i < this->Lights.size(); ++i)
  {
    const std::string reason = this->PaintMask(renderer, plan, static_cast<int>(i), unit);
    tooFewBits = reason.empty() ? tooFewBits : reason;
  }
  this->Volumes.EndFrame(renderer);
  return tooFewBits;
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
    volumes.push_back(this->PlanVolume(renderer, plan, light, this->Casters[j]));
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
  this->AddStep({ mask, -1, inFloats ? "volumes counted in floats" : "volumes counted in the stencil",
                  "something has changed" },
    start);
  return error;
}

MaskPainter::PlannedVolume MaskPainter::PlanVolume(vtkRenderer* renderer, const ShadowPlan& plan,
  const ShadowLight& light, const ShadowCaster& caster)
{
  const bool isSmooth = this->Settings.Kind == vtkStencilShadowPass::AUTOMATIC ||
    this->Settings.Kind == vtkStencilShadowPass::SMOOTH;
  const double deviation = isSmooth ? this->Volumes.GetMeshDeviation(renderer, caster.Mesh) : 0.0;
  PlannedVolume planned;
  planned.Plan = plan.Decide({ light.Position, light.Direction, light.ConeAngle },
    CornersOf(BoundsWithContours(caster.Mesh, deviation), caster.ToWorld));
  if (planned.Plan.Skip)
  {
    return planned;
  }
  const int made = this->Volumes.GetNumberMade();
  const VolumeCache::Quality quality =
    this->ChooseQuality(planned.Plan, caster, deviation, planned.Plan.Reason);
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
 * Tolerances are bounded below: where the eye touches something a pixel may be as small as one likes.
 */
VolumeCache::Quality MaskPainter::ChooseQuality(
  const CasterPlan& plan, const ShadowCaster& caster, double deviation, std::string& reason)
{
  constexpr double finest = 1e-6;
  const double scale = FindGreatestScale(caster.ToWorld);
  const double size = caster.Mesh->GetLength();
  const bool isChosen = this->Settings.Kind == vtkStencilShadowPass::AUTOMATIC;
  const SilhouetteChoice choice = ChooseSilhouette(
    isChosen ? deviation * scale : std::numeric_limits<double>::quiet_NaN(), plan.Pixel,
    this->Settings.PixelTolerance);
  VolumeCache::Quality quality{ this->Settings.Kind, 0.0, !plan.ZPass };
  if (isChosen)
  {
    quality.Kind = choice.Smooth ? vtkStencilShadowPass::SMOOTH : vtkStencilShadowPass::DISCRETE;
    reason += "; " + choice.Reason;
  }
  if (quality.Kind == vtkStencilShadowPass::SMOOTH)
  {
    quality.Tolerance =
      choice.Smooth ? std::clamp(choice.Tolerance / scale, finest * size, size) : size;
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
