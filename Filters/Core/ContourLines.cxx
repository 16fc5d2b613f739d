#include "ContourLines.h"

namespace shadow
{
namespace
{
/// A part of a piece that is all hidden or all visible.
struct Stretch
{
  Index piece;
  double from;
  double to;
  bool visible;
};

ContourPoint mix(const PieceLine& line, double share)
{
  return { glm::mix(line.from.point, line.to.point, share),
    glm::mix(line.from.caster, line.to.caster, share) };
}

class LineWriter
{
public:
  LineWriter(const std::vector<ContourPiece>& pieces, const std::vector<PieceLine>& straight,
    const ContourWalls& walls, const ReceiverView& receiver, Index receiverNumber,
    CastContours& lines)
    : Pieces(pieces)
    , Straight(straight)
    , Walls(walls)
    , Receiver(receiver)
    , Number(receiverNumber)
    , Lines(lines)
  {
  }

  /// Stretches in order, all of them hidden or visible as the first.
  void write(const Stretch* begin, const Stretch* end, bool closed)
  {
    this->addPoint(mix(this->Straight[begin->piece], begin->from));
    const std::size_t start = this->Lines.points.size() - 1;
    for (const Stretch* stretch = begin; stretch != end; ++stretch)
    {
      const std::size_t before = this->Lines.points.size() - 1;
      const bool returns = closed && stretch + 1 == end;
      if (!returns)
      {
        this->addPoint(mix(this->Straight[stretch->piece], stretch->to));
      }
      const Vec3 normal =
        unitOrZero(this->Receiver.mesh().areaNormal(this->Pieces[stretch->piece].triangle));
      const Vec3 direction = this->intoShadow(*stretch, normal);
      for (const std::size_t point : { before, returns ? start : before + 1 })
      {
        this->Lines.normals[point] += normal;
        this->Lines.directions[point] += direction;
      }
    }
    for (std::size_t i = start; i < this->Lines.points.size(); ++i)
    {
      this->Lines.normals[i] = unitOrZero(this->Lines.normals[i]);
      this->Lines.directions[i] = unitOrZero(this->Lines.directions[i]);
    }
    this->Lines.first.push_back(this->Lines.points.size());
    this->Lines.lines.push_back({ this->Number,
      this->Walls.loopOf(this->Pieces[begin->piece].segment), closed, begin->visible });
  }

private:
  void addPoint(const ContourPoint& point)
  {
    this->Lines.points.push_back(point.point);
    this->Lines.casters.push_back(point.caster);
    this->Lines.normals.emplace_back(0.0);
    this->Lines.directions.emplace_back(0.0);
  }

  /// Across the contour, on the left of its way. Zero for a piece without length.
  Vec3 intoShadow(const Stretch& stretch, const Vec3& normal) const
  {
    const PieceLine& line = this->Straight[stretch.piece];
    return unitOrZero(glm::cross(normal, line.to.point - line.from.point));
  }

  const std::vector<ContourPiece>& Pieces;
  const std::vector<PieceLine>& Straight;
  const ContourWalls& Walls;
  const ReceiverView& Receiver;
  Index Number;
  CastContours& Lines;
};

void addStretches(
  Index piece, const HiddenSpans& hidden, std::vector<Stretch>& stretches)
{
  double at = 0.0;
  for (std::size_t i = hidden.begin(piece); i < hidden.end(piece); ++i)
  {
    const auto& [from, to] = hidden.spans[i];
    if (from > at)
    {
      stretches.push_back({ piece, at, from, true });
    }
    stretches.push_back({ piece, from, to, false });
    at = to;
  }
  if (at < 1.0)
  {
    stretches.push_back({ piece, at, 1.0, true });
  }
}

bool changes(const Stretch& before, const Stretch& after)
{
  return before.visible != after.visible;
}

/// Where the run that begins here ends, and its length.
std::pair<std::size_t, double> runFrom(const std::vector<Stretch>& stretches,
  const std::vector<PieceLine>& straight, std::size_t begin)
{
  std::size_t end = begin;
  double length = 0.0;
  for (; end < stretches.size() && !changes(stretches[begin], stretches[end]); ++end)
  {
    const PieceLine& line = straight[stretches[end].piece];
    length += (stretches[end].to - stretches[end].from) *
      glm::distance(line.from.point, line.to.point);
  }
  return { end, length };
}

/// Makes a closed chain begin with a run that is long enough to stay as it is, and where it
/// changes, so that no run is cut in two. As it is if there is none.
void beginWithLongRun(
  std::vector<Stretch>& stretches, const std::vector<PieceLine>& straight, double least)
{
  const auto change = std::adjacent_find(stretches.begin(), stretches.end(), changes);
  if (change == stretches.end())
  {
    return;
  }
  std::rotate(stretches.begin(), change + 1, stretches.end());
  for (std::size_t begin = 0; begin < stretches.size();)
  {
    const auto [end, length] = runFrom(stretches, straight, begin);
    // The last run goes on in the first if these are the same.
    const bool isWhole = begin > 0 || changes(stretches.back(), stretches.front());
    if (length >= least && isWhole)
    {
      std::rotate(stretches.begin(), stretches.begin() + static_cast<std::ptrdiff_t>(begin),
        stretches.end());
      return;
    }
    begin = end;
  }
}

/// Turns runs of stretches that are hidden or visible for too short a length, but not the first,
/// nor the last of a chain that is not closed.
void dropShort(std::vector<Stretch>& stretches, const std::vector<PieceLine>& straight,
  double least, bool closed)
{
  const auto turn = [&](std::size_t begin, std::size_t end)
  {
    for (std::size_t i = begin; i < end; ++i)
    {
      stretches[i].visible = !stretches[i].visible;
    }
  };
  std::size_t begin = 0;
  while (begin < stretches.size())
  {
    const auto [end, length] = runFrom(stretches, straight, begin);
    // One that was turned before may have made this one the same as what is before it.
    if (begin > 0 && (closed || end < stretches.size()) && length < least &&
      changes(stretches[begin - 1], stretches[begin]))
    {
      turn(begin, end);
    }
    begin = end;
  }
}
}

std::vector<PieceLine> pieceLines(const std::vector<ContourPiece>& pieces,
  const ContourWalls& walls, const ContourLoops& loops, const ReceiverView& receiver,
  const RangeLoop& loop)
{
  std::vector<PieceLine> lines(pieces.size());
  loop(pieces.size(), heavyGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        lines[i] = { pointAt(pieces[i], pieces[i].from, walls, loops, receiver),
          pointAt(pieces[i], pieces[i].to, walls, loops, receiver) };
      }
    });
  return lines;
}

void appendLines(const ContourChains& chains, const std::vector<ContourPiece>& pieces,
  const std::vector<PieceLine>& straight, const HiddenSpans& hidden, const ContourWalls& walls,
  const ReceiverView& receiver, Index receiverNumber, bool keepHidden, CastContours& lines)
{
  LineWriter writer(pieces, straight, walls, receiver, receiverNumber, lines);
  std::vector<Stretch> stretches;
  for (std::size_t chain = 0; chain < chains.count(); ++chain)
  {
    stretches.clear();
    for (std::size_t i = chains.first[chain]; i < chains.first[chain + 1]; ++i)
    {
      addStretches(chains.pieces[i], hidden, stretches);
    }
    if (chains.closed[chain])
    {
      beginWithLongRun(stretches, straight, hidden.least);
    }
    dropShort(stretches, straight, hidden.least, chains.closed[chain]);
    auto change = std::adjacent_find(stretches.begin(), stretches.end(), changes);
    const bool closed = chains.closed[chain] && change == stretches.end();
    if (chains.closed[chain] && !closed)
    {
      // Begin where it changes, so that no line is cut without need.
      std::rotate(stretches.begin(), change + 1, stretches.end());
    }
    for (auto begin = stretches.begin(); begin != stretches.end();)
    {
      change = std::adjacent_find(begin, stretches.end(), changes);
      const auto end = change == stretches.end() ? change : change + 1;
      if (begin->visible || keepHidden)
      {
        writer.write(&*begin, &*begin + (end - begin), closed);
      }
      begin = end;
    }
  }
}
}
