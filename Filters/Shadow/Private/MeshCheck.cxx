#include "MeshCheck.h"

#include "PiercedTriangles.h"
#include "SMPRangeLoop.h"

#include <algorithm>

namespace
{
// Gaps up to this share of the mesh's diagonal are taken for seams that rounding has opened: some
// ten steps of a float as large as the mesh.
constexpr double gapShare = 1e-6;

// Two points that were to be one may be rounded apart by one step a coordinate, and a few more
// where they come out of different formulas.
constexpr double gapSteps = 4.0;
}

CheckedMesh checkMesh(vtkPolyData* input, const PreparedCaster& prepared, bool intersections)
{
  const shadow::Caster& caster = prepared.caster;
  const shadow::TriangleMesh& mesh = caster.mesh();
  const double diagonal = 2.0 * caster.radius();
  const InputDefects found = findInputDefects(input, mesh, diagonal);
  const double reach = std::max(gapShare * diagonal, gapSteps * found.coarsestStep);
  return { prepared, found, shadow::findMeshDefects(mesh, caster.edges(), caster.weights()), reach,
    shadow::findBorderGaps(mesh, caster.edges(), reach, smpRangeLoop),
    intersections ? shadow::findPiercedTriangles(mesh, smpRangeLoop) : shadow::Occurrences() };
}
