#include "GeometryCommand.h"

#include "Failure.h"
#include "LightMoves.h"
#include "MeshReader.h"
#include "Messages.h"
#include "PolyDataOutput.h"

#include <vtkPolyDataAlgorithm.h>
#include <vtkSmoothLightSilhouette.h>

#include <CLI/CLI.hpp>

#include <limits>
#include <map>
#include <sstream>

namespace
{
const std::map<std::string, int> searchMethods = { { "automatic",
                                                     vtkSmoothLightSilhouette::AUTOMATIC },
  { "brute-force", vtkSmoothLightSilhouette::BRUTE_FORCE },
  { "hierarchy", vtkSmoothLightSilhouette::HIERARCHY },
  { "tracking", vtkSmoothLightSilhouette::TRACKING },
  { "randomized", vtkSmoothLightSilhouette::RANDOMIZED } };

void AddSearchOptions(CLI::App& command, GeometryArguments& arguments)
{
  command
    .add_option("--search", arguments.Search,
      "how the silhouette is searched for; tracking and randomized may miss loops [automatic]")
    ->check(CLI::IsMember(std::vector<std::string>{
      "automatic", "brute-force", "hierarchy", "tracking", "randomized" }));
  command
    .add_option_function<std::string>(
      "--sample-fraction",
      [&arguments](const std::string& text) {
        arguments.SampleFraction = ParseNumber("--sample-fraction", text);
        if (arguments.SampleFraction < 0.0 || arguments.SampleFraction > 1.0)
        {
          throw UsageError("--sample-fraction " + text + ": a share from 0 to 1 is wanted");
        }
      },
      "share of the mesh that a randomized search looks at [0.01]")
    ->type_name("SHARE");
  command
    .add_option_function<std::string>(
      "--seed",
      [&arguments](const std::string& text)
      { arguments.Seed = ParseCount("--seed", text, std::numeric_limits<int>::max()); },
      "of a randomized search's sample [1]")
    ->type_name("N");
}

void ReadReceivers(
  const GeometryArguments& arguments, vtkSmoothLightSilhouette* silhouette, Progress& progress)
{
  for (const std::string& file : arguments.Receivers)
  {
    silhouette->AddInputDataObject(1, ReadMesh(file, progress).Data);
  }
}
}

void AddGeometryArguments(CLI::App& command, GeometryArguments& arguments)
{
  command.add_option("mesh", arguments.Mesh, "the mesh")->required()->type_name("MESH");
  command.add_option("-o,--output", arguments.Output, "the file to write")
    ->required()
    ->type_name("FILE.vtp");
  AddLightOption(command, arguments.Light);
  AddSilhouetteOptions(command, arguments.Silhouette);
  command
    .add_option("--receiver", arguments.Receivers,
      "a mesh that receives the shadow, given again for more of them; the tolerance of mode "
      "receiver is measured on their bounds")
    ->type_name("MESH")
    ->allow_extra_args(false);
  AddSearchOptions(command, arguments);
  AddRepeatOption(command, arguments.Repeat);
  command.add_flag("--json", arguments.Json, "print statistics as JSON");
}

void WriteGeometry(const GeometryArguments& arguments, const Geometry& geometry)
{
  const bool onReceivers = arguments.Silhouette.ToleranceMode == "receiver";
  if (onReceivers && arguments.Receivers.empty())
  {
    throw UsageError("--tolerance-mode receiver: name the receiving meshes with --receiver");
  }
  if (!onReceivers && !arguments.Receivers.empty())
  {
    throw UsageError("--receiver " + arguments.Receivers.front() +
      ": it counts with --tolerance-mode receiver only");
  }
  OutputFile output("--output", arguments.Output, ".vtp");
  Progress progress;
  const Mesh mesh = ReadMesh(arguments.Mesh, progress);
  ReadReceivers(arguments, geometry.Silhouette, progress);

  progress.Show(geometry.Noun);
  ClearMessages();
  geometry.Silhouette->SetInputData(mesh.Data);
  geometry.SetMesh(mesh.Data);
  Configure(geometry.Silhouette, arguments.Silhouette, arguments.Light);
  geometry.Silhouette->SetSearch(searchMethods.at(arguments.Search));
  geometry.Silhouette->SetSampleFraction(arguments.SampleFraction);
  geometry.Silhouette->SetSeed(arguments.Seed);
  const double first = Milliseconds([&] { geometry.Last->Update(); });
  const double move = MedianLightMove(
    arguments.Light, mesh.Data->GetLength(), arguments.Repeat, [&](Homogeneous light) {
      geometry.Silhouette->SetLightPosition(light.data());
      geometry.Silhouette->Modified();
      geometry.Last->Update();
    });
  if (!FirstError().empty())
  {
    throw Failure(
      "no " + geometry.Noun + " (" + FirstError() + ")", mesh.File, "check mesh and light");
  }
  progress.Show("writing " + arguments.Output);
  WritePolyData(geometry.Last->GetOutput(), output);
  output.Commit();

  vtkPolyData* silhouette = geometry.Silhouette->GetOutput();
  Json statistics;
  statistics["command"] = geometry.Command;
  statistics["output"] = arguments.Output;
  statistics["light"] = arguments.Light;
  statistics["kind"] = arguments.Silhouette.Kind;
  statistics["search"] = arguments.Search;
  statistics["searchComplete"] = FieldValue(silhouette, "SearchComplete") == 1;
  statistics["edgesTested"] = FieldValue(silhouette, "EdgesTested");
  const std::string description = geometry.Describe(geometry.Last->GetOutput(), statistics);
  statistics["firstMilliseconds"] = first;
  statistics["milliseconds"] = move;
  statistics["mesh"] = MeshStatistics(mesh);
  statistics["mesh"].update(MeshDefects(silhouette));
  std::ostringstream line;
  line << arguments.Output << ": " << description << ", " << move << " ms a light move";
  PrintResult(arguments.Json, statistics, line.str());
}
