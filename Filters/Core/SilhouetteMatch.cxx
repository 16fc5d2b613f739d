#include "SilhouetteMatch.h"

#include <algorithm>
#include <tuple>

namespace shadow
{
namespace
{
/// From, to and multiplicity of a piece, summed over equal ones.
using Count = std::tuple<Index, Index, int>;

std::vector<Count> summed(std::vector<Count> counts)
{
  std::sort(counts.begin(), counts.end());
  std::vector<Count> sums;
  for (const auto& [from, to, multiplicity] : counts)
  {
    if (!sums.empty() && std::get<0>(sums.back()) == from && std::get<1>(sums.back()) == to)
    {
      std::get<2>(sums.back()) += multiplicity;
    }
    else
    {
      sums.emplace_back(from, to, multiplicity);
    }
  }
  return sums;
}
}

Index nodeNumber(const Caster& caster, const SilhouetteChain& chain, Index node)
{
  const std::size_t vertices = caster.mesh().points.size();
  return node == None || node < vertices
    ? node
    : static_cast<Index>(vertices) + chain.crossings[node - vertices].side;
}

Index nodeOfNumber(const Caster& caster, const SilhouetteChain& chain, Index number)
{
  const Index vertices = static_cast<Index>(caster.mesh().points.size());
  if (number < vertices)
  {
    return number;
  }
  const Side side = number - vertices;
  if (side / 3 >= caster.mesh().triangles.size())
  {
    return None;
  }
  const Index edge = caster.edges().triangleEdges[side / 3][side % 3];
  const Index crossing =
    chain.crossingOf(caster, edge, sideNormals(caster.mesh(), caster.edges(), edge, side));
  return crossing == None ? None : vertices + crossing;
}

Match match(const SilhouetteInput& silhouette, const Caster& caster, const SilhouetteChain& chain)
{
  const std::vector<Vec3>& vertices = caster.mesh().points;
  for (std::size_t i = 0; i < silhouette.nodes.size(); ++i)
  {
    const Index node = silhouette.nodes[i];
    if (node == None)
    {
      if (!isFinite(silhouette.points[i]))
      {
        return Match::None;
      }
      continue;
    }
    if (node >= vertices.size() + chain.crossings.size())
    {
      return Match::None;
    }
    const Crossing* crossing =
      node < vertices.size() ? nullptr : &chain.crossings[node - vertices.size()];
    const Vec3 onMesh =
      crossing ? meshPoint(caster.mesh(), caster.edges(), *crossing) : vertices[node];
    if (silhouette.meshPoints[i] != onMesh ||
      silhouette.points[i] != (crossing ? crossing->point : vertices[node]))
    {
      return Match::None;
    }
  }
  std::vector<Count> given;
  for (std::size_t loop = 0; loop < silhouette.multiplicity.size(); ++loop)
  {
    if (silhouette.nodes[silhouette.loopPoints[silhouette.first[loop]]] == None)
    {
      return Match::None;
    }
    forEachStretch(silhouette, loop,
      [&](const Stretch& s)
      {
        given.emplace_back(silhouette.nodes[silhouette.loopPoints[s.begin]],
          silhouette.nodes[silhouette.loopPoints[s.end]], silhouette.multiplicity[loop]);
      });
  }
  std::vector<Count> expected;
  for (const Piece& p : chain.pieces)
  {
    expected.emplace_back(p.from, p.to, p.multiplicity);
  }
  given = summed(std::move(given));
  expected = summed(std::move(expected));
  const auto isBefore = [](const Count& l, const Count& r)
  {
    return std::tie(std::get<0>(l), std::get<1>(l)) < std::tie(std::get<0>(r), std::get<1>(r));
  };
  const bool isPart = std::all_of(given.begin(), given.end(),
    [&](const Count& count)
    {
      const auto same = std::lower_bound(expected.begin(), expected.end(), count, isBefore);
      return same != expected.end() && !isBefore(count, *same) &&
        std::get<2>(count) <= std::get<2>(*same);
    });
  return given == expected ? Match::Whole : isPart ? Match::Part : Match::None;
}
}
