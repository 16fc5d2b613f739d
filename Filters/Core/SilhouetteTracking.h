/// Searches that look at little and may miss loops: tracking, and a random sample.
///
/// Both find where the silhouette runs and follow it from there, so what they find is closed on any
/// mesh, whole components at a time, and a part of what searchAll finds. Values of the field that
/// are no number are dark, as everywhere.
#pragma once

#include "SilhouetteSearch.h"

#include <optional>

namespace shadow
{
/// What a search found that need not find all.
struct TrackedResult
{
  SearchResult found;    ///< of a corner field, edges are those on which pieces were found
  bool complete = false; ///< whether it is known to be all; false where it just may be
};

/// What a caller's searches of these methods found last, by kind of field: where its next ones
/// begin. On one mesh.
struct LastTracked
{
  std::array<std::optional<SearchResult>, 2> found;
};

/// Where tracking begins on a mesh, whatever the light.
struct TrackingSeeds
{
  std::vector<Index> starts;  ///< triangles of each part of the mesh, a few of its larger parts
  std::vector<Index> borders; ///< edges whose pieces do not cancel under one sign; ascending
};

/// O(triangles), once for a mesh and a kind of field.
TrackingSeeds findTrackingSeeds(const SearchedMesh& searched, FieldKind kind);

/// Walks to the silhouette and follows it, after Mustafa et al.'s tracking:
///
/// - The pieces of the last silhouette, if given, are looked at: what still is silhouette is
///   followed, and from the others a walk over at most 16 triangles is tried. It must be of the
///   same mesh and kind of field; best what this function gave for the light before (searchAll's
///   for a corner field holds all link edges, each of which is looked at, too).
/// - The seeds' borders are looked at. Edges of one side on parts that are not closed always are
///   silhouette.
/// - From each of the seeds' starts a walk goes through neighbouring triangles towards smaller
///   |field|, of faces over their normal's length, until it meets the silhouette. It leaves a local
///   minimum by the next smallest value beside what it has been at; triangles whose value is no
///   number, as those without area, come last. It gives up after 64 + 4 sqrt(triangles of the
///   mesh).
///
/// Loops to which no walk leads are missed. Complete only if the walks from the starts have been at
/// all triangles, as on small meshes without a silhouette. In proportion to the silhouette found,
/// the last one, the seeds and the walks.
TrackedResult trackSilhouette(const SearchedMesh& searched, const TrackingSeeds& seeds,
  const Light& light, FieldKind kind, const SearchResult* last);

/// Looks at a random sample, and at the pieces of the last silhouette if given, and follows what is
/// found, after Markosian et al. 1997, "Real-Time Nonphotorealistic Rendering".
///
/// The sample is of all edges for a face field, of all triangles and link edges for a corner field:
/// sampleFraction of them, rounded to the nearest number, one at random of each of as many equal
/// ranges. Below half an item, at 0, less and no number, none; where all are drawn it is searchAll,
/// and complete. A loop of n pieces is missed with a probability of about (1 - sampleFraction)^n.
///
/// The same result for the same seed whatever the loop and the standard library. In proportion to
/// the sample, the silhouette found and the last one, which is as in trackSilhouette.
TrackedResult sampleSilhouette(const SearchedMesh& searched, const Light& light, FieldKind kind,
  double sampleFraction, std::uint32_t seed, const SearchResult* last, const RangeLoop& loop);
}
