#include "SegmentChain.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace shadowtest
{
namespace
{
using EdgeKey = std::pair<std::size_t, std::size_t>;

double length(const Vec3& v)
{
  return std::sqrt(dot(v, v));
}

// Points within the tolerance of each other, and of those in turn, get one number.
class Places
{
public:
  explicit Places(double tolerance)
    : Tolerance(tolerance)
  {
  }

  std::size_t of(const Vec3& point)
  {
    const Cell cell = this->cellOf(point);
    std::size_t found = None;
    for (int i = 0; i < 27; ++i)
    {
      const Cell near{ cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1 };
      const auto [begin, end] = this->Cells.equal_range(near);
      for (auto entry = begin; entry != end; ++entry)
      {
        if (length(this->Points[entry->second] - point) <= this->Tolerance)
        {
          const std::size_t other = this->root(entry->second);
          if (found != None)
          {
            this->Parents[other] = found;
          }
          else
          {
            found = other;
          }
        }
      }
    }
    const std::size_t added = this->Points.size();
    this->Points.push_back(point);
    this->Parents.push_back(found == None ? added : found);
    this->Cells.emplace(cell, added);
    return added;
  }

  std::size_t root(std::size_t i) const
  {
    while (this->Parents[i] != i)
    {
      i = this->Parents[i];
    }
    return i;
  }

  const Vec3& point(std::size_t i) const { return this->Points[i]; }

private:
  using Cell = std::array<double, 3>; // whole numbers, of any size
  Cell cellOf(const Vec3& p) const
  {
    return { std::floor(p[0] / this->Tolerance), std::floor(p[1] / this->Tolerance),
      std::floor(p[2] / this->Tolerance) };
  }

  static constexpr std::size_t None = static_cast<std::size_t>(-1);
  double Tolerance;
  std::vector<Vec3> Points;
  std::vector<std::size_t> Parents;
  std::multimap<Cell, std::size_t> Cells;
};

using Net = std::map<EdgeKey, int>;

void addTo(Net& net, std::size_t from, std::size_t to, int multiplicity)
{
  if (from != to)
  {
    net[std::minmax(from, to)] += from < to ? multiplicity : -multiplicity;
  }
}

void dropZeros(Net& net)
{
  for (auto entry = net.begin(); entry != net.end();)
  {
    entry = entry->second == 0 ? net.erase(entry) : std::next(entry);
  }
}

// Cuts segments at the ends of others that lie on them.
Net cutAtEnds(const Net& net, const Places& places, double tolerance)
{
  std::vector<std::size_t> ends;
  for (const auto& entry : net)
  {
    ends.push_back(entry.first.first);
    ends.push_back(entry.first.second);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  Net result;
  for (const auto& entry : net)
  {
    const Vec3 a = places.point(entry.first.first);
    const Vec3 edge = places.point(entry.first.second) - a;
    std::vector<std::pair<double, std::size_t>> cuts{ { 0.0, entry.first.first },
      { 1.0, entry.first.second } };
    for (std::size_t end : ends)
    {
      const Vec3 offset = places.point(end) - a;
      const double u = dot(offset, edge) / dot(edge, edge);
      if (u > 0.0 && u < 1.0 && end != entry.first.first && end != entry.first.second &&
        length(offset - u * edge) <= 2.0 * tolerance)
      {
        cuts.push_back({ u, end });
      }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 1; i < cuts.size(); ++i)
    {
      addTo(result, cuts[i - 1].second, cuts[i].second, entry.second);
    }
  }
  dropZeros(result);
  return result;
}
}

void addSegment(SegmentChain& chain, const Vec3& from, const Vec3& to, int multiplicity)
{
  if (multiplicity > 0)
  {
    chain.Segments.push_back({ from, to, multiplicity });
  }
  else if (multiplicity < 0)
  {
    chain.Segments.push_back({ to, from, -multiplicity });
  }
}

SegmentChain chainOf(vtkPolyData* silhouette)
{
  SegmentChain chain;
  vtkDataArray* multiplicities = silhouette->GetCellData()->GetArray("Multiplicity");
  auto cell = vtk::TakeSmartPointer(silhouette->GetLines()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    const vtkIdType id = silhouette->GetNumberOfVerts() + cell->GetCurrentCellId();
    const int multiplicity = multiplicities ? static_cast<int>(multiplicities->GetTuple1(id)) : 1;
    for (vtkIdType i = 1; i < size; ++i)
    {
      Vec3 from;
      Vec3 to;
      silhouette->GetPoint(ids[i - 1], from.data());
      silhouette->GetPoint(ids[i], to.data());
      addSegment(chain, from, to, multiplicity);
    }
  }
  return chain;
}

ChainDifference compareChains(
  const SegmentChain& expected, const SegmentChain& actual, double tolerance)
{
  ChainDifference difference;
  difference.Expected = expected.Segments.size();
  difference.Actual = actual.Segments.size();
  Places places(tolerance);
  std::vector<std::array<std::size_t, 2>> ends;
  for (const SegmentChain* chain : { &expected, &actual })
  {
    for (const DirectedSegment& segment : chain->Segments)
    {
      const std::size_t from = places.of(segment.From);
      ends.push_back({ from, places.of(segment.To) });
    }
  }
  Net net;
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    const bool first = i < expected.Segments.size();
    const int multiplicity = first ? expected.Segments[i].Multiplicity
                                   : -actual.Segments[i - expected.Segments.size()].Multiplicity;
    addTo(net, places.root(ends[i][0]), places.root(ends[i][1]), multiplicity);
  }
  dropZeros(net);
  net = cutAtEnds(net, places, tolerance);
  difference.Differing = net.size();
  difference.Message = std::to_string(difference.Expected) + " segments expected, " +
    std::to_string(difference.Actual) + " found, " + std::to_string(difference.Differing) +
    " differ";
  for (const auto& entry : net)
  {
    const Vec3 a = places.point(entry.first.first);
    const Vec3 b = places.point(entry.first.second);
    if (difference.DifferingLength == 0.0)
    {
      auto text = [](const Vec3& p) {
        return "(" + std::to_string(p[0]) + ", " + std::to_string(p[1]) + ", " +
          std::to_string(p[2]) + ")";
      };
      difference.Message += "; the first from " + text(a) + " to " + text(b) +
        ", expected - found multiplicity " + std::to_string(entry.second);
    }
    difference.DifferingLength += length(b - a);
  }
  return difference;
}
}
