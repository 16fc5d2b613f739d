/// How much the lit and the dark part of each triangle count in the chain whose boundary is the
/// silhouette.
#pragma once

#include "EdgeTable.h"

namespace shadow
{
/// Whether the field that tells lit from dark has a value per face or per corner.
enum class FieldKind
{
  Face,
  Corner
};

/// Which homologous chain serves as the near cap of a shadow volume.
enum class CapSide
{
  Lit,
  Dark
};

/// Multiplicities, with the triangle's own winding, of its lit and its dark part: each -1, 0 or 1.
struct ChainWeight
{
  std::int8_t lit = 1;
  std::int8_t dark = 0;

  int of(bool isLit) const { return isLit ? this->lit : this->dark; }
};

/// A part of the mesh that is connected through edges.
struct MeshPart
{
  bool closed = true;       ///< its triangles form a cycle: every directed edge sums to zero
  bool outward = true;      ///< if closed: its winding encloses a positive volume
  bool normalsAgree = true; ///< its corner normals are on the side that its winding says
};

/// The parts of a mesh and the weights that follow from them.
struct ChainWeights
{
  std::vector<MeshPart> parts;
  std::vector<Index> part;         ///< part of each triangle
  std::vector<ChainWeight> corner; ///< silhouette weights of each triangle, for a corner field

  /// Weights whose boundary is the silhouette. On a closed part the lit side counts once. On any
  /// other part all of it counts, each piece as if it faced the light: the two-sided chain of
  /// Aldridge & Woods 2004, whose winding is the number of triangles between point and light.
  ChainWeight silhouette(FieldKind kind, Index triangle) const;

  /// Weights of a cap with the same boundary as the silhouette: on closed parts the lit or the
  /// dark side alone, elsewhere both.
  ChainWeight cap(FieldKind kind, CapSide side, Index triangle) const;
};

ChainWeights findChainWeights(const TriangleMesh& mesh, const EdgeTable& edges);
}
