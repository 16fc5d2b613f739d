// A sketch as architects draw them, of an animal on a chair in the sun: outlines, creases, the
// contours of cast shadows, and hatching where the sun does not come. As a picture its strokes are
// ribbons drawn as if by hand, over surfaces of paper on which the shadow pass lays a pale wash; as
// an SVG they are plain lines in layers.
//
//     ArchitecturalSketch [--smooth-outlines] sketch.png sketch.svg [animal.obj]
//
// The animal's y points upwards. Without one a torus is drawn. With --smooth-outlines a coarse
// animal is filled up to the outline that the strokes draw, which is that of its smooth surface.

#include "SketchDrawing.h"
#include "SketchPicture.h"

#include <algorithm>
#include <iostream>
#include <string>

namespace
{
bool IsWritten(bool done, const char* file)
{
  if (!done)
  {
    std::cerr << "ArchitecturalSketch: error: no drawing, in " << file << std::endl;
  }
  return done;
}
}

int main(int argc, char* argv[])
{
  std::vector<const char*> files(argv + 1, argv + argc);
  const auto option = std::find(files.begin(), files.end(), std::string("--smooth-outlines"));
  const bool smoothOutlines = option != files.end();
  if (smoothOutlines)
  {
    files.erase(option);
  }
  if (files.size() != 2 && files.size() != 3)
  {
    std::cerr << "usage: ArchitecturalSketch [--smooth-outlines] sketch.png sketch.svg [animal.obj]"
              << std::endl;
    return 2;
  }
  const Model model = MakeModel(files.size() == 3 ? files[2] : nullptr);
  if (model.Animal->GetNumberOfPolys() == 0)
  {
    std::cerr << "ArchitecturalSketch: error: no mesh, in " << files[2] << std::endl;
    return 1;
  }
  const std::vector<Layer> layers = MakeLayers(model);
  for (const Layer& layer : layers)
  {
    std::cout << layer.How.Id << ": " << layer.Lines->GetNumberOfLines() << " lines" << std::endl;
  }
  return IsWritten(WritePicture(model, layers, smoothOutlines, files[0]), files[0]) &&
      IsWritten(WriteDrawing(model, layers, files[1]), files[1])
    ? 0
    : 1;
}
