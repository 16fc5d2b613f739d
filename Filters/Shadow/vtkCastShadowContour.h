/**
 * @class   vtkCastShadowContour
 * @brief   the curves on receivers at which cast shadows begin
 *
 * Inputs and the light are those of vtkCastShadowAlgorithm; casters (port 2) are needed if hidden
 * contours are to go. A cast contour is where the wall of shadow behind a silhouette meets a
 * receiver's triangles that face the light (after Barabas 2018, which does it on the GPU); walls
 * begin at the silhouettes, so what lies between them and the light has no contour.
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
 * Errors are those of vtkCastShadowAlgorithm. Empty inputs give an empty output.
 */
#ifndef vtkCastShadowContour_h
#define vtkCastShadowContour_h

#include "vtkCastShadowAlgorithm.h"
#include "vtkFiltersShadowModule.h" // For export macro

class VTKFILTERSSHADOW_EXPORT vtkCastShadowContour : public vtkCastShadowAlgorithm
{
public:
  static vtkCastShadowContour* New();
  vtkTypeMacro(vtkCastShadowContour, vtkCastShadowAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCastShadowContour(const vtkCastShadowContour&) = delete;
  void operator=(const vtkCastShadowContour&) = delete;

  bool RemoveHidden = true;
  bool KeepHidden = false;
  double GridSpacing = 0.0;
};

#endif
