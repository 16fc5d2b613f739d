// What is to be said of a mesh's input beside what reading it tells.
#ifndef InputDefects_h
#define InputDefects_h

#include "Geometry.h"
#include "Occurrences.h"

class vtkPolyData;

// The share of the mesh's diagonal that the type of its coordinates should resolve everywhere: a
// tenth of the default tolerance of silhouettes.
constexpr double coarseShare = 1e-5;

struct InputDefects
{
  shadow::Occurrences linesAndVertices; // cells; they occur at their first point
  shadow::Occurrences unusedPoints;     // of no cell
  shadow::Occurrences coarsePoints;     // vertices where coordinates have steps above coarseShare
  double coarsestStep = 0.0;            // of the coordinates of all vertices
};

// The mesh is what was read of the input; its diagonal is that of its bounds.
InputDefects findInputDefects(
  vtkPolyData* input, const shadow::TriangleMesh& mesh, double diagonal);

#endif
