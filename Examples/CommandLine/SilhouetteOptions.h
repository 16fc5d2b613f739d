/**
 * The options that all commands which make silhouettes share.
 */
#ifndef SilhouetteOptions_h
#define SilhouetteOptions_h

#include "Numbers.h"

#include <string>

namespace CLI
{
class App;
}
class vtkSmoothLightSilhouette;

struct SilhouetteOptions
{
  std::string Kind = "smooth";
  double Tolerance = 1e-4;
  std::string ToleranceMode = "relative";
  double FeatureAngle = 60.0;
};

/// Adds --kind, --tolerance, --tolerance-mode and --feature-angle.
void AddSilhouetteOptions(CLI::App& command, SilhouetteOptions& options);

/// Adds --feature-angle, in degrees.
void AddFeatureAngleOption(CLI::App& command, double& angle);

/// Adds --light, to be given once.
void AddLightOption(CLI::App& command, Homogeneous& light);

/// Number of a kind in vtkSmoothLightSilhouette and vtkStencilShadowPass.
int KindNumber(const std::string& kind);

void Configure(
  vtkSmoothLightSilhouette* silhouette, const SilhouetteOptions& options, const Homogeneous& light);

#endif
