// How far edges are from the curves in their place.

#include "ShadowPipeline.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCellArray.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
double deviationOf(vtkPolyData* mesh)
{
  vtkNew<vtkSmoothLightSilhouette> silhouette;
  silhouette->SetInputData(mesh);
  return silhouette->ComputeMeshDeviation();
}

/// Of the longest edge of a mesh on a sphere around the origin: r (1 - cos(half angle)), and half
/// the angle.
struct Arc
{
  double Sagitta = 0.0;
  double HalfAngle = 0.0;
};

Arc longestArc(vtkPolyData* mesh, double radius)
{
  double longest = 0.0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    mesh->GetPolys()->GetCellAtId(cell, size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      double p[3];
      double q[3];
      mesh->GetPoint(ids[k], p);
      mesh->GetPoint(ids[(k + 1) % size], q);
      longest = std::max(longest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    }
  }
  const double halfAngle = std::asin(0.5 * longest / radius);
  return { radius * (1.0 - std::cos(halfAngle)), halfAngle };
}
}

// Not less than the arc's height, and not more than the bound is said to exceed it.
TEST(MeshDeviation, OfSpheresIsTheSagitta)
{
  for (const double radius : { 1.0, 1e3 })
  {
    for (const int subdivisions : { 1, 2, 3, 4 })
    {
      const auto sphere =
        shadowtest::moved(shadowtest::icosphere(subdivisions), radius, { 0.0, 0.0, 0.0 });
      const Arc arc = longestArc(sphere, radius);
      ASSERT_GT(arc.Sagitta, 0.0);
      const double deviation = deviationOf(sphere);
      EXPECT_GE(deviation, arc.Sagitta * (1.0 - shadowtest::tolerance::ArcRounding));
      EXPECT_LE(deviation, arc.Sagitta * (1.0 + arc.HalfAngle * arc.HalfAngle));
    }
  }
}

TEST(MeshDeviation, OfFlatFacesIsZero)
{
  EXPECT_LE(deviationOf(shadowtest::box()), shadowtest::tolerance::ArcRounding);
  EXPECT_LE(deviationOf(shadowtest::weldedBox()), shadowtest::tolerance::ArcRounding);
  EXPECT_LE(deviationOf(shadowtest::ground(0.0, 1.0, 3)), shadowtest::tolerance::ArcRounding);
  vtkNew<vtkPolyData> nothing;
  EXPECT_EQ(deviationOf(nothing), 0.0);
  vtkNew<vtkSmoothLightSilhouette> unconnected;
  EXPECT_EQ(unconnected->ComputeMeshDeviation(), 0.0);
}

// Across the tube edges are arcs of its circle, around it of the ring's.
TEST(MeshDeviation, OfATorusIsItsGreatestSagitta)
{
  const double pi = std::acos(-1.0);
  const int around = 60;
  const int across = 12;
  const double tube = shadowtest::TorusTube * (1.0 - std::cos(pi / across));
  const double rim =
    (shadowtest::TorusRadius + shadowtest::TorusTube) * (1.0 - std::cos(pi / around));
  ASSERT_GT(tube, rim);
  const double deviation = deviationOf(shadowtest::torus(around, across));
  // Diagonals are arcs of both.
  EXPECT_GE(deviation, tube * (1.0 - shadowtest::tolerance::ArcRounding));
  EXPECT_LE(deviation, (tube + rim) * (1.0 + std::pow(pi / across, 2)));
}

TEST(MeshDeviation, IsThatOfTheMeshAsItIs)
{
  const auto coarse = shadowtest::icosphere(1);
  vtkNew<vtkSmoothLightSilhouette> silhouette;
  silhouette->SetInputData(coarse);
  const double first = silhouette->ComputeMeshDeviation();
  EXPECT_GT(first, 0.0);

  // Neither light nor kind change it, nor has one to update.
  silhouette->SetLightPosition(3.0, 2.0, 1.0, 1.0);
  silhouette->SetKindToDiscrete();
  EXPECT_EQ(silhouette->ComputeMeshDeviation(), first);
  silhouette->Update();
  EXPECT_EQ(silhouette->ComputeMeshDeviation(), first);

  // Creases between flat faces have no curve.
  silhouette->SetInputData(shadowtest::withoutNormals(coarse));
  EXPECT_GT(silhouette->ComputeMeshDeviation(), 0.0);
  silhouette->SetFeatureAngle(0.0);
  EXPECT_LE(silhouette->ComputeMeshDeviation(), shadowtest::tolerance::ArcRounding);

  // A connected input is brought up to date.
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(8);
  silhouette->SetFeatureAngle(60.0);
  silhouette->SetInputConnection(source->GetOutputPort());
  const double ofCoarse = silhouette->ComputeMeshDeviation();
  source->SetThetaResolution(64);
  source->SetPhiResolution(64);
  EXPECT_GT(ofCoarse, 10.0 * silhouette->ComputeMeshDeviation());
}
