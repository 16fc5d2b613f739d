/**
 * A drawing of lines in layers, as an SVG file that Inkscape shows the layers of.
 */
#ifndef SvgDrawing_h
#define SvgDrawing_h

#include <array>
#include <string>
#include <vector>

/// x to the right, y upwards.
using Point2 = std::array<double, 2>;

/// A line may be in several pieces: what is between them is hidden. Closed pieces repeat their
/// first point.
using DrawnLine = std::vector<std::vector<Point2>>;

class SvgDrawing
{
public:
  /// The sheet is `width` x `height` in the units of the points, with (0, 0) in its middle; shown
  /// at `shownWidth` x `shownHeight` in the CSS unit given, such as "mm", "" for pixels.
  SvgDrawing(double width, double height, double shownWidth, double shownHeight, std::string unit);

  struct Layer
  {
    std::string Id;
    std::string Label;
    std::string Colour;     ///< as CSS has it
    double LineWidth = 1.0; ///< in thousandths of the sheet's height
    bool Dashed = false;
    std::vector<DrawnLine> Lines;
  };

  /// Later layers are drawn over earlier ones.
  void Add(Layer layer) { this->Layers.push_back(std::move(layer)); }

  /// A group for each layer, in it a path for each line that has a piece of at least two points.
  /// False if the file cannot be written.
  bool Write(const std::string& path) const;

private:
  double Width;
  double Height;
  double ShownWidth;
  double ShownHeight;
  std::string Unit;
  std::vector<Layer> Layers;
};

#endif
