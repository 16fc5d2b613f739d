/**
 * @class   vtkCastShadowContour
 * @brief   the curves on receivers at which cast shadows begin
 *
 * Port 0 takes silhouettes from vtkSmoothLightSilhouette, port 1 the meshes on which shadows fall,
 * port 2, if hidden contours are to go, the meshes that cast. Any port takes several inputs. A cast
 * contour is where the wall of shadow behind a silhouette meets a receiver's triangles that face
 * the light (after Barabas 2018, which does it on the GPU); walls begin at the silhouettes, so what
 * lies between them and the light has no contour. A mesh may be caster and receiver in one.
 *
 * The light is that of the silhouettes (their field data `LightPosition`), or LightPosition where
 * they do not say: a direction or a point anywhere, among the receivers too.
 *
 * All decisions are exact signs, with one rule for ties: so on any mesh whose triangles are
 * consistently wound each line is closed, or ends at a border of the receiver, where the receiver
 * turns away from the light, where a silhouette pierces the receiver, or where an open silhouette
 * ends; with hidden contours removed also where a contour becomes hidden. At edges of more than two
 * triangles lines may end, too.
 *
 * Output: polylines, one cell a line; a closed one repeats its first point id at its end. As seen
 * from the light the shadow is on their left.
 * - PointData `ReceiverNormals` (3, double: of the receiver's triangles, at an edge their mean),
 *   `ShadowDirection` (3, double, unit: in the receiver, into the shadow; zero where a line has no
 *   length), `CasterPoints` (3, double: the point of the silhouette on the same ray).
 * - CellData `Receiver`, `Caster` (number of the input on port 1, and on port 0), `Loop` (the line
 *   of that silhouette), `Visible`, `Closed`.
 * - FieldData `LightPosition` (4), `NodesVisited` and `LeavesTested` (boxes compared in the tree
 *   over the silhouettes, and segments that were then tested), `BuildSeconds` (the tree),
 *   `QuerySeconds` (contours), `HiddenSeconds` (their hidden parts), `LooseEnds` (ends of lines
 *   other than those said above: 0 unless products of coordinates leave the range of doubles).
 *
 * What hides contours is exact for discrete silhouettes. Accurate and smooth ones lie within the
 * shadow of their own mesh; triangles that share a vertex with one that such a silhouette crosses
 * (found by its `MeshPoints`) therefore do not hide it. So the casters must have the points of the
 * meshes that the silhouettes were made of: where they have not, that mesh hides the silhouette.
 *
 * Receivers are kept until they are modified. Points with equal coordinates are one vertex.
 *
 * Errors: silhouettes of different lights, a light that is not finite or is all zero, and one that
 * lies on a silhouette give vtkErrorMacro and no output. Cells with non-finite points are left out.
 * Empty inputs give an empty output.
 */
#ifndef vtkCastShadowContour_h
#define vtkCastShadowContour_h

#include "vtkFiltersShadowModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For the cached receivers

class ReceiverCache;

class VTKFILTERSSHADOW_EXPORT vtkCastShadowContour : public vtkPolyDataAlgorithm
{
public:
  static vtkCastShadowContour* New();
  vtkTypeMacro(vtkCastShadowContour, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Builders
  {
    UNSORTED = 0,
    OBJECT_MEDIAN = 1,
    MORTON = 2
  };

  ///@{
  /**
   * Silhouettes (port 0), receivers (port 1) and casters (port 2) from filters' outputs. Set
   * replaces all of a port, Add adds one.
   */
  void SetSilhouetteConnection(vtkAlgorithmOutput* silhouette);
  void AddSilhouetteConnection(vtkAlgorithmOutput* silhouette);
  void SetReceiverConnection(vtkAlgorithmOutput* receiver);
  void AddReceiverConnection(vtkAlgorithmOutput* receiver);
  void SetCasterConnection(vtkAlgorithmOutput* caster);
  void AddCasterConnection(vtkAlgorithmOutput* caster);
  ///@}

  ///@{
  /**
   * The light, homogeneous: (x, y, z, 1) is a point, (x, y, z, 0) the direction towards a light at
   * infinity. Used only where silhouettes have no field data `LightPosition`. Default (0, 0, 1, 0).
   */
  vtkSetVector4Macro(LightPosition, double);
  vtkGetVector4Macro(LightPosition, double);
  ///@}

  ///@{
  /**
   * How the tree over the silhouettes' segments is built: UNSORTED, in the order in which they
   * come (Barabas), OBJECT_MEDIAN, halved again and again, or MORTON, along a space-filling curve.
   * All give the same contours. UNSORTED is as fast as MORTON for silhouettes that come loop by
   * loop, and much slower for others. Default MORTON.
   */
  vtkSetClampMacro(Builder, int, UNSORTED, MORTON);
  vtkGetMacro(Builder, int);
  void SetBuilderToUnsorted() { this->SetBuilder(UNSORTED); }
  void SetBuilderToObjectMedian() { this->SetBuilder(OBJECT_MEDIAN); }
  void SetBuilderToMorton() { this->SetBuilder(MORTON); }
  ///@}

  ///@{
  /**
   * Whether contours that are in the shadow of the casters on port 2 are told from those that can
   * be seen. Without casters all are visible. Default on.
   */
  vtkSetMacro(RemoveHidden, bool);
  vtkGetMacro(RemoveHidden, bool);
  vtkBooleanMacro(RemoveHidden, bool);
  ///@}

  ///@{
  /**
   * Whether hidden contours stay, as lines of their own with `Visible` 0. Default off.
   */
  vtkSetMacro(KeepHidden, bool);
  vtkGetMacro(KeepHidden, bool);
  vtkBooleanMacro(KeepHidden, bool);
  ///@}

  ///@{
  /**
   * Spacing of a grid to whose points those of the contours are moved, in world units; segments
   * that have no length then go. 0: none. Default 0.
   */
  vtkSetClampMacro(GridSpacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(GridSpacing, double);
  ///@}

protected:
  vtkCastShadowContour();
  ~vtkCastShadowContour() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCastShadowContour(const vtkCastShadowContour&) = delete;
  void operator=(const vtkCastShadowContour&) = delete;

  double LightPosition[4] = { 0.0, 0.0, 1.0, 0.0 };
  int Builder = MORTON;
  bool RemoveHidden = true;
  bool KeepHidden = false;
  double GridSpacing = 0.0;

  std::unique_ptr<ReceiverCache> Receivers;
  std::unique_ptr<ReceiverCache> Casters;
};

#endif
