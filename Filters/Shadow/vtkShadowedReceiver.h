/**
 * @class   vtkShadowedReceiver
 * @brief   receivers split along cast contours, each part lit or in shadow, with areas
 *
 * Inputs and the light are those of vtkCastShadowAlgorithm. Triangles that face the light are cut
 * along the visible contours (vtkCastShadowContour) and where casters pierce or touch them; so what
 * remains is all lit or all in shadow, and a ray from the middle of each part to the light tells.
 * What is inside of a closed caster is in shadow, as is what a caster stands on. Triangles that
 * turn away from the light, and those that are edge-on to it, are not lit.
 *
 * Without casters (port 2) nothing is in shadow, as silhouettes alone do not say what is between
 * them and which of them another caster hides: silhouettes without any caster are an error. Connect
 * the mesh of each silhouette, and the silhouette of each caster: the shadow of a caster without
 * one ends at the edges of triangles, wherever their middles are in it.
 *
 * Near accurate and smooth silhouettes, which do not follow the edges of their mesh, the contour
 * decides: what has nothing between it and the light but what is around such a silhouette
 * (vtkCastShadowContour) is as the side of the contour at its rim says, or else as the nearest part
 * that can be reached without crossing a contour or a caster. Where contours leave gaps, because
 * another mesh or a fold hides their ends, or because a smooth silhouette pierces the receiver
 * beside its mesh, parts as wide as the silhouette is off its mesh may be on the wrong side.
 * Whether a triangle turns away from the light is told by the triangle for all kinds.
 *
 * Output: convex polygons, in the order of the receivers and their triangles and wound as these.
 * Polygons that meet have all points on what they share in common, those of neighbouring triangles
 * too; therefore some have points in the middle of straight sides. Polygons and strips of the input
 * come as triangles. Together the polygons have the area of the receivers.
 * - PointData: the arrays that all receivers have, interpolated (normals then are not of unit
 *   length). Of points with equal coordinates those of the first one.
 * - CellData `Lit` (signed char, 1: the light reaches it), `TurnedAway` (signed char, 1: it faces
 *   away from the light or is edge-on to it), `Receiver` (number of the input on port 1),
 *   `ReceiverCell` (id of its cell there), and the arrays that all receivers have.
 * - FieldData `LitArea`, `ShadowedArea` (faces the light, but is in shadow), `TurnedAwayArea`
 *   (double, one value for each receiver, world units squared; their sum is the receiver's area),
 *   `LightPosition` (4).
 *
 * Discrete shadows are exact but for rounding and for what is within 1e-9 of the scene: what is
 * nearer than that to a receiver's plane casts no shadow there, and parts of triangles that are
 * narrower than 1e-8 of it are as most of what is around them. O(n log n) polygons are to be
 * expected for n segments of contours on a triangle.
 *
 * Errors are those of vtkCastShadowAlgorithm, and silhouettes without casters. Empty inputs give an
 * empty output.
 */
#ifndef vtkShadowedReceiver_h
#define vtkShadowedReceiver_h

#include "vtkCastShadowAlgorithm.h"
#include "vtkFiltersShadowModule.h" // For export macro

class VTKFILTERSSHADOW_EXPORT vtkShadowedReceiver : public vtkCastShadowAlgorithm
{
public:
  static vtkShadowedReceiver* New();
  vtkTypeMacro(vtkShadowedReceiver, vtkCastShadowAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkShadowedReceiver();
  ~vtkShadowedReceiver() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkShadowedReceiver(const vtkShadowedReceiver&) = delete;
  void operator=(const vtkShadowedReceiver&) = delete;
};

#endif
