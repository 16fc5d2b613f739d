#include "SilhouetteWalk.h"

#include <algorithm>

namespace shadow
{
/// Infinite where it is no number. Between the corners of a triangle without a change of sign the
/// sum is as good as any value, and unlike the least one it differs between neighbours.
float SilhouetteWalk::distanceToZero(Index triangle) const
{
  double distance;
  if (this->Field.kind() == FieldKind::Face)
  {
    distance = std::fabs(this->Field.value(triangle)) /
      glm::length(this->Searched.mesh.areaNormal(triangle));
  }
  else
  {
    const Triangle& n = this->Searched.mesh.cornerNormals[triangle];
    distance =
      std::fabs(this->Field.value(n[0]) + this->Field.value(n[1]) + this->Field.value(n[2]));
  }
  // A double beyond float's range has no defined value there.
  return distance < std::numeric_limits<float>::max() ? static_cast<float>(distance)
                                                      : std::numeric_limits<float>::infinity();
}

void SilhouetteWalk::offer(Index triangle)
{
  const IndexSet::Insertion seen = this->Seen.insert(triangle);
  if (seen.isNew)
  {
    this->Front.push_back({ this->distanceToZero(triangle), seen.place, triangle });
    std::push_heap(this->Front.begin(), this->Front.end());
  }
}

bool SilhouetteWalk::walkFrom(Index start, std::size_t budget)
{
  const std::size_t mostSeen = this->Seen.size() + budget;
  this->Front.clear();
  this->offer(start);
  while (!this->Front.empty() && this->Seen.size() <= mostSeen)
  {
    const Index triangle = this->Front.front().triangle;
    std::pop_heap(this->Front.begin(), this->Front.end());
    this->Front.pop_back();
    ++this->Visited;
    if (this->Follower.startAt(triangle))
    {
      return true;
    }
    const EdgeTable& edges = this->Searched.edges;
    for (const Index edge : edges.triangleEdges[triangle])
    {
      for (Index i = edges.firstSide(edge); i < edges.firstSide(edge + 1); ++i)
      {
        this->offer(edges.sides[i] / 3);
      }
    }
  }
  return false;
}
}
