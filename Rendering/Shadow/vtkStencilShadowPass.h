/**
 * @class   vtkStencilShadowPass
 * @brief   shadows of point and directional lights by stencil-counted shadow volumes
 *
 * It draws what its delegate draws, with each light's contribution removed where an actor hides
 * the light. Shading stays the mappers' own: Phong, PBR, textures and vertex colours work as
 * without the pass.
 *
 * Per frame: depth of the opaque props into an own framebuffer; then, for each light that casts,
 * the actors' shadow volumes (vtkSmoothLightSilhouette, vtkShadowVolumeExtruder) counted in the
 * stencil buffer (in floats where there may be more than it can count) by z-fail (Everitt & Kilgard
 * 2002), which is right with the eye in shadow and with volumes cut by the near plane; the zero
 * counts become the light's visibility mask; last, the delegate draws with the mask applied to the
 * light's colour. Volumes are remade only for a light or an actor that moved or was modified.
 *
 * Where it stands among other passes:
 * - Alone, `renderer->SetPass(pass)`: the default delegate sets viewport and background by the
 *   camera pass that it contains. A delegate of one's own then needs one, too.
 * - Inside, as in vtkSSAAPass(pass), vtkCameraPass(pass) or vtkSSAAPass(vtkCameraPass(pass)): works
 *   with the default delegate as well. It clears once more, so if anything was drawn before, take a
 *   delegate without a camera pass.
 * - Around, as in pass(vtkSSAOPass(...)): the delegate may draw into framebuffers of its own and at
 *   another resolution than the mask's.
 *
 * Lights: any number. Positional lights cast in all directions (a cone limits what is lit, as
 * without the pass), directional ones along their direction. A headlight casts nothing: what it
 * lights is never in its shadow.
 *
 * Casters: what visible actors draw as opaque surfaces, parts of assemblies included, seen by the
 * camera or not, each with its matrix, which may mirror. By mapper:
 * - vtkPolyDataMapper: polygons and strips; lines and vertices cast nothing.
 * - vtkCompositePolyDataMapper2: the blocks that are visible and opaque, by
 *   vtkCompositeDataDisplayAttributes and their scalars; vtkCompositePolyDataMapper: all blocks.
 * - vtkGlyph3DMapper: each glyph where the mapper puts it. It has a volume of its own, unless its
 *   light is the same in the source's coordinates as another's, as along a direction where glyphs
 *   are only moved.
 * - vtkDataSetMapper: the surface of the data, which is extracted a second time.
 * Everything opaque receives.
 *
 * Limits: other mappers receive but do not cast (vtkMoleculeMapper), nor do mappers that draw
 * splats at points (vtkPointGaussianMapper), actors drawn as wireframe or points, props that are no
 * vtkActor (vtkLODProp3D). Clipping planes of mappers, replacements in their shaders, levels of
 * detail of glyphs, faces that are culled and holes in textures are not seen in shadows.
 * Translucent actors and blocks neither cast nor are darkened. The mask has one value a pixel, so
 * multisampling does not smooth shadow edges: put vtkSSAAPass around. While something is being
 * selected, the delegate draws without shadows. Wireframe actors of a renderer that removes hidden
 * lines take the shadows of what is behind their lines.
 *
 * Errors: where OpenGL cannot give the framebuffer, with 8 bits of stencil, there is one warning
 * and no shadows; where it cannot draw floats that counts need, one warning.
 */
#ifndef vtkStencilShadowPass_h
#define vtkStencilShadowPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingShadowModule.h" // For export macro

#include <memory> // For the implementation
#include <string> // For shader hooks
#include <vector> // For the props

class vtkImageData;
class vtkInformationIntegerKey;
class vtkLight;
class vtkTable;
struct MaskSettings;

class VTKRENDERINGSHADOW_EXPORT vtkStencilShadowPass : public vtkOpenGLRenderPass
{
public:
  static vtkStencilShadowPass* New();
  vtkTypeMacro(vtkStencilShadowPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Left to the pass: the value of every choice that it can make itself.
   */
  enum Choice
  {
    AUTOMATIC = -1
  };

  enum SilhouetteKind
  {
    DISCRETE = 0,
    ACCURATE = 1,
    SMOOTH = 2
  };

  enum CountingMethods
  {
    Z_PASS = 0,
    Z_FAIL = 1
  };

  ///@{
  /**
   * The pass that draws the scene. Default (null): all that the renderer draws without a pass, with
   * its depth peeling, hidden-line removal, ambient occlusion and FXAA. Within passes that have a
   * framebuffer of their own, as vtkSSAAPass, it draws as vtkRenderStepsPass.
   */
  void SetDelegatePass(vtkRenderPass* delegate);
  vtkGetObjectMacro(DelegatePass, vtkRenderPass);
  ///@}

  ///@{
  /**
   * Kind of silhouettes, as in vtkSmoothLightSilhouette. AUTOMATIC (the default) takes for each light
   * and caster DISCRETE, which is the fastest, if its error is within PixelTolerance, else SMOOTH: the
   * error is told from how far the mesh's edges are from the smooth surface's.
   */
  vtkSetClampMacro(Kind, int, AUTOMATIC, SMOOTH);
  vtkGetMacro(Kind, int);
  void SetKindToAutomatic() { this->SetKind(AUTOMATIC); }
  void SetKindToDiscrete() { this->SetKind(DISCRETE); }
  void SetKindToAccurate() { this->SetKind(ACCURATE); }
  void SetKindToSmooth() { this->SetKind(SMOOTH); }
  ///@}

  ///@{
  /**
   * By how many pixels a shadow's edge may be off that of the smooth surface, from where the camera
   * is. From it come the choice of AUTOMATIC and the tolerance of SMOOTH silhouettes: the pixel's size
   * where the shadow falls, made smaller by as much as the light enlarges the caster there, rounded
   * down to a power of two, so that a moving camera keeps most of its volumes, and at least 1e-6 of
   * the caster's diagonal. It is measured across the light's rays: on a surface that these only graze,
   * edges move by more. Default 0.5.
   */
  vtkSetClampMacro(PixelTolerance, double, 1e-6, 1e6);
  vtkGetMacro(PixelTolerance, double);
  ///@}

  ///@{
  /**
   * How volumes are counted. Z_FAIL, from the surface to infinity, is right always. Z_PASS, from the
   * eye to the surface, draws less, but is wrong where the eye is in shadow or the near plane cuts a
   * volume: it is there for comparison. AUTOMATIC (the default) takes z-pass for each caster of which
   * nothing is between the light and the part of the near plane that is seen, else z-fail.
   */
  vtkSetClampMacro(Counting, int, AUTOMATIC, Z_FAIL);
  vtkGetMacro(Counting, int);
  void SetCountingToAutomatic() { this->SetCounting(AUTOMATIC); }
  void SetCountingToZPass() { this->SetCounting(Z_PASS); }
  void SetCountingToZFail() { this->SetCounting(Z_FAIL); }
  ///@}

  ///@{
  /**
   * Rules that save time and leave the picture as it is, all on by default. Casters whose shadow does
   * not come into view are left out.
   */
  vtkSetMacro(SkipUnseenCasters, bool);
  vtkGetMacro(SkipUnseenCasters, bool);
  vtkBooleanMacro(SkipUnseenCasters, bool);
  ///@}

  ///@{
  /**
   * Nor are those that are outside of a spot light's cone.
   */
  vtkSetMacro(SkipCastersOutsideCones, bool);
  vtkGetMacro(SkipCastersOutsideCones, bool);
  vtkBooleanMacro(SkipCastersOutsideCones, bool);
  ///@}

  ///@{
  /**
   * Nor those in whose shadow nothing lies that shows one.
   */
  vtkSetMacro(SkipCastersWithoutReceivers, bool);
  vtkGetMacro(SkipCastersWithoutReceivers, bool);
  vtkBooleanMacro(SkipCastersWithoutReceivers, bool);
  ///@}

  ///@{
  /**
   * Volumes end behind the bounds of all visible props, as far as all of their rays come there,
   * instead of at infinity. A visible prop with UseBounds off keeps all of them infinite.
   */
  vtkSetMacro(FiniteVolumes, bool);
  vtkGetMacro(FiniteVolumes, bool);
  vtkBooleanMacro(FiniteVolumes, bool);
  ///@}

  ///@{
  /**
   * Volumes are drawn within their bounds on the screen.
   */
  vtkSetMacro(Scissor, bool);
  vtkGetMacro(Scissor, bool);
  vtkBooleanMacro(Scissor, bool);
  ///@}

  ///@{
  /**
   * Volumes are drawn only over pixels whose depth is within theirs, where the driver has
   * GL_EXT_depth_bounds_test.
   */
  vtkSetMacro(DepthBounds, bool);
  vtkGetMacro(DepthBounds, bool);
  vtkBooleanMacro(DepthBounds, bool);
  ///@}

  ///@{
  /**
   * Depths of the last frame are used again if neither the camera nor anything opaque has changed, and
   * masks if no light and no caster has, either. Changes are seen by the objects' times. Props other
   * than actors and assemblies of them, and actors of classes of their own (vtkLODActor), may draw
   * something else without a word: with such in view everything is drawn anew, as it is with a shader
   * whose uniforms an observer sets.
   */
  vtkSetMacro(ReuseUnchanged, bool);
  vtkGetMacro(ReuseUnchanged, bool);
  vtkBooleanMacro(ReuseUnchanged, bool);
  ///@}

  ///@{
  /**
   * Whether the graphics card is waited for after each step, so that the plan's times are true. It
   * costs time itself. Default off: the times are what the CPU took.
   */
  vtkSetMacro(StepTiming, bool);
  vtkGetMacro(StepTiming, bool);
  vtkBooleanMacro(StepTiming, bool);
  ///@}

  /**
   * What was done in the last frame, a row each: `Light` (number of the mask), `Caster` (number among
   * those that cast, both from 0), `Decision`, `Reason` and `Milliseconds`. A row with a light and a
   * caster is about its volume, and took the time to make and upload that; with a light alone, about
   * counting all its volumes; with neither, about depths and shading. New table, to be deleted by the
   * caller.
   */
  VTK_NEWINSTANCE vtkTable* GetPlan();

  ///@{
  /**
   * Whether a light casts shadows. On for every light that is not a headlight.
   */
  void SetLightCasts(vtkLight* light, bool casts);
  bool GetLightCasts(vtkLight* light);
  ///@}

  /**
   * Key for vtkProp::SetPropertyKeys: 0 keeps an actor, or all parts of an assembly, from casting.
   * Parts cannot differ: VTK gives them the keys of the outermost assembly. Default 1.
   */
  static vtkInformationIntegerKey* CASTS_SHADOW();

  /**
   * Key for vtkProp::SetPropertyKeys: 0 keeps an actor, or all parts of an assembly, free of
   * shadows. Default 1.
   */
  static vtkInformationIntegerKey* RECEIVES_SHADOW();

  /**
   * The visibility mask of a light in the last frame: one component, unsigned char, 255 where the
   * light is visible and 0 in shadow, in the size that the pass drew in (the renderer's viewport,
   * or more inside vtkSSAAPass), origin at the lower left; background pixels are 255. New image, to
   * be deleted by the caller; null if that light cast nothing in the last frame, or if the pass's
   * graphics resources have been released since.
   */
  VTK_NEWINSTANCE vtkImageData* GetMask(vtkLight* light);

  /**
   * How many shadow volumes the last frame had to make; all others were those of a frame before.
   * Each light has one of each caster: an actor's mesh, block or glyph.
   */
  int GetNumberOfVolumesMade();

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * Hooks through which the mappers' shaders read the mask.
   */
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  ///@}

protected:
  vtkStencilShadowPass();
  ~vtkStencilShadowPass() override;

private:
  vtkStencilShadowPass(const vtkStencilShadowPass&) = delete;
  void operator=(const vtkStencilShadowPass&) = delete;

  /**
   * Everything up to the masks. False if there are none this time: no light casts, something is
   * being selected, or OpenGL cannot.
   */
  bool MakeMasks(const vtkRenderState* state);
  void DrawDepth(const vtkRenderState* state, std::vector<vtkProp*>& occluders);
  MaskSettings GetMaskSettings() const;
  void DropMasks(const vtkRenderState* state);
  void WarnOnce(const std::string& reason);

  vtkRenderPass* DelegatePass = nullptr;
  int Kind = AUTOMATIC;
  double PixelTolerance = 0.5;
  int Counting = AUTOMATIC;
  bool SkipUnseenCasters = true;
  bool SkipCastersOutsideCones = true;
  bool SkipCastersWithoutReceivers = true;
  bool FiniteVolumes = true;
  bool Scissor = true;
  bool DepthBounds = true;
  bool ReuseUnchanged = true;
  bool StepTiming = false;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
