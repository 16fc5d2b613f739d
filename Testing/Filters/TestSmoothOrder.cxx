// The shadow boundary of a smooth silhouette against that of the true surface: it converges with
// the fourth power of the mesh's edges (discrete and accurate ones with the second).

#include "AnalyticShadow.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <gtest/gtest.h>

#include <functional>

namespace
{
using shadowtest::LightPosition;

struct Study
{
  std::string name;
  std::function<shadowtest::Mesh(int level)> mesh;
  std::function<std::unique_ptr<shadowtest::AnalyticShadow>(
    const LightPosition&, const shadowtest::Plane&)>
    shadow;
};

const shadowtest::Plane Receiver{ { 0.0, 0.0, -3.0 }, { 0.0, 0.0, 1.0 } };

struct Fit
{
  double order;
  double finest; // largest error on the finest mesh
};

// Errors of polylines whose chords are the silhouette are measured along the chords, that of a
// smooth one, which stands for a curve, at its points: they are on the curve, between nodes too.
Fit converge(const Study& study, const LightPosition& light, int kind)
{
  std::vector<double> h;
  std::vector<double> error;
  const auto shadow = study.shadow(light, Receiver);
  for (int level = 0; level < 4; ++level)
  {
    const shadowtest::Mesh mesh = study.mesh(level);
    shadowtest::ShadowPipeline pipeline(mesh, light, kind);
    pipeline.Silhouette->SetTolerance(1e-7);
    const int samples = kind == vtkSmoothLightSilhouette::SMOOTH ? 0 : 4;
    const shadowtest::ShadowError e =
      shadowtest::shadowError(pipeline.silhouette(), *shadow, samples);
    EXPECT_EQ(e.Failed, 0) << study.name;
    EXPECT_GT(e.Samples, 20) << study.name;
    h.push_back(shadowtest::meanEdgeLength(mesh));
    error.push_back(e.Largest);
  }
  return { shadowtest::fitOrder(h, error), error.back() };
}

const double Ball[3] = { 1.0, 1.0, 1.0 };

const Study Studies[] = {
  { "sphere", [](int level) { return shadowtest::sphere(12 << level, 24 << level); },
    [](const LightPosition& light, const shadowtest::Plane& plane)
    { return shadowtest::ellipsoidShadow(Ball, light, plane); } },
  { "jittered sphere", [](int level) { return shadowtest::icosphere(3 + level, 7); },
    [](const LightPosition& light, const shadowtest::Plane& plane)
    { return shadowtest::ellipsoidShadow(Ball, light, plane); } },
  { "torus", [](int level) { return shadowtest::torus(36 << level, 18 << level); },
    [](const LightPosition& light, const shadowtest::Plane& plane)
    {
      return shadowtest::torusShadow(
        shadowtest::TorusRadius, shadowtest::TorusTube, light, plane);
    } }
};

const LightPosition Lights[] = { { 0.3, 0.2, 1.0, 0.0 }, { 1.1, 0.7, 3.1, 1.0 } };
}

TEST(SmoothOrder, SmoothShadowBoundariesConvergeWithOrderFour)
{
  for (const Study& study : Studies)
  {
    for (const LightPosition& light : Lights)
    {
      const Fit fit = converge(study, light, vtkSmoothLightSilhouette::SMOOTH);
      EXPECT_GE(fit.order, shadowtest::tolerance::SmoothOrder)
        << study.name << ", w = " << light[3];
      EXPECT_LT(fit.finest, 1e-7) << study.name << ", w = " << light[3];
    }
  }
}

// Normals are estimated by jets: angle-weighted ones end at order 2.
TEST(SmoothOrder, MeshesWithoutNormalsKeepTheOrder)
{
  for (Study study : Studies)
  {
    const auto withNormals = study.mesh;
    study.mesh = [withNormals](int level)
    { return shadowtest::withoutNormals(withNormals(level)); };
    for (const LightPosition& light : Lights)
    {
      const Fit fit = converge(study, light, vtkSmoothLightSilhouette::SMOOTH);
      EXPECT_GE(fit.order, shadowtest::tolerance::SmoothOrder)
        << study.name << ", w = " << light[3] << ", finest " << fit.finest;
      EXPECT_LT(fit.finest, 1e-6) << study.name << ", w = " << light[3];
    }
  }
}

TEST(SmoothOrder, OthersConvergeWithOrderTwo)
{
  for (const Study& study : Studies)
  {
    for (const LightPosition& light : Lights)
    {
      for (const int kind :
        { vtkSmoothLightSilhouette::DISCRETE, vtkSmoothLightSilhouette::ACCURATE })
      {
        const Fit fit = converge(study, light, kind);
        EXPECT_NEAR(fit.order, 2.0, 0.35) << study.name << ", w = " << light[3] << ", " << kind;
      }
    }
  }
}
