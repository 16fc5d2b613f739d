#include "EdgeCurve.h"

#include <algorithm>

namespace shadow
{
namespace
{
/// Below this cosine against the frame's z a normal's slopes say nothing.
constexpr double steepestCosine = 0.25;

/// A vertex in the frame of an edge, relative to the edge's end a: its place and the slopes of
/// the surface there.
struct FramedVertex
{
  double x, y, z;
  double gx, gy;
  bool usable;
};

FramedVertex framed(const EdgeCurve& c, const Vec3& point, const Vec3& normal)
{
  const Vec3 d = point - c.a;
  const double nz = glm::dot(normal, c.z);
  return { glm::dot(d, c.x), glm::dot(d, c.y), glm::dot(d, c.z), -glm::dot(normal, c.x) / nz,
    -glm::dot(normal, c.y) / nz, nz > steepestCosine };
}

/// Adds one triangle's two equations for the correction (half of it) to a least-squares sum: the
/// cubic Bezier patch over triangle (a, b, c) is to continue to vertex d of the other triangle
/// with that vertex's place and slopes.
void addEquations(const EdgeCurve& e, const FramedVertex& c, const FramedVertex& d, double& num,
  double& den)
{
  const double L = e.length;
  const double sa = e.slopeA;
  const double sb = e.slopeB;
  const double ga = e.acrossA;
  const double gb = e.acrossB;
  // Bezier ordinates of the patch that are fixed by places and slopes at a, b and c.
  const double b210 = sa * L / 3.0;
  const double b120 = -sb * L / 3.0;
  const double b201 = (sa * c.x + ga * c.y) / 3.0;
  const double b021 = (sb * (c.x - L) + gb * c.y) / 3.0;
  const double b102 = c.z - (c.gx * c.x + c.gy * c.y) / 3.0;
  const double b012 = c.z + (c.gx * (L - c.x) - c.gy * c.y) / 3.0;
  // The same ordinates of the patch of the other triangle, as vertex d tells them.
  const double r102 = d.z - (d.gx * d.x + d.gy * d.y) / 3.0;
  const double r012 = d.z + (d.gx * (L - d.x) - d.gy * d.y) / 3.0;
  // d in barycentric coordinates of (a, b, c), and the derivatives of these along y.
  const double G = d.y / c.y;
  const double B = (d.x - G * c.x) / L;
  const double A = 1.0 - B - G;
  const double yc = 1.0 / c.y;
  const double yb = -c.x / (c.y * L);
  const double ya = -yc - yb;
  const double linear = ((ga + gb) / 6.0 - ya * b210 - yb * b120) / yc;
  const double w1 = 2.0 * B * G;
  const double w2 = 2.0 * A * G;
  const double r1 = r102 -
    (B * B * b120 + G * G * b102 + 2.0 * A * B * b210 + 2.0 * A * G * b201) - w1 * linear;
  const double r2 = r012 -
    (A * A * b210 + G * G * b012 + 2.0 * A * B * b120 + 2.0 * B * G * b021) - w2 * linear;
  const double q = 1.0 / (L * (0.5 + A * A + B * B + G * G));
  const double a1 = w1 * q / (3.0 * yc);
  const double a2 = w2 * q / (3.0 * yc);
  num += q * (a1 * r1 + a2 * r2);
  den += a1 * a1 + a2 * a2;
}

FramedVertex oppositeVertex(const TriangleMesh& mesh, const EdgeCurve& curve, Side side)
{
  const unsigned corner = next(next(side % 3));
  return framed(curve, mesh.points[mesh.triangles[side / 3][corner]],
    mesh.normals[mesh.cornerNormals[side / 3][corner]]);
}

void shapeSurface(const TriangleMesh& mesh, const SideNormals& sides, EdgeCurve& c)
{
  const Vec3 na = mesh.normals[sides.a];
  const Vec3 nb = mesh.normals[sides.b];
  c.length = glm::length(c.b - c.a);
  c.x = (c.b - c.a) * (1.0 / c.length);
  const Vec3 mean = na + nb;
  c.z = unitOrZero(mean - glm::dot(mean, c.x) * c.x);
  c.y = glm::cross(c.z, c.x);
  const double za = glm::dot(na, c.z);
  const double zb = glm::dot(nb, c.z);
  if (!(za > steepestCosine) || !(zb > steepestCosine))
  {
    return;
  }
  c.shape = EdgeCurve::Shape::Surface;
  const double overA = -1.0 / za;
  const double overB = -1.0 / zb;
  c.slopeA = glm::dot(na, c.x) * overA;
  c.slopeB = glm::dot(nb, c.x) * overB;
  c.acrossA = glm::dot(na, c.y) * overA;
  c.acrossB = glm::dot(nb, c.y) * overB;
  // What a circle's arc has more than the cubic with the same ends and slopes: it turns by the
  // angle of (cosine, sine), of which the tangents of the half and of the quarter are needed.
  const double cosine = 1.0 + c.slopeA * c.slopeB;
  const double sine = c.slopeA - c.slopeB;
  const double half = sine / (std::sqrt(cosine * cosine + sine * sine) + cosine);
  const double quarter = half / (1.0 + std::sqrt(1.0 + half * half));
  c.heightCorrection = c.length * (8.0 * quarter - 4.0 * half);
}

/// The tangent of a crease at one end: along both sides' surfaces, at the length that makes the
/// cubic keep a circle's arc; the chord where that is no usable direction.
Vec3 creaseTangent(const Vec3& n1, const Vec3& n2, const Vec3& chord)
{
  const double length = glm::length(chord);
  Vec3 t = glm::cross(n1, n2);
  if (glm::length(t) < 0.05)
  {
    const Vec3 n = unitOrZero(n1 + n2);
    t = chord - glm::dot(chord, n) * n;
  }
  t = unitOrZero(t);
  double cosine = glm::dot(t, chord) / length;
  if (cosine < 0.0)
  {
    t = -t;
    cosine = -cosine;
  }
  return cosine >= 0.5 ? t * (2.0 * length / (1.0 + cosine)) : chord;
}

void shapeCrease(
  const TriangleMesh& mesh, const std::vector<SideNormals>& normals, EdgeCurve& c)
{
  c.shape = EdgeCurve::Shape::Crease;
  const Vec3 chord = c.b - c.a;
  if (normals.size() != 2)
  {
    c.crease = CubicCurve::line(c.a, c.b);
    return;
  }
  c.crease = CubicCurve::hermite(c.a,
    creaseTangent(mesh.normals[normals[0].a], mesh.normals[normals[1].a], chord), c.b,
    creaseTangent(mesh.normals[normals[0].b], mesh.normals[normals[1].b], chord));
}

double height(const EdgeCurve& c, double s)
{
  const double r = 1.0 - s;
  return c.length * (c.slopeA * s * r * r - c.slopeB * s * s * r) +
    c.heightCorrection * s * s * r * r;
}

double slopeAlong(const EdgeCurve& c, double s)
{
  const double r = 1.0 - s;
  return c.slopeA * r * (1.0 - 3.0 * s) + c.slopeB * s * (3.0 * s - 2.0) +
    2.0 * c.heightCorrection * s * r * (1.0 - 2.0 * s) / c.length;
}
/// The heights' coefficients of s, s^2, s^3 and s^4.
Vec4 heightPolynomial(const EdgeCurve& c)
{
  const double la = c.length * c.slopeA;
  const double lb = c.length * c.slopeB;
  return { la, c.heightCorrection - 2.0 * la - lb, la + lb - 2.0 * c.heightCorrection,
    c.heightCorrection };
}

/// Regula falsi with the Illinois rule (Dowell & Jarratt 1971): where one end stays twice its value
/// is halved, so that it moves as well.
double solveOnCrease(const EdgeCurve& curve, const Vec3& normalA, const Vec3& normalB,
  double fieldA, double fieldB, const Light& light)
{
  double s0 = 0.0;
  double s1 = 1.0;
  double f0 = fieldA;
  double f1 = fieldB;
  double s = linearCrossing(f0, f1);
  int stayed = 0;
  for (int step = 0; step < 12; ++step)
  {
    const EdgeCurve::Sample q = curve.sample(s, normalA, normalB);
    const double f = glm::dot(q.normal, light.toward(q.point));
    const bool replacesFirst = isLit(f) == isLit(fieldA);
    if (replacesFirst)
    {
      s0 = s;
      f0 = f;
      f1 = stayed == 1 ? 0.5 * f1 : f1;
      stayed = 1;
    }
    else
    {
      s1 = s;
      f1 = f;
      f0 = stayed == -1 ? 0.5 * f0 : f0;
      stayed = -1;
    }
    const double nextS = s0 + (s1 - s0) * linearCrossing(f0, f1);
    const double moved = std::fabs(nextS - s);
    s = nextS;
    if (f == 0.0 || moved < 1e-14)
    {
      break;
    }
  }
  return s;
}
}

Vec3 EdgeCurve::point(double s) const
{
  switch (this->shape)
  {
    case Shape::Surface:
      return this->a + s * (this->b - this->a) + height(*this, s) * this->z;
    case Shape::Crease:
      return this->crease.point(s);
    default:
      return this->a + s * (this->b - this->a);
  }
}

Vec3 EdgeCurve::derivative(double s) const
{
  switch (this->shape)
  {
    case Shape::Surface:
      return this->length * (this->x + slopeAlong(*this, s) * this->z);
    case Shape::Crease:
      return this->crease.derivative(s);
    default:
      return this->b - this->a;
  }
}

/// A Surface's height is the cubic with the ends' slopes, whose inner ordinates are a third of
/// these and weigh at most 3/4 together, and the correction times s^2 (1-s)^2, which is 1/16 at most.
double EdgeCurve::chordDeviation() const
{
  switch (this->shape)
  {
    case Shape::Surface:
      return 0.25 * this->length * std::max(std::fabs(this->slopeA), std::fabs(this->slopeB)) +
        std::fabs(this->heightCorrection) / 16.0;
    case Shape::Crease:
      return this->crease.deviationBound();
    default:
      return 0.0;
  }
}

EdgeCurve::Sample EdgeCurve::sample(double s, const Vec3& normalA, const Vec3& normalB) const
{
  Sample result{ this->point(s), normalA + s * (normalB - normalA) };
  if (this->shape == Shape::Surface)
  {
    const double across = (1.0 - s) * this->acrossA + s * this->acrossB +
      s * (1.0 - s) * this->acrossCorrection;
    result.normal = this->z - slopeAlong(*this, s) * this->x - across * this->y;
  }
  else if (this->shape == Shape::Crease)
  {
    const Vec3 t = unitOrZero(this->derivative(s));
    result.normal -= glm::dot(result.normal, t) * t;
  }
  return result;
}

CubicCurve EdgeCurve::arc(double from, double to) const
{
  const double span = to - from;
  return CubicCurve::hermite(this->point(from), span * this->derivative(from), this->point(to),
    span * this->derivative(to));
}

EdgeCurve makeUncorrectedCurve(
  const TriangleMesh& mesh, const EdgeTable& edges, Index edge, EdgeKind kind)
{
  EdgeCurve curve;
  curve.a = mesh.points[edges.edges[edge].a];
  curve.b = mesh.points[edges.edges[edge].b];
  if (kind == EdgeKind::Plain)
  {
    shapeSurface(
      mesh, sideNormals(mesh, edges, edge, edges.sides[edges.firstSide(edge)]), curve);
    return curve;
  }
  const std::vector<SideNormals> normals = distinctNormals(mesh, edges, edge);
  if (normals.size() == 1)
  {
    shapeSurface(mesh, normals[0], curve);
  }
  else
  {
    shapeCrease(mesh, normals, curve);
  }
  return curve;
}

float makeCorrection(
  const TriangleMesh& mesh, const EdgeTable& edges, Index edge, const EdgeCurve& curve)
{
  const FramedVertex o0 = oppositeVertex(mesh, curve, edges.sides[edges.firstSide(edge)]);
  const FramedVertex o1 = oppositeVertex(mesh, curve, edges.sides[edges.firstSide(edge) + 1]);
  if (!(o0.y * o1.y < 0.0) || !o0.usable || !o1.usable)
  {
    return 0.0f;
  }
  const double limit = std::fabs(curve.acrossA - curve.acrossB) +
    std::fabs(curve.slopeA - curve.slopeB);
  double num = 0.0;
  // A ridge keeps slivers harmless. It falls with the square of the edge, or else it would damp the
  // correction by the same share on every mesh and end at order 3 where triangles are flat.
  double den = 0.003 * limit * limit;
  addEquations(curve, o0, o1, num, den);
  addEquations(curve, o1, o0, num, den);
  const float correction = static_cast<float>(2.0 * std::clamp(num / den, -limit, limit));
  return std::isfinite(correction) ? correction : 0.0f;
}

EdgeCurve makeEdgeCurve(const TriangleMesh& mesh, const EdgeTable& edges, Index edge)
{
  return makeEdgeCurve(mesh, edges, edge, edgeKind(mesh, edges, edge),
    [&](const EdgeCurve& curve) { return makeCorrection(mesh, edges, edge, curve); });
}

double linearCrossing(double fieldA, double fieldB)
{
  const double s = fieldA / (fieldA - fieldB);
  return s >= 0.0 && s <= 1.0 ? s : 0.5;
}

/// In the curve's frame, with the light at R from the end a, the field is
/// Rz - w z(s) - z'(s)/L (Rx - w L s) - across(s) Ry.
Quartic fieldQuartic(const EdgeCurve& c, const Light& light)
{
  const Vec3 toward = light.toward(c.a);
  const double rx = glm::dot(c.x, toward) / c.length;
  const double ry = glm::dot(c.y, toward);
  const double rz = glm::dot(c.z, toward);
  const Vec4 z = heightPolynomial(c);
  return { { rz - z[0] * rx - c.acrossA * ry,
    -2.0 * z[1] * rx - (c.acrossB - c.acrossA + c.acrossCorrection) * ry,
    -3.0 * z[2] * rx + c.acrossCorrection * ry + light.w * z[1],
    -4.0 * z[3] * rx + 2.0 * light.w * z[2], 3.0 * light.w * z[3] } };
}

double guessCrossing(const EdgeCurve& curve, const Vec3& normalA, const Vec3& normalB,
  double fieldA, double fieldB)
{
  // On a Surface the normals along the curve have length 1 along z: the ends' fields likewise.
  return curve.shape == EdgeCurve::Shape::Surface
    ? linearCrossing(fieldA * glm::dot(normalB, curve.z), fieldB * glm::dot(normalA, curve.z))
    : linearCrossing(fieldA, fieldB);
}

double solveCrossing(const EdgeCurve& curve, const Vec3& normalA, const Vec3& normalB,
  double fieldA, double fieldB, const Light& light)
{
  const double guess = guessCrossing(curve, normalA, normalB, fieldA, fieldB);
  switch (curve.shape)
  {
    case EdgeCurve::Shape::Surface:
    {
      QuarticZeros zeros;
      zeros.add(fieldQuartic(curve, light), guess);
      zeros.refine();
      return zeros.zero(0, isLit(fieldA));
    }
    case EdgeCurve::Shape::Crease:
      return solveOnCrease(curve, normalA, normalB, fieldA, fieldB, light);
    default:
      return guess;
  }
}
}
