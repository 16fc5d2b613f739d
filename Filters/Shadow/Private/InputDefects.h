// What is to be said of a mesh's input beside what reading it tells.
#ifndef InputDefects_h
#define InputDefects_h

#include "Geometry.h"
#include "Occurrences.h"

class vtkPolyData;

// The share of the mesh's diagonal that the type of its coordinates should resolve everywhere: a
// tenth of the default tolerance of silhouettes.
constexpr double coarseShare = 1e-5;

// Between these sizes the core's products of up to four lengths, and of more that a distant light
// takes part in, stay far within the range of doubles (1e-308 to 1e308).
constexpr double leastSize = 1e-50;
constexpr double largestSize = 1e50;

struct InputDefects
{
  shadow::Occurrences linesAndVertices; // cells; they occur at their first point that exists
  shadow::Occurrences unusedPoints;     // of no cell
  shadow::Occurrences coarsePoints;     // vertices where coordinates have steps above coarseShare
  shadow::Occurrences extremePoints;    // vertices beyond largestSize; all below leastSize
  double coarsestStep = 0.0;            // of the coordinates of all vertices
};

// The mesh is what was read of the input; its diagonal is that of its bounds. Vertices are all
// at one place where this is zero: they are not coarse or extreme then.
InputDefects findInputDefects(
  vtkPolyData* input, const shadow::TriangleMesh& mesh, double diagonal);

#endif
