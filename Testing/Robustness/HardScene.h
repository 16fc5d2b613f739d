/**
 * @brief Casters over a ground, drawn by the pass and held against the ray cast.
 */
#ifndef shadowtest_HardScene_h
#define shadowtest_HardScene_h

#include "RayCast.h"

#include <vector>

namespace shadowtest
{
/// A caster: what is drawn, and its triangles if they are not the same.
struct HardCaster
{
  Mesh Drawn;
  Mesh Triangles = nullptr;
  /// VTK does not draw meshes with points that are not finite: it draws the triangles instead,
  /// which cast nothing.
  bool ShowTriangles = false;
};

/// Draws casters over the ground z = 0, |x|, |y| <= 4, seen from (-3, -6, 5), with the pass in its
/// discrete kind, and expects its mask to be that of the ray cast. `truth`: where the ray cast has
/// its light, if not at the same place.
void expectCastMask(const std::vector<HardCaster>& casters, const RayLight& light);
void expectCastMask(
  const std::vector<HardCaster>& casters, const RayLight& light, const RayLight& truth);
}

#endif
