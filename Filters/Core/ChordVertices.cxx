#include "ChordVertices.h"

#include "BoxTree.h"
#include "ChainWeights.h"

#include <tuple>

namespace shadow
{
namespace
{
/// Of the greatest coordinate: how far off an edge or a triangle a point may be that was computed
/// on it, by a product and two sums, and what telling that adds.
constexpr double roundings = 16.0 * std::numeric_limits<double>::epsilon();

/// What a segment is on the mesh that it is of, as far as silhouettes say.
struct Chord
{
  Index segment;
  std::array<Vec3, 2> ends;
  bool isOnMesh; ///< the segment is its own chord
};

bool isOnSegment(const Vec3& point, const Vec3& a, const Vec3& b, double error)
{
  const Vec3 along = b - a;
  const double squared = glm::dot(along, along);
  const double share =
    squared > 0.0 ? std::clamp(glm::dot(point - a, along) / squared, 0.0, 1.0) : 0.0;
  return glm::distance(point, a + share * along) <= error;
}

/// A chord and a triangle that holds it: one triangle, or those at an edge that it runs along.
struct Held
{
  Index chord;
  Index caster;
  Index triangle;

  bool operator<(const Held& o) const
  {
    return std::tie(this->chord, this->caster, this->triangle) <
      std::tie(o.chord, o.caster, o.triangle);
  }
};

class ChordFinder
{
public:
  ChordFinder(const ContourLoops& loops, const std::vector<ContourReceiver>& casters)
    : Casters(casters)
  {
    Box bounds;
    for (const ContourReceiver& caster : casters)
    {
      bounds.add(caster.mesh->bounds());
    }
    this->Error = roundings *
      std::max(largestComponent(bounds.low), largestComponent(bounds.high));
    this->addChords(loops);
  }

  const std::vector<Chord>& chords() const { return this->Chords; }

  /// Ascending.
  std::vector<Held> find(const RangeLoop& loop) const
  {
    std::vector<Held> held;
    if (this->Chords.empty())
    {
      return held;
    }
    std::vector<Box> boxes;
    for (const Chord& chord : this->Chords)
    {
      Box box;
      box.add(chord.ends[0]);
      box.add(chord.ends[1]);
      box.low -= Vec3(this->Error);
      box.high += Vec3(this->Error);
      boxes.push_back(box);
    }
    const BoxTree tree(boxes);
    for (std::size_t caster = 0; caster < this->Casters.size(); ++caster)
    {
      const TriangleMesh& mesh = *this->Casters[caster].mesh;
      const auto visit = [&](Index triangle, const auto& found)
      {
        Box box;
        for (const Index vertex : mesh.triangles[triangle])
        {
          box.add(mesh.points[vertex]);
        }
        tree.search([&](const Box& around) { return around.meets(box); },
          [&](Index chord)
          { return !this->holds(mesh, triangle, this->Chords[chord]) || found(chord); });
      };
      const std::vector<Index> holding = selectIndices(mesh.triangles.size(), loop,
        [&](Index triangle)
        {
          bool isHolding = false;
          visit(triangle,
            [&](Index)
            {
              isHolding = true;
              return false;
            });
          return isHolding;
        });
      for (const Index triangle : holding)
      {
        visit(triangle,
          [&](Index chord)
          {
            held.push_back({ chord, static_cast<Index>(caster), triangle });
            return true;
          });
      }
    }
    std::sort(held.begin(), held.end());
    return held;
  }

  /// Whether a chord runs along an edge of a triangle that holds it.
  bool runsAlongEdge(const Held& held) const
  {
    const TriangleMesh& mesh = *this->Casters[held.caster].mesh;
    const Triangle& t = mesh.triangles[held.triangle];
    const std::array<Vec3, 2>& ends = this->Chords[held.chord].ends;
    for (unsigned k = 0; k < 3; ++k)
    {
      const Vec3& a = mesh.points[t[k]];
      const Vec3& b = mesh.points[t[next(k)]];
      if (isOnSegment(ends[0], a, b, this->Error) && isOnSegment(ends[1], a, b, this->Error))
      {
        return true;
      }
    }
    return false;
  }

private:
  void addChords(const ContourLoops& loops)
  {
    for (std::size_t loop = 0; loop < loops.count(); ++loop)
    {
      const std::size_t begin = loops.first[loop];
      const std::size_t end = loops.first[loop + 1];
      for (std::size_t i = begin; i < end && !loops.ofEdges[loop]; ++i)
      {
        if (i + 1 == end && !loops.closed[loop])
        {
          continue;
        }
        const std::size_t to = i + 1 == end ? begin : i + 1;
        const std::array<Vec3, 2> ends{ loops.meshPoints[i], loops.meshPoints[to] };
        this->Chords.push_back({ static_cast<Index>(i), ends,
          glm::distance(ends[0], loops.points[i]) <= this->Error &&
            glm::distance(ends[1], loops.points[to]) <= this->Error });
      }
    }
  }

  bool isWithin(const Vec3& point, const std::array<Vec3, 3>& corners, const Vec3& normal) const
  {
    bool isInside = std::fabs(glm::dot(normal, point - corners[0])) <= this->Error;
    for (unsigned k = 0; k < 3; ++k)
    {
      const Vec3& a = corners[k];
      const Vec3& b = corners[next(k)];
      if (isOnSegment(point, a, b, this->Error))
      {
        return true;
      }
      isInside = isInside && glm::dot(glm::cross(normal, b - a), point - a) > 0.0;
    }
    return isInside;
  }

  bool holds(const TriangleMesh& mesh, Index triangle, const Chord& chord) const
  {
    const Triangle& t = mesh.triangles[triangle];
    const std::array<Vec3, 3> corners{ mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]] };
    const Vec3 normal = unitOrZero(mesh.areaNormal(triangle));
    return this->isWithin(chord.ends[0], corners, normal) &&
      this->isWithin(chord.ends[1], corners, normal);
  }

  const std::vector<ContourReceiver>& Casters;
  double Error;
  std::vector<Chord> Chords;
};

/// Whether the lit side of a chord, on its left in the triangle that it crosses, is behind it as
/// seen from the light, the part being closed.
bool isConcave(const TriangleMesh& mesh, Index triangle, const std::array<Vec3, 2>& chord,
  const MeshPart& part, const Light& light)
{
  const Vec3 left = glm::cross(mesh.areaNormal(triangle), chord[1] - chord[0]);
  const double towards = glm::dot(left, light.toward(chord[0]));
  return part.closed && (part.outward ? towards < 0.0 : towards > 0.0);
}
}

ChordVertices::ChordVertices(const ContourLoops& loops,
  const std::vector<ContourReceiver>& casters, const Light& light, const RangeLoop& loop)
{
  const ChordFinder finder(loops, casters);
  const std::vector<Held> held = finder.find(loop);
  std::vector<Index> firstVertex{ 0 };
  for (const ContourReceiver& caster : casters)
  {
    firstVertex.push_back(firstVertex.back() + static_cast<Index>(caster.mesh->points.size()));
  }
  std::vector<ChainWeights> weights;
  for (std::size_t i = 0; i < casters.size() && !held.empty(); ++i)
  {
    weights.push_back(findChainWeights(*casters[i].mesh, *casters[i].edges));
  }
  std::vector<std::vector<Index>> around(loops.points.size());
  for (std::size_t begin = 0, end = 0; begin < held.size(); begin = end)
  {
    const Chord& chord = finder.chords()[held[begin].chord];
    const Index first = held[begin].triangle;
    const TriangleMesh& mesh = *casters[held[begin].caster].mesh;
    const ChainWeights& own = weights[held[begin].caster];
    std::size_t lit = 0;
    bool isAlongEdge = chord.isOnMesh;
    for (; end < held.size() && held[end].chord == held[begin].chord &&
         held[end].caster == held[begin].caster;
         ++end)
    {
      lit += isLit(faceField(mesh, light, held[end].triangle));
      isAlongEdge = isAlongEdge && finder.runsAlongEdge(held[end]);
    }
    const bool turns = end - begin == 1 || (lit > 0 && lit < end - begin);
    const bool isBare = isAlongEdge
      ? turns
      : end - begin == 1 && isConcave(mesh, first, chord.ends, own.parts[own.part(first)], light);
    for (std::size_t i = begin; i < end && !isBare; ++i)
    {
      for (const Index vertex : mesh.triangles[held[i].triangle])
      {
        around[chord.segment].push_back(firstVertex[held[i].caster] + vertex);
      }
    }
  }
  this->First.push_back(0);
  for (const auto& vertices : around)
  {
    this->Vertices.insert(this->Vertices.end(), vertices.begin(), vertices.end());
    this->First.push_back(this->Vertices.size());
  }
  this->All = this->Vertices;
  std::sort(this->All.begin(), this->All.end());
  this->All.erase(std::unique(this->All.begin(), this->All.end()), this->All.end());
}

bool ChordVertices::touches(Index segment, const Triangle& triangle) const
{
  const auto begin = this->Vertices.begin();
  return std::any_of(begin + static_cast<std::ptrdiff_t>(this->First[segment]),
    begin + static_cast<std::ptrdiff_t>(this->First[segment + 1]),
    [&](Index vertex)
    { return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end(); });
}

bool ChordVertices::touchesAny(const Triangle& triangle) const
{
  return std::any_of(triangle.begin(), triangle.end(),
    [&](Index vertex) { return std::binary_search(this->All.begin(), this->All.end(), vertex); });
}
}
