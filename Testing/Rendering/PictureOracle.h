/**
 * @brief What a picture of a scene must be like, by the ray cast: which pixels are lit, in shadow,
 * or background, and their colours.
 */
#ifndef shadowtest_PictureOracle_h
#define shadowtest_PictureOracle_h

#include "RayCast.h"
#include "ShadowScene.h"

#include <vtkImageData.h>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace shadowtest
{
/// Red, green and blue, from 0 to 1 or brighter.
using Color = std::array<double, 3>;

/**
 * Actors as Scene::Add makes them, one light, and the renderer's background. The objects
 * have no matrices. The first of them is plane; each cell of the others is a face with an edge
 * around it.
 */
class PictureOracle
{
public:
  PictureOracle(const Scene& scene, const RayLight& light, const std::vector<RayObject>& objects,
    int width, int height, double intensity = 1.0);

  enum Kind
  {
    Background,
    Lit,
    Dark ///< in shadow or turned away from the light
  };

  int GetWidth() const { return this->Picture.Width; }
  int GetHeight() const { return this->Picture.Height; }
  Kind GetKind(int x, int y) const;
  Color GetColor(int x, int y) const;
  const RaySample& GetSample(int x, int y) const { return this->Picture.at(x, y); }

  /// Whether there is an edge of an object, a face or a shadow within so many pixels, or the
  /// picture's border within fewer than these.
  bool IsNearEdge(int x, int y, int pixels) const;

private:
  RayPicture Picture;
  std::vector<double> Cosines; ///< of lit pixels, 0 elsewhere
  Color BackgroundColor;
  double Intensity;
};

/// The colour of a surface as Scene::Add makes it, where the light comes at an angle of that cosine
/// to its normal, or not at all (0).
Color ShadedColor(double cosine, double intensity = 1.0);

struct PictureExpectation
{
  /// Goes into messages.
  const char* What = "picture";

  /// How far from an edge the picture is compared, in pixels; more where it has been filtered.
  int Margin = 1;

  /// The oracle's lower left pixel in the picture.
  std::array<int, 2> Origin{ 0, 0 };

  /// What becomes of a colour on its way into the picture; nothing where that is not known.
  std::function<std::optional<Color>(const Color&, int x, int y)> Recolor;
};

/// Expects the picture to have the oracle's colours everywhere away from edges (tolerance::Shade),
/// and enough of lit and dark ground, and of background, to tell.
void ExpectPicture(
  const PictureOracle& oracle, vtkImageData* picture, const PictureExpectation& expectation = {});

/// Expects the picture to be, away from edges, as `unlit` where the oracle says dark, and elsewhere
/// as `lit`: pictures of the same chain of passes without shadows, the light on and off
/// (tolerance::SameShade).
void ExpectComposed(const PictureOracle& oracle, vtkImageData* picture, vtkImageData* lit,
  vtkImageData* unlit, const PictureExpectation& expectation = {});
}

#endif
