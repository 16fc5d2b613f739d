/**
 * @brief Compares a visibility mask with the ray cast, pixel by pixel.
 */
#ifndef shadowtest_MaskComparison_h
#define shadowtest_MaskComparison_h

#include "RayCast.h"

#include <string>
#include <vector>

namespace shadowtest
{
struct MaskCount
{
  long Compared = 0;
  long Shadowed = 0; ///< of these, in shadow by the oracle
  long Wrong = 0;
  long WrongBeyond = 0; ///< of these, farther than tolerance::MaskPixels from an edge
  long WrongFaint = 0;  ///< of these, lit so faintly (tolerance::FaintLight) that they are black
};

struct WrongPixel
{
  int X;
  int Y;
  double Cosine; ///< see RaySample
};

struct MaskComparison
{
  /// By number of the object.
  std::vector<MaskCount> Objects;
  MaskCount Background;
  /// The first of the pixels beyond, for a look at the pictures.
  std::vector<WrongPixel> FirstBeyond;

  MaskCount total() const;
  std::string describe() const;
};

enum class TurnedAwayPixels
{
  Ignored, ///< shading darkens them
  Shadow   ///< the mask must say shadow
};

/// Compares a mask (one component, 0 shadow, otherwise lit, of the view's size) with the oracle.
/// Triangles that are edge-on to the light (tolerance::EdgeOn) are neither lit nor in shadow and
/// are left out.
///
/// A pixel is near an edge if, somewhere within one pixel of its middle in x and y, the oracle sees
/// another object than at its middle, or changes between lit, in shadow and turned away. This is
/// looked for at the 8 neighbours first and then, for wrong pixels, at a grid of 17 x 17 places, as
/// a sliver of shadow can lie between the middles of pixels. After 3,000 such searches in vain the
/// rest of the wrong pixels count as beyond by their neighbours alone: the mask is wrong anyway.
MaskComparison compareMask(const RayScene& scene, const RayView& view, const RayLight& light,
  vtkImageData* mask, TurnedAwayPixels turnedAway = TurnedAwayPixels::Ignored);
}

#endif
