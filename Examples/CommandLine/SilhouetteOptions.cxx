#include "SilhouetteOptions.h"

#include "Failure.h"

#include <vtkSmoothLightSilhouette.h>

#include <CLI/CLI.hpp>

void AddSilhouetteOptions(CLI::App& command, SilhouetteOptions& options)
{
  command.add_option("--kind", options.Kind, "kind of silhouette [smooth]")
    ->check(CLI::IsMember(std::vector<std::string>{ "smooth", "accurate", "discrete" }));
  command
    .add_option_function<std::string>(
      "--tolerance",
      [&options](
        const std::string& text) { options.Tolerance = ParsePositive("--tolerance", text); },
      "how far a smooth silhouette may be from its curve [1e-4]")
    ->type_name("LENGTH");
  command
    .add_option("--tolerance-mode", options.ToleranceMode,
      "whether it is a share of the mesh's diagonal, or a length in its units or in those of the "
      "receivers' shadow [relative]")
    ->check(CLI::IsMember(std::vector<std::string>{ "relative", "world", "receiver" }));
  AddFeatureAngleOption(command, options.FeatureAngle);
}

void AddFeatureAngleOption(CLI::App& command, double& angle)
{
  command
    .add_option_function<std::string>(
      "--feature-angle",
      [&angle](const std::string& text) {
        angle = ParseNumber("--feature-angle", text);
        if (angle < 0.0 || angle > 180.0)
        {
          throw UsageError("--feature-angle " + text + ": an angle from 0 to 180 is wanted");
        }
      },
      "where a mesh has no normals, edges that turn by more degrees are creases [60]")
    ->type_name("DEGREES");
}

void AddLightOption(CLI::App& command, Homogeneous& light)
{
  command
    .add_option_function<std::string>(
      "--light", [&light](const std::string& text) { light = ParseLight("--light", text); },
      "the light; w = 0 is a direction towards a light at infinity")
    ->type_name("x,y,z[,w]")
    ->required();
}

int KindNumber(const std::string& kind)
{
  if (kind == "discrete")
  {
    return vtkSmoothLightSilhouette::DISCRETE;
  }
  return kind == "accurate" ? vtkSmoothLightSilhouette::ACCURATE : vtkSmoothLightSilhouette::SMOOTH;
}

void Configure(
  vtkSmoothLightSilhouette* silhouette, const SilhouetteOptions& options, const Homogeneous& light)
{
  Homogeneous position = light;
  silhouette->SetLightPosition(position.data());
  silhouette->SetKind(KindNumber(options.Kind));
  silhouette->SetTolerance(options.Tolerance);
  silhouette->SetToleranceMode(options.ToleranceMode == "world"
      ? vtkSmoothLightSilhouette::WORLD
      : options.ToleranceMode == "receiver" ? vtkSmoothLightSilhouette::RECEIVER
                                            : vtkSmoothLightSilhouette::RELATIVE);
  silhouette->SetFeatureAngle(options.FeatureAngle);
}
