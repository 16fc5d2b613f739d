// Tracking and sampling find whole components of the silhouette, and nothing else, on any mesh.
//
// The oracle builds the chain of a search's result by its definition, with nodes at crossings and
// at fans around vertices, and looks at all of the mesh.

#include "SilhouetteTracking.h"

#include "DisjointSets.h"
#include "Random.h"
#include "RandomMeshes.h"
#include "SilhouetteFollower.h"
#include "TestMeshes.h"
#include "VertexNormals.h"
#include "VertexWelding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

using namespace shadow;

namespace
{
constexpr FieldKind bothKinds[] = { FieldKind::Face, FieldKind::Corner };

/// The triangles of a mesh of VTK; without normals they are estimated, with creases.
TriangleMesh coreMesh(vtkPolyData* surface)
{
  shadowtest::MeshBuilder given;
  given.append(surface);
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  for (std::size_t i = 0; i < given.Points.size(); ++i)
  {
    points.emplace_back(given.Points[i][0], given.Points[i][1], given.Points[i][2]);
    if (!given.Normals.empty())
    {
      normals.emplace_back(given.Normals[i][0], given.Normals[i][1], given.Normals[i][2]);
    }
  }
  const Welding vertices = weldPoints(points);
  const Welding welded =
    weldNormals(normals, normals.empty() ? std::vector<Index>() : vertices.target);
  TriangleMesh mesh;
  for (const Index i : vertices.first)
  {
    mesh.points.push_back(points[i]);
  }
  for (const Index i : welded.first)
  {
    mesh.normals.push_back(normals[i]);
    mesh.normalVertex.push_back(vertices.target[i]);
  }
  for (const auto& cell : given.Cells)
  {
    for (std::size_t k = 2; k < cell.size(); ++k)
    {
      const std::array<std::size_t, 3> corners{ static_cast<std::size_t>(cell[0]),
        static_cast<std::size_t>(cell[k - 1]), static_cast<std::size_t>(cell[k]) };
      const Triangle t{ vertices.target[corners[0]], vertices.target[corners[1]],
        vertices.target[corners[2]] };
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      {
        continue;
      }
      mesh.triangles.push_back(t);
      if (!normals.empty())
      {
        mesh.cornerNormals.push_back(
          { welded.target[corners[0]], welded.target[corners[1]], welded.target[corners[2]] });
      }
    }
  }
  if (normals.empty())
  {
    estimateCornerNormals(mesh, buildEdgeTable(mesh), 0.5);
  }
  return mesh;
}

/// A mesh with all that a search takes.
struct Subject
{
  explicit Subject(TriangleMesh given)
    : Mesh(std::move(given))
    , Edges(buildEdgeTable(this->Mesh))
    , Weights(findChainWeights(this->Mesh, this->Edges))
    , LinkEdges(findLinkEdges(
        this->Mesh, this->Edges, this->Weights, findEdgeKinds(this->Mesh, this->Edges)))
  {
  }

  SearchedMesh searched() const
  {
    return { this->Mesh, this->Edges, this->Weights, this->LinkEdges };
  }

  SearchResult all(const Light& light, FieldKind kind) const
  {
    return searchAll(this->searched(), light, kind, serialLoop);
  }

  TrackedResult track(const Light& light, FieldKind kind, const SearchResult* last = nullptr) const
  {
    return trackSilhouette(
      this->searched(), findTrackingSeeds(this->searched(), kind), light, kind, last);
  }

  TrackedResult sample(const Light& light, FieldKind kind, double fraction, std::uint32_t seed = 1,
    const SearchResult* last = nullptr) const
  {
    return sampleSilhouette(this->searched(), light, kind, fraction, seed, last, serialLoop);
  }

  TriangleMesh Mesh;
  EdgeTable Edges;
  ChainWeights Weights;
  std::vector<Index> LinkEdges;
};

/// A fan around a vertex, or the edge and place of a crossing.
using Node = std::tuple<bool, Index, Index>;

/// Of a triangle, or of an interval of an edge.
using PieceName = std::tuple<bool, Index, Index>;

struct OraclePiece
{
  Node from;
  Node to;
  int multiplicity;

  bool operator==(const OraclePiece& o) const
  {
    return this->from == o.from && this->to == o.to && this->multiplicity == o.multiplicity;
  }
};

using Pieces = std::map<PieceName, OraclePiece>;

class ChainOracle
{
public:
  ChainOracle(const Subject& subject, const Light& light, FieldKind kind)
    : S(subject)
    , Field(subject.Mesh, light, kind)
    , Corners(3 * subject.Mesh.triangles.size())
  {
    // Corners at a vertex are of one fan where their triangles share an edge at it.
    std::map<std::pair<Index, Index>, Index> cornerAtEnd;
    for (Index t = 0; t < this->S.Mesh.triangles.size(); ++t)
    {
      for (unsigned k = 0; k < 3; ++k)
      {
        const Index edge = this->S.Edges.triangleEdges[t][k];
        for (const unsigned c : { k, next(k) })
        {
          const auto key = std::make_pair(edge, this->S.Mesh.triangles[t][c]);
          this->Corners.unite(3 * t + c, cornerAtEnd.emplace(key, 3 * t + c).first->second);
        }
      }
    }
    for (const auto& [end, corner] : cornerAtEnd)
    {
      this->FanAtEnd[end] = this->Corners.find(corner);
    }
  }

  Pieces pieces(const SearchResult& found)
  {
    Pieces result;
    if (this->Field.kind() == FieldKind::Face)
    {
      for (std::size_t i = 0; i < found.edges.size(); ++i)
      {
        const Edge& e = this->S.Edges.edges[found.edges[i]];
        result[{ false, found.edges[i], 0 }] = { this->end(found.edges[i], e.a),
          this->end(found.edges[i], e.b), found.multiplicities[i] };
      }
      return result;
    }
    // Crossings are known of edges that a found triangle crosses, as when the chain is built.
    std::set<Index> crossed;
    for (const Index t : found.triangles)
    {
      const Triangle& n = this->S.Mesh.cornerNormals[t];
      Node from, to;
      for (unsigned k = 0; k < 3; ++k)
      {
        const bool lit = this->Field.lit(n[k]);
        if (lit != this->Field.lit(n[next(k)]))
        {
          crossed.insert(this->S.Edges.triangleEdges[t][k]);
          (lit ? from : to) = this->crossing(3 * t + k);
        }
      }
      const ChainWeight& w = this->S.Weights.corner(t);
      result[{ true, t, 0 }] = { from, to, w.lit - w.dark };
    }
    for (const Index e : found.edges)
    {
      this->addLinks(e, crossed.count(e) > 0, result);
    }
    return result;
  }

private:
  Node end(Index edge, Index vertex) const
  {
    return { false, this->FanAtEnd.at({ edge, vertex }), 0 };
  }

  SideNormals normals(Side side) const
  {
    return sideNormals(
      this->S.Mesh, this->S.Edges, this->S.Edges.triangleEdges[side / 3][side % 3], side);
  }

  /// The distinct normals that cross on an edge, in order of their crossings.
  std::vector<SideNormals> crossings(Index edge) const
  {
    std::vector<std::pair<double, SideNormals>> sorted;
    for (const SideNormals& n : distinctNormals(this->S.Mesh, this->S.Edges, edge))
    {
      const double a = this->Field.value(n.a);
      const double b = this->Field.value(n.b);
      if (isLit(a) != isLit(b))
      {
        sorted.emplace_back(std::isfinite(a / (a - b)) ? a / (a - b) : 0.5, n);
      }
    }
    std::stable_sort(
      sorted.begin(), sorted.end(), [](const auto& l, const auto& r) { return l.first < r.first; });
    std::vector<SideNormals> result;
    for (const auto& c : sorted)
    {
      result.push_back(c.second);
    }
    return result;
  }

  Node crossing(Side side) const
  {
    const Index edge = this->S.Edges.triangleEdges[side / 3][side % 3];
    const std::vector<SideNormals> order = this->crossings(edge);
    return { true, edge,
      static_cast<Index>(
        std::find(order.begin(), order.end(), this->normals(side)) - order.begin()) };
  }

  void addLinks(Index edge, bool isCrossed, Pieces& result) const
  {
    const std::vector<SideNormals> order =
      isCrossed ? this->crossings(edge) : std::vector<SideNormals>();
    const Edge& ends = this->S.Edges.edges[edge];
    Node from = this->end(edge, ends.a);
    for (Index passed = 0; passed <= order.size(); ++passed)
    {
      const Node to = passed < order.size() ? Node{ true, edge, passed } : this->end(edge, ends.b);
      int sum = 0;
      for (Index i = this->S.Edges.firstSide(edge); i < this->S.Edges.firstSide(edge + 1); ++i)
      {
        const Side side = this->S.Edges.sides[i];
        const SideNormals n = this->normals(side);
        const bool beyond =
          std::find(order.begin(), order.begin() + passed, n) != order.begin() + passed;
        sum += sideSign(this->S.Mesh, this->S.Edges, edge, side) *
          this->S.Weights.corner(side / 3).of(this->Field.lit(beyond ? n.b : n.a));
      }
      if (sum != 0)
      {
        result[{ false, edge, passed }] = { from, to, sum };
      }
      from = to;
    }
  }

  const Subject& S;
  LightField Field;
  DisjointSets Corners;
  std::map<std::pair<Index, Index>, Index> FanAtEnd;
};

bool isBalanced(const Pieces& pieces)
{
  std::map<Node, int> sum;
  for (const auto& [name, p] : pieces)
  {
    sum[p.from] -= p.multiplicity;
    sum[p.to] += p.multiplicity;
  }
  return std::all_of(sum.begin(), sum.end(), [](const auto& s) { return s.second == 0; });
}

/// The component of each piece: pieces that share a node, and those that share theirs.
std::map<PieceName, Index> components(const Pieces& pieces)
{
  std::map<Node, Index> firstAt;
  DisjointSets sets(pieces.size());
  Index i = 0;
  for (const auto& [name, p] : pieces)
  {
    sets.unite(i, firstAt.emplace(p.from, i).first->second);
    sets.unite(i, firstAt.emplace(p.to, i).first->second);
    ++i;
  }
  std::map<PieceName, Index> component;
  i = 0;
  for (const auto& [name, p] : pieces)
  {
    component[name] = sets.find(i++);
  }
  return component;
}

template <class Items>
bool isAscending(const Items& items)
{
  return std::adjacent_find(items.begin(), items.end(),
           [](const auto& l, const auto& r) { return l >= r; }) == items.end();
}

/// Gives the number of pieces found.
std::size_t expectWholeComponents(ChainOracle& oracle, const SearchResult& found, const Pieces& all)
{
  EXPECT_TRUE(isAscending(found.triangles));
  EXPECT_TRUE(isAscending(found.edges));
  const Pieces pieces = oracle.pieces(found);
  EXPECT_TRUE(isBalanced(pieces));
  std::map<Index, bool> isFound;
  for (const auto& [name, component] : components(all))
  {
    const bool here = pieces.count(name) > 0;
    EXPECT_EQ(isFound.emplace(component, here).first->second, here) << "only a part is found";
  }
  for (const auto& [name, p] : pieces)
  {
    const auto same = all.find(name);
    EXPECT_TRUE(same != all.end() && same->second == p) << "not of the silhouette";
  }
  return pieces.size();
}

/// Splits normals and takes them from a grid, leaves some zero or no number; moves points to no
/// number.
void spoil(TriangleMesh& mesh, shadowtest::Random& random)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  if (random.chance(0.25))
  {
    mesh.normals.clear();
    mesh.normalVertex.clear();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      for (unsigned k = 0; k < 3; ++k)
      {
        mesh.cornerNormals[t][k] = static_cast<Index>(mesh.normals.size());
        mesh.normalVertex.push_back(mesh.triangles[t][k]);
        mesh.normals.emplace_back(
          random.integer(-1, 1), random.integer(-1, 1), random.integer(-1, 1));
      }
    }
  }
  for (Vec3& n : mesh.normals)
  {
    n = random.chance(0.01) ? Vec3(random.chance(0.5) ? nan : 0.0) : n;
  }
  if (random.chance(0.1) && !mesh.points.empty())
  {
    mesh
      .points[static_cast<std::size_t>(random.integer(0, static_cast<int>(mesh.points.size()) - 1))]
      .x = nan;
  }
}

Vec3 anyDirection(shadowtest::Random& random)
{
  std::array<double, 3> d{};
  random.direction(d.data());
  return { d[0], d[1], d[2] };
}

std::vector<Light> someLights(const TriangleMesh& mesh, shadowtest::Random& random)
{
  const double sign = random.chance(0.5) ? 1.0 : -1.0;
  std::vector<Light> lights{ { { sign, 0.0, 0.0 }, 0.0 }, { { 0.0, sign, 0.0 }, 0.0 },
    { { 0.0, 0.0, sign }, 0.0 }, { anyDirection(random), 0.0 }, { 3.0 * anyDirection(random), 1.0 },
    { 0.3 * anyDirection(random), 2.0 }, { Vec3(0.0), 0.0 },
    { Vec3(std::numeric_limits<double>::quiet_NaN()), 1.0 } };
  if (!mesh.points.empty())
  {
    lights.push_back({ mesh.points[mesh.points.size() / 2], 1.0 });
  }
  return lights;
}

/// A loop as of many threads, in an order that none would take.
void backwardLoop(std::size_t count, std::size_t /*grain*/, const RangeBody& body)
{
  for (std::size_t i = count; i > 0; --i)
  {
    body(i - 1, i);
  }
}

TriangleMesh twoSpheres()
{
  return coreMesh(shadowtest::merged({ shadowtest::icosphere(3),
    shadowtest::moved(shadowtest::icosphere(2, 5), 0.4, { 3.0, 0.5, 0.2 }) }));
}

/// The cube [-1, 1]^3 of 12 n^2 triangles, turned, with creases. Those of the side z = 1 come
/// first.
TriangleMesh fineCube(int n)
{
  shadowtest::MeshBuilder builder;
  const Vec3 axes[] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
  for (const int side : { 2, 1, 0 })
  {
    for (const double sign : { 1.0, -1.0 })
    {
      const Vec3 w = sign * axes[side];
      const Vec3 u = axes[(side + 1) % 3];
      const Vec3 v = glm::cross(w, u);
      const auto point = [&](int i, int j) {
        const Vec3 p = w + (2.0 * i / n - 1.0) * u + (2.0 * j / n - 1.0) * v;
        return builder.addPoint({ p.x, p.y, p.z });
      };
      for (int i = 0; i < n; ++i)
      {
        for (int j = 0; j < n; ++j)
        {
          builder.addQuad(point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
        }
      }
    }
  }
  TriangleMesh mesh = coreMesh(builder.build());
  // Welded before, turned after: rounding tells the triangles of a side apart.
  const Vec3 x = glm::normalize(Vec3(0.8, 0.3, 0.1));
  const Vec3 y = glm::normalize(glm::cross(Vec3(0.1, 0.2, 0.9), x));
  const Vec3 z = glm::cross(x, y);
  for (std::vector<Vec3>* vectors : { &mesh.points, &mesh.normals })
  {
    for (Vec3& p : *vectors)
    {
      p = p.x * x + p.y * y + p.z * z;
    }
  }
  return mesh;
}

TriangleMesh hemisphere()
{
  TriangleMesh mesh = coreMesh(shadowtest::icosphere(3, 4));
  std::vector<Triangle> kept;
  for (const Triangle& t : mesh.triangles)
  {
    if (mesh.points[t[0]].z + mesh.points[t[1]].z + mesh.points[t[2]].z > 0.0)
    {
      kept.push_back(t);
    }
  }
  mesh.triangles = mesh.cornerNormals = kept;
  return mesh;
}
}

TEST(SilhouetteTracking, WholeComponentsOnAnyMesh)
{
  std::size_t every = 0, tracked = 0, sampled = 0, coherent = 0;
  for (std::uint64_t seed = 1; seed <= 2000 && !HasFailure(); ++seed)
  {
    const shadowtest::RandomMesh scene = shadowtest::randomMesh(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind);
    shadowtest::Random random(seed);
    TriangleMesh mesh = coreMesh(scene.Surface);
    if (mesh.triangles.size() > 300)
    {
      continue;
    }
    spoil(mesh, random);
    const Subject subject(std::move(mesh));
    std::vector<Light> lights = someLights(subject.Mesh, random);
    lights.push_back({ { scene.Light[0], scene.Light[1], scene.Light[2] }, scene.Light[3] });
    for (const FieldKind kind : bothKinds)
    {
      const TrackingSeeds seeds = findTrackingSeeds(subject.searched(), kind);
      TrackedResult lastTracked, lastSampled;
      for (const Light& light : lights)
      {
        ChainOracle oracle(subject, light, kind);
        const Pieces all = oracle.pieces(subject.all(light, kind));
        ASSERT_TRUE(isBalanced(all));
        every += all.size();
        lastTracked = trackSilhouette(subject.searched(), seeds, light, kind,
          random.chance(0.5) ? &lastTracked.found : nullptr);
        const std::size_t found = expectWholeComponents(oracle, lastTracked.found, all);
        EXPECT_TRUE(!lastTracked.complete || found == all.size());
        tracked += found;
        lastSampled = subject.sample(light, kind, 0.05, static_cast<std::uint32_t>(seed),
          random.chance(0.5) ? &lastSampled.found : nullptr);
        sampled += expectWholeComponents(oracle, lastSampled.found, all);
        const TrackedResult walked =
          trackSilhouette(subject.searched(), {}, light, kind, &lastSampled.found);
        coherent += expectWholeComponents(oracle, walked.found, all);
      }
    }
  }
  EXPECT_GT(every, 500000u);
  EXPECT_GT(static_cast<double>(tracked), 0.9 * static_cast<double>(every));
  EXPECT_GT(static_cast<double>(sampled), 0.5 * static_cast<double>(every));
  EXPECT_LT(sampled, every);
  EXPECT_GE(coherent, sampled);
}

// One triangle or edge at a time, each with a follower of its own or all with one.
TEST(SilhouetteTracking, AnyStartGivesItsComponentAndAllStartsGiveAll)
{
  for (std::uint64_t seed = 1; seed <= 600 && !HasFailure(); ++seed)
  {
    const shadowtest::RandomMesh scene = shadowtest::randomMesh(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind);
    shadowtest::Random random(seed);
    TriangleMesh mesh = coreMesh(scene.Surface);
    if (mesh.triangles.size() > 60)
    {
      continue;
    }
    spoil(mesh, random);
    const Subject subject(std::move(mesh));
    for (const FieldKind kind : bothKinds)
    {
      for (const Light& light : someLights(subject.Mesh, random))
      {
        ChainOracle oracle(subject, light, kind);
        const Pieces all = oracle.pieces(subject.all(light, kind));
        SilhouetteFollower together(subject.searched(), light, kind);
        for (Index t = 0; t < subject.Mesh.triangles.size(); ++t)
        {
          SilhouetteFollower alone(subject.searched(), light, kind);
          const bool found = alone.startAt(t);
          EXPECT_EQ(found, together.startAt(t));
          EXPECT_LE(expectWholeComponents(oracle, alone.result(), all) > 0 ? 1 : 0, found ? 1 : 0);
        }
        EXPECT_TRUE(oracle.pieces(together.result()) == all);
        SilhouetteFollower byEdges(subject.searched(), light, kind);
        for (Index e = 0; e < subject.Edges.edges.size(); ++e)
        {
          byEdges.startOn(e);
        }
        EXPECT_TRUE(oracle.pieces(byEdges.result()) == all);
      }
    }
  }
}

TEST(SilhouetteTracking, AllDrawnIsTheSearchOfAll)
{
  for (std::uint64_t seed = 1; seed <= 300 && !HasFailure(); ++seed)
  {
    const shadowtest::RandomMesh scene = shadowtest::randomMesh(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ", " + scene.Kind);
    const Subject subject(coreMesh(scene.Surface));
    const Light light{ { scene.Light[0], scene.Light[1], scene.Light[2] }, scene.Light[3] };
    for (const FieldKind kind : bothKinds)
    {
      const SearchResult all = subject.all(light, kind);
      for (const double fraction : { 1.0, 7.0, std::numeric_limits<double>::infinity() })
      {
        const TrackedResult drawn = subject.sample(light, kind, fraction);
        EXPECT_TRUE(drawn.complete);
        EXPECT_EQ(drawn.found.triangles, all.triangles);
        EXPECT_EQ(drawn.found.edges, all.edges);
        EXPECT_EQ(drawn.found.multiplicities, all.multiplicities);
        EXPECT_EQ(drawn.found.tested, all.tested);
      }
    }
  }
}

TEST(SilhouetteTracking, AllButOneDrawnAreDistinct)
{
  const Subject subject(coreMesh(shadowtest::facetted(shadowtest::icosphere(3))));
  for (const FieldKind kind : bothKinds)
  {
    const Light light{ { 0.3, 0.5, 0.8 }, 0.0 };
    ChainOracle oracle(subject, light, kind);
    const double items = static_cast<double>(subject.all(light, kind).tested);
    const TrackedResult drawn = subject.sample(light, kind, 1.0 - 1.0 / items);
    EXPECT_FALSE(drawn.complete);
    EXPECT_TRUE(oracle.pieces(drawn.found) == oracle.pieces(subject.all(light, kind)));
  }
}

TEST(SilhouetteTracking, SamplesAreOfAllOfTheMesh)
{
  const Subject subject(twoSpheres());
  for (const FieldKind kind : bothKinds)
  {
    const Light light{ { 0.3, 0.5, 0.8 }, 0.0 };
    const SearchResult all = subject.all(light, kind);
    const TrackedResult drawn = subject.sample(light, kind, 0.6);
    EXPECT_EQ(drawn.found.triangles, all.triangles);
    EXPECT_EQ(drawn.found.edges, all.edges);
  }
}

TEST(SilhouetteTracking, FindsAllOfConvexMeshes)
{
  const std::vector<std::pair<std::string, TriangleMesh>> meshes{
    { "sphere", coreMesh(shadowtest::icosphere(4)) },
    { "jittered sphere", coreMesh(shadowtest::icosphere(3, 9)) },
    { "ellipsoid", coreMesh(shadowtest::ellipsoid(40, 60)) },
    { "cylinder", coreMesh(shadowtest::cylinder(64, 5)) },
    { "box with creases", coreMesh(shadowtest::box(1.0, 2.0, 0.1)) },
    { "box without normals", coreMesh(shadowtest::weldedBox()) },
    { "two spheres", twoSpheres() },
  };
  shadowtest::Random random(3);
  for (const auto& [name, mesh] : meshes)
  {
    const Subject subject(mesh);
    for (const FieldKind kind : bothKinds)
    {
      std::vector<Light> lights;
      for (int i = 0; i < 40; ++i)
      {
        lights.push_back({ anyDirection(random), 0.0 });
        lights.push_back({ random.uniform(2.5, 10.0) * anyDirection(random), 1.0 });
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        Vec3 direction(0.0);
        direction[axis] = 1.0;
        lights.push_back({ direction, 0.0 });
        lights.push_back({ -4.0 * direction, 1.0 });
      }
      for (std::size_t i = 0; i < lights.size(); ++i)
      {
        SCOPED_TRACE(name + (kind == FieldKind::Face ? ", faces" : ", corners") + ", light " +
          std::to_string(i));
        ChainOracle oracle(subject, lights[i], kind);
        const Pieces all = oracle.pieces(subject.all(lights[i], kind));
        EXPECT_FALSE(all.empty());
        EXPECT_TRUE(oracle.pieces(subject.track(lights[i], kind).found) == all);
      }
    }
  }
}

TEST(SilhouetteTracking, LooksAtLittleOfALargeMesh)
{
  const Subject subject(coreMesh(shadowtest::icosphere(5, 2)));
  for (const FieldKind kind : bothKinds)
  {
    const Light light{ { 0.2, -0.7, 0.4 }, 0.0 };
    const SearchResult all = subject.all(light, kind);
    const TrackedResult tracked = subject.track(light, kind);
    EXPECT_EQ(tracked.found.triangles, all.triangles);
    EXPECT_EQ(tracked.found.edges, all.edges);
    EXPECT_EQ(tracked.found.multiplicities, all.multiplicities);
    EXPECT_GT(tracked.found.tested, all.triangles.size() + all.edges.size());
    EXPECT_LT(tracked.found.tested, all.tested / 4);
    EXPECT_FALSE(tracked.complete);
  }
}

// Without other seeds: what keeps the loops is the last silhouette, and walks from it.
TEST(SilhouetteTracking, KeepsAllLoopsOfAMovingLight)
{
  const Subject subject(twoSpheres());
  for (const FieldKind kind : bothKinds)
  {
    SearchResult last = subject.all({ { 1.0, 0.0, 0.4 }, 0.0 }, kind);
    for (int i = 1; i <= 90; ++i)
    {
      const double angle = 0.07 * i;
      const Light light{ { std::cos(angle), std::sin(angle), 0.4 }, 0.0 };
      const SearchResult all = subject.all(light, kind);
      last = trackSilhouette(subject.searched(), {}, light, kind, &last).found;
      EXPECT_EQ(last.triangles, all.triangles) << i;
      EXPECT_EQ(last.edges, all.edges) << i;
      EXPECT_LT(last.tested, all.tested) << i;
    }
    EXPECT_GT(last.triangles.size() + last.edges.size(), 50u);
  }
}

// Light that comes nearer leaves a sphere's silhouette with nothing of the last one.
TEST(SilhouetteTracking, WalksFromTheLastSilhouette)
{
  const Subject subject(coreMesh(shadowtest::icosphere(4, 3)));
  for (const FieldKind kind : bothKinds)
  {
    const auto light = [](double distance) { return Light{ { 0.0, 0.0, distance }, 1.0 }; };
    SearchResult last = subject.all(light(5.0), kind);
    int disjoint = 0;
    for (double distance = 4.0; distance > 1.2; distance *= 0.85)
    {
      const SearchResult all = subject.all(light(distance), kind);
      const auto isLast = [&](Index i) {
        const auto& items = kind == FieldKind::Face ? last.edges : last.triangles;
        return std::binary_search(items.begin(), items.end(), i);
      };
      const auto& items = kind == FieldKind::Face ? all.edges : all.triangles;
      disjoint += std::none_of(items.begin(), items.end(), isLast);
      last = trackSilhouette(subject.searched(), {}, light(distance), kind, &last).found;
      EXPECT_EQ(last.triangles, all.triangles) << distance;
      EXPECT_EQ(last.edges, all.edges) << distance;
    }
    EXPECT_GE(disjoint, 2);
  }
}

// The field is the same all over a side, up to rounding.
TEST(SilhouetteTracking, WalksCrossFlatRegions)
{
  const int n = 100;
  const Subject subject(fineCube(n));
  for (const FieldKind kind : bothKinds)
  {
    shadowtest::Random random(5);
    int found = 0;
    for (int i = 0; i < 50; ++i)
    {
      const Light light{ anyDirection(random), 0.0 };
      const TrackingSeeds seeds{ { static_cast<Index>(n * n + n) }, {} };
      const SearchResult tracked =
        trackSilhouette(subject.searched(), seeds, light, kind, nullptr).found;
      EXPECT_LE(tracked.edges.size(), subject.all(light, kind).edges.size());
      found += !tracked.edges.empty();
    }
    EXPECT_GE(found, 40);
  }
}

// A sample of nothing that starts from the last silhouette: loops that are where they were stay.
TEST(SilhouetteTracking, SamplesStartFromTheLastSilhouette)
{
  const Subject subject(twoSpheres());
  const Light light{ { 1.0, 0.2, 0.4 }, 0.0 };
  const Light beside{ { 1.0, 0.21, 0.4 }, 0.0 };
  for (const FieldKind kind : bothKinds)
  {
    const SearchResult before = subject.all(light, kind);
    const SearchResult all = subject.all(beside, kind);
    EXPECT_NE(before.triangles.size() + before.edges.size(), 0u);
    const TrackedResult found = subject.sample(beside, kind, 0.0, 1, &before);
    EXPECT_EQ(found.found.triangles, all.triangles);
    EXPECT_EQ(found.found.edges, all.edges);
    EXPECT_FALSE(found.complete);
  }
}

TEST(SilhouetteTracking, TheSeedAloneDecidesTheSample)
{
  const Subject subject(coreMesh(shadowtest::torus(60, 30)));
  const Light light{ { 0.2, 0.4, 1.0 }, 0.0 };
  for (const FieldKind kind : bothKinds)
  {
    std::set<std::size_t> tested, sizes;
    for (std::uint32_t seed = 0; seed < 40; ++seed)
    {
      const auto sample = [&](const RangeLoop& loop) {
        return sampleSilhouette(subject.searched(), light, kind, 0.005, seed, nullptr, loop).found;
      };
      const SearchResult first = sample(serialLoop);
      for (const SearchResult& again : { sample(serialLoop), sample(backwardLoop) })
      {
        EXPECT_EQ(again.triangles, first.triangles);
        EXPECT_EQ(again.edges, first.edges);
        EXPECT_EQ(again.multiplicities, first.multiplicities);
        EXPECT_EQ(again.tested, first.tested);
      }
      tested.insert(first.tested);
      sizes.insert(first.triangles.size() + first.edges.size());
    }
    // Both loops, one, the other one, or none.
    EXPECT_GE(sizes.size(), 2u);
    EXPECT_GE(tested.size(), 4u);
  }
}

TEST(SilhouetteTracking, BordersOfOpenMeshesAreAlwaysFound)
{
  const Subject subject(hemisphere());
  for (const FieldKind kind : bothKinds)
  {
    TrackingSeeds seeds = findTrackingSeeds(subject.searched(), kind);
    EXPECT_FALSE(seeds.starts.empty());
    seeds.starts.clear();
    std::vector<Index> borders;
    for (Index e = 0; e < subject.Edges.edges.size(); ++e)
    {
      if (subject.Edges.sideCount(e) == 1)
      {
        borders.push_back(e);
      }
    }
    EXPECT_GT(borders.size(), 20u);
    EXPECT_EQ(seeds.borders, borders);
    // All lit: nothing but the border.
    const Light above{ { 0.0, 0.0, 1.0 }, 0.0 };
    const TrackedResult found =
      trackSilhouette(subject.searched(), seeds, { { 0.0, 0.0, 100.0 }, 1.0 }, kind, nullptr);
    EXPECT_TRUE(std::includes(
      found.found.edges.begin(), found.found.edges.end(), borders.begin(), borders.end()));
    ChainOracle oracle(subject, above, kind);
    const Pieces all = oracle.pieces(subject.all(above, kind));
    expectWholeComponents(
      oracle, trackSilhouette(subject.searched(), seeds, above, kind, nullptr).found, all);
  }
}

TEST(SilhouetteTracking, NoSilhouetteIsKnownOfSmallMeshesOnly)
{
  for (const FieldKind kind : bothKinds)
  {
    const Light inside{ { 0.1, 0.0, 0.05 }, 1.0 };
    const Subject small(coreMesh(shadowtest::icosphere(1)));
    const Subject large(coreMesh(shadowtest::icosphere(4)));
    for (const Subject* subject : { &small, &large })
    {
      const TrackedResult tracked = subject->track(inside, kind);
      EXPECT_TRUE(tracked.found.triangles.empty());
      EXPECT_TRUE(tracked.found.edges.empty());
      EXPECT_GT(tracked.found.tested, 0u);
      EXPECT_EQ(tracked.complete, subject == &small);
      const TrackedResult sampled = subject->sample(inside, kind, 0.1);
      EXPECT_TRUE(sampled.found.triangles.empty());
      EXPECT_TRUE(sampled.found.edges.empty());
      EXPECT_FALSE(sampled.complete);
    }
  }
}

TEST(SilhouetteTracking, NothingDrawnIsNothingFound)
{
  const Subject subject(coreMesh(shadowtest::icosphere(2)));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const FieldKind kind : bothKinds)
  {
    for (const double fraction : { 0.0, -1.0, nan, 1e-300, 0.4 / 480.0 })
    {
      const TrackedResult found = subject.sample({ { 0.3, 0.1, 1.0 }, 0.0 }, kind, fraction);
      EXPECT_TRUE(found.found.triangles.empty());
      EXPECT_TRUE(found.found.edges.empty());
      EXPECT_EQ(found.found.tested, 0u);
      EXPECT_FALSE(found.complete);
    }
  }
}

TEST(SilhouetteTracking, TheEmptyMeshIsComplete)
{
  const Subject subject((TriangleMesh()));
  for (const FieldKind kind : bothKinds)
  {
    for (const TrackedResult& found :
      { subject.track({}, kind), subject.sample({}, kind, 0.5), subject.sample({}, kind, 0.0) })
    {
      EXPECT_TRUE(found.found.triangles.empty());
      EXPECT_TRUE(found.found.edges.empty());
      EXPECT_TRUE(found.complete);
    }
  }
}
