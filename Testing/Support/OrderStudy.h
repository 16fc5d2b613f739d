/**
 * @brief The cases of the study of convergence: shapes, their meshes at five sizes, and lights.
 *
 * A case knows nothing of how silhouettes are made: whoever runs it brings that along.
 */
#ifndef shadowtest_OrderStudy_h
#define shadowtest_OrderStudy_h

#include "AnalyticShadow.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace shadowtest
{
/// Meshes of about 1,300 triangles and four times as many at each further size.
constexpr int OrderSizes = 5;

struct OrderCase
{
  std::string Shape;        ///< "sphere", "ellipsoid" or "torus"
  std::string Tessellation; ///< "regular", "jittered", or "flat": four times as long as wide
  std::string Light;        ///< "direction", "near" or "far"
  LightPoint LightPosition;
  std::function<Mesh(int size)> Make;                      ///< size in [0, OrderSizes)
  std::function<std::unique_ptr<AnalyticShadow>()> Shadow; ///< on a plane behind the shape

  std::string name() const { return this->Shape + ", " + this->Tessellation + ", " + this->Light; }
};

/// All shapes and their meshes under all lights.
std::vector<OrderCase> orderCases();

/// Makes the silhouette of a mesh.
using SilhouetteMaker =
  std::function<vtkSmartPointer<vtkPolyData>(vtkPolyData* mesh, const LightPoint& light)>;

struct OrderFigures
{
  std::array<vtkIdType, OrderSizes> Triangles;
  std::array<double, OrderSizes> EdgeLength; ///< mean
  std::array<ShadowError, OrderSizes> Error;

  /// The p of error = c h^p for the largest and for the root mean square error.
  double largestOrder() const;
  double rootMeanSquareOrder() const;
};

/// Error of the shadow's boundary at all sizes. samplesPerChord as in shadowError.
OrderFigures measureOrder(const OrderCase& study, const SilhouetteMaker& make, int samplesPerChord);
}

#endif
