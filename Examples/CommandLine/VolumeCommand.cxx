#include "VolumeCommand.h"

#include "GeometryCommand.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkShadowVolumeExtruder.h>
#include <vtkSmoothLightSilhouette.h>

#include <CLI/CLI.hpp>

#include <map>
#include <memory>

namespace
{
const std::map<std::string, int> capKinds = { { "automatic", vtkShadowVolumeExtruder::AUTOMATIC },
  { "lit", vtkShadowVolumeExtruder::LIT }, { "dark", vtkShadowVolumeExtruder::DARK },
  { "none", vtkShadowVolumeExtruder::NONE } };
const std::map<std::string, int> extents = { { "infinite", vtkShadowVolumeExtruder::INFINITE },
  { "length", vtkShadowVolumeExtruder::LENGTH }, { "plane", vtkShadowVolumeExtruder::PLANE } };

struct Arguments
{
  GeometryArguments Geometry;
  std::string Caps = "automatic";
  std::string Extent = "infinite";
  double Length = 0.0;
  Vector3 PlaneOrigin = { 0.0, 0.0, 0.0 };
  Vector3 PlaneNormal = { 0.0, 0.0, 1.0 };
  bool Strips = false;
};

Json CellsByPart(vtkPolyData* volume)
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
  Json cells;
  for (std::size_t part = 0; part < names.size(); ++part)
  {
    cells[names[part]] = counts[part];
  }
  cells["all"] = volume->GetNumberOfCells();
  return cells;
}

void Run(const Arguments& arguments)
{
  vtkNew<vtkSmoothLightSilhouette> silhouette;
  vtkNew<vtkShadowVolumeExtruder> extruder;
  extruder->SetSilhouetteConnection(silhouette->GetOutputPort());
  extruder->SetCaps(capKinds.at(arguments.Caps));
  extruder->SetExtent(extents.at(arguments.Extent));
  extruder->SetLength(arguments.Length);
  extruder->SetPlaneOrigin(
    arguments.PlaneOrigin[0], arguments.PlaneOrigin[1], arguments.PlaneOrigin[2]);
  extruder->SetPlaneNormal(
    arguments.PlaneNormal[0], arguments.PlaneNormal[1], arguments.PlaneNormal[2]);
  extruder->SetWallStrips(arguments.Strips);
  const auto describe = [&](vtkPolyData* volume, Json& statistics)
  {
    const Json closed = FieldValue(volume, "Closed");
    statistics["caps"] = arguments.Caps;
    statistics["extent"] = arguments.Extent;
    statistics["volume"] = FieldValue(volume, "Volume");
    statistics["triangles"] = CellsByPart(volume);
    statistics["strips"] = volume->GetNumberOfStrips();
    statistics["closed"] = closed.is_number() ? Json(closed != 0) : closed;
    const std::string strips = arguments.Strips
      ? std::to_string(volume->GetNumberOfStrips()) + " strips, "
      : std::string();
    return std::to_string(volume->GetNumberOfPolys()) + " triangles, " + strips +
      (closed == 1 ? "closed" : "not closed");
  };
  WriteGeometry(arguments.Geometry,
    { "volume", "shadow volume", silhouette, extruder,
      [&](vtkPolyData* mesh) { extruder->SetInputData(mesh); }, describe });
}
}

void AddVolumeCommand(CLI::App& app, std::function<void()>& chosen)
{
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& command =
    *app.add_subcommand("volume", "Write the volume in which a mesh's shadow lies (VTP)");
  AddGeometryArguments(command, arguments->Geometry);
  command
    .add_option("--caps", arguments->Caps,
      "the side of a closed mesh that closes the volume near the light [automatic: the dark one]")
    ->check(CLI::IsMember(std::vector<std::string>{ "automatic", "lit", "dark", "none" }));
  command
    .add_option("--extent", arguments->Extent,
      "where shadows end: at infinity, at a length, or on a plane [infinite]")
    ->check(CLI::IsMember(std::vector<std::string>{ "infinite", "length", "plane" }));
  command
    .add_option_function<std::string>(
      "--length",
      [arguments](const std::string& text) { arguments->Length = ParsePositive("--length", text); },
      "how long shadows are, or where points at infinity are shown, in the mesh's units [ten "
      "diagonals]")
    ->type_name("LENGTH");
  command
    .add_option_function<std::string>(
      "--plane-origin",
      [arguments](const std::string& text)
      { arguments->PlaneOrigin = ParseVector("--plane-origin", text); },
      "a point on the plane [0,0,0]")
    ->type_name("x,y,z");
  command
    .add_option_function<std::string>(
      "--plane-normal",
      [arguments](const std::string& text)
      { arguments->PlaneNormal = ParseDirection("--plane-normal", text); },
      "the plane's normal [0,0,1]")
    ->type_name("x,y,z");
  command.add_flag("--strips", arguments->Strips, "write the walls of long loops as strips");
  command.callback([arguments, &chosen] { chosen = [arguments] { Run(*arguments); }; });
}
