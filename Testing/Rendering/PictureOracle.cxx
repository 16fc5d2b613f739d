#include "PictureOracle.h"

#include "Tolerances.h"

#include <vtkCell.h>
#include <vtkIdList.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace shadowtest
{
namespace
{
/// Shares of the picture that lit, dark and background pixels must have at least.
constexpr double LeastLit = 0.1;
constexpr double LeastDark = 0.01;
constexpr double LeastBackground = 0.01;

/**
 * Counts compared pixels by kind, and those that are wrong.
 */
class Tally
{
public:
  void Add(PictureOracle::Kind kind, bool wrong, int x, int y)
  {
    ++this->Seen[kind];
    if (wrong && this->Wrong++ < 5)
    {
      this->First << " (" << x << ", " << y << ")";
    }
  }

  void Expect(const PictureOracle& oracle, const char* what) const
  {
    const double all = oracle.GetWidth() * oracle.GetHeight();
    EXPECT_EQ(this->Wrong, 0) << what << ", the first at" << this->First.str() << ", of "
                              << this->Seen[PictureOracle::Lit] << " lit and "
                              << this->Seen[PictureOracle::Dark] << " dark";
    EXPECT_GT(static_cast<double>(this->Seen[PictureOracle::Lit]), LeastLit * all) << what;
    EXPECT_GT(static_cast<double>(this->Seen[PictureOracle::Dark]), LeastDark * all) << what;
    EXPECT_GT(static_cast<double>(this->Seen[PictureOracle::Background]), LeastBackground * all)
      << what;
  }

private:
  long Seen[3] = { 0, 0, 0 };
  long Wrong = 0;
  std::ostringstream First;
};

/// The cosine between a polygon's normal and the direction to the light from a point of it.
double CosineAt(const Mesh& mesh, vtkIdType cell, const Vec3& point, const RayLight& light)
{
  std::array<Vec3, 3> corners;
  vtkIdList* ids = mesh->GetCell(cell)->GetPointIds();
  for (std::size_t i = 0; i < 3; ++i)
  {
    mesh->GetPoint(ids->GetId(static_cast<vtkIdType>(i)), corners[i].data());
  }
  const Vec3 normal = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
  const Vec3 place = { light[0], light[1], light[2] };
  return std::abs(dot(normal, normalized(light[3] == 0.0 ? place : place - point)));
}
}

Color ShadedColor(double cosine, double intensity)
{
  const double shade = Scene::Ambient + Scene::Diffuse * intensity * cosine;
  return { Scene::Red * shade, Scene::Green * shade, Scene::Blue * shade };
}

//------------------------------------------------------------------------------------------------
PictureOracle::PictureOracle(const Scene& scene, const RayLight& light,
  const std::vector<RayObject>& objects, int width, int height, double intensity)
  : Intensity(intensity)
{
  this->Picture = RayScene(objects).render(
    RayView::fromCamera(scene.Renderer->GetActiveCamera(), width, height), light);
  scene.Renderer->GetBackground(this->BackgroundColor.data());
  this->Cosines.resize(this->Picture.Samples.size(), 0.0);
  for (std::size_t i = 0; i < this->Cosines.size(); ++i)
  {
    const RaySample& sample = this->Picture.Samples[i];
    if (sample.Light == Visibility::Lit)
    {
      this->Cosines[i] = CosineAt(
        objects[static_cast<std::size_t>(sample.Object)].Surface, sample.Cell, sample.Point, light);
    }
  }
}

PictureOracle::Kind PictureOracle::GetKind(int x, int y) const
{
  switch (this->Picture.at(x, y).Light)
  {
    case Visibility::Background:
      return Background;
    case Visibility::Lit:
      return Lit;
    default:
      return Dark;
  }
}

Color PictureOracle::GetColor(int x, int y) const
{
  if (this->GetKind(x, y) == Background)
  {
    return this->BackgroundColor;
  }
  const double cosine = this->Cosines[static_cast<std::size_t>(y * this->GetWidth() + x)];
  return ShadedColor(cosine, this->Intensity);
}

bool PictureOracle::IsNearEdge(int x, int y, int pixels) const
{
  const int border = pixels - 1;
  if (x < border || y < border || x >= this->GetWidth() - border || y >= this->GetHeight() - border)
  {
    return true;
  }
  const RaySample& here = this->Picture.at(x, y);
  for (int j = std::max(y - pixels, 0); j <= std::min(y + pixels, this->GetHeight() - 1); ++j)
  {
    for (int i = std::max(x - pixels, 0); i <= std::min(x + pixels, this->GetWidth() - 1); ++i)
    {
      const RaySample& there = this->Picture.at(i, j);
      if (there.Object != here.Object || there.Light != here.Light ||
        (here.Object > 0 && there.Cell != here.Cell))
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------------------------
void ExpectPicture(
  const PictureOracle& oracle, vtkImageData* picture, const PictureExpectation& expectation)
{
  Tally tally;
  for (int y = 0; y < oracle.GetHeight(); ++y)
  {
    for (int x = 0; x < oracle.GetWidth(); ++x)
    {
      std::optional<Color> color = oracle.GetColor(x, y);
      if (expectation.Recolor)
      {
        color = expectation.Recolor(*color, x, y);
      }
      if (!color || oracle.IsNearEdge(x, y, expectation.Margin))
      {
        continue;
      }
      bool wrong = false;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const double expected = 255.0 * std::min((*color)[i], 1.0);
        const double shown =
          Byte(picture, expectation.Origin[0] + x, expectation.Origin[1] + y, static_cast<int>(i));
        wrong = wrong || std::abs(shown - expected) > tolerance::Shade;
      }
      tally.Add(oracle.GetKind(x, y), wrong, x, y);
    }
  }
  tally.Expect(oracle, expectation.What);
}

void ExpectComposed(const PictureOracle& oracle, vtkImageData* picture, vtkImageData* lit,
  vtkImageData* unlit, const PictureExpectation& expectation)
{
  Tally tally;
  long told = 0;
  for (int y = 0; y < oracle.GetHeight(); ++y)
  {
    for (int x = 0; x < oracle.GetWidth(); ++x)
    {
      if (oracle.IsNearEdge(x, y, expectation.Margin))
      {
        continue;
      }
      const PictureOracle::Kind kind = oracle.GetKind(x, y);
      const int place[2] = { expectation.Origin[0] + x, expectation.Origin[1] + y };
      bool wrong = false;
      bool differ = false;
      for (int i = 0; i < 3; ++i)
      {
        const int whenLit = Byte(lit, place[0], place[1], i);
        const int whenUnlit = Byte(unlit, place[0], place[1], i);
        const int expected = kind == PictureOracle::Dark ? whenUnlit : whenLit;
        differ = differ || std::abs(whenLit - whenUnlit) > 4 * tolerance::SameShade;
        wrong =
          wrong || std::abs(Byte(picture, place[0], place[1], i) - expected) > tolerance::SameShade;
      }
      tally.Add(kind, wrong, x, y);
      told += differ && kind == PictureOracle::Dark;
    }
  }
  tally.Expect(oracle, expectation.What);
  EXPECT_GT(static_cast<double>(told), LeastDark * oracle.GetWidth() * oracle.GetHeight())
    << expectation.What << ": the light makes no difference";
}
}
