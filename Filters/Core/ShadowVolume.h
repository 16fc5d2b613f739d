/// The shadow volume of a caster: caps, gaps, walls and far cap as one closed chain of triangles.
#pragma once

#include "Caster.h"

namespace shadow
{
/// A silhouette as polylines: what a silhouette filter gave.
struct SilhouetteInput
{
  std::vector<Vec3> points;
  std::vector<Vec3> meshPoints;
  std::vector<Index> nodes;       ///< node of each point, None between nodes
  std::vector<Index> loopPoints;  ///< points of the loops, loop after loop, the first not repeated
  std::vector<std::size_t> first; ///< where each loop begins, and the end
  std::vector<int> multiplicity;  ///< of each loop
};

/// A number for a node that is the same however the silhouette was searched for: a vertex's own, and
/// behind these for a crossing that of the first side that crosses there.
Index nodeNumber(const Caster& caster, const SilhouetteChain& chain, Index node);

/// The chain's node of that number, or None.
Index nodeOfNumber(const Caster& caster, const SilhouetteChain& chain, Index number);

/// How much of a chain polylines are.
enum class Match
{
  None, ///< they are another mesh's, or another light's
  Part, ///< some pieces are missing, as an incomplete search may leave them out
  Whole
};

/// Whether the polylines are the silhouette that the chain describes: nodes of it at the same places
/// on the mesh, joined by its pieces.
Match match(const SilhouetteInput& silhouette, const Caster& caster, const SilhouetteChain& chain);

enum class VolumePart : std::uint8_t
{
  Cap,
  Gap,
  Wall,
  FarCap
};

struct VolumeTriangle
{
  Triangle points;
  VolumePart part;
  int multiplicity; ///< at least 1
};

/// The walls along a loop as one strip of triangles: a loop's point, where its shadow ends, the next
/// point, and so on around; the first two come again at the end.
struct WallStrip
{
  std::vector<Index> points;
  int multiplicity;
};

struct ShadowVolume
{
  std::vector<Vec4> points; ///< homogeneous, w = 1, or w = 0 at infinity
  std::vector<VolumeTriangle> triangles;
  std::vector<WallStrip> strips; ///< if wanted: of long loops, which then have no wall triangles
  /// For each point at infinity the finite point whose shadow ends there; None for those that
  /// belong to no single one. firstInfinite + i is the point of origin[i].
  std::size_t firstInfinite = 0;
  std::vector<Index> origin;
};

/// What the near cap is made of.
enum class Caps
{
  None,
  Lit,
  Dark
};

struct VolumeSettings
{
  Caps caps = Caps::Dark;
  bool wallStrips = false; ///< of a point's light; a direction's walls have one point in common
};

/// Extrudes to infinity. The silhouette must match the chain. The sum of all directed edges, with
/// multiplicity, is zero unless caps are left out, or pieces of the silhouette missing.
///
/// Gap triangles fill what is between a smooth silhouette and the mesh. Walls are quads to
/// infinity for a point light and triangles for a directional one, all of whose shadows end at
/// one point there; only a point light has a far cap. With the light outside the ball around the
/// caster this is a fan at infinity, otherwise all of the near cap is projected there: then it
/// covers the sphere at infinity as often as the light is enclosed by the caster.
ShadowVolume extrude(const Caster& caster, const SilhouetteChain& chain,
  const SilhouetteInput& silhouette, const VolumeSettings& settings);
}
