/**
 * @class   vtkCastShadowAlgorithm
 * @brief   what filters of cast shadows on receivers have in common
 *
 * Port 0 takes silhouettes from vtkSmoothLightSilhouette, port 1 the meshes on which shadows fall,
 * port 2 the meshes that cast. Any port takes several inputs. A mesh may be caster and receiver in
 * one.
 *
 * The light is that of the silhouettes (their field data `LightPosition`), or LightPosition where
 * they do not say: a direction or a point anywhere, among the receivers too.
 *
 * Receivers and casters are kept until they are modified. Points with equal coordinates are one
 * vertex. Cells with non-finite points are left out.
 *
 * Errors: silhouettes of different lights, a light that is not finite or is all zero, and one that
 * lies on a silhouette give vtkErrorMacro and no output.
 */
#ifndef vtkCastShadowAlgorithm_h
#define vtkCastShadowAlgorithm_h

#include "vtkFiltersShadowModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For the cached receivers

class ReceiverCache;
struct ContourInput;

class VTKFILTERSSHADOW_EXPORT vtkCastShadowAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkCastShadowAlgorithm, vtkPolyDataAlgorithm);
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

protected:
  vtkCastShadowAlgorithm();
  ~vtkCastShadowAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  // False, with an error, if the inputs cannot be read. The casters only if asked for.
  bool ReadScene(vtkInformationVector** inputVector, bool withCasters, ContourInput& input);

  // False, with an error, if the light is on a silhouette, at the point of that number.
  bool CheckLight(const ContourInput& input, unsigned int lightPoint);

  double LightPosition[4] = { 0.0, 0.0, 1.0, 0.0 };
  int Builder = MORTON;

private:
  vtkCastShadowAlgorithm(const vtkCastShadowAlgorithm&) = delete;
  void operator=(const vtkCastShadowAlgorithm&) = delete;

  std::unique_ptr<ReceiverCache> Receivers;
  std::unique_ptr<ReceiverCache> Casters;
};

#endif
