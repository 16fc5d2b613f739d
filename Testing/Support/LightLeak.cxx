#include "LightLeak.h"

#include <algorithm>

namespace shadowtest
{
namespace
{
double percent(long part, long whole)
{
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

bool isBesideEdge(const RayPicture& picture, int x, int y)
{
  bool anyLit = false;
  bool anyShadow = false;
  bool anyBackground = false;
  for (int j = y - 1; j <= y + 1; ++j)
  {
    for (int i = x - 1; i <= x + 1; ++i)
    {
      const Visibility seen = picture.at(i, j).Light;
      anyLit = anyLit || seen == Visibility::Lit;
      anyShadow = anyShadow || seen == Visibility::Shadow;
      anyBackground = anyBackground || seen == Visibility::Background;
    }
  }
  return (anyLit && anyShadow) || anyBackground;
}
}

double LeakCount::percentLeaking() const
{
  return percent(this->Leaking, this->Shadow);
}

double LeakCount::percentLost() const
{
  return percent(this->Lost, this->Lit);
}

void countLeaks(const RayPicture& reference, vtkImageData* mask, LeakCounts& counts)
{
  for (int y = 1; y < reference.Height - 1; ++y)
  {
    for (int x = 1; x < reference.Width - 1; ++x)
    {
      const RaySample& sample = reference.at(x, y);
      if ((sample.Light != Visibility::Lit && sample.Light != Visibility::Shadow) ||
        isBesideEdge(reference, x, y))
      {
        continue;
      }
      const auto above =
        std::upper_bound(LeakCosines.begin() + 1, LeakCosines.end() - 1, sample.Cosine);
      LeakCount& count = counts[static_cast<std::size_t>(above - LeakCosines.begin()) - 1];
      const bool isLit = *static_cast<unsigned char*>(mask->GetScalarPointer(x, y, 0)) != 0;
      if (sample.Light == Visibility::Shadow)
      {
        ++count.Shadow;
        count.Leaking += isLit;
      }
      else
      {
        ++count.Lit;
        count.Lost += !isLit;
      }
    }
  }
}
}
