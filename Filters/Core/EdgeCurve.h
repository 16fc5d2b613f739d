/// The curve on the smooth surface that a mesh edge stands for, and where a light's field is zero
/// on it.
#pragma once

#include "CasterEdges.h"
#include "CubicCurve.h"
#include "QuarticZeros.h"

namespace shadow
{
/// An edge's curve over s in [0, 1], from the edge's end a to its end b.
///
/// On an edge without crease: over the chord, in the frame (x, y, z) with x along the edge and z
/// along the mean normal, a quartic height that meets both normals and keeps a circle's arc to
/// fourth order, and a slope across the edge that interpolates both normals and is corrected by
/// acrossCorrection, which the two triangles at the edge tell (they say how the normal turns
/// between its ends).
///
/// At a crease: one cubic that all sides share, tangent at its ends to both sides' surfaces; each
/// side has its own normals along it.
struct EdgeCurve
{
  enum class Shape : std::uint8_t
  {
    Straight, ///< the chord, with linearly interpolated normals
    Surface,  ///< the curve of an edge without crease
    Crease    ///< the cubic of a crease
  };

  /// Point and normal, the normal not normalised and with the length 1 along z if on a Surface.
  struct Sample
  {
    Vec3 point;
    Vec3 normal;
  };

  Shape shape = Shape::Straight;
  Vec3 a, b;    ///< the ends
  Vec3 x, y, z; ///< Surface: its frame
  double length = 0.0;
  double slopeA = 0.0, slopeB = 0.0;   ///< Surface: slopes along x at the ends
  double acrossA = 0.0, acrossB = 0.0; ///< Surface: slopes along y at the ends
  double acrossCorrection = 0.0;
  double heightCorrection = 0.0;
  CubicCurve crease; ///< Crease: the curve

  Vec3 point(double s) const;
  Vec3 derivative(double s) const;

  /// normalA, normalB: the side's unit normals at the ends. For Surface they are in the frame.
  Sample sample(double s, const Vec3& normalA, const Vec3& normalB) const;

  /// How far the curve is from the chord at most: no point of it is farther from the chord's point
  /// at the same parameter. An upper bound: of a circle's arc it exceeds the sagitta by half the
  /// square of the angle, in radians, between chord and curve at the ends, relatively.
  double chordDeviation() const;

  /// The piece of the curve between two parameters, in this order, as a cubic with the curve's
  /// ends and derivatives.
  CubicCurve arc(double from, double to) const;
};

/// An edge's curve without acrossCorrection.
EdgeCurve makeUncorrectedCurve(
  const TriangleMesh& mesh, const EdgeTable& edges, Index edge, EdgeKind kind);

/// What the triangles at a plain regular edge tell of its curve's acrossCorrection. In single
/// precision: it is kept for many edges, and an error of 1e-7 of it is far below the curve's own.
float makeCorrection(
  const TriangleMesh& mesh, const EdgeTable& edges, Index edge, const EdgeCurve& curve);

/// Derives an edge's curve from its ends, the normals of its sides and, on an edge without crease,
/// from the two triangles at it, which acrossCorrection(curve) tells: makeCorrection, or what it
/// gave before.
template <class AcrossCorrection>
EdgeCurve makeEdgeCurve(const TriangleMesh& mesh, const EdgeTable& edges, Index edge, EdgeKind kind,
  const AcrossCorrection& acrossCorrection)
{
  EdgeCurve curve = makeUncorrectedCurve(mesh, edges, edge, kind);
  if (curve.shape == EdgeCurve::Shape::Surface && kind == EdgeKind::Plain && edges.isRegular(edge))
  {
    curve.acrossCorrection = acrossCorrection(curve);
  }
  return curve;
}

EdgeCurve makeEdgeCurve(const TriangleMesh& mesh, const EdgeTable& edges, Index edge);

/// The field along a Surface curve, over the part of the normals along z.
Quartic fieldQuartic(const EdgeCurve& curve, const Light& light);

/// Where the field on the curve, for one side's normals, is zero: a parameter in [0, 1]. fieldA
/// and fieldB are the field at the ends; one of them is lit and the other one is not.
double solveCrossing(const EdgeCurve& curve, const Vec3& normalA, const Vec3& normalB,
  double fieldA, double fieldB, const Light& light);

/// A first guess at it.
double guessCrossing(const EdgeCurve& curve, const Vec3& normalA, const Vec3& normalB,
  double fieldA, double fieldB);

/// The crossing of a field that is linear along the edge, in [0, 1].
double linearCrossing(double fieldA, double fieldB);
}
