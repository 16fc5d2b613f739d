#include "ContourCasting.h"

namespace shadow
{
namespace
{
Box boundsOf(const ContourScene& scene)
{
  Box bounds;
  for (const Vec3& point : scene.loops.points)
  {
    bounds.add(point);
  }
  for (const auto* meshes : { &scene.receivers, &scene.casters })
  {
    for (const ContourReceiver& mesh : *meshes)
    {
      bounds.add(mesh.mesh->bounds());
    }
  }
  return bounds;
}
}

ContourCasting::ContourCasting(const ContourScene& scene, TreeBuilder builder, BlockerSides sides,
  const RangeLoop& loop, ContourReport& report)
  : Scene(scene)
  , Loop(loop)
  , Report(report)
  , Frame(scene.light, boundsOf(scene))
{
  {
    const Stopwatch watch(report.seconds.build);
    this->Walls.emplace(scene.loops, this->Frame, builder);
  }
  report.lightPoint = this->Walls->lightPoint();
  if (!scene.casters.empty() && !this->Walls->touchesLight())
  {
    const Stopwatch watch(report.seconds.hidden);
    this->Blockers.emplace(scene.casters, scene.loops, scene.light, this->Frame, sides, loop);
  }
}

ReceiverContours ContourCasting::contours(Index receiver) const
{
  ReceiverContours contours;
  {
    const Stopwatch watch(this->Report.seconds.query);
    contours.receiver.emplace(this->Scene.receivers[receiver], this->Frame, this->Loop);
    contours.pieces = findPieces(*this->Walls, *contours.receiver, this->Loop, this->Report.visits);
    contours.straight =
      pieceLines(contours.pieces, *this->Walls, this->Scene.loops, *contours.receiver, this->Loop);
  }
  if (this->Blockers)
  {
    const Stopwatch watch(this->Report.seconds.hidden);
    contours.hidden =
      this->Blockers->hiddenSpans(contours.pieces, contours.straight, *this->Walls, this->Loop);
  }
  return contours;
}
}
