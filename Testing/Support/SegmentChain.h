/**
 * @brief Silhouettes as chains of directed segments, to be compared whatever their order.
 */
#ifndef shadowtest_SegmentChain_h
#define shadowtest_SegmentChain_h

#include "MeshBuilder.h"

#include <string>
#include <vector>

namespace shadowtest
{
struct DirectedSegment
{
  Vec3 From;
  Vec3 To;
  int Multiplicity; ///< at least 1
};

struct SegmentChain
{
  std::vector<DirectedSegment> Segments;
  /// How clearly lit was told from dark: least |field| over the lengths of normal and ray. Where a
  /// mesh is not exact in doubles (RandomMesh::Exact), a margin near rounding decides nothing.
  double Margin = 1.0;
  /// The same for the windings of triangles (or closed parts) against their normals.
  double WindingMargin = 1.0;
};

/// Adds a segment; a negative multiplicity turns it around, zero leaves it out.
void addSegment(SegmentChain& chain, const Vec3& from, const Vec3& to, int multiplicity);

/// The polylines of a filter's output, with their CellData `Multiplicity`.
SegmentChain chainOf(vtkPolyData* silhouette);

struct ChainDifference
{
  std::size_t Expected = 0; ///< segments of the first chain; ask for some
  std::size_t Actual = 0;
  /// Segments whose multiplicities do not agree, after cutting what overlaps at common points.
  std::size_t Differing = 0;
  double DifferingLength = 0.0;
  std::string Message; ///< numbers, and the first of them

  bool none() const { return this->Differing == 0; }
};

/// Compares as chains: order, starting points and directions of travel with opposite multiplicity
/// do not matter. Points closer than tolerance (absolute) are one.
ChainDifference compareChains(
  const SegmentChain& expected, const SegmentChain& actual, double tolerance);
}

#endif
