/// The core's vocabulary: vectors in double, the light, and the arrays of a mesh.
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace shadow
{
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Index = std::uint32_t;

/// No index: the value of an Index that refers to nothing.
constexpr Index None = std::numeric_limits<Index>::max();

inline bool isFinite(const Vec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// By size.
inline double largestComponent(const Vec3& v)
{
  return std::max(std::fabs(v.x), std::max(std::fabs(v.y), std::fabs(v.z)));
}

/// The vector of unit length, or zero where it has no direction: zero or no finite vector. Squares
/// of very large and very small components leave the range of doubles, so these are scaled first.
inline Vec3 unitOrZero(const Vec3& v)
{
  const double squared = glm::dot(v, v);
  if (squared > 1e-280 && squared < 1e280)
  {
    return v * (1.0 / std::sqrt(squared));
  }
  const double largest = largestComponent(v);
  if (!isFinite(v) || !(largest > 0.0))
  {
    return Vec3(0.0);
  }
  const Vec3 scaled = v / largest;
  return scaled / glm::length(scaled);
}

/// The vector of unit length, or where it has no direction the other one, as it is.
inline Vec3 unitOr(const Vec3& v, const Vec3& otherwise)
{
  const Vec3 unit = unitOrZero(v);
  return unit != Vec3(0.0) ? unit : otherwise;
}

/// A light, homogeneous with w >= 0: a point for w > 0, at position / w; for w = 0 the direction
/// towards a light at infinity.
struct Light
{
  Vec3 position{ 0.0, 0.0, 1.0 };
  double w = 0.0;

  bool isDirectional() const { return this->w == 0.0; }

  /// From a point towards the light, not normalised.
  Vec3 toward(const Vec3& point) const { return this->position - this->w * point; }

  /// Where a point's shadow ends at infinity: a homogeneous point with w = 0.
  Vec4 extrude(const Vec3& point) const { return Vec4(-this->toward(point), 0.0); }

  bool operator==(const Light& o) const { return position == o.position && w == o.w; }
};

/// Lit means a field of at least zero; a field that is no number is dark. Every topological
/// decision follows from this one rule, taken once a corner or a face and never once an edge.
inline bool isLit(double field)
{
  return field >= 0.0;
}

/// A box along the axes, with its faces.
struct Box
{
  Vec3 low{ std::numeric_limits<double>::infinity() };
  Vec3 high{ -std::numeric_limits<double>::infinity() };

  void add(const Vec3& point)
  {
    this->low = glm::min(this->low, point);
    this->high = glm::max(this->high, point);
  }

  void add(const Box& other)
  {
    this->low = glm::min(this->low, other.low);
    this->high = glm::max(this->high, other.high);
  }

  bool meets(const Box& o) const
  {
    return this->low.x <= o.high.x && o.low.x <= this->high.x && this->low.y <= o.high.y &&
      o.low.y <= this->high.y && this->low.z <= o.high.z && o.low.z <= this->high.z;
  }
};

using Triangle = std::array<Index, 3>;

/// A ball around a mesh: the centre of its bounds and half their diagonal.
struct Ball
{
  Vec3 centre{ 0.0 };
  double radius = 0.0;
};

/// Triangles over distinct vertices. Each corner has a normal of its own; corners at one vertex
/// that share their normal share its number.
struct TriangleMesh
{
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;     ///< vertex of each corner; three distinct ones
  std::vector<Vec3> normals;           ///< unit length, or zero where none is known
  std::vector<Index> normalVertex;     ///< the vertex at which each normal is
  std::vector<Triangle> cornerNormals; ///< normal of each corner
  std::vector<Index> sources;          ///< if known, each vertex's number where it comes from

  /// Normal of a triangle by its winding, twice its area long.
  Vec3 areaNormal(Index triangle) const
  {
    const Triangle& t = this->triangles[triangle];
    const Vec3& origin = this->points[t[0]];
    return glm::cross(this->points[t[1]] - origin, this->points[t[2]] - origin);
  }

  /// Endless and inside out without points.
  Box bounds() const
  {
    Box bounds;
    for (const Vec3& p : this->points)
    {
      bounds.add(p);
    }
    return bounds;
  }

  Ball ball() const
  {
    if (this->points.empty())
    {
      return {};
    }
    const Box bounds = this->bounds();
    return { 0.5 * (bounds.low + bounds.high), 0.5 * glm::length(bounds.high - bounds.low) };
  }
};

/// The next corner of a triangle, counter-clockwise; side k runs from corner k to corner next(k).
constexpr unsigned next(unsigned corner)
{
  return corner == 2 ? 0 : corner + 1;
}
}
