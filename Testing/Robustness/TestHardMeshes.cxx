// Meshes that are not what a caster should be, each with its exact shadow.

#include "ChainChecks.h"
#include "ExactShadow.h"
#include "HardScene.h"
#include "HostileMeshes.h"
#include "SegmentChain.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStripper.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace shadowtest;

/// From above in no special direction; all meshes below are about (0, 0, 1) and of about size 1.
const LightPosition Lights[] = { { 1.1, 0.7, 4.3, 1.0 }, { 0.3, -0.2, 1.0, 0.0 } };

Mesh overTheGround(vtkPolyData* mesh, double scale = 0.6)
{
  return moved(mesh, scale, { 0.0, 0.0, 1.2 });
}

struct Defects
{
  double Degenerate = 0.0;
  double NonFinite = 0.0;
  double Boundary = 0.0;
  double NonManifold = 0.0;
  double Inconsistent = 0.0;
};

void expectDefects(vtkPolyData* mesh, const Defects& expected)
{
  for (const int kind : AllKinds)
  {
    ShadowPipeline pipeline(mesh, Lights[0], kind);
    vtkPolyData* silhouette = pipeline.silhouette();
    EXPECT_EQ(fieldValue(silhouette, "DegenerateCells"), expected.Degenerate);
    EXPECT_EQ(fieldValue(silhouette, "NonFiniteCells"), expected.NonFinite);
    EXPECT_EQ(fieldValue(silhouette, "BoundaryEdges"), expected.Boundary);
    EXPECT_EQ(fieldValue(silhouette, "NonManifoldEdges"), expected.NonManifold);
    EXPECT_EQ(fieldValue(silhouette, "InconsistentEdges"), expected.Inconsistent);
  }
}

struct Found
{
  int GreatestMultiplicity = 0; ///< of the silhouettes' loops
  int Deepest = 0;              ///< the greatest winding around a point
};

/// All checks that hold of any mesh; it casts something from all lights, and not all around.
Found expectExactShadow(vtkPolyData* mesh, const CastingParts& parts, int samples = 300)
{
  Found found;
  for (const LightPosition& light : Lights)
  {
    SCOPED_TRACE(light[3] == 0.0 ? "directional" : "point");
    const ChainTotals chains = expectClosedChains(mesh, light);
    EXPECT_GT(chains.Segments, 3);
    EXPECT_GT(chains.Triangles, 3);
    EXPECT_EQ(chains.ZeroNormals, 0);
    const PointTotals points = expectExactWinding(mesh, light, parts, samples);
    EXPECT_GT(points.InShadow, 4);
    EXPECT_GT(points.Lit, 20);
    found.GreatestMultiplicity = std::max(found.GreatestMultiplicity, chains.GreatestMultiplicity);
    found.Deepest = std::max(found.Deepest, points.Deepest);
  }
  return found;
}

void expectMasks(const std::vector<HardCaster>& casters)
{
  for (const LightPosition& light : Lights)
  {
    SCOPED_TRACE(light[3] == 0.0 ? "directional" : "point");
    expectCastMask(casters, light);
  }
}

void expectNothingCast(vtkPolyData* mesh)
{
  for (const LightPosition& light : Lights)
  {
    const ChainTotals totals = expectClosedChains(mesh, light);
    EXPECT_EQ(totals.Segments, 0);
    EXPECT_EQ(totals.Triangles, 0);
  }
}

Mesh closedBall()
{
  return sphere(8, 14);
}

/// The unit sphere's half below z = 0: open upwards and with a contour for oblique lights.
Mesh bowl()
{
  MeshBuilder ball;
  ball.append(closedBall());
  MeshBuilder half = ball;
  half.Cells.clear();
  for (const auto& cell : ball.Cells)
  {
    const bool low = std::all_of(cell.begin(), cell.end(),
      [&](vtkIdType id) { return ball.Points[static_cast<std::size_t>(id)][2] < 0.1; });
    if (low)
    {
      half.Cells.push_back(cell);
    }
  }
  return half.build();
}

MeshBuilder opening(vtkPolyData* mesh)
{
  MeshBuilder builder;
  builder.append(mesh);
  return builder;
}

/// The cells whose points are all finite, and no other points.
Mesh finiteCells(vtkPolyData* mesh)
{
  const MeshBuilder builder = opening(mesh);
  const auto isFinite = [&](vtkIdType id) {
    const Vec3& p = builder.Points[static_cast<std::size_t>(id)];
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  };
  MeshBuilder kept;
  std::map<vtkIdType, vtkIdType> ids;
  for (std::vector<vtkIdType> cell : builder.Cells)
  {
    if (std::all_of(cell.begin(), cell.end(), isFinite))
    {
      for (vtkIdType& id : cell)
      {
        const auto known = ids.emplace(id, kept.pointCount());
        if (known.second)
        {
          kept.addPoint(builder.Points[static_cast<std::size_t>(id)]);
        }
        id = known.first->second;
      }
      kept.addPolygon(cell);
    }
  }
  return kept.build();
}

/// How many cells are at each edge of a mesh that shares its points.
std::map<std::pair<vtkIdType, vtkIdType>, int> facesAtEdges(vtkPolyData* mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> faces;
  for (const auto& cell : opening(mesh).Cells)
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      ++faces[std::minmax(cell[i], cell[(i + 1) % cell.size()])];
    }
  }
  return faces;
}

double countEdges(vtkPolyData* mesh, int faces)
{
  double count = 0.0;
  for (const auto& edge : facesAtEdges(mesh))
  {
    count += edge.second == faces;
  }
  return count;
}

int partOf(vtkPolyData* volume, vtkIdType cell)
{
  return static_cast<int>(volume->GetCellData()->GetArray("Part")->GetComponent(cell, 0));
}

vtkIdType countPart(vtkPolyData* volume, int part)
{
  vtkIdType count = 0;
  for (vtkIdType cell = 0; cell < volume->GetNumberOfCells(); ++cell)
  {
    count += partOf(volume, cell) == part;
  }
  return count;
}

using Segment = std::pair<Vec3, Vec3>; // its ends in ascending order

/// How often a silhouette runs along each segment, in all of its loops.
std::map<Segment, int> countSegments(vtkPolyData* silhouette)
{
  std::map<Segment, int> counted;
  for (const DirectedSegment& segment : chainOf(silhouette).Segments)
  {
    counted[std::minmax(segment.From, segment.To)] += segment.Multiplicity;
  }
  return counted;
}

/// The multiplicities that the loops of a silhouette have.
std::set<int> multiplicities(vtkPolyData* silhouette)
{
  std::set<int> found;
  vtkDataArray* array = silhouette->GetCellData()->GetArray("Multiplicity");
  for (vtkIdType loop = 0; loop < array->GetNumberOfTuples(); ++loop)
  {
    found.insert(static_cast<int>(array->GetComponent(loop, 0)));
  }
  return found;
}

/// A torus of any shape: shape(u, v) for angles along and across it. Wound outwards if u, v and the
/// outside are right-handed.
template <class Shape>
Mesh closedTube(int along, int across, const Shape& shape)
{
  const double turn = 2.0 * std::acos(-1.0);
  MeshBuilder mesh;
  for (int i = 0; i < along; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      mesh.addPoint(shape(turn * i / along, turn * (j + 0.25) / across));
    }
  }
  const auto id = [&](int i, int j) -> vtkIdType { return i % along * across + j % across; };
  for (int i = 0; i < along; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      mesh.addQuad(id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1));
    }
  }
  return mesh.build();
}

void expectSameSilhouettes(vtkPolyData* expected, vtkPolyData* actual)
{
  const double tolerance = tolerance::SamePoint * expected->GetLength();
  for (const LightPosition& light : Lights)
  {
    for (const int kind : AllKinds)
    {
      ShadowPipeline first(expected, light, kind);
      ShadowPipeline second(actual, light, kind);
      const ChainDifference difference =
        compareChains(chainOf(first.silhouette()), chainOf(second.silhouette()), tolerance);
      EXPECT_TRUE(difference.none()) << "kind " << kind << ": " << difference.Message;
      EXPECT_GT(difference.Expected, 3u);
    }
  }
}
}

TEST(HardMeshes, Empty)
{
  vtkNew<vtkPolyData> nothing;
  MeshBuilder pointsOnly;
  pointsOnly.addPoint({ 0.0, 0.0, 1.0 });
  pointsOnly.addPoint({ 1.0, 0.0, 1.0 });
  const Mesh linesOnly = pointsOnly.build();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  linesOnly->SetLines(lines);
  for (const Mesh& mesh : { Mesh(nothing), pointsOnly.build(), linesOnly })
  {
    expectNothingCast(mesh);
    expectDefects(mesh, {});
    // Others beside it cast as ever.
    const Mesh ball = overTheGround(closedBall());
    expectMasks({ { mesh }, { ball } });
  }
}

TEST(HardMeshes, OneTriangle)
{
  const Mesh front = overTheGround(triangle(), 1.5);
  MeshBuilder turned = opening(front);
  std::swap(turned.Cells[0][1], turned.Cells[0][2]);
  for (const Mesh& mesh : { front, turned.build() })
  {
    const Found found = expectExactShadow(mesh, { nullptr, mesh });
    EXPECT_EQ(found.GreatestMultiplicity, 1);
    EXPECT_EQ(found.Deepest, 1);
    expectDefects(mesh, { 0.0, 0.0, 3.0, 0.0, 0.0 });
    expectMasks({ { mesh } });
    for (const int kind : AllKinds)
    {
      ShadowPipeline pipeline(mesh, Lights[0], kind);
      EXPECT_EQ(pipeline.silhouette()->GetNumberOfLines(), 1);
      EXPECT_EQ(checkLoops(pipeline.silhouette()).Segments, 3);
      EXPECT_EQ(pipeline.silhouette()->GetCellData()->GetArray("Kind")->GetComponent(0, 0), 2.0);
    }
  }
  // Seen edge-on it casts nothing.
  const LightPosition inItsPlane{ 5.0, 2.0, 1.2, 1.0 };
  EXPECT_GT(expectClosedChains(front, inItsPlane).Segments, 0);
  const PointTotals points = expectExactWinding(front, inItsPlane, { nullptr, front });
  EXPECT_EQ(points.InShadow, 0);
  EXPECT_GT(points.Lit, 100);
}

TEST(HardMeshes, ZeroArea)
{
  // A corner twice, or three points on a line: holes, and T-junctions beside the latter.
  const Mesh spoilt = overTheGround(degenerated(closedBall(), 0.3, 5));
  double twice = 0.0;
  for (const auto& cell : opening(spoilt).Cells)
  {
    twice += cell[0] == cell[1];
  }
  EXPECT_GT(twice, 10.0);
  expectExactShadow(spoilt, { nullptr, spoilt });
  ShadowPipeline pipeline(spoilt, Lights[0], vtkSmoothLightSilhouette::DISCRETE);
  EXPECT_EQ(fieldValue(pipeline.silhouette(), "DegenerateCells"), twice);
  EXPECT_GT(fieldValue(pipeline.silhouette(), "BoundaryEdges"), 10.0);
  expectMasks({ { spoilt } });

  // A closed mesh with triangles without area between two others is as closed as before.
  MeshBuilder folded = opening(overTheGround(weldedBox()));
  const std::vector<vtkIdType> first = folded.Cells[0];
  const Vec3 middle = 0.5 *
    (folded.Points[static_cast<std::size_t>(first[0])] +
      folded.Points[static_cast<std::size_t>(first[1])]);
  const vtkIdType on = folded.addPoint(middle);
  folded.Cells[0] = { first[0], on, first[2] };
  folded.addTriangle(on, first[1], first[2]);
  folded.addTriangle(first[0], first[1], on);
  const Mesh closed = folded.build();
  expectDefects(closed, {});
  const Found found = expectExactShadow(closed, { closed, nullptr });
  EXPECT_EQ(found.GreatestMultiplicity, 1);
  expectMasks({ { closed } });

  // Nothing else.
  MeshBuilder line;
  for (int i = 0; i < 6; ++i)
  {
    line.addPoint({ 0.25 * i, 0.125 * i, 1.0 });
  }
  line.addTriangle(0, 1, 2);
  line.addTriangle(3, 5, 4);
  line.addTriangle(0, 5, 1);
  const Mesh flat = line.build();
  for (const LightPosition& light : Lights)
  {
    const ChainTotals chains = expectClosedChains(flat, light);
    EXPECT_GT(chains.Segments, 0);
    EXPECT_EQ(chains.ZeroNormals, chains.Segments);
    const PointTotals points = expectExactWinding(flat, light, { nullptr, flat });
    EXPECT_EQ(points.InShadow, 0);
    EXPECT_GT(points.Lit, 100);
  }
}

TEST(HardMeshes, SliversOfAspect1e12)
{
  const Mesh fan = overTheGround(slivers(24, 1e-12), 3.0);
  Found found = expectExactShadow(fan, { nullptr, fan });
  EXPECT_EQ(found.Deepest, 1);
  expectDefects(fan, { 0.0, 0.0, 26.0, 0.0, 0.0 });
  expectMasks({ { fan } });

  const Mesh leaf = overTheGround(sliverBox(1e-12));
  found = expectExactShadow(leaf, { leaf, nullptr });
  EXPECT_EQ(found.GreatestMultiplicity, 1);
  EXPECT_EQ(found.Deepest, 1);
  expectDefects(leaf, {});
  expectMasks({ { leaf } });
}

TEST(HardMeshes, DuplicatePoints)
{
  const Mesh ball = overTheGround(closedBall());
  const Mesh apart = facetted(ball);
  ASSERT_EQ(apart->GetNumberOfPoints(), 3 * apart->GetNumberOfPolys());
  const Found found = expectExactShadow(apart, { apart, nullptr });
  EXPECT_EQ(found.GreatestMultiplicity, 1);
  expectDefects(apart, {});
  expectMasks({ { apart } });

  // Without normals it is the same mesh, too.
  expectSameSilhouettes(withoutNormals(ball), withoutNormals(apart));

  // Taken apart each triangle casts on its own.
  ShadowPipeline pipeline(apart, Lights[0], vtkSmoothLightSilhouette::DISCRETE);
  pipeline.Silhouette->MergePointsOff();
  EXPECT_EQ(fieldValue(pipeline.silhouette(), "BoundaryEdges"),
    static_cast<double>(apart->GetNumberOfPoints()));
  EXPECT_EQ(multiplicities(pipeline.silhouette()), std::set<int>{ 1 });
  EXPECT_EQ(openEdges(pipeline.volume()), 0);
  int inShadow = 0;
  for (int sample = 0; sample < 60; ++sample)
  {
    const Vec3 point = samplePoint(apart, sample);
    const Blockers blockers = blockersTowards(apart, point.data(), Lights[0].data());
    EXPECT_NEAR(windingNumber(pipeline.volume(), point.data()), blockers.Count, tolerance::Winding);
    inShadow += blockers.Count > 0;
  }
  EXPECT_GT(inShadow, 5);
}

TEST(HardMeshes, DuplicateCells)
{
  // All of them: still closed, and counted twice.
  const Mesh ball = closedBall();
  const Mesh twice = overTheGround(duplicated(ball, 1.0, 3));
  ASSERT_EQ(twice->GetNumberOfPolys(), 2 * ball->GetNumberOfPolys());
  Found found = expectExactShadow(twice, { twice, nullptr });
  EXPECT_EQ(found.GreatestMultiplicity, 2);
  EXPECT_EQ(found.Deepest, 2);
  expectDefects(twice, { 0.0, 0.0, 0.0, static_cast<double>(facesAtEdges(ball).size()), 0.0 });
  expectMasks({ { twice } });

  // Some of them: no longer closed.
  const Mesh some = overTheGround(duplicated(ball, 0.3, 3));
  found = expectExactShadow(some, { nullptr, some });
  EXPECT_GE(found.Deepest, 3);
  expectMasks({ { some } });

  // One triangle several times: its border counts as often, and casts one shadow.
  for (const int times : { 2, 3, 7 })
  {
    MeshBuilder builder = opening(overTheGround(triangle(), 1.5));
    builder.Cells.resize(static_cast<std::size_t>(times), builder.Cells[0]);
    const Mesh stack = builder.build();
    found = expectExactShadow(stack, { nullptr, stack });
    EXPECT_EQ(found.GreatestMultiplicity, times);
    EXPECT_EQ(found.Deepest, times);
    expectMasks({ { stack } });
  }
}

TEST(HardMeshes, ZeroNormals)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Mesh ball = overTheGround(closedBall());
  for (const Vec3& bad : { Vec3{ 0.0, 0.0, 0.0 }, Vec3{ nan, 0.0, 1.0 } })
  {
    MeshBuilder all = opening(ball);
    MeshBuilder some = all;
    for (std::size_t i = 0; i < all.Normals.size(); ++i)
    {
      all.Normals[i] = bad;
      some.Normals[i] = i % 3 == 0 ? bad : some.Normals[i];
    }
    const Mesh none = all.build();
    const Mesh few = some.build();
    for (const Mesh& mesh : { none, few })
    {
      const Found found = expectExactShadow(mesh, { mesh, nullptr });
      EXPECT_EQ(found.GreatestMultiplicity, 1);
      expectDefects(mesh, {});
      expectMasks({ { mesh } });
    }
    // As if there were none at all: every corner's normal is estimated.
    expectSameSilhouettes(withoutNormals(ball), none);
  }
}

TEST(HardMeshes, NaNAndInfinitePoints)
{
  const Mesh ball = overTheGround(closedBall());
  const Mesh spoilt = withBadPoints(ball, 6, 3);
  const Mesh kept = finiteCells(spoilt);
  const double lost = static_cast<double>(spoilt->GetNumberOfPolys() - kept->GetNumberOfPolys());
  ASSERT_GT(lost, 10.0);
  ASSERT_GT(kept->GetNumberOfPolys(), 50);
  expectExactShadow(spoilt, { nullptr, kept });
  expectDefects(spoilt, { 0.0, lost, countEdges(kept, 1), 0.0, 0.0 });
  expectSameSilhouettes(withoutNormals(kept), withoutNormals(spoilt));
  expectMasks({ { spoilt, kept, true } });

  expectNothingCast(withBadPoints(triangle(), 1, 2));
}

TEST(HardMeshes, TJunctions)
{
  const Mesh open = overTheGround(tJunction());
  expectExactShadow(open, { nullptr, open });
  // 1 -> 2 on one side, 1 -> 6 -> 2 on the other.
  expectDefects(open, { 0.0, 0.0, countEdges(open, 1), 0.0, 0.0 });
  expectMasks({ { open } });

  // A box that would be closed if its neighbour had the point on the edge as well.
  MeshBuilder builder = opening(overTheGround(weldedBox()));
  const std::vector<vtkIdType> first = builder.Cells[0];
  const vtkIdType on = builder.addPoint(0.5 *
    (builder.Points[static_cast<std::size_t>(first[0])] +
      builder.Points[static_cast<std::size_t>(first[1])]));
  builder.Cells[0] = { first[0], on, first[2] };
  builder.addTriangle(on, first[1], first[2]);
  const Mesh solid = builder.build();
  const Found found = expectExactShadow(solid, { nullptr, solid });
  EXPECT_EQ(found.Deepest, 2) << "front and back, as it is not closed";
  expectDefects(solid, { 0.0, 0.0, 3.0, 0.0, 0.0 });
  expectMasks({ { solid } });
}

TEST(HardMeshes, Open)
{
  const Mesh torn = overTheGround(opened(closedBall(), 0.3, 11));
  expectExactShadow(torn, { nullptr, torn });
  expectDefects(torn, { 0.0, 0.0, countEdges(torn, 1), 0.0, 0.0 });
  expectMasks({ { torn } });

  const Mesh half = overTheGround(bowl());
  expectExactShadow(half, { nullptr, half });
  expectMasks({ { half } });

  // Borders count once, contours twice.
  const MeshBuilder points = opening(half);
  std::map<Segment, int> faces;
  for (const auto& edge : facesAtEdges(half))
  {
    const Vec3& a = points.Points[static_cast<std::size_t>(edge.first.first)];
    const Vec3& b = points.Points[static_cast<std::size_t>(edge.first.second)];
    faces[std::minmax(a, b)] = edge.second;
  }
  ShadowPipeline pipeline(half, Lights[1], vtkSmoothLightSilhouette::DISCRETE);
  int borders = 0;
  int contours = 0;
  for (const auto& segment : countSegments(pipeline.silhouette()))
  {
    const auto known = faces.find(segment.first);
    ASSERT_NE(known, faces.end());
    EXPECT_EQ(segment.second, known->second);
    ++(segment.second == 1 ? borders : contours);
  }
  EXPECT_EQ(borders, static_cast<int>(countEdges(half, 1)));
  EXPECT_GT(contours, 3);

  // A hole that no contour comes near: a loop of each.
  MeshBuilder punched = opening(overTheGround(closedBall()));
  punched.Cells.erase(punched.Cells.begin());
  const Mesh holed = punched.build();
  EXPECT_EQ(expectExactShadow(holed, { nullptr, holed }).GreatestMultiplicity, 2);
  expectDefects(holed, { 0.0, 0.0, 3.0, 0.0, 0.0 });
  for (const int kind : AllKinds)
  {
    ShadowPipeline loops(holed, Lights[1], kind);
    vtkPolyData* silhouette = loops.silhouette();
    ASSERT_EQ(silhouette->GetNumberOfCells(), 2);
    for (vtkIdType loop = 0; loop < 2; ++loop)
    {
      const double what = silhouette->GetCellData()->GetArray("Kind")->GetComponent(loop, 0);
      EXPECT_EQ(silhouette->GetCellData()->GetArray("Multiplicity")->GetComponent(loop, 0),
        what == 2.0 ? 1.0 : 2.0);
    }
    EXPECT_EQ(multiplicities(silhouette), (std::set<int>{ 1, 2 }));
  }
  expectMasks({ { holed } });
}

TEST(HardMeshes, NonManifold)
{
  for (const int faces : { 3, 5 })
  {
    SCOPED_TRACE(faces);
    const Mesh leaves = overTheGround(fin(faces), 1.0);
    expectExactShadow(leaves, { nullptr, leaves });
    expectDefects(leaves, { 0.0, 0.0, 2.0 * faces, 1.0, 0.0 });
    expectMasks({ { leaves } });

    const Mesh finned = overTheGround(finnedBox(faces - 2));
    expectExactShadow(finned, { nullptr, finned });
    expectDefects(finned, { 0.0, 0.0, 2.0 * (faces - 2), 1.0, 0.0 });
    expectMasks({ { finned } });

    // Pages of a book that lie on one side of their common edge, which counts for all of them.
    MeshBuilder pages;
    pages.addPoint({ 0.0, -0.8, 1.0 });
    pages.addPoint({ 0.0, 0.8, 1.0 });
    for (int page = 0; page < faces; ++page)
    {
      const vtkIdType tip = pages.addPoint({ 1.5, 0.1 * page, 0.5 + 0.15 * page });
      pages.addTriangle(page % 2, 1 - page % 2, tip);
    }
    const Mesh book = pages.build();
    const Found found = expectExactShadow(book, { nullptr, book });
    EXPECT_GE(found.Deepest, 3);
    ShadowPipeline pipeline(book, Lights[0], vtkSmoothLightSilhouette::DISCRETE);
    const Segment spine{ pages.Points[0], pages.Points[1] };
    EXPECT_EQ(countSegments(pipeline.silhouette())[spine], faces);
    expectMasks({ { book } });
  }
}

TEST(HardMeshes, FlippedFaces)
{
  const Mesh ball = overTheGround(closedBall());
  const Mesh some = misoriented(ball, 0.3, 7);
  const Found found = expectExactShadow(some, { nullptr, some });
  EXPECT_EQ(found.Deepest, 2);
  double inconsistent = 0.0;
  std::map<std::pair<vtkIdType, vtkIdType>, int> balance;
  for (const auto& cell : opening(some).Cells)
  {
    for (std::size_t i = 0; i < cell.size(); ++i)
    {
      const vtkIdType next = cell[(i + 1) % cell.size()];
      balance[std::minmax(cell[i], next)] += cell[i] < next ? 1 : -1;
    }
  }
  for (const auto& edge : balance)
  {
    inconsistent += edge.second != 0;
  }
  EXPECT_GT(inconsistent, 30.0);
  expectDefects(some, { 0.0, 0.0, 0.0, 0.0, inconsistent });
  expectMasks({ { some } });

  // All of them: inside out, as closed as before, and with the dark cap on the far side.
  const Mesh all = misoriented(ball, 1.0, 7);
  expectDefects(all, {});
  EXPECT_EQ(expectExactShadow(all, { ball, nullptr }).GreatestMultiplicity, 1);
  expectMasks({ { all } });
}

TEST(HardMeshes, MoebiusStrip)
{
  const Mesh strip = overTheGround(moebiusStrip(24), 0.9);
  expectExactShadow(strip, { nullptr, strip });
  expectDefects(strip, { 0.0, 0.0, 48.0, 0.0, 1.0 });
  expectMasks({ { strip } });
  const Mesh upright = moved(moebiusStrip(24), 0.8, { 0.0, 0.0, 1.2 }, 4);
  expectExactShadow(upright, { nullptr, upright });
  expectMasks({ { upright } });
}

TEST(HardMeshes, SelfIntersecting)
{
  // Two bodies through one another.
  const Mesh pair =
    overTheGround(merged({ sphere(8, 14), moved(box(0.7, 0.6, 0.5), 1.0, { 0.7, 0.2, 0.3 }, 3) }));
  Found found = expectExactShadow(pair, { pair, nullptr });
  EXPECT_EQ(found.Deepest, 2);
  expectDefects(pair, {});
  expectMasks({ { pair } });

  // A tube along an eight that lies on its side: where it crosses itself it is twice around.
  const Mesh crossing = overTheGround(closedTube(32, 8, [](double u, double v) -> Vec3 {
    const Vec3 across = normalized({ std::cos(2.0 * u), std::sin(u), 0.0 });
    return Vec3{ std::cos(u), 0.5 * std::sin(2.0 * u), 0.0 } + 0.25 * std::cos(v) * across +
      Vec3{ 0.0, 0.0, 0.25 * std::sin(v) };
  }));
  const double middle[3] = { 0.0, 0.0, 1.2 };
  EXPECT_NEAR(windingNumber(crossing, middle), 2.0, tolerance::Winding);
  EXPECT_GE(expectExactShadow(crossing, { crossing, nullptr }).Deepest, 2);
  expectDefects(crossing, {});
  expectMasks({ { crossing } });

  // A torus whose tube reaches through the axis: what it does so twice is inside of nothing.
  const Mesh spindle = overTheGround(closedTube(24, 12, [](double u, double v) -> Vec3 {
    const double radius = 0.7 + std::cos(v);
    return { radius * std::cos(u), radius * std::sin(u), std::sin(v) };
  }));
  EXPECT_NEAR(windingNumber(spindle, middle), 0.0, tolerance::Winding);
  EXPECT_GE(expectExactShadow(spindle, { spindle, nullptr }).Deepest, 2);
  expectMasks({ { spindle } });

  // An eight turned about an axis: one half of it is inside out.
  const Mesh eight = overTheGround(closedTube(16, 18, [](double u, double v) -> Vec3 {
    const double radius = 1.0 + 0.5 * std::sin(v);
    return { radius * std::cos(u), radius * std::sin(u), -0.4 * std::sin(2.0 * v) };
  }));
  const double outer[3] = { 0.6 * 1.4, 0.0, 1.2 };
  const double inner[3] = { 0.6 * 0.6, 0.0, 1.2 };
  EXPECT_NEAR(windingNumber(eight, outer), 1.0, tolerance::Winding);
  EXPECT_NEAR(windingNumber(eight, inner), -1.0, tolerance::Winding);
  expectExactShadow(eight, { eight, nullptr });
  expectMasks({ { eight } });
}

TEST(HardMeshes, ThousandsOfComponents)
{
  // Closed and open ones.
  std::vector<Mesh> bodies;
  std::vector<Mesh> leaves;
  for (int i = 0; i < 3000; ++i)
  {
    const Vec3 place{ -1.5 + 0.2 * (i % 15), -1.5 + 0.2 * (i / 15 % 15), 0.6 + 0.12 * (i / 225) };
    const std::uint64_t seed = static_cast<std::uint64_t>(i) + 1;
    if (i % 3 == 0)
    {
      leaves.push_back(moved(withoutNormals(triangle()), 0.12, place, seed));
    }
    else
    {
      bodies.push_back(moved(weldedBox(), 0.03, place, seed));
    }
  }
  const Mesh closed = merged(bodies);
  const Mesh open = merged(leaves);
  const Mesh all = merged({ closed, open });
  const Found found = expectExactShadow(all, { closed, open }, 40);
  EXPECT_EQ(found.GreatestMultiplicity, 1);
  EXPECT_GE(found.Deepest, 2);
  expectDefects(all, { 0.0, 0.0, 3000.0, 0.0, 0.0 });
  ShadowPipeline pipeline(all, Lights[1], vtkSmoothLightSilhouette::DISCRETE);
  EXPECT_EQ(pipeline.silhouette()->GetNumberOfLines(), 3000);
  expectMasks({ { all } });
}

TEST(HardMeshes, StripsAndPolygons)
{
  const Mesh ring = moved(torus(18, 9), 0.8, { 0.0, 0.0, 1.2 }, 4);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(ring);
  stripper->Update();
  const Mesh strips = stripper->GetOutput();
  ASSERT_GT(strips->GetNumberOfStrips(), 5);
  expectExactShadow(strips, { ring, nullptr });
  expectDefects(strips, {});
  expectMasks({ { strips, ring } });

  // A star is no fan of triangles. Its ears are cut in any order, but on the same plane.
  MeshBuilder star;
  std::vector<vtkIdType> outline;
  MeshBuilder fan;
  fan.addPoint({ 0.0, 0.0, 0.0 });
  constexpr int Corners = 10;
  for (int i = 0; i < Corners; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * (i + 0.2) / Corners;
    const double radius = i % 2 ? 0.5 : 1.5;
    const Vec3 corner{ radius * std::cos(angle), radius * std::sin(angle), 0.0 };
    outline.push_back(star.addPoint(corner));
    fan.addPoint(corner);
    fan.addTriangle(0, 1 + i, 1 + (i + 1) % Corners);
  }
  star.addPolygon(outline);
  const Mesh polygon = overTheGround(star.build(), 1.0);
  const Mesh triangles = overTheGround(fan.build(), 1.0);
  const Found found = expectExactShadow(polygon, { nullptr, triangles });
  EXPECT_EQ(found.Deepest, 1);
  expectDefects(polygon, { 0.0, 0.0, static_cast<double>(Corners), 0.0, 0.0 });
  expectMasks({ { polygon, triangles } });

  // Quads, with lines and vertices beside them: what does not cast has no part in it.
  const Mesh quads = overTheGround(quadBox());
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1, 7 });
  quads->SetLines(lines);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 3 });
  quads->SetVerts(vertices);
  expectExactShadow(quads, { overTheGround(weldedBox()), nullptr });
  expectDefects(quads, {});
  expectSameSilhouettes(overTheGround(quadBox()), quads);
}

TEST(HardMeshes, UnusedPoints)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Mesh ball = overTheGround(closedBall());
  for (const double far : { 3.0, 1e9, nan })
  {
    SCOPED_TRACE(far);
    MeshBuilder builder;
    builder.addPoint({ far, far, far }, { 0.0, 0.0, 1.0 });
    builder.append(ball);
    builder.addPoint({ -far, 0.0, far }, { 0.0, 0.0, 0.0 });
    const Mesh mesh = builder.build();
    const Found found = expectExactShadow(mesh, { ball, nullptr });
    EXPECT_EQ(found.GreatestMultiplicity, 1);
    expectDefects(mesh, {});
    // The tolerance of subdivision is relative to what is used.
    expectSameSilhouettes(ball, mesh);
    ShadowPipeline with(mesh, Lights[0], vtkSmoothLightSilhouette::SMOOTH);
    ShadowPipeline without(ball, Lights[0], vtkSmoothLightSilhouette::SMOOTH);
    EXPECT_EQ(with.silhouette()->GetNumberOfPoints(), without.silhouette()->GetNumberOfPoints());
    EXPECT_EQ(with.volume()->GetNumberOfPoints(), without.volume()->GetNumberOfPoints());
    // VTK's mappers draw points of floats: far from one another they cannot be told apart.
    expectMasks({ { mesh, ball, !(far < 1e6) } });
  }
}

// One open part beside a closed one leaves the closed one its dark caps.
TEST(HardMeshes, OpenPartBesideClosedOne)
{
  const Mesh ball = overTheGround(closedBall());
  const Mesh sheet = moved(ground(0.0, 0.4, 3), 1.0, { 1.2, -0.8, 1.6 }, 9);
  const Mesh both = merged({ ball, sheet });
  const Found found = expectExactShadow(both, { ball, sheet });
  EXPECT_EQ(found.GreatestMultiplicity, 1);
  expectDefects(both, { 0.0, 0.0, 12.0, 0.0, 0.0 });
  expectMasks({ { both } });

  // Cap triangles of the ball: all turned away from the light, and all of these.
  for (const LightPosition& light : Lights)
  {
    const auto facing = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
      const Vec3 towards{ light[0] - light[3] * a[0], light[1] - light[3] * a[1],
        light[2] - light[3] * a[2] };
      return dot(cross(b - a, c - a), towards) >= 0.0;
    };
    vtkIdType dark = 0;
    const MeshBuilder triangles = opening(ball);
    for (const auto& cell : triangles.Cells)
    {
      dark += !facing(triangles.Points[static_cast<std::size_t>(cell[0])],
        triangles.Points[static_cast<std::size_t>(cell[1])],
        triangles.Points[static_cast<std::size_t>(cell[2])]);
    }
    ShadowPipeline pipeline(both, light, vtkSmoothLightSilhouette::DISCRETE);
    vtkPolyData* volume = pipeline.volume();
    EXPECT_EQ(countPart(volume, vtkShadowVolumeExtruder::CAP), dark + sheet->GetNumberOfPolys());
    const MeshBuilder solid = opening(volume);
    for (vtkIdType i = 0; i < volume->GetNumberOfPolys(); ++i)
    {
      const auto& cell = solid.Cells[static_cast<std::size_t>(i)];
      if (partOf(volume, i) == vtkShadowVolumeExtruder::CAP)
      {
        // Caps close the volume on the light's side: reversed on a dark side.
        EXPECT_TRUE(facing(solid.Points[static_cast<std::size_t>(cell[0])],
          solid.Points[static_cast<std::size_t>(cell[1])],
          solid.Points[static_cast<std::size_t>(cell[2])]));
      }
    }
  }
}

TEST(HardMeshes, WithoutCaps)
{
  const std::pair<const char*, Mesh> meshes[] = { { "ball", closedBall() }, { "bowl", bowl() },
    { "fin", fin(5) }, { "soup", misoriented(opened(closedBall(), 0.3, 5), 0.5, 5) } };
  for (const auto& [name, mesh] : meshes)
  {
    SCOPED_TRACE(name);
    for (const LightPosition& light : Lights)
    {
      for (const int kind : AllKinds)
      {
        ShadowPipeline pipeline(mesh, light, kind);
        const vtkIdType walls = countPart(pipeline.volume(), vtkShadowVolumeExtruder::WALL);
        const vtkIdType gaps = countPart(pipeline.volume(), vtkShadowVolumeExtruder::GAP);
        EXPECT_GT(countPart(pipeline.volume(), vtkShadowVolumeExtruder::CAP), 0);
        pipeline.Extruder->SetCapsToNone();
        vtkPolyData* volume = pipeline.volume();
        EXPECT_EQ(fieldValue(volume, "Closed"), 0.0);
        EXPECT_GT(openEdges(volume), 0);
        EXPECT_EQ(countPart(volume, vtkShadowVolumeExtruder::WALL), walls);
        EXPECT_EQ(countPart(volume, vtkShadowVolumeExtruder::GAP), gaps);
        EXPECT_EQ(volume->GetNumberOfCells(), walls + gaps);
        EXPECT_GT(walls, 0);
      }
    }
  }
}
