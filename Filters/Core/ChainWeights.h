/// How much the lit and the dark part of each triangle count in the chain whose boundary is the
/// silhouette.
#pragma once

#include "EdgeTable.h"
#include "LightFacing.h"

namespace shadow
{
/// Which homologous chain serves as the near cap of a shadow volume.
enum class CapSide
{
  Lit,
  Dark
};

/// Multiplicities of a lit and of a dark part: of a triangle, with its own winding, each -1, 0
/// or 1.
struct ChainWeight
{
  int lit = 1;
  int dark = 0;

  int of(bool isLit) const { return isLit ? this->lit : this->dark; }

  bool isZero() const { return this->lit == 0 && this->dark == 0; }

  ChainWeight operator-() const { return { -this->lit, -this->dark }; }
};

/// A part of the mesh that is connected through edges.
struct MeshPart
{
  bool closed = true;       ///< its triangles form a cycle: every directed edge sums to zero
  bool outward = true;      ///< if closed: its winding encloses a positive volume
  bool normalsAgree = true; ///< its corner normals are on the side that its winding says
};

/// The parts of a mesh and the weights that follow from them.
///
/// The boundary of the weighted chain is the silhouette. On a closed part the lit side counts once.
/// On any other part all of it counts, each piece as if it faced the light: the two-sided chain of
/// Aldridge & Woods 2004, whose winding is the number of triangles between point and light.
struct ChainWeights
{
  std::vector<MeshPart> parts;
  std::vector<Index> parting;         ///< part of each triangle; empty if there is one part at most
  std::vector<std::uint8_t> agreeing; ///< whether each triangle's corner normals are on the side
                                      ///< that its winding says; empty if all are

  Index part(Index triangle) const { return this->parting.empty() ? 0 : this->parting[triangle]; }

  /// For a face field.
  ChainWeight face(Index triangle) const
  {
    return this->parts[this->part(triangle)].closed ? ChainWeight{ 1, 0 } : ChainWeight{ 1, -1 };
  }

  /// For a corner field.
  ChainWeight corner(Index triangle) const
  {
    const ChainWeight weight = this->face(triangle);
    return this->agreeing.empty() || this->agreeing[triangle] != 0 ? weight : -weight;
  }

  ChainWeight silhouette(FieldKind kind, Index triangle) const
  {
    return kind == FieldKind::Face ? this->face(triangle) : this->corner(triangle);
  }

  /// Whether a triangle's corner normals point out of its part, if that is closed; all others'
  /// say themselves where out is.
  bool cornersPointOutward(Index triangle) const
  {
    const MeshPart& own = this->parts[this->part(triangle)];
    return !own.closed || own.outward == own.normalsAgree;
  }

  /// For each part whether its cap is what the field calls dark, reversed. Lit and dark part of a
  /// closed part are together without boundary: one and the other one reversed bound the same.
  /// Parts that are not closed have all of themselves as the cap, with the silhouette's weights.
  std::vector<bool> capsOnDarkField(FieldKind kind, CapSide side) const;

  /// Weights of a triangle's cap, given its part's entry of capsOnDarkField.
  ChainWeight cap(FieldKind kind, Index triangle, bool onDarkField) const
  {
    const ChainWeight weight = this->silhouette(kind, triangle);
    return onDarkField ? ChainWeight{ 0, -weight.lit } : weight;
  }
};

/// Sum over a triangle's corners of normal times area normal: positive if they are on one side; 0
/// where there are no normals.
double normalAgreement(const TriangleMesh& mesh, Index triangle);

ChainWeights findChainWeights(const TriangleMesh& mesh, const EdgeTable& edges);
}
