/// The contours of a scene on one receiver after the other, before they are joined to lines.
#pragma once

#include "CastContour.h"
#include "HiddenContours.h"

#include <chrono>
#include <optional>

namespace shadow
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

/// The pieces on one receiver.
struct ReceiverContours
{
  std::optional<ReceiverView> receiver;
  std::vector<ContourPiece> pieces;
  std::vector<PieceLine> straight; ///< each piece as a line
  HiddenSpans hidden;              ///< nothing, without casters
};

/// What is the same for all receivers of a scene. The scene, the loop and the report must stay.
class ContourCasting
{
public:
  ContourCasting(const ContourScene& scene, TreeBuilder builder, BlockerSides sides,
    const RangeLoop& loop, ContourReport& report);

  const LightFrame& frame() const { return this->Frame; }
  const ContourWalls& walls() const { return *this->Walls; }
  /// Null without casters, and where the light is on a silhouette.
  const ContourBlockers* blockers() const { return this->Blockers ? &*this->Blockers : nullptr; }

  ReceiverContours contours(Index receiver) const;

private:
  const ContourScene& Scene;
  const RangeLoop& Loop;
  ContourReport& Report;
  LightFrame Frame;
  std::optional<ContourWalls> Walls;
  std::optional<ContourBlockers> Blockers;
};
}
