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

class vtkImageData;
class vtkInformationIntegerKey;
class vtkLight;
class vtkTable;

class VTKRENDERINGSHADOW_EXPORT vtkStencilShadowPass : public vtkOpenGLRenderPass
{
public:
  static vtkStencilShadowPass* New();
  vtkTypeMacro(vtkStencilShadowPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SilhouetteKind
  {
    DISCRETE = 0,
    ACCURATE = 1,
    SMOOTH = 2
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
   * Kind of silhouettes, as in vtkSmoothLightSilhouette. Default SMOOTH.
   */
  vtkSetClampMacro(Kind, int, DISCRETE, SMOOTH);
  vtkGetMacro(Kind, int);
  void SetKindToDiscrete() { this->SetKind(DISCRETE); }
  void SetKindToAccurate() { this->SetKind(ACCURATE); }
  void SetKindToSmooth() { this->SetKind(SMOOTH); }
  ///@}

  ///@{
  /**
   * Tolerance of SMOOTH silhouettes as a share of the caster's diagonal. Default 1e-4.
   */
  vtkSetClampMacro(Tolerance, double, 1e-12, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  enum CountingMethods
  {
    AUTOMATIC = 0,
    Z_PASS = 1,
    Z_FAIL = 2
  };

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

  /**
   * What was done in the last frame for each light and caster, a row each: `Light` (number of the mask),
   * `Caster` (number among those that cast, both from 0), `Decision`, `Reason` and `Milliseconds` that
   * its volume took to make. New table, to be deleted by the caller.
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
  void DropMasks(const vtkRenderState* state);
  void WarnOnce(const std::string& reason);

  vtkRenderPass* DelegatePass = nullptr;
  int Kind = SMOOTH;
  double Tolerance = 1e-4;
  int Counting = AUTOMATIC;
  bool SkipUnseenCasters = true;
  bool FiniteVolumes = true;
  bool Scissor = true;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
