#include "LitRegions.h"

#include "CasterCuts.h"
#include "CellIllumination.h"
#include "ContourCasting.h"

#include <numeric>
#include <tuple>

namespace shadow
{
namespace
{
/// As near to a triangle's plane, as a share of the scene, a caster touches it: what contours and
/// rays take for nothing is less.
constexpr double touchShare = 1e-9;

/// Cuts in one order for each triangle, as good as random: then cells are not many more than cuts
/// (Paterson & Yao 1990).
void shuffleByTriangle(std::vector<CellCut>& cuts)
{
  std::vector<std::pair<std::uint64_t, Index>> keys;
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    // The high bits of a product with the golden ratio spread neighbouring numbers.
    const std::uint64_t spread = std::uint32_t(i * 2654435769u);
    keys.emplace_back((std::uint64_t(cuts[i].triangle) << 32) | spread, static_cast<Index>(i));
  }
  std::sort(keys.begin(), keys.end());
  std::vector<CellCut> sorted;
  for (const auto& [key, place] : keys)
  {
    sorted.push_back(cuts[place]);
  }
  cuts.swap(sorted);
}

/// The visible parts of contours, in an order that does not depend on how they were searched for.
void addContours(const ReceiverContours& contours, std::vector<CellCut>& cuts)
{
  std::vector<Index> order(contours.pieces.size());
  std::iota(order.begin(), order.end(), Index(0));
  std::sort(order.begin(), order.end(),
    [&](Index a, Index b)
    {
      const ContourPiece& first = contours.pieces[a];
      const ContourPiece& second = contours.pieces[b];
      return std::tie(first.triangle, first.segment) < std::tie(second.triangle, second.segment);
    });
  for (const Index i : order)
  {
    const Vec3& a = contours.straight[i].from.point;
    const Vec3& b = contours.straight[i].to.point;
    const double length = glm::distance(a, b);
    const auto add = [&](double from, double to) {
      if (to > from)
      {
        cuts.push_back(
          { contours.pieces[i].triangle, glm::mix(a, b, from), glm::mix(a, b, to), ShadowOnLeft });
      }
    };
    double at = 0.0;
    for (std::size_t k = contours.hidden.begin(i); k < contours.hidden.end(i); ++k)
    {
      const auto& [from, to] = contours.hidden.spans[k];
      if ((to - from) * length >= contours.hidden.least || from == 0.0 || to == 1.0)
      {
        add(at, from);
        at = to;
      }
    }
    add(at, 1.0);
  }
}

/// Finds the weights of cells' points from those that they are between.
std::vector<RegionPoint> weighted(const std::vector<CellPoint>& points)
{
  std::vector<RegionPoint> result;
  result.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const CellPoint& point = points[i];
    RegionPoint region{ point.place, { static_cast<Index>(i), None, None }, { 1.0, 0.0, 0.0 } };
    if (point.from != None)
    {
      region.vertices = { None, None, None };
      region.weights = Vec3(0.0);
      const std::pair<Index, double> parents[] = { { point.from, 1.0 - point.share },
        { point.to, point.share } };
      for (const auto& [parent, share] : parents)
      {
        for (glm::length_t k = 0; k < 3 && result[parent].vertices[std::size_t(k)] != None; ++k)
        {
          const Index vertex = result[parent].vertices[std::size_t(k)];
          // All are of one triangle, so there is a place for each.
          glm::length_t at = 0;
          while (
            region.vertices[std::size_t(at)] != None && region.vertices[std::size_t(at)] != vertex)
          {
            ++at;
          }
          region.vertices[std::size_t(at)] = vertex;
          region.weights[at] += share * result[parent].weights[k];
        }
      }
    }
    result.push_back(region);
  }
  return result;
}

/// The largest cells all of whose parts are the same, in the order of triangles.
std::vector<Index> uniformCells(
  const ReceiverCells& cells, std::size_t triangles, std::vector<Illumination>& illumination)
{
  std::vector<bool> isUniform(cells.count());
  // Halves come after their whole.
  for (std::size_t i = cells.count(); i-- > 0;)
  {
    const Index cell = static_cast<Index>(i);
    isUniform[i] = !cells.isCut(cell);
    if (cells.isCut(cell))
    {
      const Index half = cells.halves(cell);
      isUniform[i] =
        isUniform[half] && isUniform[half + 1] && illumination[half] == illumination[half + 1];
      illumination[i] = illumination[half];
    }
  }
  std::vector<Index> uniform;
  std::vector<Index> waiting;
  for (std::size_t triangle = 0; triangle < triangles; ++triangle)
  {
    waiting.push_back(cells.whole(static_cast<Index>(triangle)));
    while (!waiting.empty())
    {
      const Index cell = waiting.back();
      waiting.pop_back();
      if (isUniform[cell])
      {
        uniform.push_back(cell);
        continue;
      }
      waiting.push_back(cells.halves(cell) + 1);
      waiting.push_back(cells.halves(cell));
    }
  }
  return uniform;
}

LitRegions regionsOf(
  const ReceiverCells& cells, std::size_t triangles, std::vector<Illumination> illumination)
{
  LitRegions regions;
  regions.points = weighted(cells.edges().points());
  for (const Index cell : uniformCells(cells, triangles, illumination))
  {
    const std::vector<CellSide> sides = cells.sides(cell);
    for (const CellSide& side : sides)
    {
      regions.corners.push_back(cells.edges().start(side));
    }
    regions.first.push_back(regions.corners.size());
    regions.triangles.push_back(cells.triangle(cell));
    regions.illumination.push_back(illumination[cell]);
    regions.areas[static_cast<std::size_t>(illumination[cell])] +=
      0.5 * glm::length(areaNormal(sides, cells.edges()));
  }
  return regions;
}
}

std::vector<LitRegions> findLitRegions(
  const ContourScene& scene, TreeBuilder builder, const RangeLoop& loop, ContourReport& report)
{
  std::vector<LitRegions> all;
  const ContourCasting casting(scene, builder, BlockerSides::All, loop, report);
  if (report.lightPoint != None)
  {
    return all;
  }
  const CasterCuts casters(scene.casters, scene.receivers, touchShare * casting.frame().size());
  for (std::size_t i = 0; i < scene.receivers.size(); ++i)
  {
    const ReceiverContours contours = casting.contours(static_cast<Index>(i));
    std::vector<CellCut> cuts = casters.cuts(*contours.receiver, loop);
    addContours(contours, cuts);
    shuffleByTriangle(cuts);
    ReceiverCells cells(scene.receivers[i]);
    for (const CellCut& cut : cuts)
    {
      cells.cut(cut);
    }
    all.push_back(regionsOf(cells, scene.receivers[i].mesh->triangles.size(),
      illuminate(cells, *contours.receiver, casting.blockers(), loop)));
  }
  return all;
}
}
