/// What a shadow volume begins with: all of it that is to be extruded.
#pragma once

#include "SilhouetteMatch.h"
#include "VolumeCaps.h"

#include <optional>

namespace shadow
{
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

/// A closed line along which walls begin.
struct VolumeRim
{
  std::vector<Index> points; ///< no two neighbours are the same
  int multiplicity;
};

/// What the near cap is made of.
enum class Caps
{
  None,
  Lit,
  Dark
};

/// Over the chain's nodes, which further points follow. Its boundary is the rims; without a cap
/// that of the gaps is missing. Costs in proportion to the silhouette, but for its cap's whole
/// triangles, which are not kept.
struct NearEnd
{
  const Caster& caster;
  const SilhouetteChain& chain;
  std::optional<NearCap> cap;
  std::vector<Vec3> points;              ///< further points: off the mesh, or between nodes
  std::vector<Index> origins;            ///< of each further point, the silhouette's that it is
  std::vector<VolumeTriangle> triangles; ///< gaps, and what is cap in front of concave contours
  std::vector<VolumeRim> rims;           ///< of the loops that enclose something
  /// Of the ball around the mesh and the silhouette. From there all of their points are seen within
  /// less than a half space.
  bool lightIsOutside = false;

  /// Where a node or further point is.
  Vec3 place(Index node) const
  {
    const TriangleMesh& mesh = this->caster.mesh();
    const std::size_t crossings = this->chain.crossings.size();
    return node < mesh.points.size() ? mesh.points[node]
      : node < mesh.points.size() + crossings
      ? meshPoint(mesh, this->caster.edges(), this->chain.crossings[node - mesh.points.size()])
      : this->points[node - mesh.points.size() - crossings];
  }
};

/// The silhouette must match the chain. Gap triangles fill what is between a smooth silhouette and
/// the mesh.
NearEnd makeNearEnd(const Caster& caster, const SilhouetteChain& chain,
  const SilhouetteInput& silhouette, Caps caps);
}
