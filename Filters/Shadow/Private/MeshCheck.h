// All that is looked for in a mesh.
#ifndef MeshCheck_h
#define MeshCheck_h

#include "BorderGaps.h"
#include "CasterCache.h"
#include "InputDefects.h"
#include "MeshDefects.h"

struct CheckedMesh
{
  const PreparedCaster& prepared;
  InputDefects input;
  shadow::MeshDefects mesh;
  double diagonal; // of the bounds
  double reach;    // of the gaps, in world units
  shadow::BorderGaps gaps;
  shadow::Occurrences pierced;
};

// Piercings are looked for if they are wanted.
CheckedMesh checkMesh(vtkPolyData* input, const PreparedCaster& prepared, bool intersections);

#endif
