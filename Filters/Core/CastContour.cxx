#include "CastContour.h"

#include "ContourCasting.h"

namespace shadow
{
CastContours castContours(const ContourScene& scene, const ContourSettings& settings,
  const RangeLoop& loop, ContourReport& report)
{
  CastContours lines;
  if (scene.loops.points.empty() || scene.receivers.empty())
  {
    return lines;
  }
  const ContourCasting casting(scene, settings.builder, BlockerSides::Needed, loop, report);
  for (std::size_t i = 0; i < scene.receivers.size() && report.lightPoint == None; ++i)
  {
    const Index number = static_cast<Index>(i);
    const ReceiverContours contours = casting.contours(number);
    const Stopwatch watch(report.seconds.query);
    const ContourChains chains =
      joinPieces(contours.pieces, casting.walls(), *contours.receiver);
    report.loose += chains.loose;
    appendLines(chains, contours.pieces, contours.straight, contours.hidden, casting.walls(),
      *contours.receiver, number, settings.keepHidden, lines);
  }
  return lines;
}
}
