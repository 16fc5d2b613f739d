#include "ContourOracle.h"

#include <vtkCellArray.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace shadowtest
{
namespace
{
/// A part of the line in which a wall's plane cuts a triangle, from which half-spaces are cut.
struct Part
{
  Vec3 From;
  Vec3 To;
  bool Empty = false;

  /// Keeps where f >= 0; f is affine.
  template <class Field>
  void clip(const Field& f)
  {
    const double from = f(this->From);
    const double to = f(this->To);
    if (from < 0.0 && to < 0.0)
    {
      this->Empty = true;
    }
    else if (from < 0.0 || to < 0.0)
    {
      const Vec3 at = this->From + from / (from - to) * (this->To - this->From);
      (from < 0.0 ? this->From : this->To) = at;
    }
  }
};

/// Where the plane with that normal through a point cuts a triangle.
Part cut(const std::array<Vec3, 3>& t, const Vec3& normal, const Vec3& through)
{
  std::vector<Vec3> ends;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3& p = t[k];
    const Vec3& q = t[(k + 1) % 3];
    const double before = dot(normal, p - through);
    const double behind = dot(normal, q - through);
    if ((before < 0.0) != (behind < 0.0))
    {
      ends.push_back(p + before / (before - behind) * (q - p));
    }
  }
  return ends.size() == 2 ? Part{ ends[0], ends[1] } : Part{ {}, {}, true };
}
}

SegmentChain contoursByBruteForce(vtkPolyData* silhouette, vtkPolyData* receiver,
  const std::array<double, 4>& light, double least)
{
  MeshBuilder mesh;
  mesh.append(receiver);
  const Vec3 l{ light[0], light[1], light[2] };
  SegmentChain chain;
  for (vtkIdType line = 0; line < silhouette->GetNumberOfLines(); ++line)
  {
    vtkIdType count;
    const vtkIdType* ids;
    silhouette->GetLines()->GetCellAtId(line, count, ids);
    for (vtkIdType i = 0; i + 1 < count; ++i)
    {
      Vec3 a;
      Vec3 b;
      silhouette->GetPoint(ids[i], a.data());
      silhouette->GetPoint(ids[i + 1], b.data());
      const Vec3 rayA = light[3] * a - l;
      const Vec3 rayB = light[3] * b - l;
      const Vec3 wall = cross(b - a, rayA); // into the shadow: to the left as the light sees it
      for (const auto& cell : mesh.Cells)
      {
        const std::array<Vec3, 3> t{ mesh.Points[static_cast<std::size_t>(cell[0])],
          mesh.Points[static_cast<std::size_t>(cell[1])],
          mesh.Points[static_cast<std::size_t>(cell[2])] };
        const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
        if (dot(normal, l - light[3] * t[0]) < 0.0)
        {
          continue;
        }
        Part part = cut(t, wall, a);
        // In the wall's plane: right of the ray through a, left of that through b, and beyond the
        // segment.
        const auto side = [&](const Vec3& at, const Vec3& ray, double sign)
        { return [=](const Vec3& p) { return sign * dot(cross(p - at, ray), wall); }; };
        const double turn = dot(cross(b - a, rayA), wall) > 0.0 ? 1.0 : -1.0;
        if (!part.Empty)
        {
          part.clip(side(a, rayA, turn));
        }
        if (!part.Empty)
        {
          part.clip(side(b, rayB, -turn));
        }
        if (!part.Empty)
        {
          const Vec3 across = cross(b - a, wall);
          const double sign = dot(across, rayA) > 0.0 ? 1.0 : -1.0;
          part.clip([&](const Vec3& p) { return sign * dot(across, p - a); });
        }
        const Vec3 along = part.To - part.From;
        if (part.Empty || std::sqrt(dot(along, along)) < least)
        {
          continue;
        }
        // The lit side is on the right of the way as seen from the light.
        const bool turned = dot(cross(along, normal), wall) > 0.0;
        addSegment(
          chain, turned ? part.To : part.From, turned ? part.From : part.To, 1);
      }
    }
  }
  return chain;
}
}
