/**
 * @class   vtkShadowVolumeExtruder
 * @brief   the closed volume in which a mesh's shadow lies
 *
 * Port 0 takes the mesh, port 1 its silhouette from vtkSmoothLightSilhouette, whose light, kind
 * and treatment of points it adopts. Without port 1 the discrete silhouette from LightPosition is
 * made here.
 *
 * The volume reaches from the mesh to infinity, or as Extent says to a length or to a plane. Its
 * points are homogeneous: a point x goes to infinity as (w x - l, 0) for the light (l, w) (Everitt
 * & Kilgard 2002). A point of space is in shadow where the volume winds around it, which the
 * stencil test counts. A finite volume is an ordinary closed surface.
 *
 * The near cap is a part of the mesh itself. On a closed, consistently wound part of the mesh the
 * dark side can serve as well as the lit one: the shadow that it throws is the same, and it lies
 * on surface which is black anyway, so no offset is needed against self-shadowing artefacts.
 * Where a part of the mesh is open or not consistently wound each triangle is taken facing the
 * light, the whole part is the cap, and the winding around a point is the number of the part's
 * triangles between it and the light (Aldridge & Woods 2004; Kim, Kim & Turk 2008).
 *
 * Output: triangles, wound outwards; with WallStrips also triangle strips.
 * - PointData `Homogeneous` (4, double; w is 1 or 0, at infinity). Points shows those at infinity
 *   at Length along their direction.
 * - CellData `Part` (0 cap, 1 gap between a smooth silhouette and the mesh, 2 wall, 3 far cap),
 *   `Multiplicity` (how often the triangle counts, at least 1).
 * - FieldData `Closed`: 1 if the directed edges of all triangles, taken with their multiplicity,
 *   sum to zero: so it is by construction, as silhouettes that are not of the mesh's chain are
 *   refused, unless Caps is NONE or the silhouette's search left some of it out.
 *   `GreatestDepth`: a bound on how often the volume winds around a point (far behind the mesh, if
 *   a corner field's cap turns away from the light in places). `Volume`, of a finite extent: what
 *   it encloses.
 *
 * With the extent NEAR_END the output is only what the volume begins with, for renderers that
 * extrude it themselves; without caps it costs in proportion to the silhouette, with them the
 * mesh's triangles are looked at once. Points (double) are those that its cells use, none else.
 * - Polys: gaps, and those of the near cap's triangles that are parts of the mesh's.
 * - Lines: the rims, along which walls begin, each a closed polyline (the first id is repeated). A
 *   segment from p to q has the wall (q, p, p's end), (q, p's end, q's end).
 * - CellData `Part`, `Multiplicity` as above; lines come before polys, and are WALL.
 * - FieldData `CapTriangles` (3, unsigned int): the near cap's other triangles, as point ids of
 *   port 0's mesh, of equal points any one. One that counts several times is there as often.
 *   `GreatestDepth`: as above; with the light inside of the ball it is no bound if Caps is NONE, as
 *   what is around the light is not known then. `LightOutside`: whether the light is outside of the
 *   ball around mesh and silhouette: from there an infinite volume's far end may be a fan over the
 *   rims' ends at infinity, from inside it is all of the near end, projected there.
 *
 * Errors: a silhouette that does not belong to the mesh gives vtkErrorMacro and no output, as does
 * a light that is not finite or is all zero. At most 2^30 points and 2^31 corners of triangles,
 * polygons and strips taken apart.
 */
#ifndef vtkShadowVolumeExtruder_h
#define vtkShadowVolumeExtruder_h

#include "vtkFiltersShadowModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For the cached caster

class CasterCache;
struct SilhouetteSettings;

class VTKFILTERSSHADOW_EXPORT vtkShadowVolumeExtruder : public vtkPolyDataAlgorithm
{
public:
  static vtkShadowVolumeExtruder* New();
  vtkTypeMacro(vtkShadowVolumeExtruder, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Extents
  {
    INFINITE = 0,
    LENGTH = 1,
    PLANE = 2,
    NEAR_END = 3
  };

  enum CapKinds
  {
    AUTOMATIC = 0,
    LIT = 1,
    DARK = 2,
    NONE = 3
  };

  enum Parts
  {
    CAP = 0,
    GAP = 1,
    WALL = 2,
    FAR_CAP = 3
  };

  ///@{
  /**
   * The light, homogeneous, used only without port 1. Default (0, 0, 1, 0).
   */
  vtkSetVector4Macro(LightPosition, double);
  vtkGetVector4Macro(LightPosition, double);
  ///@}

  /**
   * Takes the silhouette from a filter's output (port 1).
   */
  void SetSilhouetteConnection(vtkAlgorithmOutput* silhouette);

  ///@{
  /**
   * Which side of closed parts is the near cap: AUTOMATIC (the dark side), LIT, DARK, or NONE:
   * walls and gaps alone, which are then not closed. Parts that are not closed have both sides as
   * their cap. Default AUTOMATIC.
   *
   * The dark cap leaves the inside of a closed part out of the shadow: what lies in there is lit,
   * which only an eye in there sees. The lit cap has the inside in shadow, but casts nothing from
   * a light inside of a closed part, from which no part of it is lit; the dark one then casts all
   * around.
   */
  vtkSetClampMacro(Caps, int, AUTOMATIC, NONE);
  vtkGetMacro(Caps, int);
  void SetCapsToAutomatic() { this->SetCaps(AUTOMATIC); }
  void SetCapsToLit() { this->SetCaps(LIT); }
  void SetCapsToDark() { this->SetCaps(DARK); }
  void SetCapsToNone() { this->SetCaps(NONE); }
  ///@}

  ///@{
  /**
   * Where shadows end: INFINITE; LENGTH, at Length from each point along its ray; or PLANE, on a
   * plane that each point's ray meets (a point beyond the plane is its own end). It is an error if
   * there are rays that do not come to the plane. NEAR_END makes only what is to be extruded.
   * Default INFINITE.
   */
  vtkSetClampMacro(Extent, int, INFINITE, NEAR_END);
  vtkGetMacro(Extent, int);
  void SetExtentToInfinite() { this->SetExtent(INFINITE); }
  void SetExtentToLength() { this->SetExtent(LENGTH); }
  void SetExtentToPlane() { this->SetExtent(PLANE); }
  void SetExtentToNearEnd() { this->SetExtent(NEAR_END); }
  ///@}

  ///@{
  /**
   * How long shadows are (LENGTH), or how far along their direction Points shows what is at
   * infinity (INFINITE). World units. 0 (the default) takes ten times the diagonal of the mesh's
   * bounds.
   */
  vtkSetClampMacro(Length, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Length, double);
  ///@}

  ///@{
  /**
   * Of PLANE: a point on the plane, default (0, 0, 0), and a normal of any length but zero, on
   * either side, default (0, 0, 1).
   */
  vtkSetVector3Macro(PlaneOrigin, double);
  vtkGetVector3Macro(PlaneOrigin, double);
  vtkSetVector3Macro(PlaneNormal, double);
  vtkGetVector3Macro(PlaneNormal, double);
  ///@}

  ///@{
  /**
   * Whether the walls along a loop of 16 points or more become one triangle strip: two point ids a
   * segment in place of six, and one cell a loop. Strips come behind the triangles. The walls of a
   * directional light's infinite volume all end in one point and stay triangles. Many filters want
   * triangles alone (vtkTriangleFilter takes strips apart), so the default is off.
   */
  vtkSetMacro(WallStrips, bool);
  vtkGetMacro(WallStrips, bool);
  vtkBooleanMacro(WallStrips, bool);
  ///@}

protected:
  vtkShadowVolumeExtruder();
  ~vtkShadowVolumeExtruder() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkShadowVolumeExtruder(const vtkShadowVolumeExtruder&) = delete;
  void operator=(const vtkShadowVolumeExtruder&) = delete;

  // False after an error.
  bool ReadSettings(vtkPolyData* input, vtkPolyData* given, SilhouetteSettings& settings);

  double LightPosition[4] = { 0.0, 0.0, 1.0, 0.0 };
  int Caps = AUTOMATIC;
  int Extent = INFINITE;
  double Length = 0.0;
  double PlaneOrigin[3] = { 0.0, 0.0, 0.0 };
  double PlaneNormal[3] = { 0.0, 0.0, 1.0 };
  bool WallStrips = false;

  std::unique_ptr<CasterCache> Cache;
};

#endif
