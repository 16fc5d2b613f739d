#include "CastContour.h"

#include "ContourLines.h"

#include <chrono>

namespace shadow
{
namespace
{
/// Adds the seconds that its life takes.
class Stopwatch
{
public:
  explicit Stopwatch(double& seconds)
    : Seconds(seconds)
  {
  }
  ~Stopwatch()
  {
    this->Seconds +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  void operator=(const Stopwatch&) = delete;

private:
  double& Seconds;
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

Box boundsOf(const ContourLoops& loops, const std::vector<ContourReceiver>& receivers)
{
  Box bounds;
  for (const Vec3& point : loops.points)
  {
    bounds.add(point);
  }
  for (const ContourReceiver& receiver : receivers)
  {
    bounds.add(receiver.mesh->bounds());
  }
  return bounds;
}

ContourWalls buildWalls(const ContourLoops& loops, const LightFrame& frame, TreeBuilder builder,
  ContourReport& report)
{
  const Stopwatch watch(report.seconds.build);
  return ContourWalls(loops, frame, builder);
}
}

CastContours castContours(const ContourLoops& loops, const std::vector<ContourReceiver>& receivers,
  const Light& light, TreeBuilder builder, const RangeLoop& loop, ContourReport& report)
{
  CastContours lines;
  if (loops.points.empty() || receivers.empty())
  {
    return lines;
  }
  const LightFrame frame(light, boundsOf(loops, receivers));
  const ContourWalls walls = buildWalls(loops, frame, builder, report);
  report.lightPoint = walls.lightPoint();
  if (walls.touchesLight())
  {
    return lines;
  }
  const Stopwatch watch(report.seconds.query);
  for (std::size_t i = 0; i < receivers.size(); ++i)
  {
    const ReceiverView receiver(receivers[i], frame, loop);
    const std::vector<ContourPiece> pieces = findPieces(walls, receiver, loop, report.visits);
    const ContourChains chains = joinPieces(pieces, walls, receiver);
    report.loose += chains.loose;
    appendLines(chains, pieces, pieceLines(pieces, walls, loops, receiver, loop), {}, walls,
      receiver, static_cast<Index>(i), lines);
  }
  return lines;
}
}
