#include "MeshCheck.h"

#include "PiercedTriangles.h"
#include "SMPRangeLoop.h"

#include <algorithm>
#include <cmath>

namespace
{
// Gaps up to this share of the mesh's diagonal are taken for seams that rounding has opened: some
// ten steps of a float as large as the mesh.
constexpr double gapShare = 1e-6;

// Two points that were to be one may be rounded apart by one step a coordinate, and a few more
// where they come out of different formulas.
constexpr double gapSteps = 4.0;

// Without squares, which leave the range of doubles on meshes of extreme sizes.
double diagonalOf(const shadow::TriangleMesh& mesh)
{
  if (mesh.points.empty())
  {
    return 0.0;
  }
  const shadow::Box bounds = mesh.bounds();
  const shadow::Vec3 size = bounds.high - bounds.low;
  return std::hypot(size.x, size.y, size.z);
}
}

CheckedMesh checkMesh(vtkPolyData* input, const PreparedCaster& prepared, bool intersections)
{
  const shadow::Caster& caster = prepared.caster;
  const shadow::TriangleMesh& mesh = caster.mesh();
  const double diagonal = diagonalOf(mesh);
  const InputDefects found = findInputDefects(input, mesh, diagonal);
  const double reach = std::max(gapShare * diagonal, gapSteps * found.coarsestStep);
  return { prepared, found, shadow::findMeshDefects(mesh, caster.edges(), caster.weights()),
    diagonal, reach, shadow::findBorderGaps(mesh, caster.edges(), reach, smpRangeLoop),
    intersections ? shadow::findPiercedTriangles(mesh, smpRangeLoop) : shadow::Occurrences() };
}
