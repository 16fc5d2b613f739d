// Each defect is found, with its exact count, and nothing is found on clean meshes; and what the
// table says of the shadow is true.

#include "ChainChecks.h"
#include "HostileMeshes.h"
#include "Random.h"
#include "RandomMeshes.h"
#include "RealMeshes.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkPoints.h>
#include <vtkShadowMeshCheck.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>
#include <vtkVariant.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

namespace
{
using shadowtest::Mesh;
using shadowtest::MeshBuilder;
using shadowtest::Vec3;

constexpr double Pi = 3.14159265358979323846;

struct Row
{
  vtkIdType Count;
  std::string Meaning;
  std::string Shadow;
  std::string Remedy;
  Vec3 Place;
};

struct Report
{
  std::map<std::string, Row> Rows;
  std::map<std::string, vtkIdType> Fields;

  vtkIdType count(const std::string& defect) const
  {
    const auto found = this->Rows.find(defect);
    return found != this->Rows.end() ? found->second.Count : 0;
  }

  /// All of them.
  std::map<std::string, vtkIdType> counts() const
  {
    std::map<std::string, vtkIdType> counts;
    for (const auto& [defect, row] : this->Rows)
    {
      counts[defect] = row.Count;
    }
    return counts;
  }
};

Report reportOf(vtkShadowMeshCheck* check)
{
  check->Update();
  vtkTable* table = check->GetOutput();
  Report report;
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    const auto value = [&](const char* column) { return table->GetValueByName(i, column); };
    const Row row{ value("Count").ToLongLong(), value("Meaning").ToString(),
      value("Shadow").ToString(), value("Remedy").ToString(),
      { value("X").ToDouble(), value("Y").ToDouble(), value("Z").ToDouble() } };
    EXPECT_TRUE(report.Rows.emplace(value("Defect").ToString(), row).second);
    EXPECT_GT(row.Count, 0);
    EXPECT_EQ(row.Shadow.back(), '.');
  }
  for (const char* name : { "Triangles", "Points", "Parts", "ClosedParts", "TwoSidedTriangles" })
  {
    vtkDataArray* field = table->GetFieldData()->GetArray(name);
    EXPECT_TRUE(field);
    report.Fields[name] = field ? static_cast<vtkIdType>(field->GetComponent(0, 0)) : -1;
  }
  return report;
}

Report reportOf(vtkPolyData* mesh)
{
  vtkNew<vtkShadowMeshCheck> check;
  check->SetInputData(mesh);
  return reportOf(check);
}

using Counts = std::map<std::string, vtkIdType>;

/// What a mesh without normals has beside the rest.
Counts withoutEstimates(Counts counts)
{
  EXPECT_EQ(counts.erase("estimated normals"), 1u);
  counts.erase("averaged normals");
  return counts;
}

/// How edges, by point id, are used: along and against. Cells are triangles.
std::map<std::pair<vtkIdType, vtkIdType>, std::pair<int, int>> edgesOf(const MeshBuilder& mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, std::pair<int, int>> edges;
  for (const auto& cell : mesh.Cells)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const vtkIdType a = cell[k];
      const vtkIdType b = cell[(k + 1) % 3];
      auto& uses = edges[std::minmax(a, b)];
      ++(a < b ? uses.first : uses.second);
    }
  }
  return edges;
}

MeshBuilder opening(vtkPolyData* mesh)
{
  MeshBuilder builder;
  builder.append(mesh);
  return builder;
}

/// Cylinder wall whose last column of points is the first one but for the rounding of sin(2 pi).
Mesh wallWithSeam(int sides, int rows)
{
  MeshBuilder mesh;
  for (int i = 0; i <= sides; ++i)
  {
    const double angle = 2.0 * Pi * i / sides;
    for (int row = 0; row <= rows; ++row)
    {
      const Vec3 normal{ std::cos(angle), std::sin(angle), 0.0 };
      mesh.addPoint({ normal[0], normal[1], 1.0 * row }, normal);
    }
  }
  for (int i = 0; i < sides; ++i)
  {
    for (int row = 0; row < rows; ++row)
    {
      const vtkIdType a = i * (rows + 1) + row;
      mesh.addQuad(a, a + rows + 1, a + rows + 2, a + 1);
    }
  }
  return mesh.build();
}

Mesh inFloat(vtkPolyData* mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->DeepCopy(mesh->GetPoints());
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(mesh);
  copy->SetPoints(points);
  return copy;
}

Mesh turnedOver(vtkPolyData* mesh)
{
  MeshBuilder builder = opening(mesh);
  for (auto& cell : builder.Cells)
  {
    std::swap(cell[0], cell[1]);
  }
  return builder.build();
}
}

TEST(ShadowMeshCheck, CleanMeshesHaveNoDefect)
{
  const std::vector<std::pair<const char*, Mesh>> meshes{ { "sphere", shadowtest::sphere(12, 24) },
    { "icosphere", shadowtest::icosphere(3, 5) }, { "torus", shadowtest::torus(40, 16) },
    { "cylinder", shadowtest::cylinder(24, 3) }, { "box", shadowtest::box() },
    { "star", shadowtest::starShaped(3, 7) }, { "far", shadowtest::moved(
                                                         shadowtest::torus(40, 16), 1e-3,
                                                         { 1e6, 0.0, -1e6 }, 3) } };
  for (const auto& [name, mesh] : meshes)
  {
    SCOPED_TRACE(name);
    const Report report = reportOf(mesh);
    EXPECT_EQ(report.counts(), Counts());
    EXPECT_EQ(report.Fields.at("Triangles"), mesh->GetNumberOfPolys());
    EXPECT_EQ(report.Fields.at("Parts"), 1);
    EXPECT_EQ(report.Fields.at("ClosedParts"), 1);
    EXPECT_EQ(report.Fields.at("TwoSidedTriangles"), 0);
  }
  EXPECT_EQ(reportOf(shadowtest::box()).Fields.at("Points"), 8);
  EXPECT_EQ(withoutEstimates(reportOf(shadowtest::quadBox()).counts()), Counts());
  EXPECT_EQ(reportOf(shadowtest::quadBox()).Fields.at("Triangles"), 12);
}

TEST(ShadowMeshCheck, FinsAreNonManifold)
{
  for (const int faces : { 3, 4, 5 })
  {
    EXPECT_EQ(reportOf(shadowtest::fin(faces)).counts(),
      (Counts{ { "non-manifold edges", 1 }, { "border edges", 2 * faces } }));
    const Report box = reportOf(shadowtest::finnedBox(faces));
    EXPECT_EQ(withoutEstimates(box.counts()),
      (Counts{ { "non-manifold edges", 1 }, { "border edges", 2 * faces } }));
    EXPECT_EQ(box.Fields.at("TwoSidedTriangles"), 12 + faces);
    EXPECT_EQ(box.Rows.at("non-manifold edges").Place, (Vec3{ 1.0, 1.0, 0.0 }));
    EXPECT_EQ(box.Rows.at("non-manifold edges").Meaning, "exact");
  }
}

TEST(ShadowMeshCheck, AMoebiusStripIsInconsistentAtItsSeam)
{
  EXPECT_EQ(withoutEstimates(reportOf(shadowtest::moebiusStrip(16)).counts()),
    (Counts{ { "border edges", 32 }, { "inconsistent edges", 1 } }));
}

TEST(ShadowMeshCheck, SliversAndNoArea)
{
  EXPECT_EQ(reportOf(shadowtest::sliverBox(1e-12)).counts(), (Counts{ { "slivers", 8 } }));
  // Heights 1e-6^(1 - i / 8): the first one is a triangle of its own, the others lie between two.
  const Counts counts = reportOf(shadowtest::slivers(8, 1e-6)).counts();
  EXPECT_EQ(counts.count("slivers"), 1u);
  EXPECT_EQ(counts.count("zero-area triangles"), 0u);

  const Mesh spoilt = shadowtest::degenerated(shadowtest::icosphere(3), 0.1, 4);
  vtkIdType cornerTwice = 0;
  vtkIdType onALine = 0;
  const MeshBuilder builder = opening(spoilt);
  for (const auto& cell : builder.Cells)
  {
    cornerTwice += cell[0] == cell[1];
    onALine += cell[2] >= 642;
  }
  ASSERT_GT(cornerTwice, 30);
  ASSERT_GT(onALine, 30);
  const Report report = reportOf(spoilt);
  EXPECT_EQ(report.count("degenerate cells"), cornerTwice);
  EXPECT_EQ(report.count("zero-area triangles"), onALine);
  EXPECT_EQ(report.count("slivers"), 0);
}

TEST(ShadowMeshCheck, TJunctionsAndNearSeams)
{
  const Report junction = reportOf(shadowtest::tJunction());
  EXPECT_EQ(junction.count("T-junctions"), 1);
  EXPECT_EQ(junction.Rows.at("T-junctions").Place, (Vec3{ 1.0, 1.0, 0.0 }));
  EXPECT_EQ(junction.Rows.at("T-junctions").Meaning, "well defined");
  EXPECT_EQ(junction.count("near seams"), 0);

  const Mesh wall = wallWithSeam(24, 3);
  const Report open = reportOf(wall);
  EXPECT_EQ(open.counts(), (Counts{ { "near seams", 8 }, { "border edges", 54 } }));
  // What the remedy says: within the distance that the sentence names, which is all of the reach.
  const std::string& sentence = open.Rows.at("near seams").Shadow;
  const std::string before = "Border points within ";
  ASSERT_EQ(sentence.rfind(before, 0), 0u) << sentence;
  const double distance = std::stod(sentence.substr(before.size()));
  EXPECT_GE(distance, 1e-6 * wall->GetLength());
  EXPECT_LT(distance, 1.01e-6 * wall->GetLength());
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(wall);
  clean->ToleranceIsAbsoluteOn();
  clean->SetAbsoluteTolerance(distance);
  clean->Update();
  EXPECT_EQ(reportOf(clean->GetOutput()).counts(), (Counts{ { "border edges", 48 } }));
  // Floats of this size have steps of 7.6e-6, more than the share of the wall's size.
  const Mesh far = inFloat(shadowtest::moved(wall, 1.0, { 100.0, 100.0, 0.0 }));
  EXPECT_EQ(reportOf(far).counts(), (Counts{ { "border edges", 48 } }));
  for (vtkIdType id = far->GetNumberOfPoints() - 4; id < far->GetNumberOfPoints(); ++id)
  {
    double p[3];
    far->GetPoint(id, p);
    far->GetPoints()->SetPoint(id, p[0], std::nextafter(static_cast<float>(p[1]), 0.0f), p[2]);
  }
  EXPECT_EQ(reportOf(far).counts(), (Counts{ { "near seams", 8 }, { "border edges", 54 } }));
}

TEST(ShadowMeshCheck, EdgesOfOpenedAndMisorientedMeshes)
{
  const Mesh sphere = shadowtest::icosphere(3);
  for (const bool opened : { true, false })
  {
    const Mesh spoilt = opened ? shadowtest::opened(sphere, 0.2, 9)
                               : shadowtest::misoriented(sphere, 0.2, 9);
    vtkIdType borders = 0;
    vtkIdType inconsistent = 0;
    for (const auto& [edge, uses] : edgesOf(opening(spoilt)))
    {
      borders += uses.first + uses.second == 1;
      inconsistent += uses.first == 2 || uses.second == 2;
    }
    ASSERT_GT(borders + inconsistent, 300);
    const Report report = reportOf(spoilt);
    EXPECT_EQ(report.count("border edges"), borders);
    EXPECT_EQ(report.count("inconsistent edges"), inconsistent);
    EXPECT_GE(report.Fields.at("TwoSidedTriangles"), spoilt->GetNumberOfPolys() - 10);
    EXPECT_EQ(report.count("turned normals") > 0, !opened);
    EXPECT_EQ(report.Rows.size(), opened ? 1u : 2u);
  }
}

TEST(ShadowMeshCheck, DuplicatesAndRepeatedPoints)
{
  const Mesh sphere = shadowtest::icosphere(3);
  const Mesh spoilt = shadowtest::duplicated(sphere, 0.3, 2);
  const Report report = reportOf(spoilt);
  EXPECT_GT(spoilt->GetNumberOfPolys(), sphere->GetNumberOfPolys() + 100);
  EXPECT_EQ(
    report.count("duplicate triangles"), spoilt->GetNumberOfPolys() - sphere->GetNumberOfPolys());
  EXPECT_GT(spoilt->GetNumberOfPoints(), sphere->GetNumberOfPoints() + 100);
  EXPECT_EQ(
    report.count("repeated points"), spoilt->GetNumberOfPoints() - sphere->GetNumberOfPoints());
  EXPECT_EQ(report.Fields.at("Points"), sphere->GetNumberOfPoints());

  vtkNew<vtkShadowMeshCheck> apart;
  apart->SetInputData(spoilt);
  apart->MergePointsOff();
  const Report unwelded = reportOf(apart);
  EXPECT_EQ(unwelded.count("repeated points"), 0);
  EXPECT_EQ(unwelded.Fields.at("Points"), spoilt->GetNumberOfPoints());
  EXPECT_LT(unwelded.count("duplicate triangles"), report.count("duplicate triangles"));
}

TEST(ShadowMeshCheck, WhatIsLeftOutIsWarnedOf)
{
  const Mesh spoilt = shadowtest::withBadPoints(shadowtest::icosphere(3), 12, 3);
  vtkIdType touched = 0;
  const MeshBuilder builder = opening(spoilt);
  for (const auto& cell : builder.Cells)
  {
    bool finite = true;
    for (const vtkIdType id : cell)
    {
      for (const double c : builder.Points[static_cast<std::size_t>(id)])
      {
        finite = finite && std::isfinite(c);
      }
    }
    touched += !finite;
  }
  ASSERT_GT(touched, 50);
  const Report report = reportOf(spoilt);
  EXPECT_EQ(report.count("non-finite cells"), touched);
  const Row& row = report.Rows.at("non-finite cells");
  EXPECT_EQ(row.Meaning, "warned");
  EXPECT_TRUE(std::isfinite(row.Place[0] + row.Place[1] + row.Place[2]));
  EXPECT_EQ(report.Fields.at("Triangles"), spoilt->GetNumberOfPolys() - touched);

  vtkNew<vtkPolyData> empty;
  const Report nothing = reportOf(empty);
  EXPECT_EQ(nothing.counts(), (Counts{ { "no triangles", 1 } }));
  EXPECT_EQ(nothing.Rows.at("no triangles").Meaning, "warned");
  EXPECT_TRUE(std::isnan(nothing.Rows.at("no triangles").Place[0]));
  EXPECT_EQ(nothing.Fields.at("Parts"), 0);
}

TEST(ShadowMeshCheck, GravestFirst)
{
  vtkNew<vtkShadowMeshCheck> check;
  check->SetInputData(shadowtest::withBadPoints(
    shadowtest::withoutNormals(shadowtest::opened(shadowtest::icosphere(2), 0.2, 1)), 3, 1));
  check->Update();
  vtkTable* table = check->GetOutput();
  const std::vector<std::string> order{ "warned", "well defined", "exact" };
  std::set<std::ptrdiff_t> seen;
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    const auto place =
      std::find(order.begin(), order.end(), table->GetValueByName(i, "Meaning").ToString()) -
      order.begin();
    EXPECT_TRUE(seen.empty() || place >= *seen.rbegin());
    seen.insert(place);
  }
  EXPECT_EQ(seen, (std::set<std::ptrdiff_t>{ 0, 1, 2 }));
}

TEST(ShadowMeshCheck, CoarseCoordinatesNameTheirStep)
{
  const Mesh sphere = shadowtest::icosphere(3);
  EXPECT_EQ(reportOf(inFloat(sphere)).counts(), Counts());
  // Between 512 and 1024 floats have steps of 2^-14 = 6.1e-5; the sphere's diagonal is 3.5.
  const Mesh far = shadowtest::moved(sphere, 1.0, { 1000.0, 0.0, 0.0 });
  EXPECT_EQ(reportOf(far).counts(), Counts());
  const Report report = reportOf(inFloat(far));
  EXPECT_EQ(report.count("coarse coordinates"), 642);
  const Row& row = report.Rows.at("coarse coordinates");
  EXPECT_EQ(row.Meaning, "warned");
  EXPECT_NE(row.Shadow.find("steps of 6.1e-05, 1.76e-05 of"), std::string::npos) << row.Shadow;
  EXPECT_GT(reportOf(shadowtest::moved(sphere, 1.0, { 1e13, 0.0, 0.0 })).count(
    "coarse coordinates"), 600);
}

// The largest one has no next one.
TEST(ShadowMeshCheck, StepsOfTheLargestFloatsAreFinite)
{
  for (const float largest : { 2e38f, std::numeric_limits<float>::max() })
  {
    MeshBuilder mesh;
    mesh.addPoint({ largest, 0.0, 0.0 });
    mesh.addPoint({ largest, 1e33, 0.0 });
    mesh.addPoint({ largest, 0.0, 1e33 });
    mesh.addTriangle(0, 1, 2);
    const Report report = reportOf(inFloat(mesh.build()));
    EXPECT_EQ(report.count("extreme coordinates"), 0);
    ASSERT_EQ(report.count("coarse coordinates"), 3);
    // 2^104, of the square's diagonal.
    const std::string& sentence = report.Rows.at("coarse coordinates").Shadow;
    EXPECT_NE(sentence.find("steps of 2.03e+31, 0.0143 of"), std::string::npos) << sentence;
  }
}

// Up to the sizes that are warned of, a mesh of another size by a power of two has the same shadow
// of that size, for no product leaves the range of doubles.
TEST(ShadowMeshCheck, ExtremeCoordinatesAreThoseThatCastOtherShadows)
{
  const Mesh sphere = shadowtest::sphere(20, 48);
  const std::vector<Mesh> meshes{ sphere, shadowtest::withoutNormals(shadowtest::starShaped(3, 7)),
    shadowtest::opened(shadowtest::icosphere(3), 0.2, 9), shadowtest::weldedBox() };
  for (const double size : { 0x1p-167, 0x1p165 }) // 5e-51 and 5e49, where diagonals are 2 and more
  {
    SCOPED_TRACE(size);
    for (const Mesh& mesh : meshes)
    {
      const Mesh same = shadowtest::moved(mesh, 1.0, { 0.0, 0.0, 0.0 });
      const Mesh scaled = shadowtest::moved(mesh, size, { 0.0, 0.0, 0.0 });
      EXPECT_EQ(reportOf(scaled).counts(), reportOf(same).counts());
      for (const int kind : shadowtest::AllKinds)
      {
        for (const double w : { 0.0, 1.0 })
        {
          const double unit = w == 0.0 ? 1.0 : size;
          shadowtest::ShadowPipeline one(same, { 1.5, 2.5, 3.7, w }, kind);
          shadowtest::ShadowPipeline other(
            scaled, { 1.5 * unit, 2.5 * unit, 3.7 * unit, w }, kind);
          ASSERT_GT(one.silhouette()->GetNumberOfPoints(), 3);
          ASSERT_EQ(
            one.silhouette()->GetNumberOfPoints(), other.silhouette()->GetNumberOfPoints());
          EXPECT_EQ(one.volume()->GetNumberOfCells(), other.volume()->GetNumberOfCells());
          for (vtkIdType i = 0; i < one.silhouette()->GetNumberOfPoints(); ++i)
          {
            for (int k = 0; k < 3; ++k)
            {
              EXPECT_NEAR(one.silhouette()->GetPoint(i)[k],
                other.silhouette()->GetPoint(i)[k] / size, shadowtest::tolerance::SamePoint);
            }
          }
        }
      }
    }
  }
  for (const double size : { 1e-170, 1e-80, 1e-51, 1e51, 1e80, 1e155, 1e200 })
  {
    SCOPED_TRACE(size);
    const Report report = reportOf(shadowtest::moved(sphere, size, { 0.0, 0.0, 0.0 }));
    EXPECT_GT(report.count("extreme coordinates"), 500);
    EXPECT_EQ(report.Rows.at("extreme coordinates").Meaning, "warned");
    EXPECT_EQ(report.count("zero-area triangles"), 0);
    EXPECT_EQ(report.count("coarse coordinates"), 0);
  }
  // One vertex is enough, and a mesh that has no size is not a small one.
  MeshBuilder one = opening(shadowtest::weldedBox());
  one.Points[3][0] = 1e51;
  EXPECT_EQ(reportOf(one.build()).count("extreme coordinates"), 1);
  MeshBuilder point;
  for (int k = 0; k < 3; ++k)
  {
    point.addPoint({ 1.0, 2.0, 3.0 });
  }
  point.addTriangle(0, 1, 2);
  vtkNew<vtkShadowMeshCheck> apart;
  apart->SetInputData(point.build());
  apart->MergePointsOff();
  const Report none = reportOf(apart);
  EXPECT_EQ(none.count("zero-area triangles"), 1);
  EXPECT_EQ(none.count("extreme coordinates") + none.count("coarse coordinates"), 0);
}

TEST(ShadowMeshCheck, CellsAndPointsThatCastNothing)
{
  MeshBuilder mesh = opening(shadowtest::quadBox());
  mesh.addPoint({ 7.0, 8.0, 9.0 });
  mesh.addPoint({ 3.0, 0.0, 0.0 });
  mesh.addPoint({ 4.0, 0.0, 0.0 });
  // A bow tie, which ear cutting gives up on, and a cell of two points.
  const vtkIdType first = mesh.addPoint({ 10.0, 0.0, 0.0 });
  mesh.addPoint({ 11.0, 1.0, 0.0 });
  mesh.addPoint({ 11.0, 0.0, 0.0 });
  mesh.addPoint({ 10.0, 1.0, 0.0 });
  mesh.addPolygon({ first, first + 1, first + 2, first + 3 });
  mesh.addPolygon({ first, first + 1 });
  const Mesh surface = mesh.build();
  const vtkIdType line[2] = { 9, 10 };
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(2, line);
  surface->SetLines(lines);
  const Report report = reportOf(surface);
  EXPECT_EQ(report.count("lines and vertices"), 1);
  EXPECT_EQ(report.Rows.at("lines and vertices").Place, (Vec3{ 3.0, 0.0, 0.0 }));
  // Of a line whose first point does not exist, the next one is its place.
  const vtkIdType broken[2] = { 77, 8 };
  lines->InsertNextCell(2, broken);
  surface->Modified();
  const Report more = reportOf(surface);
  EXPECT_EQ(more.count("lines and vertices"), 2);
  EXPECT_EQ(more.Rows.at("lines and vertices").Place, (Vec3{ 3.0, 0.0, 0.0 }));
  EXPECT_EQ(more.count("unused points"), 0);
  EXPECT_EQ(report.count("unused points"), 1);
  EXPECT_EQ(report.Rows.at("unused points").Place, (Vec3{ 7.0, 8.0, 9.0 }));
  EXPECT_EQ(report.count("crossed polygons"), 1);
  EXPECT_EQ(report.count("degenerate cells"), 1);
}

TEST(ShadowMeshCheck, NormalsOfAllKinds)
{
  const Mesh sphere = shadowtest::icosphere(3);
  const Report none = reportOf(shadowtest::withoutNormals(sphere));
  EXPECT_EQ(none.counts(), (Counts{ { "estimated normals", 642 } }));
  const Report box = reportOf(shadowtest::weldedBox());
  EXPECT_EQ(box.counts(), (Counts{ { "estimated normals", 24 }, { "averaged normals", 24 } }));
  vtkNew<vtkShadowMeshCheck> round;
  round->SetInputData(shadowtest::weldedBox());
  round->SetFeatureAngle(100.0);
  EXPECT_EQ(reportOf(round).count("estimated normals"), 8);

  MeshBuilder broken = opening(sphere);
  broken.Normals[5] = { 0.0, 0.0, 0.0 };
  broken.Normals[77] = { std::nan(""), 0.0, 1.0 };
  EXPECT_EQ(reportOf(broken.build()).counts(), (Counts{ { "unusable normals", 2 } }));

  EXPECT_EQ(reportOf(turnedOver(sphere)).counts(),
    (Counts{ { "inside-out parts", 1 }, { "turned normals", 1280 } }));
}

TEST(ShadowMeshCheck, PiercedTrianglesAreLookedForOrNot)
{
  const Mesh boxes = shadowtest::merged(
    { shadowtest::box(), shadowtest::moved(shadowtest::box(), 1.0, { 0.9, 0.8, 0.7 }, 3) });
  vtkNew<vtkShadowMeshCheck> check;
  check->SetInputData(boxes);
  const Report report = reportOf(check);
  EXPECT_GE(report.count("pierced triangles"), 6);
  EXPECT_EQ(report.Rows.size(), 1u);
  EXPECT_EQ(report.Fields.at("ClosedParts"), 2);
  EXPECT_EQ(report.Rows.at("pierced triangles").Meaning, "well defined");
  MeshBuilder crossing;
  for (const Vec3& p : { Vec3{ -1.0, -1.0, 0.0 }, Vec3{ 1.0, -1.0, 0.0 }, Vec3{ 0.0, 1.0, 0.0 },
         Vec3{ 0.0, 0.0, -1.0 }, Vec3{ 0.0, 0.0, 1.0 }, Vec3{ 9.0, 0.0, 0.0 } })
  {
    crossing.addPoint(p);
  }
  crossing.addTriangle(0, 1, 2);
  crossing.addTriangle(3, 4, 5);
  const Report open = reportOf(crossing.build());
  EXPECT_EQ(open.Rows.at("pierced triangles").Meaning, "exact");
  check->CheckIntersectionsOff();
  EXPECT_EQ(reportOf(check).counts(), Counts());
  // As exact predicates count them (with CGAL, of the pairs that it finds).
  EXPECT_EQ(reportOf(shadowtest::cgalMesh("cow")).count("pierced triangles"), 89);
  EXPECT_EQ(reportOf(shadowtest::cgalMesh("camel")).count("pierced triangles"), 20);
}

namespace
{
double windingOfShadow(vtkPolyData* mesh, const shadowtest::LightPosition& light, int kind,
  const double point[3])
{
  shadowtest::ShadowPipeline pipeline(mesh, light, kind);
  return shadowtest::windingNumber(pipeline.volume(), point);
}
}

// With the light outside of closed parts, the shadow is exact outside of them, and what lies inside
// may be lit: said of pierced triangles.
TEST(ShadowMeshCheck, PiercingPartsCastExactlyOutside)
{
  // A box whose right side is upside down crosses itself, and is inside out beyond the crossing.
  MeshBuilder crossed = opening(shadowtest::weldedBox(2.0, 1.0, 1.0));
  for (Vec3& p : crossed.Points)
  {
    p = p[0] > 0.0 ? Vec3{ p[0], -0.7 * p[1], 0.8 * p[2] } : p;
  }
  const std::vector<Mesh> meshes{ crossed.build(),
    shadowtest::merged({ shadowtest::weldedBox(), shadowtest::moved(shadowtest::weldedBox(), 1.0,
                                                    { 0.9, 0.8, 0.7 }, 3) }) };
  shadowtest::Random random(21);
  int inShadow = 0;
  int lit = 0;
  int litInside = 0;
  int insideOut = 0;
  for (const Mesh& mesh : meshes)
  {
    const Report report = reportOf(mesh);
    EXPECT_GE(report.count("pierced triangles"), 4);
    EXPECT_EQ(report.Fields.at("TwoSidedTriangles"), 0);
    for (int sample = 0; sample < 300; ++sample)
    {
      shadowtest::LightPosition light{ 0.0, 0.0, 0.0, sample % 2 == 0 ? 0.0 : 1.0 };
      random.direction(light.data());
      const double distance = random.uniform(4.0, 9.0);
      for (int i = 0; i < 3; ++i)
      {
        light[static_cast<std::size_t>(i)] *= distance;
      }
      double point[3];
      for (double& c : point)
      {
        c = random.uniform(-3.0, 3.0);
      }
      const shadowtest::Blockers blockers =
        shadowtest::blockersTowards(mesh, point, light.data());
      if (blockers.Margin < shadowtest::tolerance::TooClose)
      {
        continue;
      }
      const double winding =
        windingOfShadow(mesh, light, vtkSmoothLightSilhouette::DISCRETE, point);
      const bool isDark = std::fabs(winding) > 0.5;
      const double around = shadowtest::windingNumber(mesh, point);
      insideOut += around < -0.5;
      if (std::fabs(around) < 0.5)
      {
        EXPECT_EQ(isDark, blockers.Count > 0);
        ++(isDark ? inShadow : lit);
      }
      else
      {
        litInside += around > 0.5 && !isDark;
      }
    }
  }
  EXPECT_GT(inShadow, 30);
  EXPECT_GT(lit, 100);
  EXPECT_GT(litInside, 0);
  EXPECT_GT(insideOut, 0);
}

// Said of turned normals, and of inside-out and inconsistent meshes.
TEST(ShadowMeshCheck, TurnedNormalsCastTheSameShadow)
{
  const Mesh sphere = shadowtest::icosphere(3);
  const std::vector<Mesh> spoilt{ turnedOver(sphere), shadowtest::misoriented(sphere, 0.3, 8) };
  const shadowtest::LightPosition light{ 2.0, 3.0, 5.0, 1.0 };
  shadowtest::Random random(5);
  int inShadow = 0;
  for (const Mesh& mesh : spoilt)
  {
    EXPECT_GT(reportOf(mesh).count("turned normals"), 300);
    for (const int kind : shadowtest::AllKinds)
    {
      for (int sample = 0; sample < 40; ++sample)
      {
        const double point[3] = { random.uniform(-4.0, 1.0), random.uniform(-4.0, 1.0),
          random.uniform(-4.0, -1.1) };
        const bool isDark = std::fabs(windingOfShadow(sphere, light, kind, point)) > 0.5;
        EXPECT_EQ(std::fabs(windingOfShadow(mesh, light, kind, point)) > 0.5, isDark);
        inShadow += isDark;
      }
    }
  }
  EXPECT_GT(inShadow, 30);
}

// What the silhouette says of any mesh, the table says too.
TEST(ShadowMeshCheck, AgreesWithTheSilhouettesDiagnosis)
{
  const std::map<std::string, const char*> fields{ { "border edges", "BoundaryEdges" },
    { "non-manifold edges", "NonManifoldEdges" }, { "inconsistent edges", "InconsistentEdges" },
    { "degenerate cells", "DegenerateCells" }, { "non-finite cells", "NonFiniteCells" },
    { "estimated normals", "EstimatedNormals" }, { "averaged normals", "FallbackNormals" } };
  std::map<std::string, vtkIdType> totals;
  for (std::uint64_t seed = 1; seed <= 300 && !HasFailure(); ++seed)
  {
    shadowtest::RandomMesh scene = shadowtest::randomMesh(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind);
    if (seed % 7 == 0 && scene.Surface->GetNumberOfPoints() > 0)
    {
      scene.Surface = shadowtest::withBadPoints(scene.Surface, 1, seed);
    }
    const Report report = reportOf(scene.Surface);
    shadowtest::ShadowPipeline pipeline(
      scene.Surface, scene.Light, vtkSmoothLightSilhouette::DISCRETE);
    for (const auto& [defect, field] : fields)
    {
      EXPECT_EQ(report.count(defect), shadowtest::fieldValue(pipeline.silhouette(), field));
      totals[defect] += report.count(defect);
    }
  }
  EXPECT_EQ(totals.size(), fields.size());
  for (const auto& [defect, total] : totals)
  {
    EXPECT_GT(total, 50) << defect;
  }
}

TEST(ShadowMeshCheck, AnAngleThatIsNoNumberIsAnError)
{
  vtkNew<vtkShadowMeshCheck> check;
  vtkNew<vtkTest::ErrorObserver> observer;
  check->AddObserver(vtkCommand::ErrorEvent, observer);
  check->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  check->SetInputData(shadowtest::box());
  check->SetFeatureAngle(std::nan(""));
  check->Update();
  EXPECT_TRUE(observer->GetError());
  EXPECT_NE(observer->GetErrorMessage().find("FeatureAngle"), std::string::npos);
  EXPECT_EQ(check->GetOutput()->GetNumberOfRows(), 0);
}
