#include "CheckCommand.h"

#include "CheckReport.h"
#include "Failure.h"
#include "MeshReader.h"
#include "Messages.h"
#include "SilhouetteOptions.h"
#include "Timing.h"

#include <vtkNew.h>
#include <vtkShadowMeshCheck.h>
#include <vtkTable.h>

#include <CLI/CLI.hpp>

#include <memory>

namespace
{
struct Arguments
{
  std::string Mesh;
  double FeatureAngle = 60.0;
  bool NoIntersections = false;
  bool Json = false;
};

void Run(const Arguments& arguments)
{
  CheckReport report;
  {
    Progress progress;
    const Mesh mesh = ReadMeshWithLines(arguments.Mesh, progress);
    progress.Show("checking " + arguments.Mesh);
    ClearMessages();
    vtkNew<vtkShadowMeshCheck> check;
    check->SetInputData(mesh.Data);
    check->SetFeatureAngle(arguments.FeatureAngle);
    check->SetCheckIntersections(!arguments.NoIntersections);
    const double milliseconds = Milliseconds([&] { check->Update(); });
    if (!FirstError().empty())
    {
      throw Failure(
        "it cannot be checked (" + FirstError() + ")", mesh.File, "give a smaller mesh");
    }
    report = DescribeCheck(mesh, check->GetOutput());
    report.Statistics["intersectionsChecked"] = !arguments.NoIntersections;
    report.Statistics["milliseconds"] = milliseconds;
  }
  PrintResult(arguments.Json, report.Statistics, report.Text);
}
}

void AddCheckCommand(CLI::App& app, std::function<void()>& chosen)
{
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& command = *app.add_subcommand(
    "check", "Say what is wrong with a mesh, and what each defect means for its shadow");
  command.add_option("mesh", arguments->Mesh, "the mesh")->required()->type_name("MESH");
  AddFeatureAngleOption(command, arguments->FeatureAngle);
  command.add_flag("--no-intersections", arguments->NoIntersections,
    "do not look for triangles that pierce each other, which takes most of the time");
  command.add_flag("--json", arguments->Json, "print what was found as JSON");
  command.callback([arguments, &chosen] { chosen = [arguments] { Run(*arguments); }; });
}
