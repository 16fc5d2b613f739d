#include "vtkStencilShadowPass.h"

#include "DepthOccluders.h"
#include "MaskPainter.h"
#include "MaskedLighting.h"
#include "OpenGLFunctions.h"
#include "RenderPassKeys.h"
#include "RendererSteps.h"
#include "RestoredState.h"
#include "SceneBounds.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkFrameBufferObjectBase.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTable.h"
#include "vtkTextureUnitManager.h"
#include "vtkTimeStamp.h"
#include "vtkTimerLog.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <map>
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
    this->Painter.Release();
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

  LightSwitches Switches;
  vtkSmartPointer<vtkRenderPass> DefaultDelegate = MakeRendererSteps();
  vtkNew<vtkOpaquePass> DepthPass;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  unsigned long WindowObserver = 0;
  MaskPainter Painter;

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
  static const std::map<int, const char*> kinds = { { AUTOMATIC, "Automatic" },
    { DISCRETE, "Discrete" }, { ACCURATE, "Accurate" }, { SMOOTH, "Smooth" } };
  static const std::map<int, const char*> countings = { { AUTOMATIC, "Automatic" },
    { Z_PASS, "Z-pass" }, { Z_FAIL, "Z-fail" } };
  const auto printSwitch = [&](const char* name, bool on)
  { os << indent << name << ": " << (on ? "on" : "off") << "\n"; };
  os << indent << "Kind: " << kinds.at(this->Kind) << "\n";
  os << indent << "PixelTolerance: " << this->PixelTolerance << "\n";
  os << indent << "Counting: " << countings.at(this->Counting) << "\n";
  printSwitch("SkipUnseenCasters", this->SkipUnseenCasters);
  printSwitch("SkipCastersOutsideCones", this->SkipCastersOutsideCones);
  printSwitch("SkipCastersWithoutReceivers", this->SkipCastersWithoutReceivers);
  printSwitch("FiniteVolumes", this->FiniteVolumes);
  printSwitch("Scissor", this->Scissor);
  printSwitch("DepthBounds", this->DepthBounds);
  printSwitch("ReuseUnchanged", this->ReuseUnchanged);
  printSwitch("StepTiming", this->StepTiming);
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
  const double start = vtkTimerLog::GetUniversalTime();
  this->Internal->Shading = masked;
  delegate->Render(state);
  this->NumberOfRenderedProps = delegate->GetNumberOfRenderedProps();
  if (masked)
  {
    this->Internal->Shading = false;
    this->Internal->Painter.AddStep({ -1, -1, "shading", "by the delegate" }, start);
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
  if (!internal.Painter.Prepare(window, size, static_cast<int>(lights.size()), error))
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
  internal.Painter.GetTarget().BindMasks(glState, internal.TextureUnit);
  JoinProps(state, this);

  std::vector<vtkProp*> occluders = FindOccluders(state);
  internal.Painter.BeginFrame(
    renderer, lights, RecordOccluders(occluders), this->GetMaskSettings(), this->GetMTime());
  this->DrawDepth(state, occluders);
  const std::string tooFewBits = internal.Painter.Paint(renderer, internal.TextureUnit);
  if (!tooFewBits.empty())
  {
    this->WarnOnce("256 shadow volumes around a point count as none, as floats cannot be drawn: " +
      tooFewBits);
  }
  return true;
}

MaskSettings vtkStencilShadowPass::GetMaskSettings() const
{
  ShadowRules rules;
  rules.Counting = this->Counting == Z_PASS ? CountingMethod::ZPass
    : this->Counting == Z_FAIL              ? CountingMethod::ZFail
                                            : CountingMethod::Automatic;
  rules.SkipUnseen = this->SkipUnseenCasters;
  rules.SkipOutsideCones = this->SkipCastersOutsideCones;
  rules.SkipWithoutReceivers = this->SkipCastersWithoutReceivers;
  rules.FiniteVolumes = this->FiniteVolumes;
  rules.Scissor = this->Scissor;
  rules.DepthBounds = this->DepthBounds;
  return { this->Kind, this->PixelTolerance, rules, this->ReuseUnchanged, this->StepTiming };
}

void vtkStencilShadowPass::DrawDepth(const vtkRenderState* state, std::vector<vtkProp*>& occluders)
{
  Internals& internal = *this->Internal;
  const double start = vtkTimerLog::GetUniversalTime();
  if (!internal.Painter.NeedsDepth())
  {
    internal.Painter.AddStep(
      { -1, -1, "depth of before", "neither the camera nor what it sees has changed" }, start);
    return;
  }
  vtkOpenGLState* glState = internal.Window->GetState();
  internal.Painter.GetTarget().BeginDepth(glState);
  glState->vtkglEnable(GL_DEPTH_TEST);
  glState->vtkglDepthFunc(GL_LEQUAL);
  glState->vtkglDisable(GL_BLEND);
  const LoneRenderPass lone(state, this);
  vtkRenderState opaque(state->GetRenderer());
  opaque.SetPropArrayAndCount(occluders.data(), static_cast<int>(occluders.size()));
  opaque.SetFrameBuffer(state->GetFrameBuffer());
  opaque.SetRequiredKeys(state->GetRequiredKeys());
  internal.DepthPass->Render(&opaque);
  internal.Painter.AddStep({ -1, -1, "depth drawn", "something has changed" }, start);
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
    internal.Painter.GetTarget().ReadMask(internal.Window->GetState(), mask);
  if (image)
  {
    image->Register(nullptr);
  }
  return image;
}

vtkTable* vtkStencilShadowPass::GetPlan()
{
  const vtkSmartPointer<vtkTable> table = MakePlanTable(this->Internal->Painter.GetPlan());
  table->Register(nullptr);
  return table;
}

int vtkStencilShadowPass::GetNumberOfVolumesMade()
{
  return this->Internal->MaskedLights.empty() ? 0
                                              : this->Internal->Painter.GetNumberOfVolumesMade();
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
    internal.Shading && !prop->IsRenderingTranslucentPolygonalGeometry() && MayReceive(prop);

  // Passes in between may draw elsewhere, and at another resolution, than the one around.
  int viewport[4];
  internal.Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const float origin[2] = { static_cast<float>(viewport[0]), static_cast<float>(viewport[1]) };
  const ShadowFramebuffer& target = internal.Painter.GetTarget();
  const float scale[2] = { static_cast<float>(target.GetWidth()) / static_cast<float>(viewport[2]),
    static_cast<float>(target.GetHeight()) / static_cast<float>(viewport[3]) };
  return program->SetUniformi("stencilShadowMasks", internal.TextureUnit) &&
    program->SetUniformi("stencilShadowMasked", masked ? 1 : 0) &&
    program->SetUniform2f("stencilShadowOrigin", origin) &&
    program->SetUniform2f("stencilShadowScale", scale);
}

vtkMTimeType vtkStencilShadowPass::GetShaderStageMTime()
{
  return this->Internal->ShaderStageTime;
}
