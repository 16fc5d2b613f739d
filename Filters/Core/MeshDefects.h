/// What is wrong with a mesh, as far as its triangles tell.
#pragma once

#include "ChainWeights.h"
#include "Occurrences.h"

namespace shadow
{
/// A triangle is a sliver if its longest side is at least so many times its height over that side.
constexpr double sliverAspect = 1000.0;

/// Edges occur in their middle, triangles in theirs, a part in that of its least triangle.
struct MeshDefects
{
  Occurrences borderEdges;       ///< with one side
  Occurrences nonManifoldEdges;  ///< with more than two sides
  Occurrences inconsistentEdges; ///< with two sides that run in the same direction

  /// With the three vertices of another one, in any order; of each set all but one.
  Occurrences duplicateTriangles;
  Occurrences flatTriangles; ///< no higher than what rounding does to their coordinates in double
  Occurrences slivers;       ///< sliverAspect, and not flat

  Occurrences insideOutParts; ///< closed, with a negative volume

  /// Triangles whose corner normals' signs are turned, as these are against the winding: of a
  /// closed part all if they are so on the whole, of others each one that is.
  Occurrences turnedNormals;
  /// Triangles of closed parts whose corner normals are on another side of the winding than those
  /// of the part on the whole. Flat ones have no side.
  Occurrences contraryNormals;

  std::size_t closedParts = 0;
  std::size_t twoSidedTriangles = 0; ///< those of parts that are not closed
};

/// The mesh has corner normals. O(n log n).
MeshDefects findMeshDefects(
  const TriangleMesh& mesh, const EdgeTable& edges, const ChainWeights& weights);
}
