#include "VolumeCommand.h"

#include "Failure.h"
#include "LightMoves.h"
#include "MeshReader.h"
#include "Messages.h"
#include "PolyDataOutput.h"
#include "SilhouetteOptions.h"
#include "Statistics.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkShadowVolumeExtruder.h>
#include <vtkSmoothLightSilhouette.h>

#include <CLI/CLI.hpp>

#include <map>
#include <memory>
#include <sstream>

namespace
{
const std::map<std::string, int> capKinds = { { "automatic", vtkShadowVolumeExtruder::AUTOMATIC },
  { "lit", vtkShadowVolumeExtruder::LIT }, { "dark", vtkShadowVolumeExtruder::DARK },
  { "none", vtkShadowVolumeExtruder::NONE } };

struct Arguments
{
  std::string Mesh;
  std::string Output;
  Homogeneous Light = { 0.0, 0.0, 1.0, 0.0 };
  SilhouetteOptions Silhouette;
  std::string Caps = "automatic";
  double Length = 0.0;
  int Repeat = 1;
  bool Json = false;
};

Json TrianglesByPart(vtkPolyData* volume)
{
  const std::vector<std::string> names = { "cap", "gap", "wall", "farCap" };
  std::vector<vtkIdType> counts(names.size(), 0);
  if (vtkDataArray* parts = volume->GetCellData()->GetArray("Part"))
  {
    for (vtkIdType cell = 0; cell < parts->GetNumberOfTuples(); ++cell)
    {
      ++counts.at(static_cast<std::size_t>(parts->GetComponent(cell, 0)));
    }
  }
  Json triangles;
  for (std::size_t part = 0; part < names.size(); ++part)
  {
    triangles[names[part]] = counts[part];
  }
  triangles["all"] = volume->GetNumberOfPolys();
  return triangles;
}

void Run(const Arguments& arguments)
{
  OutputFile output("--output", arguments.Output, ".vtp");
  Progress progress;
  const Mesh mesh = ReadMesh(arguments.Mesh, progress);

  progress.Show("shadow volume");
  ClearMessages();
  vtkNew<vtkSmoothLightSilhouette> silhouette;
  silhouette->SetInputData(mesh.Data);
  Configure(silhouette, arguments.Silhouette, arguments.Light);
  vtkNew<vtkShadowVolumeExtruder> extruder;
  extruder->SetInputData(mesh.Data);
  extruder->SetSilhouetteConnection(silhouette->GetOutputPort());
  extruder->SetCaps(capKinds.at(arguments.Caps));
  extruder->SetLength(arguments.Length);
  const double first = Milliseconds([&] { extruder->Update(); });
  const double move = MedianLightMove(
    arguments.Light, mesh.Data->GetLength(), arguments.Repeat, [&](Homogeneous light) {
      silhouette->SetLightPosition(light.data());
      silhouette->Modified();
      extruder->Update();
    });
  if (!FirstError().empty())
  {
    throw Failure("no shadow volume (" + FirstError() + ")", mesh.File, "check mesh and light");
  }
  vtkPolyData* volume = extruder->GetOutput();
  progress.Show("writing " + arguments.Output);
  WritePolyData(volume, output);
  output.Commit();

  const Json closed = FieldValue(volume, "Closed");
  Json statistics;
  statistics["command"] = "volume";
  statistics["output"] = arguments.Output;
  statistics["light"] = arguments.Light;
  statistics["kind"] = arguments.Silhouette.Kind;
  statistics["caps"] = arguments.Caps;
  statistics["triangles"] = TrianglesByPart(volume);
  statistics["closed"] = closed.is_number() ? Json(closed != 0) : closed;
  statistics["firstMilliseconds"] = first;
  statistics["milliseconds"] = move;
  statistics["mesh"] = MeshStatistics(mesh);
  statistics["mesh"].update(MeshDefects(silhouette->GetOutput()));
  std::ostringstream line;
  line << arguments.Output << ": " << volume->GetNumberOfPolys() << " triangles, "
       << (closed == 1 ? "closed, " : "not closed, ") << move << " ms a light move";
  PrintResult(arguments.Json, statistics, line.str());
}
}

void AddVolumeCommand(CLI::App& app, std::function<void()>& chosen)
{
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& command =
    *app.add_subcommand("volume", "Write the volume in which a mesh's shadow lies (VTP)");
  command.add_option("mesh", arguments->Mesh, "the mesh")->required()->type_name("MESH");
  command.add_option("-o,--output", arguments->Output, "the file to write")
    ->required()
    ->type_name("FILE.vtp");
  AddLightOption(command, arguments->Light);
  AddSilhouetteOptions(command, arguments->Silhouette, false);
  command
    .add_option("--caps", arguments->Caps,
      "the side of a closed mesh that closes the volume near the light [automatic: the dark one]")
    ->check(CLI::IsMember(std::vector<std::string>{ "automatic", "lit", "dark", "none" }));
  command
    .add_option_function<std::string>(
      "--length",
      [arguments](const std::string& text) { arguments->Length = ParsePositive("--length", text); },
      "where points at infinity are shown, in the mesh's units [ten diagonals]")
    ->type_name("LENGTH");
  AddRepeatOption(command, arguments->Repeat);
  command.add_flag("--json", arguments->Json, "print statistics as JSON");
  command.callback([arguments, &chosen] { chosen = [arguments] { Run(*arguments); }; });
}
