// CGAL's collection of meshes, closed, open, non-manifold, degenerate, under lights all around:
// silhouettes and volumes are closed and finite, masks equal the ray cast of the same triangles.
//
// A usual run takes 4 of 30 lights of each mesh. SMOOTHSHADOW_TEST_ALL_MESHES=1 takes all of them;
// GoogleTest's GTEST_TOTAL_SHARDS and GTEST_SHARD_INDEX divide that among processes. Each test says
// in a line what it compared.

#include "ChainChecks.h"
#include "MaskComparison.h"
#include "RayCast.h"
#include "RealMeshes.h"
#include "ShadowPipeline.h"
#include "ShadowScene.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCell.h>
#include <vtkMatrix4x4.h>
#include <vtkPolygon.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace
{
using namespace shadowtest;

struct NamedLight
{
  std::string Name;
  /// In the mesh's coordinates.
  LightPosition Position;
};

struct RealMesh
{
  std::string Name;
  /// Its place in the list, from which the sample of its lights follows.
  int Number;
};

void PrintTo(const RealMesh& mesh, std::ostream* out)
{
  *out << mesh.Name;
}

bool isEverythingAsked()
{
  const char* value = std::getenv("SMOOTHSHADOW_TEST_ALL_MESHES");
  return value && std::string(value) == "1";
}

// A scan that has no triangles.
const char* const PointCloud = "b9.ply";

std::vector<RealMesh> meshesToTest()
{
  std::vector<RealMesh> meshes;
  for (const std::string& name : cgalMeshNames())
  {
    if (name != PointCloud)
    {
      meshes.push_back({ name, static_cast<int>(meshes.size()) });
    }
  }
  return meshes;
}

// Size 2 (the diagonal of its bounds), around the origin. No normals: the library estimates them.
Mesh atTheOrigin(const std::string& name)
{
  const Mesh mesh = cgalMesh(name);
  double centre[3];
  mesh->GetCenter(centre);
  const double scale = 2.0 / mesh->GetLength();
  return moved(withoutNormals(mesh), scale,
    { -scale * centre[0], -scale * centre[1], -scale * centre[2] });
}

// A thousandth of the size above the middle of a triangle about halfway through the mesh.
Vec3 closeToTheSurface(vtkPolyData* mesh)
{
  MeshBuilder builder;
  builder.append(mesh);
  for (std::size_t i = 0; i < builder.Cells.size(); ++i)
  {
    const auto& ids = builder.Cells[(i + builder.Cells.size() / 2) % builder.Cells.size()];
    Vec3 corners[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] = builder.Points[static_cast<std::size_t>(ids[k])];
    }
    const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (dot(normal, normal) > 0.0)
    {
      const Vec3 middle = (1.0 / 3.0) * (corners[0] + corners[1] + corners[2]);
      return middle + 0.002 * normalized(normal);
    }
  }
  throw std::runtime_error("closeToTheSurface: all triangles are without area");
}

// The directions to the middles of a cube's faces and edges and to its corners, and four points.
std::vector<NamedLight> lightsAround(vtkPolyData* mesh)
{
  std::vector<NamedLight> lights;
  for (int i = 0; i < 27; ++i)
  {
    const double x = i % 3 - 1;
    const double y = i / 3 % 3 - 1;
    const double z = i / 9 - 1;
    if (i != 13)
    {
      lights.push_back({ "direction " + std::to_string(static_cast<int>(x)) + " " +
          std::to_string(static_cast<int>(y)) + " " + std::to_string(static_cast<int>(z)),
        { x, y, z, 0.0 } });
    }
  }
  double bounds[6];
  mesh->GetBounds(bounds);
  const Vec3 close = closeToTheSurface(mesh);
  lights.push_back({ "near", { 0.9, 0.7, 1.1, 1.0 } });
  lights.push_back({ "far", { -300.0, 200.0, 400.0, 1.0 } });
  // Not on the surface of a flat mesh: what is in shadow from there is not defined.
  lights.push_back({ "inside of the bounds",
    { 0.03 + 0.23 * bounds[1], 0.04 + 0.14 * bounds[3], 0.05 + 0.31 * bounds[5], 1.0 } });
  lights.push_back({ "close to the surface", { close[0], close[1], close[2], 1.0 } });
  return lights;
}

class RealMeshes : public ::testing::TestWithParam<RealMesh>
{
protected:
  void SetUp() override
  {
    this->Surface = atTheOrigin(GetParam().Name);
    this->Lights = lightsAround(this->Surface);
    ASSERT_EQ(this->Lights.size(), 30u);
    if (!isEverythingAsked())
    {
      // A few of them; 7 and 30 have no common divisor, so neighbours in the list have others.
      std::vector<NamedLight> sample;
      for (std::size_t i = 0; i < 4; ++i)
      {
        sample.push_back(
          this->Lights[(7 * static_cast<std::size_t>(GetParam().Number) + 8 * i) % 30]);
      }
      this->Lights = sample;
    }
  }

  Mesh Surface;
  std::vector<NamedLight> Lights;
};

std::string testName(const ::testing::TestParamInfo<RealMesh>& info)
{
  std::string name;
  for (const char c : info.param.Name)
  {
    name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  }
  return name;
}
}

TEST(RealMeshesWithoutTriangles, CastNothing)
{
  const Mesh points = cgalMesh(PointCloud);
  EXPECT_GT(points->GetNumberOfPoints(), 10000);
  ShadowPipeline pipeline(points, { 0.0, 0.0, 1.0, 0.0 }, vtkSmoothLightSilhouette::SMOOTH);
  EXPECT_EQ(pipeline.silhouette()->GetNumberOfLines(), 0);
  EXPECT_EQ(pipeline.volume()->GetNumberOfPolys(), 0);
  EXPECT_EQ(fieldValue(pipeline.volume(), "Closed"), 1.0);
}

TEST_P(RealMeshes, SilhouettesAndVolumesAreClosed)
{
  vtkIdType loops = 0;
  vtkIdType triangles = 0;
  std::string defects;
  for (const int kind : AllKinds)
  {
    ShadowPipeline pipeline(this->Surface, this->Lights.front().Position, kind);
    for (const NamedLight& light : this->Lights)
    {
      SCOPED_TRACE(light.Name + ", silhouette kind " + std::to_string(kind));
      pipeline.setLight(light.Position);
      vtkPolyData* silhouette = pipeline.silhouette();
      const LoopReport report = checkLoops(silhouette);
      EXPECT_TRUE(report.good()) << report;
      EXPECT_EQ(nonFiniteNumbers(silhouette), 0);
      vtkPolyData* volume = pipeline.volume();
      EXPECT_EQ(openEdges(volume), 0);
      EXPECT_EQ(fieldValue(volume, "Closed"), 1.0);
      EXPECT_EQ(nonFiniteNumbers(volume), 0);
      EXPECT_GT(volume->GetNumberOfPolys(), 0);
      loops += report.Loops;
      triangles += volume->GetNumberOfPolys();
    }
    defects.clear();
    for (const char* defect : { "DegenerateCells", "NonFiniteCells", "BoundaryEdges",
           "NonManifoldEdges", "InconsistentEdges" })
    {
      defects += std::string(", ") + defect + " " +
        std::to_string(static_cast<long>(fieldValue(pipeline.silhouette(), defect)));
    }
  }
  EXPECT_GT(loops, 0);
  std::cout << GetParam().Name << ": " << this->Surface->GetNumberOfPolys() << " polygons"
            << defects << "; " << this->Lights.size() << " lights of 3 kinds, " << loops
            << " loops, " << triangles << " triangles of volumes" << std::endl;
}

namespace
{
bool hasConcavePolygons(vtkPolyData* mesh)
{
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    if (!vtkPolygon::IsConvex(mesh->GetCell(i)->GetPoints()))
    {
      return true;
    }
  }
  return false;
}

// VTK's mappers and the ray cast take polygons as fans, which concave ones are not.
Mesh asDrawn(const Mesh& mesh)
{
  if (!hasConcavePolygons(mesh))
  {
    return mesh;
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  triangles->Update();
  return triangles->GetOutput();
}

// The mesh's axis along which the light comes, and from which side.
struct LightAxis
{
  std::size_t Axis;
  double Sign;
};

LightAxis axisOf(const LightPosition& light)
{
  LightAxis axis{ 2, light[2] < 0.0 ? -1.0 : 1.0 };
  for (const std::size_t i : { std::size_t{ 0 }, std::size_t{ 1 } })
  {
    if (std::abs(light[i]) > std::abs(light[axis.Axis]))
    {
      axis = { i, light[i] < 0.0 ? -1.0 : 1.0 };
    }
  }
  return axis;
}

// Turns that axis up and puts the mesh a tenth of its size over the ground. Turns by right angles
// only, so that ties remain ties.
vtkSmartPointer<vtkMatrix4x4> overTheGround(vtkPolyData* mesh, const LightAxis& up)
{
  double bounds[6];
  mesh->GetBounds(bounds);
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  matrix->Zero();
  matrix->SetElement(0, static_cast<int>((up.Axis + 1) % 3), up.Sign);
  matrix->SetElement(1, static_cast<int>((up.Axis + 2) % 3), 1.0);
  matrix->SetElement(2, static_cast<int>(up.Axis), up.Sign);
  matrix->SetElement(2, 3, 0.2 + 0.5 * (bounds[2 * up.Axis + 1] - bounds[2 * up.Axis]));
  matrix->SetElement(3, 3, 1.0);
  return matrix;
}
}

TEST_P(RealMeshes, MasksEqualTheRayCast)
{
  const Mesh surface = asDrawn(this->Surface);
  Scene scene;
  vtkSmartPointer<vtkActor> actor = scene.Add(surface);
  auto window = MakeWindow(200, 150);
  window->AddRenderer(scene.Renderer);
  MaskCount sum;
  for (const NamedLight& light : this->Lights)
  {
    SCOPED_TRACE(light.Name);
    const auto matrix = overTheGround(this->Surface, axisOf(light.Position));
    actor->SetUserMatrix(matrix);
    RayLight position;
    matrix->MultiplyPoint(light.Position.data(), position.data());
    scene.Renderer->RemoveAllLights();
    vtkSmartPointer<vtkLight> vtk = scene.AddLight(position);
    scene.Renderer->ResetCameraClippingRange();
    window->Render();
    const Image mask = scene.Mask(vtk);
    ASSERT_TRUE(mask);
    const RayScene rays({ { scene.GroundMesh }, { surface, matrix } });
    const MaskComparison comparison =
      compareMask(rays, ViewOf(scene.Renderer, mask), position, mask);
    const MaskCount count = comparison.total();
    const long stray = count.WrongBeyond - count.WrongFaint;
    EXPECT_LE(stray, 1) << comparison.describe();
    EXPECT_LE(static_cast<double>(count.WrongFaint),
      tolerance::FaintPixels * static_cast<double>(count.Compared))
      << comparison.describe();
    EXPECT_GT(comparison.Objects[0].Compared, 1000) << comparison.describe();
    sum.Compared += count.Compared;
    sum.Shadowed += count.Shadowed;
    sum.Wrong += count.Wrong;
    sum.WrongBeyond += count.WrongBeyond;
    sum.WrongFaint += count.WrongFaint;
  }
  EXPECT_LE(static_cast<double>(sum.WrongBeyond - sum.WrongFaint),
    std::max(1.0, tolerance::StrayPixels * static_cast<double>(sum.Compared)));
  EXPECT_GT(sum.Shadowed, 100 * static_cast<long>(this->Lights.size()));
  std::cout << GetParam().Name << ": " << this->Lights.size() << " masks, " << sum.Compared
            << " pixels compared, " << sum.Shadowed << " in shadow, " << sum.Wrong << " wrong, "
            << sum.WrongBeyond << " of them beyond an edge, of these " << sum.WrongFaint
            << " black by faint light" << std::endl;
}

// Otherwise there would be nothing to test.
TEST(RealMeshCollection, IsThere)
{
  EXPECT_GE(meshesToTest().size(), 138u);
}

INSTANTIATE_TEST_SUITE_P(Cgal, RealMeshes, ::testing::ValuesIn(meshesToTest()), testName);
