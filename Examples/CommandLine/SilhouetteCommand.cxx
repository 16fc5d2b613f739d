#include "SilhouetteCommand.h"

#include "Failure.h"
#include "LightMoves.h"
#include "MeshReader.h"
#include "Messages.h"
#include "PolyDataOutput.h"
#include "SilhouetteOptions.h"
#include "Statistics.h"

#include <vtkNew.h>
#include <vtkSmoothLightSilhouette.h>

#include <CLI/CLI.hpp>

#include <memory>
#include <sstream>

namespace
{
struct Arguments
{
  std::string Mesh;
  std::string Output;
  Homogeneous Light = { 0.0, 0.0, 1.0, 0.0 };
  SilhouetteOptions Silhouette;
  int Repeat = 1;
  bool Json = false;
};

void Run(const Arguments& arguments)
{
  OutputFile output("--output", arguments.Output, ".vtp");
  Progress progress;
  const Mesh mesh = ReadMesh(arguments.Mesh, progress);

  progress.Show("silhouette");
  ClearMessages();
  vtkNew<vtkSmoothLightSilhouette> silhouette;
  silhouette->SetInputData(mesh.Data);
  Configure(silhouette, arguments.Silhouette, arguments.Light);
  const double first = Milliseconds([&] { silhouette->Update(); });
  const double move = MedianLightMove(
    arguments.Light, mesh.Data->GetLength(), arguments.Repeat, [&](Homogeneous light) {
      silhouette->SetLightPosition(light.data());
      silhouette->Modified();
      silhouette->Update();
    });
  if (!FirstError().empty())
  {
    throw Failure("no silhouette (" + FirstError() + ")", mesh.File, "check mesh and light");
  }
  vtkPolyData* curves = silhouette->GetOutput();
  progress.Show("writing " + arguments.Output);
  WritePolyData(curves, output);
  output.Commit();

  Json statistics;
  statistics["command"] = "silhouette";
  statistics["output"] = arguments.Output;
  statistics["light"] = arguments.Light;
  statistics["kind"] = arguments.Silhouette.Kind;
  statistics["loops"] = curves->GetNumberOfLines();
  statistics["points"] = curves->GetNumberOfPoints();
  statistics["maximumDeviation"] = FieldValue(curves, "MaximumDeviation");
  statistics["edgesTested"] = FieldValue(curves, "EdgesTested");
  statistics["firstMilliseconds"] = first;
  statistics["milliseconds"] = move;
  statistics["mesh"] = MeshStatistics(mesh);
  statistics["mesh"].update(MeshDefects(curves));
  std::ostringstream line;
  line << arguments.Output << ": " << curves->GetNumberOfLines() << " loops, "
       << curves->GetNumberOfPoints() << " points, " << move << " ms a light move";
  PrintResult(arguments.Json, statistics, line.str());
}
}

void AddSilhouetteCommand(CLI::App& app, std::function<void()>& chosen)
{
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& command = *app.add_subcommand(
    "silhouette", "Write the closed curves that part a mesh's lit from its dark side (VTP)");
  command.add_option("mesh", arguments->Mesh, "the mesh")->required()->type_name("MESH");
  command.add_option("-o,--output", arguments->Output, "the file to write")
    ->required()
    ->type_name("FILE.vtp");
  AddLightOption(command, arguments->Light);
  AddSilhouetteOptions(command, arguments->Silhouette, false);
  AddRepeatOption(command, arguments->Repeat);
  command.add_flag("--json", arguments->Json, "print statistics as JSON");
  command.callback([arguments, &chosen] { chosen = [arguments] { Run(*arguments); }; });
}
