#include "ContourCommand.h"

#include "ContourDrawing.h"
#include "ContourRegions.h"
#include "Failure.h"
#include "LightMoves.h"
#include "MeshReader.h"
#include "Messages.h"
#include "PolyDataOutput.h"
#include "SilhouetteOptions.h"
#include "Statistics.h"
#include "ViewOptions.h"

#include <vtkCastShadowContour.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkSmoothLightSilhouette.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <sstream>

namespace
{
const std::map<std::string, int> builders = { { "unsorted", vtkCastShadowContour::UNSORTED },
  { "object-median", vtkCastShadowContour::OBJECT_MEDIAN },
  { "morton", vtkCastShadowContour::MORTON } };

struct Arguments
{
  std::vector<std::string> Casters;
  std::vector<std::string> Receivers;
  std::string Output;
  std::string Regions; // none if empty
  Homogeneous Light = { 0.0, 0.0, 1.0, 0.0 };
  SilhouetteOptions Silhouette;
  std::string Builder = "morton";
  bool KeepHidden = false;
  DrawingOptions Drawing;
  std::string DrawingOption; // the first one given of those that count with a drawing only
  int Repeat = 1;
  bool Json = false;
};

bool IsDrawing(const Arguments& arguments)
{
  return std::filesystem::path(arguments.Output).extension() == ".svg";
}

OutputFile MakeOutput(const Arguments& arguments)
{
  const std::string extension = std::filesystem::path(arguments.Output).extension().string();
  if (extension != ".svg" && extension != ".vtp")
  {
    throw UsageError("--output " + arguments.Output + ": a name ending in .vtp or .svg is wanted");
  }
  if (extension == ".vtp" && !arguments.DrawingOption.empty())
  {
    throw UsageError(arguments.DrawingOption + ": it counts where the output is an .svg only");
  }
  return OutputFile("--output", arguments.Output, extension);
}

std::optional<OutputFile> MakeRegions(const Arguments& arguments)
{
  if (arguments.Regions.empty())
  {
    return std::nullopt;
  }
  if (std::filesystem::path(arguments.Regions).lexically_normal() ==
    std::filesystem::path(arguments.Output).lexically_normal())
  {
    throw UsageError("--regions " + arguments.Regions + ": it is the --output, too");
  }
  return OutputFile("--regions", arguments.Regions, ".vtp");
}

// Each file once, although a mesh may cast and receive.
class Meshes
{
public:
  Meshes(const Arguments& arguments, Progress& progress)
  {
    for (const auto* files : { &arguments.Casters, &arguments.Receivers })
    {
      for (const std::string& file : *files)
      {
        if (this->ByFile.count(file) == 0)
        {
          this->ByFile[file] = ReadMesh(file, progress);
          this->All.push_back(this->ByFile[file]);
        }
      }
    }
  }

  const Mesh& Of(const std::string& file) const { return this->ByFile.at(file); }

  std::vector<Mesh> All; // in the order in which they are named

private:
  std::map<std::string, Mesh> ByFile;
};

// The silhouettes of the casters, and the filter that makes contours of them.
class Pipeline
{
public:
  Pipeline(const Arguments& arguments, const Meshes& meshes)
  {
    for (const std::string& file : arguments.Casters)
    {
      const auto silhouette = vtkSmartPointer<vtkSmoothLightSilhouette>::New();
      silhouette->SetInputData(meshes.Of(file).Data);
      Configure(silhouette, arguments.Silhouette, arguments.Light);
      this->Contour->AddSilhouetteConnection(silhouette->GetOutputPort());
      this->Contour->AddInputDataObject(2, meshes.Of(file).Data);
      for (const std::string& receiver : arguments.Receivers)
      {
        silhouette->AddInputDataObject(1, meshes.Of(receiver).Data);
      }
      this->Silhouettes.push_back(silhouette);
      this->Size = std::max(this->Size, meshes.Of(file).Data->GetLength());
    }
    for (const std::string& file : arguments.Receivers)
    {
      this->Contour->AddInputDataObject(1, meshes.Of(file).Data);
    }
    this->Contour->SetBuilder(builders.at(arguments.Builder));
    this->Contour->SetKeepHidden(arguments.KeepHidden);
  }

  void Update(Homogeneous light)
  {
    for (const auto& silhouette : this->Silhouettes)
    {
      silhouette->SetLightPosition(light.data());
      silhouette->Modified();
    }
    this->Contour->Update();
  }

  std::vector<vtkSmartPointer<vtkSmoothLightSilhouette>> Silhouettes;
  vtkNew<vtkCastShadowContour> Contour;
  double Size = 0.0; // of the largest caster
};

// The first caster with which alone there are no contours either.
std::string Culprit(const Arguments& arguments, const Meshes& meshes)
{
  const auto fails = [&](const std::string& caster) {
    Arguments alone = arguments;
    alone.Casters = { caster };
    ClearMessages();
    Pipeline(alone, meshes).Contour->Update();
    return !FirstError().empty();
  };
  const auto found = std::find_if(arguments.Casters.begin(), arguments.Casters.end(), fails);
  return found != arguments.Casters.end() ? *found : arguments.Casters.front();
}

std::string Text(const Homogeneous& light)
{
  std::ostringstream text;
  text << light[0] << "," << light[1] << "," << light[2] << "," << light[3];
  return text.str();
}

Json ContourStatistics(vtkPolyData* contours)
{
  Json statistics;
  vtkDataArray* visible = contours->GetCellData()->GetArray("Visible");
  vtkIdType hidden = 0;
  for (vtkIdType line = 0; line < contours->GetNumberOfLines(); ++line)
  {
    hidden += visible->GetComponent(line, 0) == 0.0 ? 1 : 0;
  }
  statistics["lines"] = contours->GetNumberOfLines();
  statistics["hiddenLines"] = hidden;
  statistics["points"] = contours->GetNumberOfPoints();
  statistics["looseEnds"] = FieldValue(contours, "LooseEnds");
  statistics["nodesVisited"] = FieldValue(contours, "NodesVisited");
  statistics["leavesTested"] = FieldValue(contours, "LeavesTested");
  for (const char* part : { "Build", "Query", "Hidden" })
  {
    const Json seconds = FieldValue(contours, std::string(part) + "Seconds");
    statistics[std::string(1, static_cast<char>(std::tolower(part[0]))) + (part + 1) +
      "Milliseconds"] = seconds.is_null() ? seconds : Json(1e3 * seconds.get<double>());
  }
  return statistics;
}

void Run(const Arguments& arguments)
{
  OutputFile output = MakeOutput(arguments);
  std::optional<OutputFile> regions = MakeRegions(arguments);
  Progress progress;
  const Meshes meshes(arguments, progress);
  progress.Show("contours");
  ClearMessages();
  Pipeline pipeline(arguments, meshes);
  const double first = Milliseconds([&] { pipeline.Contour->Update(); });
  const double move = MedianLightMove(arguments.Light, pipeline.Size, arguments.Repeat,
    [&](const Homogeneous& light) { pipeline.Update(light); });
  if (!FirstError().empty())
  {
    const std::string reason = FirstError();
    throw Failure("no contours (" + reason + ")", Culprit(arguments, meshes),
      "check it and --light " + Text(arguments.Light));
  }
  vtkPolyData* contours = pipeline.Contour->GetOutput();
  Json statistics;
  statistics["command"] = "contour";
  statistics["output"] = arguments.Output;
  statistics["light"] = arguments.Light;
  statistics["kind"] = arguments.Silhouette.Kind;
  statistics["builder"] = arguments.Builder;
  statistics.update(ContourStatistics(contours));
  statistics["firstMilliseconds"] = first;
  statistics["milliseconds"] = move;
  for (std::size_t i = 0; i < arguments.Casters.size(); ++i)
  {
    Json caster = MeshStatistics(meshes.Of(arguments.Casters[i]));
    caster.update(MeshDefects(pipeline.Silhouettes[i]->GetOutput()));
    statistics["casters"].push_back(caster);
  }
  for (const std::string& file : arguments.Receivers)
  {
    statistics["receivers"].push_back(MeshStatistics(meshes.Of(file)));
  }
  if (IsDrawing(arguments))
  {
    progress.Show("drawing " + arguments.Output);
    statistics["drawing"] = WriteDrawing(contours, meshes.All, arguments.Silhouette.FeatureAngle,
      arguments.Light, arguments.Drawing, output);
  }
  else
  {
    progress.Show("writing " + arguments.Output);
    WritePolyData(contours, output);
  }
  if (regions)
  {
    progress.Show("writing " + arguments.Regions);
    WriteRegions(pipeline.Contour, *regions, statistics);
    regions->Commit();
  }
  output.Commit();
  std::ostringstream line;
  line << arguments.Output << ": " << statistics["lines"] << " contours, " << statistics["points"]
       << " points, " << move << " ms a light move";
  PrintResult(arguments.Json, statistics, line.str());
}

void AddMeshesOption(CLI::App& command, const std::string& name, std::vector<std::string>& files,
  const std::string& help)
{
  command.add_option(name, files, help)->required()->type_name("MESH...");
}

void AddDrawingOptions(CLI::App& command, DrawingOptions& drawing)
{
  command.add_flag("--outlines", drawing.Outlines,
    "draw the meshes, too: their outlines as seen from the eye, and their creases");
  command.add_flag("--parallel", drawing.Parallel,
    "parallel projection along the camera's gaze, in which lengths can be measured");
  command
    .add_option_function<std::string>(
      "--scale",
      [&drawing](const std::string& text) {
        drawing.Scale = ParsePositive("--scale", text);
        drawing.ScaleText = text;
      },
      "millimetres on paper for a unit of the meshes [the picture's size in pixels]")
    ->type_name("MM");
  AddViewOptions(command, drawing.Scene);
}

// The first one that was given of those that a drawing alone has use for.
std::string GivenDrawingOption(const CLI::App& command)
{
  for (const char* option :
    { "--outlines", "--parallel", "--scale", "--eye", "--at", "--up", "--angle", "--size" })
  {
    if (command.count(option) > 0)
    {
      return option;
    }
  }
  return "";
}
}

void AddContourCommand(CLI::App& app, std::function<void()>& chosen)
{
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& command = *app.add_subcommand(
    "contour", "Write the curves at which cast shadows begin on meshes (VTP), or draw them (SVG)");
  AddMeshesOption(command, "--caster", arguments->Casters, "the meshes that cast");
  AddMeshesOption(
    command, "--receiver", arguments->Receivers, "those on which shadows fall; a mesh may do both");
  command.add_option("-o,--output", arguments->Output, "the file to write")
    ->required()
    ->type_name("FILE.vtp|FILE.svg");
  command
    .add_option("--regions", arguments->Regions,
      "write the receivers, too, split along the contours: each part lit or not, and their areas")
    ->type_name("FILE.vtp");
  AddLightOption(command, arguments->Light);
  AddSilhouetteOptions(command, arguments->Silhouette);
  command
    .add_option("--builder", arguments->Builder,
      "how the tree over silhouettes is built; all give the same contours [morton]")
    ->check(CLI::IsMember(std::vector<std::string>{ "unsorted", "object-median", "morton" }));
  command.add_flag("--keep-hidden", arguments->KeepHidden,
    "keep contours that are themselves in a shadow, as lines of their own");
  AddDrawingOptions(command, arguments->Drawing);
  AddRepeatOption(command, arguments->Repeat);
  command.add_flag("--json", arguments->Json, "print statistics as JSON");
  command.callback([arguments, &command, &chosen] {
    arguments->DrawingOption = GivenDrawingOption(command);
    chosen = [arguments] { Run(*arguments); };
  });
}
