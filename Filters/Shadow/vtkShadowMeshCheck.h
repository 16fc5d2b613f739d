/**
 * @class   vtkShadowMeshCheck
 * @brief   what is wrong with a mesh, and what each defect means for its shadow
 *
 * Takes the mesh that vtkSmoothLightSilhouette and vtkShadowVolumeExtruder are to take, and looks
 * at it as these do. Any mesh casts; the table says how well.
 *
 * Output: a table with a row for each kind of defect that occurs, those of the gravest meaning
 * first.
 * - `Defect`: the kind, see below. `Count`: how often it occurs, at least 1.
 * - `Meaning`: "exact" where the discrete shadow is exactly that of the triangles, as without the
 *   defect; "well defined" where it is fixed, but not what an ideal surface would give; "warned"
 *   where something is missing or likely to be wrong.
 * - `Shadow`: one sentence on what it means for the shadow. `Remedy`: one on what to do; may be
 *   empty.
 * - `X`, `Y`, `Z`: one place of them, the least by x, then y, then z; NaN for what has none. Edges
 *   and triangles are placed by their middles, cells by a corner, pierced triangles on one of the
 *   segments along which they cross others.
 * - FieldData `Triangles`, `Points` (of these, welded), `Parts` (connected through edges),
 *   `ClosedParts`, `TwoSidedTriangles` (those of the other parts, which cast on both sides).
 *
 * Kinds that are warned of:
 * - "no triangles"; "non-finite cells" (or with points that do not exist);
 * - "coarse coordinates": vertices at which the coordinates' type, float or double, has steps above
 *   1e-5 of the mesh's diagonal;
 * - "extreme coordinates": vertices with coordinates above 1e50, or all of a mesh whose diagonal is
 *   below 1e-50.
 *
 * Well defined:
 * - "lines and vertices": cells of these types; "crossed polygons": that cannot be triangulated;
 * - "near seams": vertices of border edges with another one within a small distance, but not at the
 *   same place; "T-junctions": those that are so near to the inside of a border edge. Small is 1e-6
 *   of the mesh's diagonal, or 4 steps of the coordinates' type where these are larger, and no more
 *   than a tenth of the edges there;
 * - "estimated normals", where the mesh has none, and "averaged normals", those of them that are
 *   means (see vtkSmoothLightSilhouette::SetFeatureAngle), both without a place; "unusable
 *   normals": given ones that are zero or not finite; "contrary normals": triangles of closed parts
 *   whose normals are to the other side than their part's;
 * - "pierced triangles", that cross another one along a segment (with CheckIntersections), where
 *   there are closed parts, as what lies inside of these may be lit; else they are exact. Those
 *   that only touch or overlap in a plane do not count.
 *
 * Exact:
 * - "degenerate cells": cells and triangles with less than three different corners; "repeated
 *   points": equal to another one in place and normal; "unused points";
 * - "border edges", with one triangle; "non-manifold edges", with more than two; "inconsistent
 *   edges", whose two triangles are wound in opposite ways;
 * - "duplicate triangles", but for the first of each; "zero-area triangles", as far as rounding
 *   lets tell; "slivers", at least 1000 times as long as high;
 * - "inside-out parts", closed and wound inwards; "turned normals": triangles whose normals are
 *   against their winding and are taken the other way around.
 *
 * O(n log n) but where boxes around triangles, or around border edges, meet many others, as needles
 * that lie askew do, and for pierced triangles those of a fan: 16,000 around one vertex take some
 * 4 s. What the filters prepare of the mesh is shared with them.
 *
 * Errors: a mesh that is too large for these filters gives vtkErrorMacro and no output.
 */
#ifndef vtkShadowMeshCheck_h
#define vtkShadowMeshCheck_h

#include "vtkFiltersShadowModule.h" // For export macro
#include "vtkTableAlgorithm.h"

#include <memory> // For the cached caster

class CasterCache;

class VTKFILTERSSHADOW_EXPORT vtkShadowMeshCheck : public vtkTableAlgorithm
{
public:
  static vtkShadowMeshCheck* New();
  vtkTypeMacro(vtkShadowMeshCheck, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * As in vtkSmoothLightSilhouette: whether points with equal coordinates are one vertex, and where
   * the mesh has no normals the angle (degrees, 0 to 180) at which edges split them. Default on,
   * 60.
   */
  vtkSetMacro(MergePoints, bool);
  vtkGetMacro(MergePoints, bool);
  vtkBooleanMacro(MergePoints, bool);
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Whether to look for triangles that pierce each other, which takes most of the time. Default on.
   */
  vtkSetMacro(CheckIntersections, bool);
  vtkGetMacro(CheckIntersections, bool);
  vtkBooleanMacro(CheckIntersections, bool);
  ///@}

protected:
  vtkShadowMeshCheck();
  ~vtkShadowMeshCheck() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkShadowMeshCheck(const vtkShadowMeshCheck&) = delete;
  void operator=(const vtkShadowMeshCheck&) = delete;

  bool MergePoints = true;
  double FeatureAngle = 60.0;
  bool CheckIntersections = true;

  std::unique_ptr<CasterCache> Cache;
};

#endif
