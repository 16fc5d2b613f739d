#include "HiddenContours.h"

#include "ExactSum.h"

namespace shadow
{
namespace
{
/// How far pieces are moved to the lit side, as a share of the scene, or of the distance to a light
/// among it: far more than roundings, far less than what is seen.
constexpr double movedShare = 1e-9;
/// Parts of contours that are shorter are taken for what is on both sides of them: where
/// silhouettes meet at an angle the lit side of one may be in the shadow of the other for some such
/// moves.
constexpr double leastMoves = 20.0;
/// Between the spans of two triangles that share an edge: roundings.
constexpr double leastGap = 1e-9;

/// The part of [from, to] in which a function is positive that is linear from one value to another.
void keepPositive(double atStart, double atEnd, double& from, double& to)
{
  if (atStart > 0.0 && atEnd > 0.0)
  {
    return;
  }
  if (!(atStart > 0.0) && !(atEnd > 0.0))
  {
    to = from;
    return;
  }
  const double at = atStart / (atStart - atEnd);
  (atStart > 0.0 ? to : from) = atStart > 0.0 ? std::min(to, at) : std::max(from, at);
}

/// Ascending and apart.
void unite(std::vector<std::array<double, 2>>& spans)
{
  std::sort(spans.begin(), spans.end());
  std::size_t kept = 0;
  for (const auto& span : spans)
  {
    if (kept > 0 && span[0] <= spans[kept - 1][1] + leastGap)
    {
      spans[kept - 1][1] = std::max(spans[kept - 1][1], span[1]);
    }
    else
    {
      spans[kept++] = span;
    }
  }
  spans.resize(kept);
}
}

/// A piece where it is looked at.
struct ContourBlockers::MovedPiece
{
  std::array<Vec3, 2> views;
  std::array<Vec3, 2> places;
  Index segment;
};

bool ContourBlockers::Blocker::isRounding(const Vec3& view) const
{
  return !(glm::dot(this->edges[0] + this->edges[1] + this->edges[2], view) >
    determinantError * glm::dot(this->permanent, glm::abs(view)));
}

ContourBlockers::ContourBlockers(const std::vector<ContourReceiver>& casters,
  const ContourLoops& loops, const Light& light, const LightFrame& frame, BlockerSides sides,
  const RangeLoop& loop)
  : Frame(frame)
  , Around(loops, casters, light, loop)
  , Charts(frame.hasOneChart())
  , Boxes(this->Charts.count())
  , Items(this->Charts.count())
{
  Index firstVertex = 0;
  for (const ContourReceiver& caster : casters)
  {
    this->addCaster(caster, firstVertex, sides, loop);
    firstVertex += static_cast<Index>(caster.mesh->points.size());
  }
  if (sides == BlockerSides::All)
  {
    this->addGaps(loops);
  }
  for (std::size_t chart = 0; chart < this->Charts.count(); ++chart)
  {
    this->Trees.emplace_back(this->Boxes[chart], TreeBuilder::Morton);
  }
}

void ContourBlockers::addCaster(
  const ContourReceiver& caster, Index firstVertex, BlockerSides sides, const RangeLoop& loop)
{
  const ReceiverView view(caster, this->Frame, loop);
  const TriangleMesh& mesh = *caster.mesh;
  const bool areLitEnough =
    sides == BlockerSides::Needed && caster.edges->regular == caster.edges->edges.size();
  const std::size_t count = areLitEnough ? view.lit().size() : mesh.triangles.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Index triangle = areLitEnough ? view.lit()[i] : static_cast<Index>(i);
    const Triangle& t = mesh.triangles[triangle];
    this->addBlocker({ view.place(t[0]), view.place(t[1]), view.place(t[2]) },
      { firstVertex + t[0], firstVertex + t[1], firstVertex + t[2] },
      [&](std::size_t chart) { return view.box(chart, triangle); });
  }
}

/// A smooth contour may run outside of what the mesh hides.
void ContourBlockers::addGaps(const ContourLoops& loops)
{
  for (std::size_t loop = 0; loop < loops.count(); ++loop)
  {
    const std::size_t begin = loops.first[loop];
    const std::size_t end = loops.first[loop + 1];
    for (std::size_t i = begin; i < end && !loops.ofEdges[loop]; ++i)
    {
      if (i + 1 == end && !loops.closed[loop])
      {
        continue;
      }
      const std::size_t to = i + 1 == end ? begin : i + 1;
      const std::array<Vec3, 4> places{ this->Frame.place(loops.points[i]),
        this->Frame.place(loops.points[to]), this->Frame.place(loops.meshPoints[to]),
        this->Frame.place(loops.meshPoints[i]) };
      for (const std::size_t corner : { 1, 2 })
      {
        const std::array<Vec3, 3> corners{ places[0], places[corner], places[corner + 1] };
        std::array<Vec3, 3> views;
        std::transform(corners.begin(), corners.end(), views.begin(),
          [&](const Vec3& place) { return this->Frame.view(place); });
        this->addBlocker(corners, { None, None, None },
          [&](std::size_t chart) { return this->boxOf(chart, views.data(), views.size()); });
      }
    }
  }
}

template <class BoxIn>
void ContourBlockers::addBlocker(
  std::array<Vec3, 3> places, const Triangle& vertices, const BoxIn& boxIn)
{
  std::array<Vec3, 3> views;
  std::transform(places.begin(), places.end(), views.begin(),
    [&](const Vec3& place) { return this->Frame.view(place); });
  const int turn = signOf(determinant(views[0], views[1], views[2]));
  if (turn == 0)
  {
    return; // edge-on, or the light is on it
  }
  if (turn < 0)
  {
    std::swap(places[1], places[2]);
    std::swap(views[1], views[2]);
  }
  Blocker blocker;
  blocker.permanent = Vec3(0.0);
  for (unsigned k = 0; k < 3; ++k)
  {
    const WallPlane plane(views[k], views[next(k)]);
    blocker.edges[k] = plane.normal;
    blocker.permanent += plane.permanent;
  }
  // Places are counted from the light away, so this is turned to what is behind.
  blocker.normal = unitOrZero(glm::cross(places[1] - places[0], places[2] - places[0]));
  blocker.offset = glm::dot(blocker.normal, places[0]);
  blocker.vertices = vertices;
  const Index number = static_cast<Index>(this->Blockers.size());
  this->Blockers.push_back(blocker);
  for (std::size_t chart = 0; chart < this->Charts.count(); ++chart)
  {
    const Box2 box = boxIn(chart);
    if (!isEmpty(box))
    {
      this->Boxes[chart].push_back(box);
      this->Items[chart].push_back(number);
    }
  }
}

ContourBlockers::MovedPiece ContourBlockers::moved(
  const PieceLine& line, const WallPlane& wall, Index segment) const
{
  MovedPiece piece;
  piece.segment = segment;
  piece.places = { this->Frame.place(line.from.point), this->Frame.place(line.to.point) };
  for (std::size_t k = 0; k < 2; ++k)
  {
    piece.views[k] = this->Frame.view(piece.places[k]);
  }
  Vec3 aside = wall.normal;
  double size = this->Frame.size();
  if (this->Frame.hasOneChart())
  {
    aside.z = 0.0;
  }
  else
  {
    size = std::max(glm::length(piece.views[0]), glm::length(piece.views[1]));
  }
  const Vec3 move = movedShare * size * unitOrZero(aside);
  piece.views[0] -= move;
  piece.views[1] -= move;
  return piece;
}

void ContourBlockers::addSpan(
  const MovedPiece& piece, const Blocker& blocker, std::vector<std::array<double, 2>>& spans) const
{
  double from = 0.0;
  double to = blocker.vertices[0] != None ? 1.0 : 0.0;
  for (unsigned k = 0; k < 3 && from < to; ++k)
  {
    keepPositive(glm::dot(blocker.edges[k], piece.views[0]),
      glm::dot(blocker.edges[k], piece.views[1]), from, to);
  }
  if (!(from < to))
  {
    return;
  }
  const double error = movedShare * this->Frame.size();
  keepPositive(glm::dot(blocker.normal, piece.places[0]) - blocker.offset - error,
    glm::dot(blocker.normal, piece.places[1]) - blocker.offset - error, from, to);
  if (from < to && !blocker.isRounding(piece.views[0]) &&
    !this->Around.touches(piece.segment, blocker.vertices))
  {
    spans.push_back({ from, to });
  }
}

Box2 ContourBlockers::boxOf(std::size_t chart, const Vec3* views, std::size_t count) const
{
  if (!this->Frame.hasOneChart())
  {
    return LightCharts::boxIn(chart, views, count);
  }
  Box2 box;
  for (std::size_t i = 0; i < count; ++i)
  {
    box.add(LightCharts::boxOf(views[i]));
  }
  return box;
}

void ContourBlockers::findSpans(
  const MovedPiece& piece, std::vector<std::array<double, 2>>& spans) const
{
  TreeVisits visits;
  for (std::size_t chart = 0; chart < this->Charts.count(); ++chart)
  {
    const Box2 box = this->boxOf(chart, piece.views.data(), piece.views.size());
    if (isEmpty(box))
    {
      continue;
    }
    bool isAllHidden = false;
    this->Trees[chart].search(box, visits, [&](Index item) {
      this->addSpan(piece, this->Blockers[this->Items[chart][item]], spans);
      isAllHidden = !spans.empty() && spans.back()[0] == 0.0 && spans.back()[1] == 1.0;
      return !isAllHidden;
    });
    if (isAllHidden)
    {
      break;
    }
  }
  unite(spans);
}

HiddenSpans ContourBlockers::hiddenSpans(const std::vector<ContourPiece>& pieces,
  const std::vector<PieceLine>& straight, const ContourWalls& walls, const RangeLoop& loop) const
{
  std::vector<std::vector<std::array<double, 2>>> found(pieces.size());
  loop(pieces.size(), heavyGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
    {
      const Index segment = pieces[i].segment;
      this->findSpans(this->moved(straight[i], walls.wall(segment), segment), found[i]);
    }
  });
  HiddenSpans hidden;
  hidden.least = leastMoves * movedShare * this->Frame.size();
  hidden.first.push_back(0);
  for (const auto& spans : found)
  {
    hidden.spans.insert(hidden.spans.end(), spans.begin(), spans.end());
    hidden.first.push_back(hidden.spans.size());
  }
  return hidden;
}

Obstruction ContourBlockers::obstructionOf(const Vec3& point) const
{
  const Vec3 place = this->Frame.place(point);
  const Vec3 view = this->Frame.view(place);
  const double error = movedShare * this->Frame.size();
  Obstruction found = Obstruction::None;
  TreeVisits visits;
  for (std::size_t chart = 0; chart < this->Charts.count() && found != Obstruction::Other; ++chart)
  {
    const Box2 box = this->boxOf(chart, &view, 1);
    if (isEmpty(box))
    {
      continue;
    }
    this->Trees[chart].search(box, visits, [&](Index item) {
      const Blocker& blocker = this->Blockers[this->Items[chart][item]];
      // Cross products of the same two views in turn are each other's negative bit for bit, so a
      // view on a common edge is within one of two triangles at least.
      const bool isWithin = std::all_of(blocker.edges.begin(), blocker.edges.end(),
        [&](const Vec3& edge) { return glm::dot(edge, view) >= 0.0; });
      if (isWithin && !blocker.isRounding(view) &&
        glm::dot(blocker.normal, place) - blocker.offset > error)
      {
        found = blocker.vertices[0] == None || this->Around.touchesAny(blocker.vertices)
          ? Obstruction::Around
          : Obstruction::Other;
      }
      return found != Obstruction::Other;
    });
  }
  return found;
}
}
