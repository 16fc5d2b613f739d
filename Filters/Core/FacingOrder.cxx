#include "FacingOrder.h"

#include "FacingPlane.h"

#include <algorithm>

namespace shadow
{
namespace
{
constexpr unsigned digitBits = 11; ///< of a sort's pass, and of each dimension
constexpr unsigned digits = 4;

/// A code and what it belongs to.
struct Coded
{
  std::uint64_t code;
  Index item;
};

/// Three zeros after each bit of a number of 11 bits.
std::uint64_t spread(std::uint64_t bits)
{
  bits = (bits | (bits << 24)) & 0x000000ff000000ffull;
  bits = (bits | (bits << 12)) & 0x000f000f000f000full;
  bits = (bits | (bits << 6)) & 0x0303030303030303ull;
  return (bits | (bits << 3)) & 0x1111111111111111ull;
}

std::uint64_t mortonCode(const Vec4& plane)
{
  constexpr double most = (1u << digitBits) - 1;
  std::uint64_t code = 0;
  for (int k = 0; k < 4; ++k)
  {
    const double cell = std::min(std::max(0.5 * (plane[k] + 1.0) * most, 0.0), most);
    code |= spread(static_cast<std::uint64_t>(cell)) << k;
  }
  return code;
}

/// By digits from the last to the first; equal codes keep their order.
void sortByCode(std::vector<Coded>& items)
{
  std::array<std::vector<std::size_t>, digits> places;
  for (std::vector<std::size_t>& place : places)
  {
    place.assign((std::size_t(1) << digitBits) + 1, 0);
  }
  constexpr std::uint64_t mask = (1u << digitBits) - 1;
  for (const Coded& item : items)
  {
    for (unsigned d = 0; d < digits; ++d)
    {
      ++places[d][((item.code >> (d * digitBits)) & mask) + 1];
    }
  }
  std::vector<Coded> sorted(items.size());
  for (unsigned d = 0; d < digits; ++d)
  {
    std::vector<std::size_t>& place = places[d];
    for (std::size_t i = 1; i < place.size(); ++i)
    {
      place[i] += place[i - 1];
    }
    for (const Coded& item : items)
    {
      sorted[place[(item.code >> (d * digitBits)) & mask]++] = item;
    }
    items.swap(sorted);
  }
}

/// Numbers below count, by their planes; planeOf(i) gives that of number i.
template <class PlaneOf>
std::vector<Index> facingOrder(std::size_t count, const RangeLoop& loop, const PlaneOf& planeOf)
{
  std::vector<Coded> items(count);
  loop(count, lightGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        items[i] = { mortonCode(planeOf(static_cast<Index>(i))), static_cast<Index>(i) };
      }
    });
  sortByCode(items);
  std::vector<Index> order(count);
  std::transform(
    items.begin(), items.end(), order.begin(), [](const Coded& c) { return c.item; });
  return order;
}

/// Gives what corners refer to numbers in order of first use, and moves it there.
class Renumbering
{
public:
  explicit Renumbering(std::size_t count)
    : NewNumber(count, None)
  {
    this->Order.reserve(count);
  }

  void apply(std::vector<Triangle>& corners)
  {
    for (Triangle& t : corners)
    {
      for (Index& i : t)
      {
        if (this->NewNumber[i] == None)
        {
          this->NewNumber[i] = static_cast<Index>(this->Order.size());
          this->Order.push_back(i);
        }
        i = this->NewNumber[i];
      }
    }
  }

  Index of(Index old) const { return this->NewNumber[old]; }

  /// Leaves out what no corner uses.
  template <class Value>
  void move(std::vector<Value>& values) const
  {
    std::vector<Value> moved(this->Order.size());
    std::transform(this->Order.begin(), this->Order.end(), moved.begin(),
      [&](Index old) { return values[old]; });
    values = std::move(moved);
  }

private:
  std::vector<Index> NewNumber;
  std::vector<Index> Order;
};

template <class Value>
void permute(std::vector<Value>& values, const std::vector<Index>& order)
{
  std::vector<Value> permuted(values.size());
  std::transform(
    order.begin(), order.end(), permuted.begin(), [&](Index old) { return values[old]; });
  values = std::move(permuted);
}
}

void orderTriangles(TriangleMesh& mesh, const RangeLoop& loop)
{
  const std::vector<Vec4> planes = cornerPlanes(mesh, mesh.ball(), loop);
  const std::vector<Index> order = facingOrder(mesh.triangles.size(), loop,
    [&](Index t)
    {
      const Triangle& n = mesh.cornerNormals[t];
      const Vec4 low = glm::min(planes[n[0]], glm::min(planes[n[1]], planes[n[2]]));
      const Vec4 high = glm::max(planes[n[0]], glm::max(planes[n[1]], planes[n[2]]));
      return 0.5 * (low + high);
    });
  permute(mesh.triangles, order);
  permute(mesh.cornerNormals, order);
  Renumbering vertices(mesh.points.size());
  vertices.apply(mesh.triangles);
  vertices.move(mesh.points);
  if (!mesh.sources.empty())
  {
    vertices.move(mesh.sources);
  }
  Renumbering normals(mesh.normals.size());
  normals.apply(mesh.cornerNormals);
  normals.move(mesh.normals);
  normals.move(mesh.normalVertex);
  for (Index& vertex : mesh.normalVertex)
  {
    vertex = vertices.of(vertex);
  }
}

void orderEdges(
  const TriangleMesh& mesh, EdgeTable& edges, const Ball& ball, const RangeLoop& loop)
{
  const std::vector<Vec4> planes = facePlanes(mesh, ball, loop);
  reorderRegularEdges(edges,
    facingOrder(edges.regular, loop,
      [&](Index e)
      { return 0.5 * (planes[edges.sides[2 * e] / 3] + planes[edges.sides[2 * e + 1] / 3]); }));
}
}
