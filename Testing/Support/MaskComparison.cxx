#include "MaskComparison.h"

#include "Tolerances.h"

#include <algorithm>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace shadowtest
{
namespace
{
constexpr int GridPerPixel = 8;
constexpr int MostSearches = 3000;
constexpr std::size_t MostListed = 20;

bool isLit(const RaySample& sample)
{
  return sample.Light == Visibility::Lit || sample.Light == Visibility::Background;
}

/// The triangle's side that is seen gets no light, whatever is in between.
bool isDarkAnyway(const RaySample& sample)
{
  return sample.Light == Visibility::TurnedAway ||
    (sample.Light != Visibility::Background && sample.Cosine <= tolerance::EdgeOn);
}

/// Between them is an edge of an object, of a cast shadow, or of an attached one: there the walls
/// of the volume leave the surface, at an angle that may be too small for a depth buffer.
bool differs(const RaySample& a, const RaySample& b)
{
  return a.Object != b.Object || isLit(a) != isLit(b) ||
    isDarkAnyway(a) != isDarkAnyway(b);
}

bool neighbourDiffers(const RayPicture& picture, int x, int y)
{
  constexpr int Reach = tolerance::MaskPixels;
  for (int j = std::max(0, y - Reach); j <= std::min(picture.Height - 1, y + Reach); ++j)
  {
    for (int i = std::max(0, x - Reach); i <= std::min(picture.Width - 1, x + Reach); ++i)
    {
      if (differs(picture.at(x, y), picture.at(i, j)))
      {
        return true;
      }
    }
  }
  return false;
}

bool placeNearbyDiffers(const RayScene& scene, const RayView& view, const RayLight& light,
  const RaySample& middle, int x, int y)
{
  constexpr int Reach = GridPerPixel * tolerance::MaskPixels;
  for (int j = -Reach; j <= Reach; ++j)
  {
    for (int i = -Reach; i <= Reach; ++i)
    {
      const double dx = static_cast<double>(i) / GridPerPixel;
      const double dy = static_cast<double>(j) / GridPerPixel;
      if (differs(middle, scene.look(view, x + 0.5 + dx, y + 0.5 + dy, light)))
      {
        return true;
      }
    }
  }
  return false;
}

void add(MaskCount& sum, const MaskCount& count)
{
  sum.Compared += count.Compared;
  sum.Shadowed += count.Shadowed;
  sum.Wrong += count.Wrong;
  sum.WrongBeyond += count.WrongBeyond;
  sum.WrongFaint += count.WrongFaint;
}

void describe(std::ostream& out, const MaskCount& count)
{
  out << count.Compared << " compared, " << count.Shadowed << " in shadow, " << count.Wrong
      << " wrong, " << count.WrongBeyond << " beyond, " << count.WrongFaint << " of them faint";
}
}

MaskCount MaskComparison::total() const
{
  MaskCount sum = this->Background;
  for (const MaskCount& object : this->Objects)
  {
    add(sum, object);
  }
  return sum;
}

std::string MaskComparison::describe() const
{
  std::ostringstream out;
  for (std::size_t i = 0; i < this->Objects.size(); ++i)
  {
    out << "object " << i << ": ";
    shadowtest::describe(out, this->Objects[i]);
    out << '\n';
  }
  out << "background: ";
  shadowtest::describe(out, this->Background);
  out << '\n';
  if (!this->FirstBeyond.empty())
  {
    out << "first pixels beyond:";
    for (const auto& pixel : this->FirstBeyond)
    {
      out << " (" << pixel.X << ", " << pixel.Y << "; cosine " << pixel.Cosine << ")";
    }
    out << '\n';
  }
  return out.str();
}

MaskComparison compareMask(const RayScene& scene, const RayView& view, const RayLight& light,
  vtkImageData* mask, TurnedAwayPixels turnedAway)
{
  int size[3];
  mask->GetDimensions(size);
  if (size[0] != view.Width || size[1] != view.Height || mask->GetNumberOfScalarComponents() != 1)
  {
    throw std::runtime_error("compareMask: the mask has " + std::to_string(size[0]) + " x " +
      std::to_string(size[1]) + " pixels of " +
      std::to_string(mask->GetNumberOfScalarComponents()) + " components, the view " +
      std::to_string(view.Width) + " x " + std::to_string(view.Height));
  }
  const RayPicture picture = scene.render(view, light);
  int extent[6];
  mask->GetExtent(extent);
  MaskComparison result;
  result.Objects.resize(static_cast<std::size_t>(scene.objectCount()));
  int searches = 0;
  for (int y = 0; y < view.Height; ++y)
  {
    for (int x = 0; x < view.Width; ++x)
    {
      const RaySample& sample = picture.at(x, y);
      if (isDarkAnyway(sample) &&
        (turnedAway == TurnedAwayPixels::Ignored || sample.Light != Visibility::TurnedAway))
      {
        continue;
      }
      MaskCount& count = sample.Object < 0
        ? result.Background
        : result.Objects[static_cast<std::size_t>(sample.Object)];
      ++count.Compared;
      count.Shadowed += !isLit(sample);
      const bool maskIsLit =
        mask->GetScalarComponentAsDouble(extent[0] + x, extent[2] + y, extent[4], 0) > 0.0;
      if (maskIsLit == isLit(sample))
      {
        continue;
      }
      ++count.Wrong;
      if (neighbourDiffers(picture, x, y))
      {
        continue;
      }
      if (searches < MostSearches && placeNearbyDiffers(scene, view, light, sample, x, y))
      {
        continue;
      }
      ++searches;
      ++count.WrongBeyond;
      count.WrongFaint += sample.Cosine <= tolerance::FaintLight;
      if (result.FirstBeyond.size() < MostListed)
      {
        result.FirstBeyond.push_back({ x, y, sample.Cosine });
      }
    }
  }
  return result;
}
}
