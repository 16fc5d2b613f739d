/// The near cap of a shadow volume: whole triangles of the mesh, and parts of the mixed ones.
#pragma once

#include "Caster.h"

#include <algorithm>
#include <functional>

namespace shadow
{
/// The lit or the dark part of a triangle that the silhouette crosses, counter-clockwise over the
/// chain's nodes, with every crossing on its edges, those of the other sides too, so that
/// neighbours share all points.
std::vector<Index> partOfTriangle(
  const Caster& caster, const SilhouetteChain& chain, Index triangle, bool lit);

/// The cap, whose boundary is the chain's pieces. Each triangle counts once. To have it costs in
/// proportion to the chain; its whole triangles are found by looking at all of the mesh.
class NearCap
{
public:
  NearCap(const Caster& caster, const SilhouetteChain& chain, CapSide side);

  /// A triangle over the chain's nodes, of the part of one of the mesh that the silhouette crosses.
  struct Part
  {
    Index triangle;
    Triangle nodes;
  };

  /// Ascending by triangle.
  const std::vector<Part>& parts() const { return this->Parts; }

  /// Calls visit(triangle, vertices) for each whole one of the mesh's triangles [begin, end), in
  /// their order.
  template <class Visit>
  void forEachWhole(Index begin, Index end, const Visit& visit) const
  {
    const ChainWeights& weights = this->TheCaster.weights();
    const FieldKind kind = this->Chain.field.kind();
    auto crossed = std::lower_bound(this->Crossed.begin(), this->Crossed.end(), begin);
    for (Index t = begin; t < end; ++t)
    {
      if (crossed != this->Crossed.end() && *crossed == t)
      {
        ++crossed;
        continue;
      }
      const ChainWeight weight = weights.cap(kind, t, this->OnDarkField[weights.part(t)]);
      const int times = weight.of(this->isLit(t));
      if (times != 0)
      {
        visit(t, turned(this->TheCaster.mesh().triangles[t], times));
      }
    }
  }

  template <class Visit>
  void forEachWhole(const Visit& visit) const
  {
    this->forEachWhole(0, static_cast<Index>(this->TheCaster.mesh().triangles.size()), visit);
  }

  /// Calls visit(triangle) for all of the cap, over nodes, in the order of the mesh's triangles.
  template <class Visit>
  void forEach(const Visit& visit) const
  {
    auto part = this->Parts.begin();
    const auto visitPartsBefore = [&](Index triangle)
    {
      for (; part != this->Parts.end() && part->triangle < triangle; ++part)
      {
        visit(part->nodes);
      }
    };
    this->forEachWhole(
      [&](Index triangle, const Triangle& vertices)
      {
        visitPartsBefore(triangle);
        visit(vertices);
      });
    visitPartsBefore(None);
  }

  /// Writes the whole triangles' vertices, by their numbers in TriangleMesh::sources, where
  /// allocate(number of triangles) says.
  void writeWhole(
    const RangeLoop& loop, const std::function<Triangle*(std::size_t)>& allocate) const;

private:
  /// A weight of -1 turns the triangle's winding around. The first corner stays the first, as the
  /// mesh has it, so that rasterisers that interpolate from it give the same depth.
  static Triangle turned(const Triangle& t, int weight)
  {
    return weight > 0 ? t : Triangle{ t[0], t[2], t[1] };
  }

  bool isLit(Index triangle) const
  {
    const LightField& field = this->Chain.field;
    return field.lit(field.kind() == FieldKind::Face
        ? triangle
        : this->TheCaster.mesh().cornerNormals[triangle][0]);
  }

  void findCrossed();
  void addParts(Index triangle);

  const Caster& TheCaster;
  const SilhouetteChain& Chain;
  std::vector<bool> OnDarkField; ///< of each part of the mesh
  std::vector<Index> Crossed;    ///< triangles at edges with crossings, ascending
  std::vector<Part> Parts;
};
}
