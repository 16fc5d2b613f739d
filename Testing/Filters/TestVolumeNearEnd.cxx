// What NEAR_END gives is what a volume begins with: extruded here, it is the volume.

#include "ChainChecks.h"
#include "RandomMeshes.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkUnsignedIntArray.h>

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <utility>

namespace
{
using shadowtest::LightPosition;
using shadowtest::ShadowPipeline;

constexpr int AllCaps[] = { vtkShadowVolumeExtruder::AUTOMATIC, vtkShadowVolumeExtruder::LIT,
  vtkShadowVolumeExtruder::DARK, vtkShadowVolumeExtruder::NONE };

/// Homogeneous.
using Point = std::array<double, 4>;

/// Triangles over homogeneous points with their multiplicity, turned so that the least corner is
/// the first; triangles of opposite winding cancel.
class Chain
{
public:
  void add(Point p, Point q, Point r, int multiplicity)
  {
    if (p == q || q == r || r == p)
    {
      return;
    }
    while (!(p < q && p < r))
    {
      const Point first = p;
      p = q;
      q = r;
      r = first;
    }
    const bool turned = r < q;
    if (turned)
    {
      std::swap(q, r);
    }
    int& sum = this->Triangles[{ p, q, r }];
    sum += turned ? -multiplicity : multiplicity;
    if (sum == 0)
    {
      this->Triangles.erase({ p, q, r });
    }
  }

  std::size_t size() const { return this->Triangles.size(); }
  bool operator==(const Chain& other) const { return this->Triangles == other.Triangles; }

private:
  std::map<std::array<Point, 3>, int> Triangles;
};

Point placeOf(vtkPolyData* data, vtkIdType id)
{
  Point place{ 0.0, 0.0, 0.0, 1.0 };
  data->GetPoint(id, place.data());
  for (double& coordinate : place)
  {
    coordinate += 0.0; // -0 is 0
  }
  return place;
}

/// As the light's filters take it: w = 1, or 0 and any length.
struct Extrusion
{
  LightPosition Light;

  Point operator()(const Point& p) const
  {
    const double w = this->Light[3];
    return w == 0.0
      ? Point{ -this->Light[0], -this->Light[1], -this->Light[2], 0.0 }
      : Point{ p[0] - this->Light[0] / w, p[1] - this->Light[1] / w, p[2] - this->Light[2] / w,
          0.0 };
  }
};

/// Of the full extruder's output, to infinity.
Chain chainOf(vtkPolyData* volume, const LightPosition& light)
{
  vtkDataArray* homogeneous = volume->GetPointData()->GetArray("Homogeneous");
  vtkDataArray* multiplicities = volume->GetCellData()->GetArray("Multiplicity");
  const auto place = [&](vtkIdType id)
  {
    Point p;
    homogeneous->GetTuple(id, p.data());
    if (p[3] == 0.0 && light[3] == 0.0)
    {
      // All of a direction's shadows end in one point.
      return Extrusion{ light }({});
    }
    for (double& coordinate : p)
    {
      coordinate += 0.0;
    }
    return p;
  };
  Chain chain;
  for (vtkIdType cell = 0; cell < volume->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    volume->GetPolys()->GetCellAtId(cell, size, ids);
    chain.add(place(ids[0]), place(ids[1]), place(ids[2]),
      static_cast<int>(multiplicities->GetComponent(cell, 0)));
  }
  return chain;
}

/// Calls visit(p, q, r, multiplicity) for the near cap and the gaps.
template <class Visit>
void forEachNearTriangle(vtkPolyData* mesh, vtkPolyData* end, const Visit& visit)
{
  auto* whole =
    vtkUnsignedIntArray::SafeDownCast(end->GetFieldData()->GetArray("CapTriangles"));
  for (vtkIdType i = 0; i < whole->GetNumberOfTuples(); ++i)
  {
    const auto corner = [&](int k) { return placeOf(mesh, whole->GetTypedComponent(i, k)); };
    visit(corner(0), corner(1), corner(2), 1);
  }
  vtkDataArray* multiplicities = end->GetCellData()->GetArray("Multiplicity");
  for (vtkIdType cell = 0; cell < end->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    end->GetPolys()->GetCellAtId(cell, size, ids);
    visit(placeOf(end, ids[0]), placeOf(end, ids[1]), placeOf(end, ids[2]),
      static_cast<int>(multiplicities->GetComponent(end->GetNumberOfLines() + cell, 0)));
  }
}

template <class Visit>
void forEachRimSegment(vtkPolyData* end, const Visit& visit)
{
  vtkDataArray* multiplicities = end->GetCellData()->GetArray("Multiplicity");
  for (vtkIdType cell = 0; cell < end->GetNumberOfLines(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    end->GetLines()->GetCellAtId(cell, size, ids);
    for (vtkIdType i = 0; i + 1 < size; ++i)
    {
      visit(placeOf(end, ids[i]), placeOf(end, ids[i + 1]),
        static_cast<int>(multiplicities->GetComponent(cell, 0)));
    }
  }
}

/// An infinite volume made of its near end. `fanCentre` is where the far cap's fan has its apex.
Chain extruded(vtkPolyData* mesh, vtkPolyData* end, const LightPosition& light, bool capped,
  const Point& fanCentre)
{
  const Extrusion farOf{ light };
  const bool outside = shadowtest::fieldValue(end, "LightOutside") == 1.0;
  Chain chain;
  forEachNearTriangle(mesh, end,
    [&](const Point& p, const Point& q, const Point& r, int multiplicity)
    {
      chain.add(p, q, r, multiplicity);
      if (capped && !outside)
      {
        chain.add(farOf(r), farOf(q), farOf(p), multiplicity);
      }
    });
  forEachRimSegment(end,
    [&](const Point& p, const Point& q, int multiplicity)
    {
      chain.add(q, p, farOf(p), multiplicity);
      chain.add(q, farOf(p), farOf(q), multiplicity);
      if (capped && outside)
      {
        chain.add(farOf(fanCentre), farOf(q), farOf(p), multiplicity);
      }
    });
  return chain;
}

void expectWellFormed(vtkPolyData* end)
{
  EXPECT_EQ(end->GetNumberOfVerts() + end->GetNumberOfStrips(), 0);
  ASSERT_TRUE(end->GetPoints());
  EXPECT_EQ(end->GetPoints()->GetDataType(), VTK_DOUBLE);
  vtkDataArray* parts = end->GetCellData()->GetArray("Part");
  vtkDataArray* multiplicities = end->GetCellData()->GetArray("Multiplicity");
  ASSERT_TRUE(parts && multiplicities);
  ASSERT_EQ(parts->GetNumberOfTuples(), end->GetNumberOfCells());
  ASSERT_EQ(multiplicities->GetNumberOfTuples(), end->GetNumberOfCells());
  std::set<vtkIdType> used;
  for (vtkIdType cell = 0; cell < end->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    end->GetCellPoints(cell, size, ids);
    const bool isRim = cell < end->GetNumberOfLines();
    EXPECT_GE(multiplicities->GetComponent(cell, 0), 1.0);
    EXPECT_EQ(parts->GetComponent(cell, 0) == vtkShadowVolumeExtruder::WALL, isRim);
    EXPECT_NE(parts->GetComponent(cell, 0), vtkShadowVolumeExtruder::FAR_CAP);
    if (isRim)
    {
      EXPECT_GE(size, 4);
      EXPECT_EQ(ids[0], ids[size - 1]);
    }
    used.insert(ids, ids + size);
  }
  EXPECT_EQ(static_cast<vtkIdType>(used.size()), end->GetNumberOfPoints());
}

struct Totals
{
  std::size_t Triangles = 0;
  vtkIdType WholeTriangles = 0;
  vtkIdType Parts = 0;
  vtkIdType Rims = 0;
  int Outside = 0;
  int Inside = 0;
};

/// Compares the near end with the full volume for all kinds and caps.
void expectSameVolumes(vtkPolyData* mesh, const LightPosition& light, Totals& totals)
{
  for (const int kind : shadowtest::AllKinds)
  {
    ShadowPipeline pipeline(mesh, light, kind);
    for (const int caps : AllCaps)
    {
      SCOPED_TRACE("kind " + std::to_string(kind) + ", caps " + std::to_string(caps));
      pipeline.Extruder->SetCaps(caps);
      pipeline.Extruder->SetExtentToInfinite();
      vtkNew<vtkPolyData> volume;
      volume->ShallowCopy(pipeline.volume());
      pipeline.Extruder->SetExtentToNearEnd();
      vtkPolyData* end = pipeline.volume();
      expectWellFormed(end);
      const bool capped = caps != vtkShadowVolumeExtruder::NONE;
      EXPECT_EQ(shadowtest::fieldValue(end, "GreatestDepth"),
        shadowtest::fieldValue(volume, "GreatestDepth"));

      // The fan's apex may be any point: the volume's own is taken, where there is one.
      Point apex{};
      vtkDataArray* homogeneous = volume->GetPointData()->GetArray("Homogeneous");
      const bool outside = shadowtest::fieldValue(end, "LightOutside") == 1.0;
      if (capped && outside && light[3] != 0.0 && end->GetNumberOfLines() > 0)
      {
        homogeneous->GetTuple(volume->GetNumberOfPoints() - 1, apex.data());
        for (int axis = 0; axis < 3; ++axis)
        {
          apex[static_cast<std::size_t>(axis)] += light[static_cast<std::size_t>(axis)] / light[3];
        }
      }
      const Chain expected = chainOf(volume, light);
      const Chain made = extruded(mesh, end, light, capped, apex);
      EXPECT_TRUE(made == expected) << made.size() << " instead of " << expected.size();
      EXPECT_EQ(expected.size() == 0, made.size() == 0);

      vtkDataArray* whole = end->GetFieldData()->GetArray("CapTriangles");
      if (!capped)
      {
        EXPECT_EQ(whole->GetNumberOfTuples(), 0);
        for (vtkIdType cell = 0; cell < end->GetNumberOfCells(); ++cell)
        {
          EXPECT_NE(end->GetCellData()->GetArray("Part")->GetComponent(cell, 0),
            vtkShadowVolumeExtruder::CAP);
        }
      }
      totals.Triangles += made.size();
      totals.WholeTriangles += whole->GetNumberOfTuples();
      totals.Parts += end->GetNumberOfPolys();
      totals.Rims += end->GetNumberOfLines();
      ++(outside ? totals.Outside : totals.Inside);
    }
  }
}
}

namespace
{
/// Such a light counts as a little above the surface, and extrudes from there.
bool isOnAPoint(const LightPosition& light, vtkPolyData* mesh)
{
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Point p = placeOf(mesh, i);
    if (light[3] != 0.0 && p[0] == light[0] / light[3] && p[1] == light[1] / light[3] &&
      p[2] == light[2] / light[3])
    {
      return true;
    }
  }
  return false;
}
}

TEST(VolumeNearEnd, OfKnownShapes)
{
  const LightPosition lights[] = { { 0.3, 0.2, 1.0, 0.0 }, { 0.0, 0.0, 1.0, 0.0 },
    { 1.1, -2.7, 3.1, 1.0 }, { 0.1, 0.05, 0.02, 1.0 }, { 2.2, -5.4, 6.2, 2.0 } };
  const std::pair<const char*, shadowtest::Mesh> meshes[] = {
    { "sphere", shadowtest::sphere(12, 24) }, { "torus", shadowtest::torus(36, 18) },
    { "cylinder", shadowtest::cylinder(16) }, { "box", shadowtest::box() },
    { "star", shadowtest::starShaped(3, 7) }, { "sheet", shadowtest::ground(0.0, 1.0, 3) }
  };
  for (const auto& [name, mesh] : meshes)
  {
    for (const LightPosition& light : lights)
    {
      SCOPED_TRACE(std::string(name) + ", light w " + std::to_string(light[3]));
      Totals totals;
      expectSameVolumes(mesh, light, totals);
      EXPECT_GT(totals.Triangles, 20u);
      EXPECT_GT(totals.WholeTriangles, 3);
    }
  }
}

TEST(VolumeNearEnd, OfRandomMeshes)
{
  Totals totals;
  constexpr std::uint64_t count = 300;
  for (std::uint64_t seed = 1; seed <= count && !HasFailure(); ++seed)
  {
    const shadowtest::RandomMesh scene = shadowtest::randomMesh(seed);
    if (isOnAPoint(scene.Light, scene.Surface))
    {
      continue;
    }
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind);
    expectSameVolumes(scene.Surface, scene.Light, totals);
  }
  EXPECT_GT(totals.Triangles, 100 * count);
  EXPECT_GT(totals.WholeTriangles, static_cast<vtkIdType>(100 * count));
  EXPECT_GT(totals.Parts, static_cast<vtkIdType>(100 * count));
  EXPECT_GT(totals.Rims, static_cast<vtkIdType>(10 * count));
  EXPECT_GT(totals.Outside, 100);
  EXPECT_GT(totals.Inside, 100);
}

// Its whole triangles keep winding and first corner, so that a rasteriser gives them the same
// depth, and the points of parts are fewer than the mesh's.
TEST(VolumeNearEnd, WholeTrianglesAreThoseOfTheMesh)
{
  const shadowtest::Mesh sphere = shadowtest::icosphere(3);
  std::set<std::array<vtkIdType, 3>> ofMesh;
  for (vtkIdType cell = 0; cell < sphere->GetNumberOfPolys(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    sphere->GetPolys()->GetCellAtId(cell, size, ids);
    ofMesh.insert({ ids[0], ids[1], ids[2] });
  }
  ShadowPipeline pipeline(
    sphere, { 1.1, -2.7, 3.1, 1.0 }, vtkSmoothLightSilhouette::SMOOTH);
  pipeline.Extruder->SetExtentToNearEnd();
  for (const int caps : { vtkShadowVolumeExtruder::LIT, vtkShadowVolumeExtruder::DARK })
  {
    pipeline.Extruder->SetCaps(caps);
    auto* whole = vtkUnsignedIntArray::SafeDownCast(
      pipeline.volume()->GetFieldData()->GetArray("CapTriangles"));
    ASSERT_TRUE(whole);
    const bool dark = caps == vtkShadowVolumeExtruder::DARK;
    for (vtkIdType i = 0; i < whole->GetNumberOfTuples(); ++i)
    {
      const auto corner = [&](int k)
      { return static_cast<vtkIdType>(whole->GetTypedComponent(i, k)); };
      EXPECT_EQ(
        ofMesh.count({ corner(0), corner(dark ? 2 : 1), corner(dark ? 1 : 2) }), 1u);
    }
    EXPECT_GT(whole->GetNumberOfTuples(), 300);
    EXPECT_GT(pipeline.volume()->GetNumberOfPoints(), 50);
    EXPECT_LT(pipeline.volume()->GetNumberOfPoints(), sphere->GetNumberOfPoints());
  }
}
