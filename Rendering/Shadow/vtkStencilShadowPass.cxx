#include "vtkStencilShadowPass.h"

#include "DataSetSurfaces.h"
#include "MaskedLighting.h"
#include "Matrix4.h"
#include "OpenGLFunctions.h"
#include "RenderPassKeys.h"
#include "RendererSteps.h"
#include "RestoredState.h"
#include "ShadowCasters.h"
#include "ShadowFramebuffer.h"
#include "ShadowLights.h"
#include "ShadowPlan.h"
#include "VolumeCache.h"
#include "VolumeCounter.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFrameBufferObjectBase.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkIntArray.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextureUnitManager.h"
#include "vtkTimeStamp.h"
#include "vtkTimerLog.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

vtkStandardNewMacro(vtkStencilShadowPass);
vtkCxxSetObjectMacro(vtkStencilShadowPass, DelegatePass, vtkRenderPass);
vtkInformationKeyMacro(vtkStencilShadowPass, CASTS_SHADOW, Integer);
vtkInformationKeyMacro(vtkStencilShadowPass, RECEIVES_SHADOW, Integer);

class vtkStencilShadowPass::Internals
{
public:
  ~Internals() { this->Release(); }

  /**
   * All that is on the graphics card belongs to one window at a time. It has to be told when that
   * window goes: the pass may by then be in no renderer that would tell.
   */
  void Attach(vtkOpenGLRenderWindow* window)
  {
    if (this->Window != window)
    {
      this->Release();
      this->Window = window;
      this->WindowObserver =
        window->AddObserver(vtkCommand::DeleteEvent, this, &Internals::Release);
      window->MakeCurrent();
    }
  }

  void Release()
  {
    if (!this->Window)
    {
      return;
    }
    this->Window->PushContext();
    this->Volumes.Release();
    this->Counter.Release();
    this->Target.Release();
    this->Window->PopContext();
    this->Window->RemoveObserver(this->WindowObserver);
    this->Window = nullptr;
    this->MaskedLights.clear();
  }

  /**
   * Takes the lights of this frame. The mappers' shaders depend only on which of them has which
   * mask.
   */
  void SetLights(const std::vector<ShadowLight>& lights)
  {
    LightMasks masks;
    this->MaskedLights.clear();
    for (const ShadowLight& light : lights)
    {
      masks.emplace(light.Number, static_cast<int>(this->MaskedLights.size()));
      this->MaskedLights.emplace_back(light.Light);
    }
    if (masks != this->Masks)
    {
      this->Masks = std::move(masks);
      this->ShaderStageTime.Modified();
    }
  }

  /**
   * Draws the mask of each light, on the depth that is there. Gives the reason if counts had to do
   * with fewer bits than they may need, or nothing.
   */
  std::string DrawMasks(vtkRenderer* renderer, const std::vector<ShadowLight>& lights,
    const VolumeCache::Quality& quality, const ShadowRules& rules);

  struct PlannedVolume
  {
    CasterPlan Plan;
    const VolumeBuffers* Buffers = nullptr;
    double Milliseconds = 0.0;
  };
  PlannedVolume PlanVolume(vtkRenderer* renderer, const ShadowPlan& plan, const ShadowLight& light,
    const ShadowCaster& caster, const VolumeCache::Quality& quality);
  void CountVolume(const PlannedVolume& volume, const ShadowLight& light,
    const ShadowCaster& caster, const Matrix4& worldToClip);

  LightSwitches Switches;
  vtkSmartPointer<vtkRenderPass> DefaultDelegate = MakeRendererSteps();
  vtkNew<vtkOpaquePass> DepthPass;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  unsigned long WindowObserver = 0;
  ShadowFramebuffer Target;
  VolumeCounter Counter;
  VolumeCache Volumes;
  DataSetSurfaces Surfaces;

  struct PlanRow
  {
    std::size_t Light;
    std::size_t Caster;
    CasterPlan Plan;
    double Milliseconds;
  };
  std::vector<PlanRow> Plan;

  // A light's place is its mask's number.
  std::vector<vtkWeakPointer<vtkLight>> MaskedLights;
  LightMasks Masks;
  vtkTimeStamp ShaderStageTime;

  int TextureUnit = -1;
  bool Shading = false;
  std::set<std::string> Warnings; // that have been given
};

namespace
{
bool Receives(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  vtkInformationIntegerKey* key = vtkStencilShadowPass::RECEIVES_SHADOW();
  return !keys || !keys->Has(key) || keys->Get(key) != 0;
}

/**
 * The size of what the state draws into, found as vtkCameraPass does.
 */
std::array<int, 2> FindSize(const vtkRenderState* state)
{
  std::array<int, 2> size{};
  if (vtkFrameBufferObjectBase* framebuffer = state->GetFrameBuffer())
  {
    framebuffer->GetLastSize(size.data());
  }
  else
  {
    int origin[2];
    state->GetRenderer()->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  }
  return size;
}

/**
 * Bounds of all that a shadow may fall on; invalid if something has none.
 */
std::array<double, 6> FindReceiverBounds(vtkRenderer* renderer)
{
  vtkBoundingBox box;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  bool everythingIsBounded = true;
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    double* bounds = prop->GetVisibility() ? prop->GetBounds() : nullptr;
    if (bounds && prop->GetUseBounds() && vtkMath::AreBoundsInitialized(bounds))
    {
      box.AddBounds(bounds);
    }
    else if (bounds && !prop->GetUseBounds())
    {
      everythingIsBounded = false;
    }
  }
  std::array<double, 6> result{ 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  if (everythingIsBounded && box.IsValid())
  {
    box.GetBounds(result.data());
  }
  return result;
}

/**
 * Bounds of a mesh with room for a smooth contour, which may leave them.
 */
std::array<double, 6> RoomyBounds(vtkPolyData* mesh)
{
  constexpr double room = 0.1;
  std::array<double, 6> bounds;
  mesh->GetBounds(bounds.data());
  const double margin = room * mesh->GetLength();
  for (std::size_t i = 0; i < 6; ++i)
  {
    bounds[i] += i % 2 == 0 ? -margin : margin;
  }
  return bounds;
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
 * The props that the depth stage draws. Lines of which some are removed as hidden are not among them:
 * what is seen behind those would get their mask.
 */
std::vector<vtkProp*> FindOccluders(const vtkRenderState* state)
{
  std::vector<vtkProp*> props;
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    vtkProp* prop = state->GetPropArray()[i];
    vtkActor* actor = vtkActor::SafeDownCast(prop);
    if (!actor || !state->GetRenderer()->GetUseHiddenLineRemoval() ||
      actor->GetProperty()->GetRepresentation() != VTK_WIREFRAME)
    {
      props.push_back(prop);
    }
  }
  return props;
}

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
}

std::string vtkStencilShadowPass::Internals::DrawMasks(vtkRenderer* renderer,
  const std::vector<ShadowLight>& lights, const VolumeCache::Quality& quality,
  const ShadowRules& rules)
{
  vtkOpenGLState* state = this->Window->GetState();
  const Matrix4 worldToClip = FindWorldToClip(renderer);
  const ShadowPlan plan({ worldToClip, this->Target.GetWidth(), this->Target.GetHeight() },
    FindReceiverBounds(renderer), rules);
  const std::vector<ShadowCaster> casters = CollectShadowCasters(renderer, this->Surfaces);
  this->Volumes.BeginFrame();
  this->Plan.clear();
  std::string error;
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    std::vector<PlannedVolume> volumes;
    std::int64_t depth = 0;
    for (std::size_t j = 0; j < casters.size(); ++j)
    {
      volumes.push_back(this->PlanVolume(renderer, plan, lights[i], casters[j], quality));
      const PlannedVolume& planned = volumes.back();
      depth += planned.Buffers ? planned.Buffers->GetGreatestDepth() : 0;
      this->Plan.push_back({ i, j, planned.Plan, planned.Milliseconds });
    }
    const auto mask = static_cast<int>(i);
    this->Target.BeginMask(state, mask);
    const bool inFloats = depth > VolumeCounter::GreatestStencilDepth &&
      this->Target.BeginCounts(state, error);
    inFloats ? this->Counter.BeginCountingInFloats(state)
             : this->Counter.BeginCountingInStencil(state);
    for (std::size_t j = 0; j < casters.size(); ++j)
    {
      this->CountVolume(volumes[j], lights[i], casters[j], worldToClip);
    }
    state->vtkglDisable(GL_SCISSOR_TEST);
    this->Target.OpenMask(state, mask);
    inFloats
      ? this->Counter.WriteMaskOfFloats(state, this->Target.GetCounts(), this->TextureUnit)
      : this->Counter.WriteMaskOfStencil(state);
  }
  this->Volumes.EndFrame(renderer);
  return error;
}

vtkStencilShadowPass::Internals::PlannedVolume vtkStencilShadowPass::Internals::PlanVolume(
  vtkRenderer* renderer, const ShadowPlan& plan, const ShadowLight& light,
  const ShadowCaster& caster, const VolumeCache::Quality& quality)
{
  PlannedVolume planned;
  if (!plan.IsSeen(light.Position, CornersOf(RoomyBounds(caster.Mesh), caster.ToWorld)))
  {
    planned.Plan.Decision = "skip";
    planned.Plan.Reason = "its shadow does not come into view";
    return planned;
  }
  const int made = this->Volumes.GetNumberMade();
  const double start = vtkTimerLog::GetUniversalTime();
  const VolumeBuffers& buffers = this->Volumes.Get(renderer, caster.Mesh,
    caster.MoveIntoMesh(light.Position), quality, this->Counter.GetAttribute());
  planned.Milliseconds = 1e3 * (vtkTimerLog::GetUniversalTime() - start);
  if (buffers.IsEmpty())
  {
    planned.Plan.Decision = "skip";
    planned.Plan.Reason = "it has no volume";
    return planned;
  }
  planned.Buffers = &buffers;
  planned.Plan = plan.Decide(light.Position, CornersOf(buffers.GetBounds(), caster.ToWorld));
  planned.Plan.Decision +=
    this->Volumes.GetNumberMade() == made ? ", volume of before" : ", new volume";
  return planned;
}

void vtkStencilShadowPass::Internals::CountVolume(const PlannedVolume& volume,
  const ShadowLight& light, const ShadowCaster& caster, const Matrix4& worldToClip)
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
    { worldToClip * caster.ToWorld, caster.MoveIntoMesh(light.Position),
      MovePlane(volume.Plan.End, caster.ToWorld) },
    volume.Plan.ZPass);
}

vtkStencilShadowPass::vtkStencilShadowPass()
  : Internal(std::make_unique<Internals>())
{
}

vtkStencilShadowPass::~vtkStencilShadowPass()
{
  this->SetDelegatePass(nullptr);
}

void vtkStencilShadowPass::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const kinds[] = { "Discrete", "Accurate", "Smooth" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DelegatePass: ";
  if (this->DelegatePass)
  {
    os << "\n";
    this->DelegatePass->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none: as the renderer draws without a pass)\n";
  }
  os << indent << "Kind: " << kinds[this->Kind] << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  static const char* const countings[] = { "Automatic", "Z-pass", "Z-fail" };
  os << indent << "Counting: " << countings[this->Counting] << "\n";
  os << indent << "SkipUnseenCasters: " << (this->SkipUnseenCasters ? "on" : "off") << "\n";
  os << indent << "FiniteVolumes: " << (this->FiniteVolumes ? "on" : "off") << "\n";
  os << indent << "Scissor: " << (this->Scissor ? "on" : "off") << "\n";
  os << indent << "Masked lights in the last frame: " << this->Internal->MaskedLights.size()
     << "\n";
}

void vtkStencilShadowPass::SetLightCasts(vtkLight* light, bool casts)
{
  if (light && this->Internal->Switches.Set(light, casts))
  {
    this->Modified();
  }
}

bool vtkStencilShadowPass::GetLightCasts(vtkLight* light)
{
  return light && !light->LightTypeIsHeadlight() && this->Internal->Switches.Casts(light);
}

void vtkStencilShadowPass::Render(const vtkRenderState* state)
{
  vtkRenderPass* delegate =
    this->DelegatePass ? this->DelegatePass : this->Internal->DefaultDelegate.Get();
  const bool masked = this->MakeMasks(state);
  if (masked)
  {
    this->Internal->Shading = true;
  }
  delegate->Render(state);
  this->NumberOfRenderedProps = delegate->GetNumberOfRenderedProps();
  if (masked)
  {
    this->Internal->Shading = false;
    this->DropMasks(state);
  }
}

bool vtkStencilShadowPass::MakeMasks(const vtkRenderState* state)
{
  Internals& internal = *this->Internal;
  vtkRenderer* renderer = state->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  internal.MaskedLights.clear();
  if (!window || renderer->GetSelector())
  {
    return false;
  }
  window->MakeCurrent();
  internal.Attach(window);

  // The delegate does this as well, but only after the masks.
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
  const std::vector<ShadowLight> lights = CollectShadowLights(renderer, internal.Switches);
  const std::array<int, 2> size = FindSize(state);
  if (lights.empty() || size[0] <= 0 || size[1] <= 0)
  {
    return false;
  }

  vtkOpenGLState* glState = window->GetState();
  const RestoredState restored(glState);
  std::string error;
  if (!internal.Target.Allocate(
        glState, size[0], size[1], static_cast<int>(lights.size()), error) ||
    !internal.Counter.Prepare(window, error))
  {
    this->WarnOnce("No shadows in this window: " + error);
    return false;
  }
  internal.TextureUnit = glState->GetTextureUnitManager()->Allocate();
  if (internal.TextureUnit < 0)
  {
    this->WarnOnce("No shadows in this window: no texture unit is free for the masks");
    return false;
  }
  internal.SetLights(lights);
  internal.Target.BindMasks(glState, internal.TextureUnit);
  JoinProps(state, this);

  internal.Target.BeginDepth(glState);
  glState->vtkglEnable(GL_DEPTH_TEST);
  glState->vtkglDepthFunc(GL_LEQUAL);
  glState->vtkglDisable(GL_BLEND);
  {
    const LoneRenderPass lone(state, this);
    std::vector<vtkProp*> props = FindOccluders(state);
    vtkRenderState occluders(renderer);
    occluders.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
    occluders.SetFrameBuffer(state->GetFrameBuffer());
    occluders.SetRequiredKeys(state->GetRequiredKeys());
    internal.DepthPass->Render(&occluders);
  }

  const std::string tooFewBits =
    internal.DrawMasks(renderer, lights, { this->Kind, this->Tolerance, true },
      { static_cast<CountingMethod>(this->Counting), this->SkipUnseenCasters, this->FiniteVolumes,
        this->Scissor });
  if (!tooFewBits.empty())
  {
    this->WarnOnce("256 shadow volumes around a point count as none, as floats cannot be drawn: " +
      tooFewBits);
  }
  return true;
}

void vtkStencilShadowPass::DropMasks(const vtkRenderState* state)
{
  Internals& internal = *this->Internal;
  LeaveProps(state, this);
  if (!internal.Window)
  {
    return;
  }
  vtkOpenGLState* glState = internal.Window->GetState();
  const RestoredState restored(glState);
  ShadowFramebuffer::UnbindMasks(glState, internal.TextureUnit);
  glState->GetTextureUnitManager()->Free(internal.TextureUnit);
  internal.TextureUnit = -1;
}

void vtkStencilShadowPass::WarnOnce(const std::string& reason)
{
  if (this->Internal->Warnings.insert(reason).second)
  {
    vtkWarningMacro(<< reason << ".");
  }
}

vtkImageData* vtkStencilShadowPass::GetMask(vtkLight* light)
{
  Internals& internal = *this->Internal;
  const auto found = std::find(internal.MaskedLights.begin(), internal.MaskedLights.end(), light);
  if (!light || !internal.Window || found == internal.MaskedLights.end())
  {
    return nullptr;
  }
  internal.Window->MakeCurrent();
  const auto mask = static_cast<int>(found - internal.MaskedLights.begin());
  const vtkSmartPointer<vtkImageData> image =
    internal.Target.ReadMask(internal.Window->GetState(), mask);
  if (image)
  {
    image->Register(nullptr);
  }
  return image;
}

vtkTable* vtkStencilShadowPass::GetPlan()
{
  vtkNew<vtkIntArray> lights;
  lights->SetName("Light");
  vtkNew<vtkIntArray> casters;
  casters->SetName("Caster");
  vtkNew<vtkStringArray> decisions;
  decisions->SetName("Decision");
  vtkNew<vtkStringArray> reasons;
  reasons->SetName("Reason");
  vtkNew<vtkDoubleArray> milliseconds;
  milliseconds->SetName("Milliseconds");
  for (const Internals::PlanRow& row : this->Internal->Plan)
  {
    lights->InsertNextValue(static_cast<int>(row.Light));
    casters->InsertNextValue(static_cast<int>(row.Caster));
    decisions->InsertNextValue(row.Plan.Decision);
    reasons->InsertNextValue(row.Plan.Reason);
    milliseconds->InsertNextValue(row.Milliseconds);
  }
  vtkTable* table = vtkTable::New();
  table->AddColumn(lights);
  table->AddColumn(casters);
  table->AddColumn(decisions);
  table->AddColumn(reasons);
  table->AddColumn(milliseconds);
  return table;
}

int vtkStencilShadowPass::GetNumberOfVolumesMade()
{
  return this->Internal->MaskedLights.empty() ? 0 : this->Internal->Volumes.GetNumberMade();
}

void vtkStencilShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  this->Internal->DefaultDelegate->ReleaseGraphicsResources(window);
  this->Internal->DepthPass->ReleaseGraphicsResources(window);
  if (this->DelegatePass)
  {
    this->DelegatePass->ReleaseGraphicsResources(window);
  }
  this->Internal->Release();
}

bool vtkStencilShadowPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  // Volumes are lit through the same names, but have no surface that a mask could belong to.
  if (vtkActor::SafeDownCast(prop))
  {
    MaskLighting(fragmentShader, this->Internal->Masks);
  }
  return true;
}

bool vtkStencilShadowPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  // A program may serve several renderers of a window, each with lights of its own, but VTK sends
  // lights only if they are newer than those that were sent last, whoever's these were.
  program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);

  Internals& internal = *this->Internal;
  if (!internal.Window || !program->IsUniformUsed("stencilShadowMasks"))
  {
    return true;
  }
  // Behind a translucent surface there is another one, which the mask belongs to.
  const bool masked =
    internal.Shading && !prop->IsRenderingTranslucentPolygonalGeometry() && Receives(prop);

  // Passes in between may draw elsewhere, and at another resolution, than the one around.
  int viewport[4];
  internal.Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const float origin[2] = { static_cast<float>(viewport[0]), static_cast<float>(viewport[1]) };
  const float scale[2] = { static_cast<float>(internal.Target.GetWidth()) /
      static_cast<float>(viewport[2]),
    static_cast<float>(internal.Target.GetHeight()) / static_cast<float>(viewport[3]) };
  return program->SetUniformi("stencilShadowMasks", internal.TextureUnit) &&
    program->SetUniformi("stencilShadowMasked", masked ? 1 : 0) &&
    program->SetUniform2f("stencilShadowOrigin", origin) &&
    program->SetUniform2f("stencilShadowScale", scale);
}

vtkMTimeType vtkStencilShadowPass::GetShaderStageMTime()
{
  return this->Internal->ShaderStageTime;
}
