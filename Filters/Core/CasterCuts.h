/// Where casters pierce or touch receivers: there a shadow may begin without a contour.
#pragma once

#include "BoxTree.h"
#include "ReceiverCells.h"

namespace shadow
{
/// The triangles of casters that come near any receiver, to be searched for by these.
class CasterCuts
{
public:
  /// What is nearer to a triangle's plane than `touch`, in world units, is in it: a sheet that only
  /// touches the receiver cuts it too, along its rim, and one that lies in it along all its edges.
  CasterCuts(const std::vector<ContourReceiver>& casters,
    const std::vector<ContourReceiver>& receivers, double touch);

  /// Of all triangles of a receiver that face the light, in their order.
  std::vector<CellCut> cuts(const ReceiverView& receiver, const RangeLoop& loop) const;

private:
  using Corners = std::array<Vec3, 3>;
  void addCuts(const Corners& receiver, Index triangle, const Corners& caster,
    std::vector<CellCut>& cuts) const;

  std::vector<Corners> Triangles;
  double Touch;
  BoxTree Tree;
};
}
