/**
 * Draws the masks of a frame by its plan, on depths that are there already, and keeps depths,
 * volumes and masks for as long as nothing changes that they depend on.
 */
#ifndef MaskPainter_h
#define MaskPainter_h

#include "DataSetSurfaces.h"
#include "PlanTable.h"
#include "SceneRecord.h"
#include "ShadowCasters.h"
#include "ShadowFramebuffer.h"
#include "ShadowLights.h"
#include "ShadowPlan.h"
#include "VolumeCache.h"
#include "VolumeCounter.h"

#include <array>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderer;

/**
 * What the pass is set to.
 */
struct MaskSettings
{
  int Kind;
  double PixelTolerance;
  ShadowRules Rules;
  bool ReuseUnchanged;
  bool WaitAfterSteps; ///< so that times are those of the graphics card, too
};

class MaskPainter
{
public:
  /**
   * Readies targets and programs. On failure says why in `error` and returns false.
   */
  bool Prepare(vtkOpenGLRenderWindow* window, const std::array<int, 2>& size, int lights,
    std::string& error);

  /**
   * Needs the context of Prepare.
   */
  void Release();

  ShadowFramebuffer& GetTarget() { return this->Target; }

  /**
   * Forgets what was done in the last frame.
   */
  void ClearPlan() { this->Plan.clear(); }

  /**
   * Looks at the scene, and how much of the last frame is still valid. `occluders` records what
   * depths depend on besides the camera.
   */
  void BeginFrame(vtkRenderer* renderer, const std::vector<ShadowLight>& lights,
    const SceneRecord& occluders, const MaskSettings& settings, vtkMTimeType settingsTime);

  bool NeedsDepth() const { return this->DepthIsOld; }

  /**
   * Draws what is needed, with the depths in the target. `unit` is a texture unit that is free.
   * Gives the reason if counts had to do with fewer bits than they may need, or nothing.
   */
  std::string Paint(vtkRenderer* renderer, int unit);

  /**
   * A step of the frame that has just ended; `start` is the universal time of its beginning.
   */
  void AddStep(PlanRow row, double start);

  const std::vector<PlanRow>& GetPlan() const { return this->Plan; }
  int GetNumberOfVolumesMade() const
  {
    return this->MasksAreOld ? this->Volumes.GetNumberMade() : 0;
  }

private:
  struct PlannedVolume
  {
    CasterPlan Plan;
    const VolumeBuffers* Buffers = nullptr;
  };

  /// What the plan asks of a caster for each light again.
  struct CasterBox
  {
    std::array<double, 6> Bounds; ///< of the mesh
    double Size;                  ///< their diagonal
    std::size_t Receiver;         ///< number of the prop's own bounds among the receivers'
  };

  void MeasureCasters();
  std::string PaintMask(vtkRenderer* renderer, const ShadowPlan& plan, int mask, int unit);
  PlannedVolume PlanVolume(vtkRenderer* renderer, const ShadowPlan& plan, const ShadowLight& light,
    const ShadowCaster& caster, const CasterBox& box);
  CasterPlan Decide(vtkRenderer* renderer, const ShadowPlan& plan, const ShadowLight& light,
    const ShadowCaster& caster, const CasterBox& box);

  /// Adds why to the plan's reasons.
  VolumeCache::Quality ChooseQuality(vtkRenderer* renderer, const ShadowCaster& caster,
    const CasterBox& box, CasterPlan& plan);
  void CountVolume(
    const PlannedVolume& volume, const ShadowLight& light, const ShadowCaster& caster);

  vtkOpenGLRenderWindow* Window = nullptr;
  ShadowFramebuffer Target;
  VolumeCounter Counter;
  VolumeCache Volumes;
  DataSetSurfaces Surfaces;

  // Of the frame.
  MaskSettings Settings{};
  ShadowView View;
  PlanReceivers Receivers;
  std::vector<vtkProp*> ReceivingProps;
  std::vector<ShadowLight> Lights;
  std::vector<ShadowCaster> Casters;
  std::vector<CasterBox> Boxes; // of the casters
  bool DepthIsOld = true;
  bool MasksAreOld = true;
  std::vector<PlanRow> Plan;

  // What the depths in the target were drawn from, and the masks besides those.
  SceneRecord DepthRecord;
  SceneRecord MaskRecord;
};

#endif
