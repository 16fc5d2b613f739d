/**
 * @class   vtkContourStrokes
 * @brief   polylines as ribbons that face the eye
 *
 * Takes any polylines: cast contours from vtkCastShadowContour, silhouettes seen from the light or
 * from the eye, creases. Each becomes a ribbon with the line in its middle, for drawing with
 * lighting off. With Taper, Overshoot and Wobble lines look as if drawn by hand.
 *
 * Lines with the point arrays of vtkCastShadowContour are lifted off the receiver along
 * `ReceiverNormals` and moved into the shadow along `ShadowDirection`, by Lift; lines without
 * normals are moved towards the eye, which leaves their places in the picture.
 *
 * Corners are mitred up to twice the width (turns of 120 degrees); sharper ones, and those between
 * segments shorter than the mitre, are round. So no triangle is turned over, and there are no
 * gaps; where a line turns sharply or meets itself its ribbon overlaps, which shows if it is
 * translucent. Closed lines (which return to the point at which they start) have neither ends nor
 * a seam.
 *
 * Output: triangles, counter-clockwise as seen from the eye.
 * - PointData: those of the lines' points, mixed where points were added between two; and `Across`
 *   (double): 1 on the left as it is seen, 0 in the middle, -1 on the right.
 * - CellData: those of the lines, and `Line` (vtkIdType): which of the input's lines it is from.
 * - FieldData: the input's, and `NonFinitePoints`, `HiddenPoints` (in pixels: not before the eye),
 *   `DegenerateLines` (without length).
 *
 * Points that are not finite, do not exist or are not before the eye are left out and counted; the
 * line falls into parts there. Points at the same place as the one before are passed over, and
 * what is then left without length is left out and counted. Empty in, empty out.
 *
 * Errors: an eye that is not finite or is all zero, or in pixels a ViewDirection like that, gives
 * vtkErrorMacro and no output. Takes O(points), on VTK's threads; the same bytes for any number of
 * them.
 */
#ifndef vtkContourStrokes_h
#define vtkContourStrokes_h

#include "vtkFiltersShadowModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSSHADOW_EXPORT vtkContourStrokes : public vtkPolyDataAlgorithm
{
public:
  static vtkContourStrokes* New();
  vtkTypeMacro(vtkContourStrokes, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum WidthUnits
  {
    PIXELS = 0,
    WORLD = 1
  };

  ///@{
  /**
   * The width of strokes, in pixels or world units. In world units it is measured at right angles
   * to the line of sight, in pixels in the picture: exact wherever a point is in it. Default 1,
   * WORLD.
   */
  vtkSetClampMacro(Width, double, 1e-300, VTK_DOUBLE_MAX);
  vtkGetMacro(Width, double);
  vtkSetClampMacro(WidthUnit, int, PIXELS, WORLD);
  vtkGetMacro(WidthUnit, int);
  void SetWidthUnitToPixels() { this->SetWidthUnit(PIXELS); }
  void SetWidthUnitToWorld() { this->SetWidthUnit(WORLD); }
  ///@}

  ///@{
  /**
   * The eye that ribbons face, homogeneous: (x, y, z, 1) is a point, as a camera's position;
   * (x, y, z, 0) the direction towards an eye at infinity, as of parallel projection. Default
   * (0, 0, 1, 0).
   */
  vtkSetVector4Macro(EyePosition, double);
  vtkGetVector4Macro(EyePosition, double);
  ///@}

  ///@{
  /**
   * Of PIXELS: where the eye looks to, as vtkCamera::GetDirectionOfProjection, of any length.
   * Default (0, 0, -1).
   */
  vtkSetVector3Macro(ViewDirection, double);
  vtkGetVector3Macro(ViewDirection, double);
  ///@}

  ///@{
  /**
   * Of PIXELS: how large a pixel is in world units, for an eye that is a point at distance 1 along
   * ViewDirection. With a vtkCamera and a picture of `height` pixels that is
   * `2 tan(ViewAngle / 2) / height`; in parallel projection `2 ParallelScale / height`. Default 1.
   */
  vtkSetClampMacro(PixelSize, double, 1e-300, VTK_DOUBLE_MAX);
  vtkGetMacro(PixelSize, double);
  ///@}

  ///@{
  /**
   * The share of a line's length, at either open end, over which the stroke widens from nothing to
   * Width; 0 to 0.5, default 0.
   */
  vtkSetClampMacro(Taper, double, 0.0, 0.5);
  vtkGetMacro(Taper, double);
  ///@}

  ///@{
  /**
   * How far open ends are drawn out, straight on, in widths at the end. Default 0.
   */
  vtkSetClampMacro(Overshoot, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Overshoot, double);
  ///@}

  ///@{
  /**
   * The most that the middle of a stroke is to the left or right of its line, in widths. Offsets
   * are drawn at random for points WobbleLength widths apart, from Seed and the line's number, and
   * are smooth in between. Defaults 0, 40 and 1.
   */
  vtkSetClampMacro(Wobble, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Wobble, double);
  vtkSetClampMacro(WobbleLength, double, 1e-3, VTK_DOUBLE_MAX);
  vtkGetMacro(WobbleLength, double);
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * How far strokes are from their receivers, and as far into the shadow, in widths (or nearer to
   * the eye, see above). From 0.5 on no part of a stroke is below a flat receiver. Default 0.5.
   */
  vtkSetClampMacro(Lift, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Lift, double);
  ///@}

protected:
  vtkContourStrokes();
  ~vtkContourStrokes() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkContourStrokes(const vtkContourStrokes&) = delete;
  void operator=(const vtkContourStrokes&) = delete;

  double Width = 1.0;
  int WidthUnit = WORLD;
  double EyePosition[4] = { 0.0, 0.0, 1.0, 0.0 };
  double ViewDirection[3] = { 0.0, 0.0, -1.0 };
  double PixelSize = 1.0;
  double Taper = 0.0;
  double Overshoot = 0.0;
  double Wobble = 0.0;
  double WobbleLength = 40.0;
  int Seed = 1;
  double Lift = 0.5;
};

#endif
