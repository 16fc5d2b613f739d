// The test support itself: meshes, invariants and images, against closed formulas, and for seeing
// what is wrong.

#include "AnalyticShadow.h"
#include "ChainChecks.h"
#include "ImageChecks.h"
#include "Random.h"
#include "RandomMeshes.h"
#include "RealMeshes.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <stdexcept>

using namespace shadowtest;

namespace
{
constexpr double Pi = 3.14159265358979323846;

struct ClosedShape
{
  const char* Name;
  Mesh Surface;
  double Volume;     // of the smooth shape, if known
  double VolumeLoss; // of the triangles against it
};

std::vector<ClosedShape> closedShapes()
{
  const double ball = 4.0 / 3.0 * Pi;
  const double ring = 2.0 * Pi * Pi * TorusRadius * TorusTube * TorusTube;
  return { { "sphere", sphere(32, 64), ball, 0.02 },
    { "jittered sphere", sphere(32, 64, 7), ball, 0.02 }, { "icosphere", icosphere(3), ball, 0.02 },
    { "jittered icosphere", icosphere(3, 7), ball, 0.02 },
    { "ellipsoid", ellipsoid(32, 64), ball, 0.02 },
    { "jittered ellipsoid", icoEllipsoid(3, 7), ball, 0.02 },
    { "torus", torus(64, 32), ring, 0.02 }, { "jittered torus", torus(64, 32, 7), ring, 0.03 },
    { "cylinder", cylinder(64, 3), 2.0 * Pi, 0.01 }, { "box", box(1, 2, 3), 48.0, 1e-12 },
    { "welded box", weldedBox(1, 2, 3), 48.0, 1e-12 },
    { "box of quads", quadBox(1, 2, 3), 48.0, 1e-12 },
    { "star-shaped", starShaped(3, 5), 0.0, 0.0 } };
}

// Triangles whose winding contradicts the normal of one of their corners.
int contradictingFaces(vtkPolyData* surface)
{
  MeshBuilder mesh;
  mesh.append(surface);
  int count = 0;
  for (const auto& cell : mesh.Cells)
  {
    auto point = [&](std::size_t i) { return mesh.Points[static_cast<std::size_t>(cell[i])]; };
    const Vec3 area = cross(point(1) - point(0), point(2) - point(0));
    for (vtkIdType id : cell)
    {
      count += dot(area, mesh.Normals[static_cast<std::size_t>(id)]) <= 0.0;
    }
  }
  return count;
}

// Greatest angle (as a chord) between a triangle's normal and the mean of its corners' normals.
double largestNormalGap(vtkPolyData* surface)
{
  MeshBuilder mesh;
  mesh.append(surface);
  double largest = 0.0;
  for (const auto& cell : mesh.Cells)
  {
    auto point = [&](std::size_t i) { return mesh.Points[static_cast<std::size_t>(cell[i])]; };
    const Vec3 area = normalized(cross(point(1) - point(0), point(2) - point(0)));
    Vec3 mean{ 0.0, 0.0, 0.0 };
    for (vtkIdType id : cell)
    {
      mean = mean + mesh.Normals[static_cast<std::size_t>(id)];
    }
    const Vec3 off = area - normalized(mean);
    largest = std::max(largest, std::sqrt(dot(off, off)));
  }
  return largest;
}

Mesh polyline(const std::vector<vtkIdType>& ids, const std::vector<Vec3>& points)
{
  MeshBuilder builder;
  for (const Vec3& p : points)
  {
    builder.addPoint(p, { 0.0, 0.0, 1.0 });
  }
  Mesh mesh = builder.build();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  mesh->SetLines(lines);
  return mesh;
}

}

TEST(Meshes, ClosedShapesAreClosedAndOutward)
{
  for (const ClosedShape& shape : closedShapes())
  {
    SCOPED_TRACE(shape.Name);
    EXPECT_GT(shape.Surface->GetNumberOfPolys(), 5);
    EXPECT_EQ(shape.Surface->GetPoints()->GetDataType(), VTK_DOUBLE);
    EXPECT_EQ(openEdgesByCoordinates(shape.Surface), 0);
    const double volume = enclosedVolume(shape.Surface);
    EXPECT_GT(volume, 0.0);
    if (shape.Volume > 0.0)
    {
      EXPECT_NEAR(volume, shape.Volume, shape.VolumeLoss * shape.Volume);
    }
    vtkDataArray* normals = shape.Surface->GetPointData()->GetNormals();
    if (normals)
    {
      EXPECT_EQ(contradictingFaces(shape.Surface), 0);
      for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
      {
        Vec3 n;
        normals->GetTuple(i, n.data());
        EXPECT_NEAR(dot(n, n), 1.0, tolerance::UnitNormal);
      }
    }
  }
}

TEST(Meshes, JitteredPointsStayOnTheSurface)
{
  const Mesh ring = torus(24, 12, 3);
  const Mesh egg = icoEllipsoid(2, 3);
  double p[3];
  for (vtkIdType i = 0; i < ring->GetNumberOfPoints(); ++i)
  {
    ring->GetPoint(i, p);
    EXPECT_NEAR(std::hypot(std::hypot(p[0], p[1]) - TorusRadius, p[2]), TorusTube, 1e-14);
  }
  for (vtkIdType i = 0; i < egg->GetNumberOfPoints(); ++i)
  {
    egg->GetPoint(i, p);
    EXPECT_NEAR(p[0] * p[0] / 4.0 + p[1] * p[1] + 4.0 * p[2] * p[2], 1.0, 1e-14);
  }
  EXPECT_GT(ring->GetNumberOfPoints() * egg->GetNumberOfPoints(), 0);
}

TEST(Meshes, NormalsOfTheStarShapeAreThoseOfItsSurface)
{
  // The triangles' own normals tend to them.
  const double coarse = largestNormalGap(starShaped(4, 11));
  const double fine = largestNormalGap(starShaped(5, 11));
  EXPECT_LT(fine, 0.02);
  EXPECT_LT(fine, 0.65 * coarse);
}

TEST(Meshes, BadOnesAreBad)
{
  EXPECT_EQ(openEdgesByCoordinates(fin(3)), 7);
  EXPECT_EQ(openEdgesByCoordinates(fin(5)), 11);
  EXPECT_GT(openEdgesByCoordinates(finnedBox(1)), 0);
  EXPECT_GT(openEdgesByCoordinates(moebiusStrip(12)), 12);
  EXPECT_GT(openEdgesByCoordinates(opened(icosphere(2), 0.1, 1)), 0);
  EXPECT_GT(openEdgesByCoordinates(misoriented(icosphere(2), 0.1, 1)), 0);
  EXPECT_EQ(openEdgesByCoordinates(voxels(3, 1)), 0);
  EXPECT_GT(enclosedVolume(voxels(3, 1)), 0.0);
  EXPECT_NEAR(
    enclosedVolume(voxels(3, 1)), std::round(enclosedVolume(voxels(3, 1))), tolerance::Volume);
  EXPECT_EQ(triangle()->GetNumberOfPolys(), 1);
  EXPECT_EQ(slivers(10, 1e-12)->GetNumberOfPolys(), 10);
  EXPECT_GT(tJunction()->GetNumberOfPolys(), 0);
}

TEST(Meshes, RandomOnesAreReproducibleAndOfAllKinds)
{
  std::map<std::string, int> kinds;
  for (std::uint64_t seed = 0; seed < 1000; ++seed)
  {
    SCOPED_TRACE(seed);
    const RandomMesh drawn = randomMesh(seed);
    ++kinds[drawn.Kind];
    EXPECT_EQ(drawn.Closed && openEdgesByCoordinates(drawn.Surface) != 0, false) << drawn.Kind;
    EXPECT_LT(drawn.Surface->GetNumberOfPolys(), 3000);
    const double* l = drawn.Light.data();
    EXPECT_TRUE(l[0] != 0.0 || l[1] != 0.0 || l[2] != 0.0 || l[3] != 0.0) << drawn.Kind;
    if (seed < 50)
    {
      MeshBuilder once;
      MeshBuilder again;
      once.append(drawn.Surface);
      again.append(randomMesh(seed).Surface);
      EXPECT_EQ(once.Points, again.Points);
      EXPECT_EQ(once.Cells, again.Cells);
      EXPECT_EQ(once.Normals, again.Normals);
    }
  }
  EXPECT_GE(kinds.size(), 20u);
}

TEST(ChainChecks, WindingNumberTellsInsideFromOutside)
{
  const Mesh ring = torus(32, 16);
  for (const auto& place : std::vector<std::pair<Vec3, double>>{ { { 1.0, 0.0, 0.1 }, 1.0 },
         { { 0.0, 0.0, 0.0 }, 0.0 }, { { 3.0, 0.0, 0.0 }, 0.0 }, { { 0.0, -0.8, 0.0 }, 1.0 } })
  {
    EXPECT_NEAR(windingNumber(ring, place.first.data()), place.second, tolerance::Winding);
  }
}

TEST(ChainChecks, VolumesReachInfinity)
{
  // The shadow of a triangle by a light from above: all walls meet in the point below.
  MeshBuilder builder;
  builder.append(withoutNormals(triangle()));
  const vtkIdType below = builder.addPoint({ 0.0, 0.0, -1.0 });
  for (vtkIdType k = 0; k < 3; ++k)
  {
    builder.addTriangle((k + 1) % 3, k, below);
  }
  const Mesh volume = builder.build();
  vtkNew<vtkDoubleArray> homogeneous;
  homogeneous->SetName("Homogeneous");
  homogeneous->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const Vec3 p = builder.Points[static_cast<std::size_t>(i)];
    homogeneous->InsertNextTuple4(p[0], p[1], p[2], i < 3 ? 1.0 : 0.0);
  }
  volume->GetPointData()->AddArray(homogeneous);
  EXPECT_EQ(openEdges(volume), 0);
  const double deep[3] = { 0.25, 0.25, -1e3 };
  const double above[3] = { 0.25, 0.25, 1.0 };
  const double beside[3] = { 1.25, 0.25, -1e3 };
  EXPECT_NEAR(windingNumber(volume, deep), 1.0, tolerance::Winding);
  EXPECT_NEAR(windingNumber(volume, above), 0.0, tolerance::Winding);
  EXPECT_NEAR(windingNumber(volume, beside), 0.0, tolerance::Winding);
}

TEST(ChainChecks, MultiplicityCounts)
{
  // Two faces against one that counts twice.
  MeshBuilder builder;
  builder.append(withoutNormals(triangle()));
  builder.addTriangle(0, 1, 2);
  builder.addTriangle(2, 1, 0);
  const Mesh mesh = builder.build();
  EXPECT_EQ(openEdges(mesh), 3);
  vtkNew<vtkDoubleArray> multiplicity;
  multiplicity->SetName("Multiplicity");
  for (double m : { 1.0, 1.0, 2.0 })
  {
    multiplicity->InsertNextValue(m);
  }
  mesh->GetCellData()->AddArray(multiplicity);
  EXPECT_EQ(openEdges(mesh), 0);
}

TEST(ChainChecks, StripsAreTakenApart)
{
  // A box whose four walls are one strip.
  const vtkIdType walls[] = { 0, 4, 1, 5, 2, 6, 3, 7, 0, 4 };
  const vtkIdType caps[2][4] = { { 0, 1, 2, 3 }, { 7, 6, 5, 4 } };
  vtkNew<vtkPoints> points;
  for (const double z : { -1.0, 1.0 })
  {
    points->InsertNextPoint(-1.0, -1.0, z);
    points->InsertNextPoint(-1.0, 1.0, z);
    points->InsertNextPoint(1.0, 1.0, z);
    points->InsertNextPoint(1.0, -1.0, z);
  }
  const auto solid = Mesh::New();
  solid->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell(4, caps[0]);
  polygons->InsertNextCell(4, caps[1]);
  solid->SetPolys(polygons);
  EXPECT_EQ(openEdges(solid), 8);
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell(10, walls);
  solid->SetStrips(strips);
  EXPECT_EQ(openEdges(solid), 0);
  EXPECT_NEAR(enclosedVolume(solid), 8.0, tolerance::Volume);

  // Cell data of strips stand behind those of polygons.
  vtkNew<vtkDoubleArray> multiplicity;
  multiplicity->SetName("Multiplicity");
  for (const double m : { 2.0, 2.0, 1.0 })
  {
    multiplicity->InsertNextValue(m);
  }
  solid->GetCellData()->AddArray(multiplicity);
  EXPECT_EQ(openEdges(solid), 8);
}

TEST(ChainChecks, LoopsAreJudged)
{
  const std::vector<Vec3> square{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  const LoopReport good = checkLoops(polyline({ 0, 1, 2, 3, 0 }, square));
  EXPECT_TRUE(good.good()) << good;
  EXPECT_EQ(good.Loops, 1);
  EXPECT_EQ(good.Segments, 4);
  const LoopReport open = checkLoops(polyline({ 0, 1, 2, 3 }, square));
  EXPECT_FALSE(open.good());
  EXPECT_EQ(open.OpenLoops, 1);
  EXPECT_EQ(open.UnbalancedPoints, 2);
  EXPECT_EQ(checkLoops(polyline({ 0, 0 }, square)).ShortLoops, 1);

  Mesh bad = polyline({ 0, 1, 2, 3, 0 }, square);
  bad->GetPoints()->SetPoint(1, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  bad->GetPointData()->GetNormals()->SetComponent(0, 2, 1.1);
  const LoopReport report = checkLoops(bad);
  EXPECT_EQ(report.NonFinitePoints, 1);
  EXPECT_NEAR(report.NormalError, 0.1, 1e-12);
  bad->GetPointData()->GetNormals()->SetComponent(0, 2, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(checkLoops(bad).NormalError < 1.0);
}

TEST(ChainChecks, BlockersAreThoseOfTheEllipsoid)
{
  const Mesh egg = icoEllipsoid(4);
  Random random(1);
  int hidden = 0;
  int compared = 0;
  for (int i = 0; i < 300; ++i)
  {
    const Vec3 p{ random.uniform(-3, 3), random.uniform(-3, 3), -1.0 };
    const LightPoint light{ 1.0, 0.5, 3.0, i % 2 ? 1.0 : 0.0 };
    const double slightlySmaller[3] = { 1.98, 0.99, 0.495 };
    if (ellipsoidHides(EllipsoidAxes, p, light) != ellipsoidHides(slightlySmaller, p, light))
    {
      continue; // between the triangles and the true surface, perhaps
    }
    const Blockers blockers = blockersTowards(egg, p.data(), light.data());
    if (blockers.Margin < tolerance::TooClose)
    {
      continue;
    }
    ++compared;
    hidden += blockers.Count > 0;
    EXPECT_EQ(blockers.Count, ellipsoidHides(EllipsoidAxes, p, light) ? 2 : 0);
    EXPECT_EQ(blockers.Signed, 0);
  }
  EXPECT_GT(hidden, 20);
  EXPECT_GT(compared - hidden, 20);
}

TEST(RealMeshes, BunnyIsTheKnownOne)
{
  const Mesh mesh = bunny();
  EXPECT_EQ(mesh->GetNumberOfPolys(), 69666);
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(openEdgesByCoordinates(mesh), 0);
  EXPECT_GT(enclosedVolume(mesh), 0.0);
}

TEST(RealMeshes, AllOfTheCollectionCanBeRead)
{
  const std::vector<std::string> names = cgalMeshNames();
  EXPECT_GE(names.size(), 138u);
  int readable = 0;
  for (const std::string& name : names)
  {
    try
    {
      const Mesh mesh = cgalMesh(name);
      readable += mesh->GetNumberOfPoints() > 0;
    }
    catch (const std::runtime_error& error)
    {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_GE(readable, 138);
  EXPECT_EQ(openEdges(cgalMesh("refined_elephant")), 0);
  EXPECT_GT(openEdges(cgalMesh("elephant-with-holes")), 0);
}

TEST(RealMeshes, MissingOnesAreNamed)
{
  try
  {
    cgalMesh("no-such-mesh");
    FAIL();
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("no-such-mesh.off"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("libcgal-demo"), std::string::npos);
  }
}

TEST(ImageChecks, DifferencesAndFiles)
{
  vtkNew<vtkImageData> a;
  a->SetDimensions(4, 3, 1);
  a->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int i = 0; i < 12; ++i)
  {
    a->SetScalarComponentFromDouble(i % 4, i / 4, 0, 0, i < 3 ? 0.0 : 100.0);
  }
  vtkNew<vtkImageData> b;
  b->DeepCopy(a);
  b->SetScalarComponentFromDouble(1, 1, 0, 0, 130.0);
  b->SetScalarComponentFromDouble(2, 1, 0, 0, 101.0);
  const ImageDifference difference = compareImages(a, b, 2.0);
  EXPECT_EQ(difference.Pixels, 1);
  EXPECT_DOUBLE_EQ(difference.Fraction, 1.0 / 12.0);
  EXPECT_EQ(difference.Largest, 30.0);
  EXPECT_DOUBLE_EQ(difference.Mean, 31.0 / 12.0);
  EXPECT_EQ(differenceImage(a, b)->GetScalarComponentAsDouble(1, 1, 0, 0), 255.0);
  EXPECT_DOUBLE_EQ(blackFraction(a), 0.25);

  const std::string path = testing::TempDir() + "shadowtest-image.png";
  writePng(b, path);
  EXPECT_EQ(compareImages(b, readPng(path)).Pixels, 0);
  std::remove(path.c_str());
  EXPECT_THROW(readPng(path), std::runtime_error);
  vtkNew<vtkImageData> other;
  other->SetDimensions(4, 4, 1);
  other->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  EXPECT_THROW(compareImages(a, other), std::runtime_error);
}
