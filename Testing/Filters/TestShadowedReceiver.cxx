// Receivers split along cast contours: areas against analytic ones, Lit against rays by brute
// force, and nothing of the receiver lost.

#include "AnalyticShadow.h"
#include "ChainChecks.h"
#include "ContourScenes.h"
#include "HostileMeshes.h"
#include "OutputComparison.h"
#include "Random.h"
#include "RealMeshes.h"
#include "RegionOracle.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkShadowedReceiver.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using namespace shadowtest;

namespace
{
struct Regions
{
  Regions(const std::vector<Mesh>& casters, const std::vector<Mesh>& receivers,
    const LightPosition& light, int kind = vtkSmoothLightSilhouette::DISCRETE)
  {
    for (vtkPolyData* caster : casters)
    {
      this->Silhouettes.push_back(vtkSmartPointer<vtkSmoothLightSilhouette>::New());
      this->Silhouettes.back()->SetInputData(caster);
      this->Silhouettes.back()->SetKind(kind);
      this->Silhouettes.back()->SetLightPosition(light.data());
      this->Filter->AddSilhouetteConnection(this->Silhouettes.back()->GetOutputPort());
      this->Filter->AddInputData(2, caster);
    }
    for (vtkPolyData* receiver : receivers)
    {
      this->Filter->AddInputData(1, receiver);
    }
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this->Errors);
    this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Errors);
  }

  vtkPolyData* update()
  {
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  double area(const char* name, vtkIdType receiver = 0)
  {
    return this->update()->GetFieldData()->GetArray(name)->GetComponent(receiver, 0);
  }

  std::vector<vtkSmartPointer<vtkSmoothLightSilhouette>> Silhouettes;
  vtkNew<vtkShadowedReceiver> Filter;
  vtkNew<vtkTest::ErrorObserver> Errors;
};

/// Where the ray through a point meets z = height.
Vec3 shadowAt(double height, const LightPosition& light, const Vec3& point)
{
  return shadowOn({ { 0.0, 0.0, height }, { 0.0, 0.0, 1.0 } }, light, point);
}

/// Area of the convex hull of points, seen along z (Andrew's monotone chain).
double hullArea(std::vector<Vec3> points)
{
  std::sort(points.begin(), points.end());
  const auto half = [](const std::vector<Vec3>& sorted) {
    std::vector<Vec3> hull;
    for (const Vec3& p : sorted)
    {
      while (
        hull.size() > 1 && cross(hull.back() - hull[hull.size() - 2], p - hull.back())[2] <= 0.0)
      {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    return hull;
  };
  std::vector<Vec3> hull = half(points);
  std::reverse(points.begin(), points.end());
  const std::vector<Vec3> back = half(points);
  hull.insert(hull.end(), back.begin(), back.end());
  double sum = 0.0;
  for (std::size_t i = 0; i < hull.size(); ++i)
  {
    sum += 0.5 * cross(hull[i], hull[(i + 1) % hull.size()])[2];
  }
  return sum;
}

/// Shadow of what is above a height of a box around the origin, and its section there.
double boxShadow(const Vec3& half, double height, const LightPosition& light)
{
  std::vector<Vec3> points;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double x = (corner & 1) != 0 ? half[0] : -half[0];
    const double y = (corner & 2) != 0 ? half[1] : -half[1];
    const double z = (corner & 4) != 0 ? half[2] : std::max(-half[2], height);
    points.push_back(shadowAt(height, light, { x, y, z }));
  }
  return hullArea(points);
}

struct RoundShadow
{
  double Area = 0.0;
  double Perimeter = 0.0;
};

/// Of the unit sphere on z = height.
RoundShadow sphereShadow(double height, const LightPosition& light)
{
  const double axes[3] = { 1.0, 1.0, 1.0 };
  const Plane plane{ { 0.0, 0.0, height }, { 0.0, 0.0, 1.0 } };
  std::vector<Vec3> boundary = ellipsoidShadow(axes, light, plane)->contour(100000);
  for (Vec3& point : boundary)
  {
    point = shadowOn(plane, light, point);
  }
  RoundShadow shadow;
  for (std::size_t i = 0; i < boundary.size(); ++i)
  {
    const Vec3& next = boundary[(i + 1) % boundary.size()];
    const Vec3 along = next - boundary[i];
    shadow.Area += 0.5 * cross(boundary[i], next)[2];
    shadow.Perimeter += std::sqrt(dot(along, along));
  }
  shadow.Area = std::fabs(shadow.Area);
  return shadow;
}

const LightPosition allLights[] = { { 0.2, 0.3, 1.0, 0.0 }, { 2.0, 3.0, 9.0, 1.0 },
  { 0.3, -0.2, 2.5, 1.0 } };

void expectWhole(const RegionReport& report)
{
  EXPECT_EQ(report.Wrong, 0) << report.FirstWrong;
  EXPECT_EQ(report.Turned, 0);
  EXPECT_LE(report.AreaError, tolerance::SamePoint);
  EXPECT_LE(report.BorderError, tolerance::SamePoint);
}

/// Of one quad a square.
Mesh quadGround(double height, double half, int cells)
{
  MeshBuilder builder;
  for (int j = 0; j <= cells; ++j)
  {
    for (int i = 0; i <= cells; ++i)
    {
      builder.addPoint({ half * (2.0 * i / cells - 1.0), half * (2.0 * j / cells - 1.0), height });
    }
  }
  for (int j = 0; j < cells; ++j)
  {
    for (int i = 0; i < cells; ++i)
    {
      const vtkIdType at = j * (cells + 1) + i;
      builder.addPolygon({ at, at + 1, at + cells + 2, at + cells + 1 });
    }
  }
  return builder.build();
}
}

// Its convex hull, whatever meshes the receiver is made of.
TEST(ShadowedReceiver, BoxOverPlane)
{
  const Vec3 half{ 1.0, 0.7, 0.4 };
  for (const LightPosition& light : allLights)
  {
    for (const int cells : { 1, 4, 7 })
    {
      const Mesh caster = box(half[0], half[1], half[2]);
      const Mesh receiver = ground(-1.5, 8.0, cells);
      Regions regions({ caster }, { receiver }, light);
      const double area = boxShadow(half, -1.5, light);
      EXPECT_NEAR(regions.area("ShadowedArea"), area, tolerance::SamePoint * area);
      EXPECT_EQ(regions.area("TurnedAwayArea"), 0.0);
      EXPECT_NEAR(regions.area("LitArea"), 256.0 - area, tolerance::SamePoint * 256.0);
      Random random(1);
      const RegionReport report =
        checkRegions(regions.update(), { receiver }, { caster }, light, random, 20);
      expectWhole(report);
      EXPECT_GT(report.Shadowed, 20);
      EXPECT_LT(report.Unclear, report.Looks / 10);
    }
  }
}

// What a box stands on, or is sunk into, is in its shadow: there no contour is, but the box itself.
TEST(ShadowedReceiver, BoxOnAndInPlane)
{
  for (const LightPosition& light : { LightPosition{ 1.0, 2.0, 4.0, 0.0 },
         LightPosition{ 2.0, 3.0, 7.0, 1.0 }, LightPosition{ 0.21, 0.37, 0.8, 0.0 },
         LightPosition{ 0.0, 0.0, 1.0, 0.0 }, LightPosition{ 0.5, 0.0, 3.0, 1.0 } })
  {
    for (const double height : { -1.0, -0.75, 0.0 })
    {
      for (const int cells : { 1, 4, 7, 8 })
      {
        const Mesh caster = box(1.0, 1.0, 1.0);
        const Mesh receiver = ground(height, 8.0, cells);
        Regions regions({ caster }, { receiver }, light);
        const double area = boxShadow({ 1.0, 1.0, 1.0 }, height, light);
        EXPECT_GE(area, 4.0);
        EXPECT_NEAR(regions.area("ShadowedArea"), area, tolerance::SamePoint * area)
          << "height " << height << ", " << cells << " cells, light " << light[0];
        Random random(2);
        expectWhole(checkRegions(regions.update(), { receiver }, { caster }, light, random, 3));
      }
    }
  }
}

// Where all coordinates are rounded the box touches the plane to within that.
TEST(ShadowedReceiver, BoxOnRotatedPlane)
{
  const double light[4] = { 1.0, 2.0, 4.0, 0.0 };
  const double area = boxShadow({ 1.0, 1.0, 1.0 }, -1.0, { 1.0, 2.0, 4.0, 0.0 });
  for (std::uint64_t rotation = 1; rotation <= 40; ++rotation)
  {
    SCOPED_TRACE("rotation " + std::to_string(rotation));
    const Vec3 shift{ 0.3, -0.2, 0.7 };
    const Mesh caster = moved(box(), 1.0, shift, rotation);
    const Mesh receiver = moved(ground(-1.0, 8.0, 4), 1.0, shift, rotation);
    Regions regions({ caster }, { receiver }, movedLight(light, 1.0, shift, rotation));
    EXPECT_NEAR(regions.area("ShadowedArea"), area, 1e-6 * area);
  }
}

// What subdivision and the contour's own error leave is within the bound that silhouettes report.
TEST(ShadowedReceiver, SmoothSphereOverPlane)
{
  for (const LightPosition& light : allLights)
  {
    const RoundShadow shadow = sphereShadow(-2.0, light);
    for (const int cells : { 1, 9, 40 })
    {
      const Mesh receiver = ground(-2.0, 8.0, cells);
      Regions regions({ icosphere(4, 5) }, { receiver }, light, vtkSmoothLightSilhouette::SMOOTH);
      regions.Silhouettes[0]->SetToleranceModeToReceiver();
      regions.Silhouettes[0]->SetTolerance(1e-3);
      regions.Silhouettes[0]->SetInputDataObject(1, receiver);
      const double area = regions.area("ShadowedArea");
      const double bound =
        fieldValue(regions.Silhouettes[0]->GetOutput(), "MaximumShadowDeviation");
      EXPECT_GT(bound, 0.0);
      EXPECT_LT(bound, 2e-3);
      EXPECT_LE(std::fabs(area - shadow.Area), shadow.Perimeter * bound);
      // Far nearer than the mesh's own shadow.
      Regions discrete({ icosphere(4, 5) }, { receiver }, light);
      EXPECT_LT(5.0 * std::fabs(area - shadow.Area),
        std::fabs(discrete.area("ShadowedArea") - shadow.Area) + 5.0 * shadow.Perimeter * bound);
    }
  }
}

// The contour alone decides, not what the mesh hides, however fine the receiver is: all cells near
// a silhouette of few triangles lie between the two.
TEST(ShadowedReceiver, SmoothShadowsDoNotDependOnTheReceiversMesh)
{
  for (const int kind : { vtkSmoothLightSilhouette::ACCURATE, vtkSmoothLightSilhouette::SMOOTH })
  {
    for (const LightPosition& light : allLights)
    {
      double first = 0.0;
      for (const int cells : { 1, 7, 64 })
      {
        Regions regions({ icosphere(1, 5) }, { ground(-2.0, 8.0, cells) }, light, kind);
        const double area = regions.area("ShadowedArea");
        first = cells == 1 ? area : first;
        EXPECT_NEAR(area, first, tolerance::Moved * first);
      }
      EXPECT_GT(first, 1.0);
    }
  }
}

// Half of it above the plane: its section, and the half of an ellipse beyond.
TEST(ShadowedReceiver, SunkSphere)
{
  const LightPosition light{ 0.6, 0.0, 0.8, 0.0 };
  const double area = 0.5 * vtkMath::Pi() * (1.0 + 1.0 / 0.8);
  for (const int kind : AllKinds)
  {
    for (const int cells : { 1, 10 })
    {
      const Mesh caster = icosphere(4, 3);
      Regions regions({ caster }, { ground(0.0, 4.0, cells) }, light, kind);
      // The mesh's section is a polygon of edges that are as long, at most about twice as the mean.
      const double edge = 2.0 * meanEdgeLength(caster);
      EXPECT_NEAR(
        regions.area("ShadowedArea"), area, 2.0 * vtkMath::Pi() / 0.8 * edge * edge / 8.0);
    }
  }
}

// Around the silhouette of a coarse mesh no ray tells: what is in the mesh is in shadow, and no
// light gets in from beside it.
TEST(ShadowedReceiver, SunkCoarseSphere)
{
  const LightPosition light{ 0.6, 0.1, 0.8, 0.0 };
  for (const int kind : AllKinds)
  {
    double first = 0.0;
    for (const int cells : { 1, 20, 50 })
    {
      Regions regions({ icosphere(0) }, { ground(0.1, 4.0, cells) }, light, kind);
      vtkPolyData* output = regions.update();
      vtkDataArray* lit = output->GetCellData()->GetArray("Lit");
      int inside = 0;
      for (vtkIdType cell = 0; cell < output->GetNumberOfPolys(); ++cell)
      {
        vtkIdType count;
        const vtkIdType* ids;
        output->GetPolys()->GetCellAtId(cell, count, ids);
        double farthest = 0.0;
        for (vtkIdType i = 0; i < count; ++i)
        {
          double p[3];
          output->GetPoint(ids[i], p);
          farthest = std::max(farthest, std::hypot(p[0], p[1]));
        }
        // The inscribed sphere of an icosahedron has a radius of 0.79.
        if (farthest < 0.75)
        {
          ++inside;
          EXPECT_EQ(lit->GetComponent(cell, 0), 0.0) << "kind " << kind << ", cell " << cell;
        }
      }
      EXPECT_TRUE(cells == 1 || inside > 0);
      first = cells == 1 ? regions.area("ShadowedArea") : first;
      // A smooth silhouette leaves the receiver beside the mesh: there is a gap between the two,
      // which of 20 triangles is a few hundredths.
      const double gap = kind == vtkSmoothLightSilhouette::SMOOTH ? 0.1 : tolerance::Moved * 64.0;
      EXPECT_NEAR(regions.area("ShadowedArea"), first, gap) << "kind " << kind << ", " << cells;
    }
    EXPECT_GT(first, 2.0);
  }
}

// A face that the light is on hides nothing, as it is edge-on everywhere.
TEST(ShadowedReceiver, LightOnFace)
{
  const Mesh room = moved(box(6.0, 6.0, 6.0), -1.0, { 0.0, 0.0, 0.0 });
  Regions regions({ box() }, { room }, { 0.2, 0.3, 1.0, 1.0 });
  EXPECT_NEAR(regions.area("LitArea"), 144.0 + 4.0 * 12.0 * 5.0, tolerance::SamePoint * 864.0);
  EXPECT_NEAR(regions.area("ShadowedArea"), 144.0 + 4.0 * 12.0 * 7.0, tolerance::SamePoint * 864.0);
}

// Of triangles whose corners are in line, but for rounding, any point may seem to be in the shadow.
TEST(ShadowedReceiver, TrianglesInLine)
{
  Random random(8);
  for (int i = 0; i < 200; ++i)
  {
    const auto draw = [&] {
      return Vec3{ random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(0.5, 2.0) };
    };
    const Vec3 start = draw();
    // Half of them so short that all of it is rounding.
    const Vec3 along = (i % 2 == 0 ? 1.0 : 1e-15) * draw();
    MeshBuilder builder;
    builder.addPoint(start);
    builder.addPoint(start + random.uniform(0.2, 0.8) * along);
    builder.addPoint(start + along);
    builder.addTriangle(0, 1, 2);
    Regions regions({ builder.build() }, { ground(0.0, 4.0, 6) }, { 0.3, 0.2, 1.0, 0.0 });
    EXPECT_LE(regions.area("ShadowedArea"), 1e-12) << i;
  }
}

// Open casters shadow on both sides, whichever way they face.
TEST(ShadowedReceiver, OpenCasters)
{
  const LightPosition light{ 0.3, -0.4, 1.0, 0.0 };
  const Mesh receiver = ground(-1.0, 4.0, 3);
  MeshBuilder turned;
  turned.addPoint({ 0.0, 0.0, 0.0 });
  turned.addPoint({ 0.0, 1.0, 0.0 });
  turned.addPoint({ 1.0, 0.0, 0.0 });
  turned.addTriangle(0, 1, 2);
  for (const Mesh& caster : { triangle(), turned.build() })
  {
    Regions regions({ caster }, { receiver }, light);
    EXPECT_NEAR(regions.area("ShadowedArea"), 0.5, tolerance::SamePoint * 64.0);
  }
  // In the plane itself it hides nothing, a little above it all.
  Regions touching({ triangle() }, { ground(0.0, 4.0, 3) }, light);
  EXPECT_EQ(touching.area("ShadowedArea"), 0.0);
  Regions above({ triangle() }, { ground(-1e-6, 4.0, 3) }, light);
  EXPECT_NEAR(above.area("ShadowedArea"), 0.5, tolerance::SamePoint * 64.0);
  // Standing on it upright.
  const Mesh upright = moved(triangle(), 1.0, { 0.0, 0.0, 0.0 });
  for (vtkIdType i = 0; i < 3; ++i)
  {
    double p[3];
    upright->GetPoint(i, p);
    upright->GetPoints()->SetPoint(i, p[0], 0.0, p[1]);
  }
  Regions standing({ upright }, { ground(0.0, 4.0, 3) }, light);
  EXPECT_NEAR(standing.area("ShadowedArea"), 0.5 * 0.4, tolerance::SamePoint * 64.0);
}

// Receivers are told apart, and one is in the shadow of the other if it casts.
TEST(ShadowedReceiver, SeveralCastersAndReceivers)
{
  const LightPosition light{ 0.0, 0.0, 1.0, 0.0 };
  const Mesh upper = moved(box(1.0, 1.0, 0.25), 1.0, { 0.5, 0.5, 3.0 });
  const Mesh lower = moved(box(1.0, 1.0, 0.25), 1.0, { 0.0, 0.0, 1.0 });
  const Mesh plane = ground(0.0, 4.0, 3);
  Regions regions({ upper, lower }, { plane, lower, upper }, light);
  EXPECT_NEAR(regions.area("ShadowedArea", 0), 8.0 - 2.25, tolerance::SamePoint * 64.0);
  EXPECT_NEAR(regions.area("ShadowedArea", 1), 2.25, tolerance::SamePoint * 64.0);
  EXPECT_EQ(regions.area("ShadowedArea", 2), 0.0);
  // Sides are edge-on.
  EXPECT_NEAR(regions.area("TurnedAwayArea", 1), 4.0 + 4.0, tolerance::SamePoint * 64.0);
  EXPECT_NEAR(regions.area("LitArea", 1), 1.75, tolerance::SamePoint * 64.0);
  EXPECT_NEAR(regions.area("LitArea", 2), 4.0, tolerance::SamePoint * 64.0);
}

// A plate in a room around the light, which has six charts.
TEST(ShadowedReceiver, LightInRoom)
{
  const Mesh room = moved(box(6.0, 6.0, 6.0), -1.0, { 0.0, 0.0, 0.0 });
  const LightPosition inRoom{ 0.0, 0.0, 0.0, 1.0 };
  for (const Vec3& turn : { Vec3{ 0.0, 0.0, 1.0 }, Vec3{ 0.0, 0.0, -1.0 }, Vec3{ 0.0, 1.0, 0.0 } })
  {
    MeshBuilder plate;
    const Vec3 u = turn[2] != 0.0 ? Vec3{ 1.0, 0.0, 0.0 } : Vec3{ 0.0, 0.0, 1.0 };
    const Vec3 v = cross(turn, u);
    for (const auto& [a, b] : { std::pair(-0.5, -0.5), { 0.5, -0.5 }, { 0.5, 0.5 }, { -0.5, 0.5 } })
    {
      plate.addPoint(2.0 * turn + a * u + b * v);
    }
    plate.addQuad(0, 1, 2, 3);
    const Mesh caster = plate.build();
    Regions regions({ caster }, { room }, inRoom);
    EXPECT_NEAR(regions.area("ShadowedArea"), 9.0, tolerance::SamePoint * 864.0);
    Random random(4);
    expectWhole(checkRegions(regions.update(), { room }, { caster }, inRoom, random, 20));
  }
  // Around the light and closed: nothing is lit outside of it.
  Regions closed({ box() }, { room }, inRoom);
  EXPECT_NEAR(closed.area("ShadowedArea"), 864.0, tolerance::SamePoint * 864.0);
}

// A linear function of the place is still one, other arrays are those of the cells, and arrays that
// not all receivers have are left out.
TEST(ShadowedReceiver, KeepsTheReceiversData)
{
  const LightPosition light{ 0.3, 0.2, 1.0, 0.0 };
  const Mesh first = quadGround(-1.5, 4.0, 5);
  const Mesh second = quadGround(-3.0, 9.0, 4);
  int number = 0;
  for (vtkPolyData* mesh : { first.Get(), second.Get() })
  {
    vtkNew<vtkDoubleArray> height;
    height->SetName("Height");
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double p[3];
      mesh->GetPoint(i, p);
      height->InsertNextValue(2.0 * p[0] - 3.0 * p[1] + p[2]);
    }
    mesh->GetPointData()->AddArray(height);
    vtkNew<vtkIntArray> material;
    material->SetName("Material");
    for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
    {
      material->InsertNextValue(static_cast<int>(100 * number + i));
    }
    mesh->GetCellData()->AddArray(material);
    ++number;
  }
  vtkNew<vtkDoubleArray> alone;
  alone->SetName("Alone");
  alone->SetNumberOfValues(first->GetNumberOfPoints());
  alone->Fill(1.0);
  first->GetPointData()->AddArray(alone);
  vtkNew<vtkDoubleArray> tooShort;
  tooShort->SetName("TooShort");
  tooShort->InsertNextValue(1.0);
  for (vtkPolyData* mesh : { first.Get(), second.Get() })
  {
    mesh->GetPointData()->AddArray(tooShort);
    mesh->GetCellData()->AddArray(tooShort);
  }
  Regions regions({ icosphere(2) }, { first, second }, light);
  vtkPolyData* output = regions.update();
  vtkDataArray* height = output->GetPointData()->GetArray("Height");
  ASSERT_TRUE(height);
  ASSERT_GT(output->GetNumberOfPoints(), first->GetNumberOfPoints() + 20);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    EXPECT_NEAR(height->GetComponent(i, 0), 2.0 * p[0] - 3.0 * p[1] + p[2], 1e-12);
  }
  vtkDataArray* material = output->GetCellData()->GetArray("Material");
  vtkDataArray* receiver = output->GetCellData()->GetArray("Receiver");
  vtkDataArray* cell = output->GetCellData()->GetArray("ReceiverCell");
  ASSERT_TRUE(material);
  std::set<double> seen;
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    EXPECT_EQ(
      material->GetComponent(i, 0), 100 * receiver->GetComponent(i, 0) + cell->GetComponent(i, 0));
    seen.insert(material->GetComponent(i, 0));
  }
  EXPECT_EQ(seen.size(), 25u + 16u);
  EXPECT_FALSE(output->GetPointData()->GetArray("Alone"));
  EXPECT_FALSE(output->GetPointData()->GetArray("TooShort"));
  EXPECT_FALSE(output->GetCellData()->GetArray("TooShort"));
  // Cells are numbered as VTK does, lines before polygons, and bad ones are left out.
  MeshBuilder mixed;
  mixed.append(withoutNormals(ground(-1.5, 4.0)));
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  mixed.addPoint({ 0.0, 0.0, nothing });
  mixed.Cells.insert(mixed.Cells.begin(), { 0, 1, 4 });
  const Mesh withLine = mixed.build();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  withLine->SetLines(lines);
  Regions offset({ icosphere(2) }, { withLine }, light);
  cell = offset.update()->GetCellData()->GetArray("ReceiverCell");
  ASSERT_GT(cell->GetNumberOfTuples(), 2);
  double range[2];
  cell->GetRange(range);
  EXPECT_EQ(range[0], 2.0);
  EXPECT_EQ(range[1], 3.0);
}

TEST(ShadowedReceiver, SameForAllBuildersAndThreads)
{
  Regions regions({ icosphere(3, 7), moved(torus(40, 20), 1.0, { 1.5, 0.2, 1.0 }, 5) },
    { ground(-2.0, 8.0, 60), icosphere(4) }, { 0.3, 0.2, 1.0, 0.0 },
    vtkSmoothLightSilhouette::SMOOTH);
  const std::string usual = vtkSMPTools::GetBackend();
  vtkNew<vtkPolyData> serial;
  ASSERT_TRUE(vtkSMPTools::SetBackend("Sequential"));
  serial->DeepCopy(regions.update());
  EXPECT_GT(serial->GetNumberOfPolys(), 8000);
  EXPECT_GT(regions.area("ShadowedArea", 1), 0.1);
  ASSERT_TRUE(vtkSMPTools::SetBackend("STDThread"));
  vtkSMPTools::Initialize(4);
  for (const int builder : { vtkShadowedReceiver::MORTON, vtkShadowedReceiver::UNSORTED,
         vtkShadowedReceiver::OBJECT_MEDIAN })
  {
    regions.Filter->SetBuilder(builder);
    regions.Filter->Modified();
    vtkPolyData* threaded = regions.update();
    EXPECT_TRUE(sameBytes(serial->GetPoints()->GetData(), threaded->GetPoints()->GetData()));
    EXPECT_TRUE(sameBytes(
      serial->GetPolys()->GetConnectivityArray(), threaded->GetPolys()->GetConnectivityArray()));
    EXPECT_TRUE(
      sameBytes(serial->GetPolys()->GetOffsetsArray(), threaded->GetPolys()->GetOffsetsArray()));
    EXPECT_EQ(differingArray(serial->GetPointData(), threaded->GetPointData()), "");
    EXPECT_EQ(differingArray(serial->GetCellData(), threaded->GetCellData()), "");
    EXPECT_EQ(differingArray(serial->GetFieldData(), threaded->GetFieldData()), "");
  }
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(usual.c_str());
}

TEST(ShadowedReceiver, SameAtAnyScaleAndPlace)
{
  const double light[4] = { 2.0, 3.0, 9.0, 1.0 };
  Regions here({ box(1.0, 0.7, 0.4) }, { ground(-1.5, 8.0, 4) }, { 2.0, 3.0, 9.0, 1.0 });
  const double area = here.area("ShadowedArea");
  for (const double scale : { 1e-9, 1e-3, 1.0, 1e9 })
  {
    for (const double away : { 0.0, 1e3, 1e7 })
    {
      const Vec3 shift{ away * scale, -0.5 * away * scale, 0.25 * away * scale };
      Regions there({ moved(box(1.0, 0.7, 0.4), scale, shift, 3) },
        { moved(ground(-1.5, 8.0, 4), scale, shift, 3) }, movedLight(light, scale, shift, 3));
      // Perimeters of some ten times the scale, at coordinates that were rounded.
      EXPECT_NEAR(there.area("ShadowedArea") / (scale * scale), area,
        100.0 * (tolerance::SamePoint + away * 0x1p-52))
        << scale << ", " << away;
    }
  }
}

TEST(ShadowedReceiver, RefusesWhatIsNoScene)
{
  const LightPosition above{ 0.0, 0.0, 1.0, 0.0 };
  const auto errorOf = [](Regions& regions) {
    EXPECT_EQ(regions.update()->GetNumberOfCells(), 0);
    return regions.Errors->GetErrorMessage();
  };
  Regions on({ triangle() }, { ground(-2.0, 8.0) }, { 0.5, 0.0, 0.0, 1.0 });
  EXPECT_NE(errorOf(on).find("lies on a silhouette"), std::string::npos);
  Regions different({ box(), box() }, { ground(-2.0, 8.0) }, above);
  different.Silhouettes[1]->SetLightPosition(0.0, 1.0, 1.0, 0.0);
  EXPECT_NE(errorOf(different).find("different lights"), std::string::npos);
  Regions noCasters({ box() }, { ground(-2.0, 8.0) }, above);
  noCasters.Filter->SetInputConnection(2, nullptr);
  EXPECT_NE(errorOf(noCasters).find("no casters on port 2"), std::string::npos);
  vtkNew<vtkPolyData> nothing;
  Regions noLight({ nothing }, { ground(-2.0, 8.0) }, above);
  noLight.Silhouettes.clear();
  noLight.Filter->SetInputDataObject(0, nothing);
  noLight.Filter->SetLightPosition(0.0, 0.0, 0.0, 0.0);
  EXPECT_NE(errorOf(noLight).find("is no light"), std::string::npos);
}

// Nothing that casts, nothing that receives, nothing at all.
TEST(ShadowedReceiver, EmptyInputs)
{
  const LightPosition above{ 0.0, 0.0, 1.0, 0.0 };
  vtkNew<vtkPolyData> nothing;
  Regions noReceiver({ box() }, { nothing }, above);
  EXPECT_EQ(noReceiver.update()->GetNumberOfCells(), 0);
  EXPECT_EQ(noReceiver.area("ShadowedArea"), 0.0);
  Regions noCaster({ nothing }, { ground(-2.0, 8.0) }, above);
  EXPECT_EQ(noCaster.area("LitArea"), 256.0);
  EXPECT_EQ(noCaster.update()->GetNumberOfCells(), 2);
  Regions neither({ nothing }, { nothing }, above);
  EXPECT_EQ(neither.update()->GetNumberOfCells(), 0);
  vtkNew<vtkShadowedReceiver> alone;
  alone->SetInputDataObject(0, nothing);
  alone->SetInputDataObject(1, ground(-2.0, 8.0));
  alone->Update();
  EXPECT_EQ(fieldValue(alone->GetOutput(), "LitArea"), 256.0);
  for (const Regions* regions : { &noReceiver, &noCaster, &neither })
  {
    EXPECT_FALSE(regions->Errors->GetError());
  }
}

TEST(ShadowedReceiver, BadPoints)
{
  const LightPosition light{ 0.2, 0.3, 1.0, 0.0 };
  const Mesh caster = withBadPoints(icosphere(2), 5, 3);
  const Mesh receiver = withBadPoints(ground(-2.0, 8.0, 12), 5, 4);
  for (const int kind : AllKinds)
  {
    Regions regions({ caster }, { receiver }, light, kind);
    EXPECT_GT(regions.area("ShadowedArea"), 0.5);
    EXPECT_EQ(nonFiniteNumbers(regions.update()), 0);
  }
}

TEST(ShadowedReceiver, RealMeshOnItself)
{
  const Mesh mesh = standing(cgalMesh("elephant"), 1);
  const LightPosition light{ 0.3, 0.2, 1.0, 0.0 };
  Regions regions({ mesh }, { mesh }, light);
  Random random(6);
  const RegionReport report = checkRegions(regions.update(), { mesh }, { mesh }, light, random, 1);
  expectWhole(report);
  EXPECT_GT(report.Shadowed, 300);
  EXPECT_LT(report.Unclear, report.Looks / 20);
  Regions smooth({ mesh }, { mesh }, light, vtkSmoothLightSilhouette::SMOOTH);
  EXPECT_NEAR(smooth.area("ShadowedArea") / regions.area("ShadowedArea"), 1.0, 0.03);
}

// Against rays by brute force, whatever casts on whatever.
TEST(ShadowedReceiver, RandomScenes)
{
  const std::uint64_t first = fromEnvironment("SMOOTHSHADOW_TEST_SEED", 1);
  const std::uint64_t count = fromEnvironment("SMOOTHSHADOW_TEST_SCENES", 1000);
  std::uint64_t refused = 0;
  std::uint64_t looks = 0;
  std::uint64_t unclear = 0;
  std::uint64_t shadowed = 0;
  for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed)
  {
    const ContourScene scene = randomContourScene(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind);
    Regions regions(scene.Casters, scene.Receivers, scene.Light);
    vtkPolyData* output = regions.update();
    if (regions.Errors->GetError())
    {
      EXPECT_NE(regions.Errors->GetErrorMessage().find("lies on a silhouette"), std::string::npos);
      ++refused;
      continue;
    }
    Random random(seed);
    const RegionReport report =
      checkRegions(output, scene.Receivers, scene.Casters, scene.Light, random, 2);
    expectWhole(report);
    EXPECT_EQ(nonFiniteNumbers(output), 0);
    looks += static_cast<std::uint64_t>(report.Looks);
    unclear += static_cast<std::uint64_t>(report.Unclear);
    shadowed += static_cast<std::uint64_t>(report.Shadowed);
    // Of other kinds the contours decide, but the whole is still that.
    Regions other(
      scene.Casters, scene.Receivers, scene.Light, AllKinds[1 + static_cast<int>(seed % 2)]);
    other.update();
    if (!other.Errors->GetError())
    {
      expectWhole(
        checkRegions(other.update(), scene.Receivers, scene.Casters, scene.Light, random, 0));
    }
  }
  EXPECT_GT(looks, 100 * count);
  EXPECT_GT(shadowed, looks / 10);
  EXPECT_LT(unclear, looks / 5);
  EXPECT_LT(refused, count / 8);
}
