/**
 * @class   vtkSilhouetteGap
 * @brief   what is seen between a mesh and its smooth silhouette, to be drawn with the mesh
 *
 * A coarse mesh shows the corners of its edges in its outline, although its shading and, with
 * smooth silhouettes, its shadow are those of the smooth surface. Port 0 takes the mesh, port 1 its
 * silhouette from vtkSmoothLightSilhouette of kind SMOOTH whose light is the eye (for a parallel
 * projection the direction towards it). Drawn beside the mesh, in its colour, the output fills what
 * is between the outline of the triangles and the smooth one (see Mattausch et al. 2012, Figure 7).
 *
 * These are the gap triangles of vtkShadowVolumeExtruder that face the eye. Mesh and gaps together
 * cover all that its rims enclose: there is no crack between them, and the depth of the outer edge
 * is that of the smooth surface. Where the silhouette runs inside of the mesh's outline, as around
 * the hole of a torus, the mesh is in the way, and its outline stays; so it does in the few places
 * where a coarse mesh shows a contour that the smooth surface, concave along the line of sight,
 * would hide. A silhouette that is not smooth lies on the mesh and has no gaps.
 *
 * Output: triangles, counter-clockwise as seen from the eye, double points.
 * - PointData `Normals` (3, double, unit; zero where none is known): on the mesh as shading
 *   interpolates the mesh's, on the silhouette its own. They point outwards, about at right angles
 *   to the line of sight; as a coarse mesh ends with normals that still turn to the eye, the output
 *   shows as a faint rim, above all under a light from the eye.
 *
 * The mesh casts: for renderers with shadows the output only receives. When the eye moves the
 * silhouette has to be made anew. Costs in proportion to the silhouette, once the mesh is prepared.
 *
 * Errors: a silhouette that does not belong to the mesh gives vtkErrorMacro and no output.
 */
#ifndef vtkSilhouetteGap_h
#define vtkSilhouetteGap_h

#include "vtkFiltersShadowModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For the cached caster

class CasterCache;

class VTKFILTERSSHADOW_EXPORT vtkSilhouetteGap : public vtkPolyDataAlgorithm
{
public:
  static vtkSilhouetteGap* New();
  vtkTypeMacro(vtkSilhouetteGap, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Takes the silhouette from a filter's output (port 1).
   */
  void SetSilhouetteConnection(vtkAlgorithmOutput* silhouette);

protected:
  vtkSilhouetteGap();
  ~vtkSilhouetteGap() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSilhouetteGap(const vtkSilhouetteGap&) = delete;
  void operator=(const vtkSilhouetteGap&) = delete;

  std::unique_ptr<CasterCache> Cache;
};

#endif
