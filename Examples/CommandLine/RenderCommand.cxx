#include "RenderCommand.h"

#include "Failure.h"
#include "ImageOutput.h"
#include "MeshReader.h"
#include "Picture.h"
#include "Shading.h"
#include "SilhouetteOptions.h"
#include "Statistics.h"
#include "Timing.h"
#include "ViewOptions.h"

#include <vtkOffscreenWindows.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <sstream>

namespace
{
constexpr int LargestSide = 16384;

struct Arguments
{
  std::vector<std::string> Meshes;
  std::string Output;
  std::string Mask;
  std::string Window = vtkOffscreenWindows::GetDefaultName();
  SceneOptions Scene;
  ShadowOptions Shadow;
  double FeatureAngle = 60.0;
  int Supersample = 1;
  int Frames = 1;
  bool MoveLights = false;
  bool Json = false;
};

struct LoadedMesh
{
  Mesh Original;
  ShadedMesh Shaded;
};

std::vector<LoadedMesh> LoadMeshes(const Arguments& arguments, Progress& progress)
{
  std::vector<LoadedMesh> meshes;
  for (const std::string& file : arguments.Meshes)
  {
    const Mesh mesh = ReadMesh(file, progress);
    progress.Show("preparing " + file);
    const ShadedMesh shaded = PrepareForShading(mesh.Data, arguments.FeatureAngle);
    if (shaded.Data->GetNumberOfPolys() == 0)
    {
      throw Failure("no triangle has finite points", file, "write the mesh again");
    }
    meshes.push_back({ mesh, shaded });
  }
  return meshes;
}

// mask.png, mask-2.png, mask-3.png: one for each light.
std::vector<OutputFile> MaskFiles(const std::string& path, std::size_t lights)
{
  std::vector<OutputFile> files;
  for (std::size_t i = 0; i < lights && !path.empty(); ++i)
  {
    std::filesystem::path name(path);
    if (i > 0)
    {
      const std::string stem = name.stem().string() + "-" + std::to_string(i + 1);
      name.replace_filename(stem + name.extension().string());
    }
    files.emplace_back("--mask", name.string(), ".png");
  }
  return files;
}

long long CountShadowed(vtkImageData* mask)
{
  const auto* values = static_cast<const unsigned char*>(mask->GetScalarPointer());
  return std::count(values, values + mask->GetNumberOfPoints(), static_cast<unsigned char>(0));
}

// First a frame that makes shaders and buffers, then those that are timed. The last one has the
// lights in their places.
Json DrawFrames(
  Picture& picture, const Scene& scene, double size, const Arguments& arguments, Progress& progress)
{
  progress.Show("drawing");
  Json times;
  times["firstFrameMilliseconds"] = picture.Draw();
  std::vector<double> frames;
  for (int step = arguments.Frames - 1; step >= 0; --step)
  {
    progress.Show("drawing", 1.0 - static_cast<double>(step) / arguments.Frames);
    if (arguments.MoveLights)
    {
      picture.MoveLights(scene, size, step);
    }
    frames.push_back(picture.Draw());
  }
  times["frameMilliseconds"] = Median(frames);
  times["frames"] = arguments.Frames;
  times["lightsMoved"] = arguments.MoveLights;
  return times;
}

Json LightStatistics(const Homogeneous& light, vtkImageData* mask, int supersample)
{
  Json statistics;
  statistics["position"] = light;
  const long long shadowed = CountShadowed(mask);
  if (supersample == 1)
  {
    statistics["shadowedPixels"] = shadowed;
  }
  else
  {
    statistics["shadowedPixels"] = static_cast<double>(shadowed) / (supersample * supersample);
  }
  return statistics;
}

Json RenderedMeshStatistics(const LoadedMesh& mesh)
{
  Json statistics = MeshStatistics(mesh.Original);
  statistics["triangles"] = mesh.Shaded.Data->GetNumberOfPolys();
  statistics["nonFiniteTriangles"] = mesh.Shaded.NonFiniteTriangles;
  statistics["normals"] = mesh.Shaded.NormalsComputed ? "computed" : "file";
  return statistics;
}

Json PlanStatistics(vtkTable* plan)
{
  Json rows = Json::array();
  for (vtkIdType row = 0; plan && row < plan->GetNumberOfRows(); ++row)
  {
    rows.push_back({ { "light", plan->GetValueByName(row, "Light").ToInt() },
      { "caster", plan->GetValueByName(row, "Caster").ToInt() },
      { "decision", plan->GetValueByName(row, "Decision").ToString() },
      { "reason", plan->GetValueByName(row, "Reason").ToString() },
      { "milliseconds", plan->GetValueByName(row, "Milliseconds").ToDouble() } });
  }
  return rows;
}

std::string DescribePlan(const Json& rows)
{
  std::ostringstream lines;
  for (const Json& row : rows)
  {
    const int light = row["light"];
    const int caster = row["caster"];
    lines << (light < 0 ? "frame" : "light " + std::to_string(light))
          << (caster < 0 ? "" : ", caster " + std::to_string(caster)) << ": "
          << row["decision"].get<std::string>() << "; " << row["reason"].get<std::string>() << "; "
          << row["milliseconds"].get<double>() << " ms\n";
  }
  return lines.str();
}

std::string Summary(const Arguments& arguments, const Json& statistics)
{
  std::ostringstream line;
  line << (arguments.Shadow.Plan ? DescribePlan(statistics["plan"]) : "");
  line << arguments.Output << ": " << statistics["width"] << " x " << statistics["height"] << ", "
       << arguments.Shadow.Kind << ", " << statistics["frameMilliseconds"].get<double>()
       << " ms a frame, shadowed pixels";
  for (const Json& light : statistics["lights"])
  {
    line << " " << light["shadowedPixels"];
  }
  return line.str();
}

void Run(const Arguments& arguments)
{
  const int supersample = arguments.Supersample;
  const std::array<int, 2> drawnSize = { arguments.Scene.Size[0] * supersample,
    arguments.Scene.Size[1] * supersample };
  if (std::max(drawnSize[0], drawnSize[1]) > LargestSide)
  {
    throw UsageError("--supersample " + std::to_string(supersample) + ": more than " +
      std::to_string(LargestSide) + " pixels would have to be drawn, give a smaller --size");
  }
  OutputFile output("--output", arguments.Output, ".png");
  std::vector<OutputFile> maskFiles =
    MaskFiles(arguments.Mask, std::max<std::size_t>(1, arguments.Scene.Lights.size()));

  Progress progress;
  const std::vector<LoadedMesh> meshes = LoadMeshes(arguments, progress);
  std::vector<vtkPolyData*> surfaces;
  double largestDiagonal = 0.0;
  for (const LoadedMesh& mesh : meshes)
  {
    surfaces.push_back(mesh.Shaded.Data);
    largestDiagonal = std::max(largestDiagonal, mesh.Shaded.Data->GetLength());
  }
  const Scene scene(surfaces, arguments.Scene);

  Picture picture(arguments.Window, drawnSize);
  picture.AddMeshes(surfaces);
  picture.AddScene(scene, arguments.Scene.Ground);
  if (arguments.Shadow.Kind != "none")
  {
    picture.CastShadows(arguments.Shadow);
  }
  const Json times = DrawFrames(picture, scene, largestDiagonal, arguments, progress);

  progress.Show("writing " + arguments.Output);
  WriteImage(ShrinkImage(picture.Image(), supersample), output);
  Json statistics;
  statistics["command"] = "render";
  statistics["output"] = arguments.Output;
  statistics["width"] = arguments.Scene.Size[0];
  statistics["height"] = arguments.Scene.Size[1];
  statistics["supersample"] = supersample;
  statistics["window"] = arguments.Window;
  statistics["renderer"] = picture.GraphicsName();
  statistics["kind"] = arguments.Shadow.Kind;
  statistics.update(times);
  statistics["plan"] = PlanStatistics(picture.Plan());
  for (std::size_t i = 0; i < scene.Lights().size(); ++i)
  {
    const vtkSmartPointer<vtkImageData> mask = picture.Mask(i);
    Json light = LightStatistics(scene.Lights()[i], mask, supersample);
    if (!maskFiles.empty())
    {
      WriteImage(ShrinkImage(mask, supersample), maskFiles[i]);
      light["mask"] = maskFiles[i].Path();
    }
    statistics["lights"].push_back(light);
  }
  for (const LoadedMesh& mesh : meshes)
  {
    statistics["meshes"].push_back(RenderedMeshStatistics(mesh));
  }
  const Camera view = scene.View();
  statistics["camera"] = { { "eye", view.Eye }, { "at", view.At }, { "up", view.Up },
    { "angle", view.Angle } };
  statistics["ground"] = arguments.Scene.Ground;

  output.Commit();
  for (OutputFile& file : maskFiles)
  {
    file.Commit();
  }
  PrintResult(arguments.Json, statistics, Summary(arguments, statistics));
}

void AddSceneOptions(CLI::App& command, SceneOptions& scene)
{
  command.add_flag("--ground", scene.Ground, "put the meshes on a plane that receives shadows");
  command
    .add_option_function<std::vector<std::string>>(
      "--light",
      [&scene](const std::vector<std::string>& texts) {
        for (const std::string& text : texts)
        {
          scene.Lights.push_back(ParseLight("--light", text));
        }
      },
      "a light, may be given repeatedly; w = 0 is a direction towards a light at infinity "
      "[one at the upper left]")
    ->type_name("x,y,z[,w]")
    ->allow_extra_args(false)
    ->take_all();
  AddViewOptions(command, scene);
}

void AddShadowOptions(CLI::App& command, ShadowOptions& shadow)
{
  command
    .add_option("--kind", shadow.Kind,
      "kind of silhouettes [auto]: discrete where a pixel does not tell, else smooth")
    ->check(
      CLI::IsMember(std::vector<std::string>{ "auto", "smooth", "accurate", "discrete", "none" }));
  command
    .add_option_function<std::string>(
      "--pixel-tolerance",
      [&shadow](const std::string& text) {
        shadow.PixelTolerance = ParsePositive("--pixel-tolerance", text);
      },
      "by how many pixels the edge of a shadow may be off [0.5]")
    ->type_name("PIXELS");
  command
    .add_option("--counting", shadow.Counting,
      "how shadow volumes are counted [auto]; zfail is right always, zpass only where the eye and "
      "what is right before it are in the light")
    ->check(CLI::IsMember(std::vector<std::string>{ "auto", "zpass", "zfail" }));
  command.add_flag("--plan", shadow.Plan,
    "print what was done for each light and each caster, why, and how long it took; frames are "
    "drawn wholly anew then");
}

void AddCount(CLI::App& command, const std::string& name, int& count, int largest, const char* help)
{
  command
    .add_option_function<std::string>(
      name,
      [name, &count, largest](const std::string& text) { count = ParseCount(name, text, largest); },
      help)
    ->type_name("N");
}
}

void AddRenderCommand(CLI::App& app, std::function<void()>& chosen)
{
  const auto arguments = std::make_shared<Arguments>();
  CLI::App& command = *app.add_subcommand("render", "Draw meshes and their shadows (PNG)");
  command.add_option("meshes", arguments->Meshes, "the meshes")->required()->type_name("MESH...");
  command.add_option("-o,--output", arguments->Output, "the picture to write")
    ->required()
    ->type_name("FILE.png");
  AddSceneOptions(command, arguments->Scene);
  AddShadowOptions(command, arguments->Shadow);
  AddFeatureAngleOption(command, arguments->FeatureAngle);
  command
    .add_option("--window", arguments->Window,
      "what draws [" + arguments->Window + "]; egl and osmesa need no display")
    ->check(CLI::IsMember(std::vector<std::string>{ "egl", "osmesa", "native" }));
  AddCount(command, "--supersample", arguments->Supersample, 16,
    "draw N x N pixels for each one of the picture, for smooth edges [1]");
  command
    .add_option("--mask", arguments->Mask,
      "write where the light is visible (white) or hidden (black); further lights' masks get -2, "
      "-3, ... before the extension")
    ->type_name("FILE.png");
  AddCount(command, "--frames", arguments->Frames, 100000,
    "draw the picture N times and report the median time [1]");
  command.add_flag("--move-lights", arguments->MoveLights, "move the lights between these frames");
  command.add_flag("--json", arguments->Json, "print statistics as JSON");
  command.callback([arguments, &chosen] { chosen = [arguments] { Run(*arguments); }; });
}
