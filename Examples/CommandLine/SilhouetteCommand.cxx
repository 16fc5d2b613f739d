#include "SilhouetteCommand.h"

#include "GeometryCommand.h"

#include <vtkNew.h>
#include <vtkSmoothLightSilhouette.h>

#include <CLI/CLI.hpp>

#include <memory>

namespace
{
std::string Describe(vtkPolyData* curves, Json& statistics)
{
  statistics["loops"] = curves->GetNumberOfLines();
  statistics["points"] = curves->GetNumberOfPoints();
  statistics["maximumDeviation"] = FieldValue(curves, "MaximumDeviation");
  const Json onReceivers = FieldValue(curves, "MaximumShadowDeviation");
  if (!onReceivers.is_null())
  {
    statistics["maximumShadowDeviation"] = onReceivers;
  }
  return std::to_string(curves->GetNumberOfLines()) + " loops, " +
    std::to_string(curves->GetNumberOfPoints()) + " points";
}

void Run(const GeometryArguments& arguments)
{
  vtkNew<vtkSmoothLightSilhouette> silhouette;
  WriteGeometry(arguments,
    { "silhouette", "silhouette", silhouette, silhouette, [](vtkPolyData*) {}, Describe });
}
}

void AddSilhouetteCommand(CLI::App& app, std::function<void()>& chosen)
{
  const auto arguments = std::make_shared<GeometryArguments>();
  CLI::App& command = *app.add_subcommand(
    "silhouette", "Write the closed curves that part a mesh's lit from its dark side (VTP)");
  AddGeometryArguments(command, *arguments);
  command.callback([arguments, &chosen] { chosen = [arguments] { Run(*arguments); }; });
}
