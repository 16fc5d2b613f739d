/**
 * What the commands that write geometry of a mesh and a light share: their arguments, and one run
 * of mesh, silhouette and what comes after it.
 */
#ifndef GeometryCommand_h
#define GeometryCommand_h

#include "Numbers.h"
#include "SilhouetteOptions.h"
#include "Statistics.h"

#include <functional>
#include <string>
#include <vector>

namespace CLI
{
class App;
}
class vtkPolyData;
class vtkPolyDataAlgorithm;
class vtkSmoothLightSilhouette;

struct GeometryArguments
{
  std::string Mesh;
  std::string Output;
  Homogeneous Light = { 0.0, 0.0, 1.0, 0.0 };
  SilhouetteOptions Silhouette;
  std::string Search = "automatic";
  double SampleFraction = 0.01;
  int Seed = 1;
  std::vector<std::string> Receivers;
  int Repeat = 1;
  bool Json = false;
};

/// Adds all of them to a command.
void AddGeometryArguments(CLI::App& command, GeometryArguments& arguments);

/// What is made, by which filter, and what is to be said of it.
struct Geometry
{
  std::string Command; ///< "silhouette"
  std::string Noun;    ///< "shadow volume", for messages
  vtkSmoothLightSilhouette* Silhouette;
  vtkPolyDataAlgorithm* Last; ///< its output is written
  std::function<void(vtkPolyData* mesh)> SetMesh; ///< beside the silhouette's
  /// Adds figures of the output; gives a few words on it.
  std::function<std::string(vtkPolyData* output, Json& statistics)> Describe;
};

/// Reads, makes, moves the light as often as asked for, writes and prints. Throws Failure.
void WriteGeometry(const GeometryArguments& arguments, const Geometry& geometry);

#endif
