#include "CastContour.h"

#include "HiddenContours.h"

#include <chrono>
#include <optional>

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

/// Adds the contours on one receiver after the other.
class Casting
{
public:
  Casting(const ContourScene& scene, const ContourSettings& settings, const RangeLoop& loop,
    ContourReport& report)
    : Scene(scene)
    , Settings(settings)
    , Loop(loop)
    , Report(report)
    , Frame(scene.light, boundsOf(scene))
  {
    {
      const Stopwatch watch(report.seconds.build);
      this->Walls.emplace(scene.loops, this->Frame, settings.builder);
    }
    if (!scene.casters.empty() && !this->Walls->touchesLight())
    {
      const Stopwatch watch(report.seconds.hidden);
      this->Blockers.emplace(scene.casters, scene.loops, scene.light, this->Frame, loop);
    }
  }

  const ContourWalls& walls() const { return *this->Walls; }

  void add(Index number, CastContours& lines) const
  {
    std::vector<ContourPiece> pieces;
    ContourChains chains;
    std::vector<PieceLine> straight;
    std::optional<ReceiverView> receiver;
    {
      const Stopwatch watch(this->Report.seconds.query);
      receiver.emplace(this->Scene.receivers[number], this->Frame, this->Loop);
      pieces = findPieces(*this->Walls, *receiver, this->Loop, this->Report.visits);
      chains = joinPieces(pieces, *this->Walls, *receiver);
      straight = pieceLines(pieces, *this->Walls, this->Scene.loops, *receiver, this->Loop);
    }
    HiddenSpans hidden;
    if (this->Blockers)
    {
      const Stopwatch watch(this->Report.seconds.hidden);
      hidden = this->Blockers->hiddenSpans(pieces, straight, *this->Walls, this->Loop);
    }
    const Stopwatch watch(this->Report.seconds.query);
    this->Report.loose += chains.loose;
    appendLines(chains, pieces, straight, hidden, *this->Walls, *receiver, number,
      this->Settings.keepHidden, lines);
  }

private:
  const ContourScene& Scene;
  const ContourSettings& Settings;
  const RangeLoop& Loop;
  ContourReport& Report;
  LightFrame Frame;
  std::optional<ContourWalls> Walls;
  std::optional<ContourBlockers> Blockers;
};
}

CastContours castContours(const ContourScene& scene, const ContourSettings& settings,
  const RangeLoop& loop, ContourReport& report)
{
  CastContours lines;
  if (scene.loops.points.empty() || scene.receivers.empty())
  {
    return lines;
  }
  const Casting casting(scene, settings, loop, report);
  report.lightPoint = casting.walls().lightPoint();
  for (std::size_t i = 0; i < scene.receivers.size() && report.lightPoint == None; ++i)
  {
    casting.add(static_cast<Index>(i), lines);
  }
  return lines;
}
}
