// The shadow boundary of a smooth silhouette against that of the true surface: it converges with
// the fourth power of the mesh's edges (discrete and accurate ones with the second).

#include "OrderPipeline.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using shadowtest::OrderCase;
using shadowtest::OrderFigures;

/// The errors of a case, of which the oracle must have answered all but the few near cusps.
OrderFigures measured(const OrderCase& study, int kind)
{
  const OrderFigures figures = shadowtest::measureOrder(study, kind);
  for (const shadowtest::ShadowError& e : figures.Error)
  {
    EXPECT_EQ(e.Failed, 0) << study.name() << ", kind " << kind;
    EXPECT_GT(e.Samples, 20) << study.name() << ", kind " << kind;
    EXPECT_LT(e.LeftOut, e.Samples / 4) << study.name() << ", kind " << kind;
  }
  return figures;
}

std::string identifier(const testing::TestParamInfo<OrderCase>& info)
{
  std::string name = info.param.name();
  name.erase(std::remove(name.begin(), name.end(), ','), name.end());
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

class SmoothOrder : public testing::TestWithParam<OrderCase>
{
};
}

namespace shadowtest
{
void PrintTo(const OrderCase& study, std::ostream* os)
{
  *os << study.name();
}
}

TEST_P(SmoothOrder, SmoothShadowBoundariesConvergeWithOrderFour)
{
  const OrderFigures figures = measured(GetParam(), vtkSmoothLightSilhouette::SMOOTH);
  EXPECT_GE(figures.largestOrder(), shadowtest::tolerance::SmoothOrder) << GetParam().name();
  EXPECT_LT(figures.Error.back().Largest, shadowtest::tolerance::SmoothFinest) << GetParam().name();
}

// Normals are estimated by jets: angle-weighted ones end at order 2.
TEST_P(SmoothOrder, MeshesWithoutNormalsKeepTheOrder)
{
  OrderCase study = GetParam();
  study.Make = [withNormals = study.Make](
                 int size) { return shadowtest::withoutNormals(withNormals(size)); };
  const OrderFigures figures = measured(study, vtkSmoothLightSilhouette::SMOOTH);
  EXPECT_GE(figures.largestOrder(), shadowtest::tolerance::SmoothOrder) << study.name();
  EXPECT_LT(figures.Error.back().Largest, shadowtest::tolerance::EstimatedFinest) << study.name();
}

TEST_P(SmoothOrder, OthersConvergeWithOrderTwo)
{
  for (const int kind : { vtkSmoothLightSilhouette::DISCRETE, vtkSmoothLightSilhouette::ACCURATE })
  {
    const OrderFigures figures = measured(GetParam(), kind);
    EXPECT_NEAR(figures.largestOrder(), 2.0, shadowtest::tolerance::PolygonOrder)
      << GetParam().name() << ", kind " << kind;
  }
}

INSTANTIATE_TEST_SUITE_P(
  Cases, SmoothOrder, testing::ValuesIn(shadowtest::orderCases()), identifier);
