/**
 * @class   vtkSmoothLightSilhouette
 * @brief   the closed curves that part the lit from the dark side of a mesh
 *
 * Port 0 takes a mesh: triangles, polygons or strips, open or closed, of any orientation. The
 * output holds its silhouette as seen from a light at LightPosition, or from an eye put there.
 * Point i is lit when `n_i . (l - w p_i) >= 0`, with the light's homogeneous position (l, w).
 *
 * Three kinds of silhouette are given:
 * - DISCRETE: the mesh edges between lit and dark triangles (Everitt & Kilgard 2002).
 * - ACCURATE: where the linearly interpolated field is zero; it crosses triangles (Hertzmann &
 *   Zorin 2000, section 4; Brown 2004).
 * - SMOOTH: the accurate one moved on to the smooth surface that mesh and normals stand for
 *   (after Mattausch et al. 2012), of fourth order in the length of an edge, and subdivided until
 *   it is within Tolerance of its curve.
 *
 * The silhouette is the boundary of the lit part of the mesh taken as an oriented chain, so each
 * polyline is closed whatever the mesh and whatever the rounding. Where the mesh has an edge with
 * split normals (a crease) or a border, the pieces that close the loops run along that edge. In
 * a connected part of the mesh that is no closed, consistently wound surface, the dark part
 * counts with the opposite sign: its loops are what an extrusion needs for that part's exact
 * shadow, contours have multiplicity 2 there and borders 1.
 *
 * Output: polylines, one cell a loop; a loop repeats its first point id at its end.
 * - PointData `Normals` (3, double, unit; zero at a vertex of triangles without area for which the
 *   mesh has no normal), `MeshPoints` (3, double: the point on the mesh that belongs to it),
 *   `MeshNodes` (vtkIdType: a number of the vertex or the crossing on the mesh, -1 between these;
 *   not of the input's points. vtkShadowVolumeExtruder needs it).
 * - CellData `Kind` (0 contour, 1 crease, 2 border, 3 mixed), `Closed` (always 1), `Multiplicity`.
 * - FieldData `LightPosition` (4), `MaximumDeviation` (world units: no point of a polyline's curve
 *   is farther than this from the polyline), `MaximumShadowDeviation` (with ToleranceMode RECEIVER:
 *   the same of the shadows on the receivers' bounds; infinite where the light touches a curve),
 * `SilhouetteKind`, `EdgesTested` (how many edges, or triangles and creases, the search looked at;
 * TRACKING and RANDOMIZED count each look), `SearchComplete`, `MergePoints`, `FeatureAngle`, and
 * what was found in the mesh: `DegenerateCells`, `NonFiniteCells`, `BoundaryEdges`,
 *   `NonManifoldEdges`, `InconsistentEdges`, `EstimatedNormals` (corner normals that the mesh did
 *   not bring; 0 if it has normals) and `FallbackNormals` (those of them that are angle-weighted
 *   means, see FeatureAngle).
 *
 * What depends on the mesh alone is kept until the mesh is modified: a moved light pays for its
 * silhouette only.
 *
 * Errors: a light that is not finite or is all zero gives vtkErrorMacro and no output, as does
 * ToleranceMode RECEIVER without receivers. Cells with
 * non-finite points, or with points that do not exist, are left out and counted as
 * `NonFiniteCells`; `DegenerateCells` counts triangles with two equal corners. Normals are taken at
 * unit length; where they are zero or not finite they are estimated. An empty mesh gives an empty
 * output. At most 2^30 points and 2^31 corners of triangles, polygons and strips taken
 * apart; areas must stay within doubles: sizes
 * between about 1e-80 and 1e80.
 */
#ifndef vtkSmoothLightSilhouette_h
#define vtkSmoothLightSilhouette_h

#include "vtkFiltersShadowModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For the cached caster

class CasterCache;
struct SilhouetteSettings;

class VTKFILTERSSHADOW_EXPORT vtkSmoothLightSilhouette : public vtkPolyDataAlgorithm
{
public:
  static vtkSmoothLightSilhouette* New();
  vtkTypeMacro(vtkSmoothLightSilhouette, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SilhouetteKind
  {
    DISCRETE = 0,
    ACCURATE = 1,
    SMOOTH = 2
  };

  enum SearchMethods
  {
    AUTOMATIC = 0,
    BRUTE_FORCE = 1,
    HIERARCHY = 2,
    TRACKING = 3,
    RANDOMIZED = 4
  };

  enum ToleranceModes
  {
    RELATIVE = 0,
    WORLD = 1,
    RECEIVER = 2
  };

  /**
   * Takes receivers from a filter's output (port 1, optional, any vtkDataSet; several may be
   * added). They count only for ToleranceMode RECEIVER.
   */
  void SetReceiverConnection(vtkAlgorithmOutput* receivers);
  void AddReceiverConnection(vtkAlgorithmOutput* receivers);

  ///@{
  /**
   * The light, homogeneous: (x, y, z, 1) is a point, (x, y, z, 0) the direction towards a light
   * at infinity; any other w scales. In the mesh's coordinates. Default (0, 0, 1, 0).
   */
  vtkSetVector4Macro(LightPosition, double);
  vtkGetVector4Macro(LightPosition, double);
  ///@}

  ///@{
  /**
   * DISCRETE, ACCURATE or SMOOTH. Default SMOOTH.
   */
  vtkSetClampMacro(Kind, int, DISCRETE, SMOOTH);
  vtkGetMacro(Kind, int);
  void SetKindToDiscrete() { this->SetKind(DISCRETE); }
  void SetKindToAccurate() { this->SetKind(ACCURATE); }
  void SetKindToSmooth() { this->SetKind(SMOOTH); }
  ///@}

  ///@{
  /**
   * How the silhouette is searched for.
   * - BRUTE_FORCE looks at the whole mesh, HIERARCHY only at what a tree of boxes over the mesh
   * cannot show to be all lit or all dark. Both find all there is, the same bit for bit. What they
   * need is made with the first update. AUTOMATIC is HIERARCHY, except on meshes of less than 2,000
   *   triangles. Default AUTOMATIC.
   * - TRACKING walks over the triangles to the silhouette and follows it, from the last light's
   *   silhouette, from borders, and from a few triangles of each connected part (after Mustafa et
   *   al.). RANDOMIZED looks at SampleFraction of the mesh, drawn from Seed, and at the last
   * light's silhouette, and follows what it finds (Markosian et al. 1997). What they find depends
   * on the lights before, those of this filter and this mesh. Both give whole closed loops but may
   * miss some: `SearchComplete` is 0 unless they happened to look at everything. They are here to
   * be compared: HIERARCHY is complete and as fast.
   */
  vtkSetClampMacro(Search, int, AUTOMATIC, RANDOMIZED);
  vtkGetMacro(Search, int);
  void SetSearchToAutomatic() { this->SetSearch(AUTOMATIC); }
  void SetSearchToBruteForce() { this->SetSearch(BRUTE_FORCE); }
  void SetSearchToHierarchy() { this->SetSearch(HIERARCHY); }
  void SetSearchToTracking() { this->SetSearch(TRACKING); }
  void SetSearchToRandomized() { this->SetSearch(RANDOMIZED); }
  ///@}

  ///@{
  /**
   * Of RANDOMIZED: the share of the edges (DISCRETE) or triangles that is looked at, 0 to 1,
   * default 0.01, and the seed of the sample, default 1. A loop of n pieces is missed with a
   * probability of about (1 - SampleFraction)^n.
   */
  vtkSetClampMacro(SampleFraction, double, 0.0, 1.0);
  vtkGetMacro(SampleFraction, double);
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * The farthest that SMOOTH's polyline may be from its curve: as a share of the diagonal of the
   * mesh's bounds (RELATIVE), in world units (WORLD), or in world units where it is seen, from the
   * shadow of its curve on the receivers of port 1 (RECEIVER). These are taken by the bounds of
   * them all: a shadow is measured on the face through which its ray leaves the bounds, at the
   * slant at which it meets it. That is exact for a receiver that is flat and along the axes; a
   * surface inside of the bounds may lie at a sharper angle to the light. Parts whose shadow misses
   * the bounds are not subdivided. The other kinds are polylines in themselves. Default 1e-4,
   * RELATIVE.
   */
  vtkSetClampMacro(Tolerance, double, 1e-12, VTK_DOUBLE_MAX);
  vtkGetMacro(Tolerance, double);
  vtkSetClampMacro(ToleranceMode, int, RELATIVE, RECEIVER);
  vtkGetMacro(ToleranceMode, int);
  void SetToleranceModeToRelative() { this->SetToleranceMode(RELATIVE); }
  void SetToleranceModeToWorld() { this->SetToleranceMode(WORLD); }
  void SetToleranceModeToReceiver() { this->SetToleranceMode(RECEIVER); }
  ///@}

  ///@{
  /**
   * Where the mesh has no point normals they are estimated, and edges whose faces turn by more
   * than this angle split them: such an edge is a crease. In degrees, 0 to 180, default 60.
   * A polynomial is fitted to the points around each (Cazals & Pouget 2005), which keeps the
   * smooth contour's order of 4. Where that is not possible (too few points, faces that turn by
   * more than 60 degrees among them, or a flat face beside a bend) the normal is the faces' mean,
   * weighted by their angles.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Whether points with equal coordinates are one vertex of the mesh, their normals then
   * belonging to the corners of its triangles. Off, such points are borders. Default on.
   */
  vtkSetMacro(MergePoints, bool);
  vtkGetMacro(MergePoints, bool);
  vtkBooleanMacro(MergePoints, bool);
  ///@}

  /**
   * How far the smooth surface is from the mesh, along its edges: the greatest distance between
   * an edge and the curve that SMOOTH has in its place, in world units. An upper bound, which
   * exceeds the distance by half the square of the angle between edge and curve (1% at 8 degrees).
   * It is what a silhouette of the mesh itself may miss there; flat faces, straight creases and
   * what has normals that say nothing give 0, but for rounding. The same for every light and Kind.
   * Updates the input; takes O(edges), on VTK's threads, once for a mesh, FeatureAngle and
   * MergePoints. 0 without a mesh or if it is too large.
   */
  double ComputeMeshDeviation();

  /**
   * What is kept of the mesh between updates, without the last silhouette, in kibibytes as
   * GetActualMemorySize of data. Filters that read the same mesh share it.
   */
  unsigned long GetKeptMemorySize() const;

protected:
  vtkSmoothLightSilhouette();
  ~vtkSmoothLightSilhouette() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSmoothLightSilhouette(const vtkSmoothLightSilhouette&) = delete;
  void operator=(const vtkSmoothLightSilhouette&) = delete;

  // False after an error.
  bool ReadSettings(vtkPolyData* input, SilhouetteSettings& settings);

  double LightPosition[4] = { 0.0, 0.0, 1.0, 0.0 };
  int Kind = SMOOTH;
  int Search = AUTOMATIC;
  double SampleFraction = 0.01;
  int Seed = 1;
  double Tolerance = 1e-4;
  int ToleranceMode = RELATIVE;
  double FeatureAngle = 60.0;
  bool MergePoints = true;

  std::unique_ptr<CasterCache> Cache;
};

#endif
