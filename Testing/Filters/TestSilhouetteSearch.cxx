// All methods of search find the same silhouette, byte for byte.

#include "ChainChecks.h"
#include "OutputComparison.h"
#include "PolylineDistance.h"
#include "Random.h"
#include "RandomMeshes.h"
#include "RealMeshes.h"
#include "ShadowPipeline.h"
#include "SilhouetteOracle.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkPolyDataNormals.h>
#include <vtkSMPTools.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace
{
using shadowtest::LightPosition;

vtkNew<vtkSmoothLightSilhouette> makeFilter(vtkPolyData* mesh, int search, int kind)
{
  vtkNew<vtkSmoothLightSilhouette> filter;
  filter->SetInputData(mesh);
  filter->SetSearch(search);
  filter->SetKind(kind);
  return filter;
}

/// Looks at all kinds for each light; gives the sum of what both methods looked at.
std::array<double, 2> compareMethods(vtkPolyData* mesh, const std::vector<LightPosition>& lights)
{
  std::array<double, 2> tested{ 0.0, 0.0 };
  for (const int kind : shadowtest::AllKinds)
  {
    const auto all = makeFilter(mesh, vtkSmoothLightSilhouette::BRUTE_FORCE, kind);
    const auto tree = makeFilter(mesh, vtkSmoothLightSilhouette::HIERARCHY, kind);
    for (std::size_t i = 0; i < lights.size(); ++i)
    {
      all->SetLightPosition(lights[i].data());
      tree->SetLightPosition(lights[i].data());
      all->Update();
      tree->Update();
      EXPECT_EQ(shadowtest::difference(all->GetOutput(), tree->GetOutput()), "")
        << "silhouette kind " << kind << ", light " << i;
      tested[0] += shadowtest::fieldValue(all->GetOutput(), "EdgesTested");
      tested[1] += shadowtest::fieldValue(tree->GetOutput(), "EdgesTested");
    }
  }
  return tested;
}

/// Around and inside of the mesh, far away, and along its axes: with ties where it has flat sides.
std::vector<LightPosition> lightsAround(vtkPolyData* mesh, std::uint64_t seed)
{
  double centre[3];
  mesh->GetCenter(centre);
  const double size = mesh->GetLength();
  shadowtest::Random random(seed);
  std::vector<LightPosition> lights;
  for (const double distance : { 0.2, 0.7, 2.0, 1e6 })
  {
    LightPosition light{ 0.0, 0.0, 0.0, 1.0 };
    for (int i = 0; i < 3; ++i)
    {
      light[i] = centre[i] + distance * size * random.uniform(-1.0, 1.0);
    }
    lights.push_back(light);
  }
  lights.push_back({ random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
    random.uniform(-1.0, 1.0), 0.0 });
  lights.push_back({ 0.0, 0.0, 1.0, 0.0 });
  if (mesh->GetNumberOfPoints() > 0)
  {
    double p[3];
    mesh->GetPoint(mesh->GetNumberOfPoints() / 2, p);
    lights.push_back({ p[0], p[1], p[2], 1.0 });
  }
  return lights;
}
}

TEST(SilhouetteSearch, MethodsAgreeOnRandomMeshes)
{
  for (std::uint64_t seed = 1; seed <= 1000 && !HasFailure(); ++seed)
  {
    const shadowtest::RandomMesh scene = shadowtest::randomMesh(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind);
    std::vector<LightPosition> lights = lightsAround(scene.Surface, seed);
    lights.push_back(scene.Light);
    compareMethods(scene.Surface, lights);
  }
}

TEST(SilhouetteSearch, MethodsAgreeOnRealMeshes)
{
  const std::vector<std::string> names = shadowtest::cgalMeshNames();
  EXPECT_GT(names.size(), 100u);
  for (std::size_t i = 0; i < names.size() && !HasFailure(); ++i)
  {
    SCOPED_TRACE(names[i]);
    const auto mesh = shadowtest::cgalMesh(names[i]);
    compareMethods(mesh, lightsAround(mesh, i + 1));
  }
}

// All methods read the same blocks, so what they find is held against the definition, too.
TEST(SilhouetteSearch, TheHierarchyEqualsTheOracleOnRealMeshes)
{
  std::size_t segments = 0;
  int unclear = 0;
  const std::vector<std::string> names = shadowtest::cgalMeshNames();
  for (std::size_t i = 0; i < names.size() && !HasFailure(); ++i)
  {
    SCOPED_TRACE(names[i]);
    vtkNew<vtkTriangleFilter> triangles;
    triangles->SetInputData(shadowtest::cgalMesh(names[i]));
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputConnection(triangles->GetOutputPort());
    normals->Update();
    vtkPolyData* mesh = normals->GetOutput();
    const std::vector<LightPosition> lights = lightsAround(mesh, i + 1);
    for (const LightPosition& light : { lights[2], lights[4] })
    {
      for (const int kind :
        { vtkSmoothLightSilhouette::DISCRETE, vtkSmoothLightSilhouette::ACCURATE })
      {
        const bool corners = kind == vtkSmoothLightSilhouette::ACCURATE;
        if (corners && !shadowtest::hasUsableNormals(mesh))
        {
          continue;
        }
        const shadowtest::SegmentChain expected = corners
          ? shadowtest::accurateSilhouette(mesh, light.data())
          : shadowtest::discreteSilhouette(mesh, light.data());
        const double margin =
          corners ? std::min(expected.Margin, expected.WindingMargin) : expected.Margin;
        if (!(margin > shadowtest::tolerance::TooClose))
        {
          ++unclear;
          continue;
        }
        const auto filter = makeFilter(mesh, vtkSmoothLightSilhouette::HIERARCHY, kind);
        filter->SetLightPosition(light[0], light[1], light[2], light[3]);
        filter->Update();
        const auto difference = shadowtest::compareChains(expected,
          shadowtest::chainOf(filter->GetOutput()),
          shadowtest::tolerance::SamePoint * mesh->GetLength());
        EXPECT_TRUE(difference.none()) << difference.Message << ", kind " << kind;
        segments += difference.Expected;
      }
    }
  }
  EXPECT_GT(segments, 100000u);
  EXPECT_LT(unclear, 100);
}

// Far from the origin the rounding of a field in double is larger than that of the tree's floats.
TEST(SilhouetteSearch, MethodsAgreeFarFromTheOriginAndAtAllSizes)
{
  for (const double size : { 1e-70, 1e-20, 1.0, 1e20, 1e70 })
  {
    for (const double away : { 0.0, 1e5, 1e10, 1e13 })
    {
      SCOPED_TRACE("size " + std::to_string(size) + ", away " + std::to_string(away));
      const auto mesh = shadowtest::moved(
        shadowtest::torus(60, 30), size, { size * away, -2.0 * size * away, 0.5 * size });
      compareMethods(mesh, lightsAround(mesh, 7));
    }
  }
}

TEST(SilhouetteSearch, TheHierarchyLooksAtLittle)
{
  const auto bunny = shadowtest::bunny();
  const std::array<double, 2> tested = compareMethods(bunny, lightsAround(bunny, 3));
  EXPECT_LT(tested[1], 0.3 * tested[0]);
  EXPECT_GT(tested[1], 0.0);
}

// On a mesh of a few triangles looking at all of them is as fast.
TEST(SilhouetteSearch, AutomaticTakesTheHierarchyOnLargeMeshes)
{
  for (const auto& [mesh, all] : { std::pair{ shadowtest::sphere(10, 20), 540.0 },
         std::pair{ shadowtest::torus(60, 30), 5400.0 } })
  {
    const auto filter = makeFilter(
      mesh, vtkSmoothLightSilhouette::AUTOMATIC, vtkSmoothLightSilhouette::DISCRETE);
    filter->SetLightPosition(0.1, 0.2, 1.0, 0.0);
    filter->Update();
    const double tested = shadowtest::fieldValue(filter->GetOutput(), "EdgesTested");
    if (all < 1000.0)
    {
      EXPECT_EQ(tested, all);
    }
    else
    {
      EXPECT_LT(tested, 0.7 * all);
      EXPECT_GT(tested, 0.0);
    }
  }
}

namespace
{
/// Numbers of the nodes that two following points of a loop have, those between them left out.
std::set<std::pair<vtkIdType, vtkIdType>> piecesOf(vtkPolyData* silhouette)
{
  vtkDataArray* nodes = silhouette->GetPointData()->GetArray("MeshNodes");
  std::set<std::pair<vtkIdType, vtkIdType>> pieces;
  for (vtkIdType cell = 0; cell < silhouette->GetNumberOfLines(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    silhouette->GetLines()->GetCellAtId(cell, size, ids);
    vtkIdType from = -1;
    for (vtkIdType i = 0; i < size; ++i)
    {
      const auto node = static_cast<vtkIdType>(nodes->GetComponent(ids[i], 0));
      if (node >= 0 && from >= 0)
      {
        pieces.emplace(from, node);
      }
      from = node >= 0 ? node : from;
    }
  }
  return pieces;
}
}

// Whole loops, part of what there is, and a volume that says whether it is closed.
TEST(SilhouetteSearch, IncompleteMethodsFindWholeLoops)
{
  const auto mesh = shadowtest::bunny();
  for (const int kind : shadowtest::AllKinds)
  {
    const auto all = makeFilter(mesh, vtkSmoothLightSilhouette::BRUTE_FORCE, kind);
    for (const int search :
      { vtkSmoothLightSilhouette::TRACKING, vtkSmoothLightSilhouette::RANDOMIZED })
    {
      shadowtest::ShadowPipeline pipeline(mesh, { 0.3, 3.0, 2.0, 1.0 }, kind);
      pipeline.Silhouette->SetSearch(search);
      pipeline.Silhouette->SetSampleFraction(1e-3);
      double found = 0.0;
      double complete = 0.0;
      for (int step = 0; step < 10; ++step)
      {
        const LightPosition light{ 0.3 + 0.02 * step, 3.0, 2.0, 1.0 };
        all->SetLightPosition(light.data());
        all->Update();
        pipeline.setLight(light);
        vtkPolyData* some = pipeline.silhouette();
        EXPECT_EQ(shadowtest::fieldValue(some, "SearchComplete"), 0.0);
        EXPECT_LT(shadowtest::fieldValue(some, "EdgesTested"),
          0.7 * shadowtest::fieldValue(all->GetOutput(), "EdgesTested"));
        EXPECT_TRUE(shadowtest::checkLoops(some).good()) << shadowtest::checkLoops(some);
        const auto pieces = piecesOf(some);
        const auto allPieces = piecesOf(all->GetOutput());
        EXPECT_GT(pieces.size(), 50u);
        EXPECT_TRUE(
          std::includes(allPieces.begin(), allPieces.end(), pieces.begin(), pieces.end()));
        found += shadowtest::lengthOfLines(some);
        complete += shadowtest::lengthOfLines(all->GetOutput());
        EXPECT_EQ(shadowtest::fieldValue(pipeline.volume(), "Closed"),
          pieces.size() == allPieces.size() ? 1.0 : 0.0);
      }
      EXPECT_GT(found, 0.5 * complete) << "kind " << kind << ", search " << search;
    }
  }
}

TEST(SilhouetteSearch, ASampleOfEverythingIsEverything)
{
  for (const shadowtest::Mesh& mesh :
    { shadowtest::torus(60, 30), shadowtest::cylinder(24), shadowtest::ground(0.0, 1.0, 5) })
  {
    for (const int kind : shadowtest::AllKinds)
    {
      const auto all = makeFilter(mesh, vtkSmoothLightSilhouette::BRUTE_FORCE, kind);
      const auto sample = makeFilter(mesh, vtkSmoothLightSilhouette::RANDOMIZED, kind);
      for (const auto& filter : { all.Get(), sample.Get() })
      {
        filter->SetLightPosition(0.3, 0.2, 1.0, 0.0);
      }
      all->Update();
      EXPECT_GT(all->GetOutput()->GetNumberOfPoints(), 0);
      sample->SetSampleFraction(0.0);
      sample->Update();
      EXPECT_EQ(sample->GetOutput()->GetNumberOfPoints(), 0);
      EXPECT_EQ(shadowtest::fieldValue(sample->GetOutput(), "SearchComplete"), 0.0);
      sample->SetSampleFraction(1.0);
      sample->Update();
      EXPECT_EQ(shadowtest::fieldValue(sample->GetOutput(), "SearchComplete"), 1.0);
      EXPECT_EQ(shadowtest::difference(all->GetOutput(), sample->GetOutput()), "");
    }
  }
}

TEST(SilhouetteSearch, ThreadsDoNotMatterToTheHierarchy)
{
  const auto bunny = shadowtest::bunny();
  const std::string usual = vtkSMPTools::GetBackend();
  for (const int kind : shadowtest::AllKinds)
  {
    std::vector<vtkSmartPointer<vtkPolyData>> outputs;
    for (const char* backend : { "Sequential", "STDThread" })
    {
      ASSERT_TRUE(vtkSMPTools::SetBackend(backend));
      // Its own copy, or both would share one tree.
      vtkNew<vtkPolyData> copy;
      copy->ShallowCopy(bunny);
      const auto filter = makeFilter(copy, vtkSmoothLightSilhouette::HIERARCHY, kind);
      filter->SetLightPosition(0.3, 3.0, 2.0, 1.0);
      filter->Update();
      outputs.emplace_back(filter->GetOutput());
    }
    EXPECT_EQ(shadowtest::difference(outputs[0], outputs[1]), "");
    EXPECT_EQ(shadowtest::fieldValue(outputs[0], "EdgesTested"),
      shadowtest::fieldValue(outputs[1], "EdgesTested"));
  }
  vtkSMPTools::SetBackend(usual.c_str());
}
