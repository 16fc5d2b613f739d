// Where two pieces of a smooth contour meet, the shadow's boundary has no kink: at a crossing the
// tangent plane holds the light's ray, so it is seen as one line from the light.

#include "Caster.h"
#include "TestMeshes.h"
#include "Tolerances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace shadow;

namespace
{
/// Both tangents of the contour at a crossing, of any length.
struct Joint
{
  Vec3 point;
  Vec3 incoming{ 0.0 };
  Vec3 outgoing{ 0.0 };
  int pieces = 0;
};

/// All that the test knows of the chain's layout.
std::vector<Joint> jointsOf(const Caster& caster, const SilhouetteChain& chain)
{
  const std::size_t vertices = caster.mesh().points.size();
  std::vector<Joint> joints(chain.crossings.size());
  for (std::size_t i = 0; i < joints.size(); ++i)
  {
    joints[i].point = chain.crossings[i].point;
  }
  for (std::size_t i = 0; i < chain.pieces.size(); ++i)
  {
    const CubicCurve& curve = chain.curves[i];
    Joint& from = joints.at(chain.pieces[i].from - vertices);
    Joint& to = joints.at(chain.pieces[i].to - vertices);
    from.outgoing = curve.derivative(0.0);
    to.incoming = curve.derivative(1.0);
    ++from.pieces;
    ++to.pieces;
  }
  return joints;
}

Vec3 vector(const shadowtest::Vec3& v)
{
  return { v[0], v[1], v[2] };
}

TriangleMesh coreMesh(vtkPolyData* data)
{
  shadowtest::MeshBuilder builder;
  builder.append(data);
  TriangleMesh mesh;
  for (std::size_t i = 0; i < builder.Points.size(); ++i)
  {
    mesh.points.push_back(vector(builder.Points[i]));
    mesh.normals.push_back(vector(builder.Normals[i]));
    mesh.normalVertex.push_back(static_cast<Index>(i));
  }
  for (const auto& cell : builder.Cells)
  {
    mesh.triangles.push_back(
      { static_cast<Index>(cell[0]), static_cast<Index>(cell[1]), static_cast<Index>(cell[2]) });
  }
  mesh.cornerNormals = mesh.triangles;
  return mesh;
}

/// What is seen of a tangent from the light: the part across the ray, as a share of the tangent.
Vec3 seen(const Vec3& tangent, const Vec3& ray)
{
  const Vec3 t = glm::normalize(tangent);
  const Vec3 r = glm::normalize(ray);
  return t - glm::dot(t, r) * r;
}

double angleBetween(const Vec3& a, const Vec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

struct Kinks
{
  double largest = 0.0; ///< radians
  std::size_t joints = 0;
  std::size_t leftOut = 0; ///< near cusps
};

Kinks measureKinks(const TriangleMesh& mesh, const Light& light)
{
  Caster caster(mesh, 1.0, serialLoop);
  LastTracked none;
  const auto chain = caster.silhouette(
    light, SilhouetteKind::Smooth, { SearchMethod::BruteForce }, none, serialLoop);
  Kinks kinks;
  for (const Joint& joint : jointsOf(caster, *chain))
  {
    EXPECT_EQ(joint.pieces, 2);
    ++kinks.joints;
    const Vec3 in = seen(joint.incoming, light.toward(joint.point));
    const Vec3 out = seen(joint.outgoing, light.toward(joint.point));
    if (std::fmin(glm::length(in), glm::length(out)) < shadowtest::tolerance::CuspSeenTangent)
    {
      ++kinks.leftOut;
      continue;
    }
    kinks.largest = std::fmax(kinks.largest, angleBetween(in, out));
  }
  return kinks;
}
}

TEST(SmoothJoints, ShadowBoundariesHaveNoKinks)
{
  using namespace shadowtest;
  const std::pair<const char*, Mesh> meshes[] = { { "sphere", sphere(24, 48) },
    { "jittered sphere", icosphere(3, 7) }, { "ellipsoid", ellipsoid(36, 72) },
    { "jittered ellipsoid", icoEllipsoid(4, 7) }, { "torus", torus(72, 36) },
    { "jittered torus", torus(72, 36, 7) }, { "dented", starShaped(4, 5) } };
  const Light lights[] = { { { 0.3, 0.2, 1.0 }, 0.0 }, { { 1.0, 0.3, 0.4 }, 0.0 },
    { { 0.7, 0.5, 1.9 }, 1.0 }, { { 3.1, -1.3, 2.2 }, 1.0 }, { { 60.0, 40.0, 90.0 }, 1.0 } };
  for (const auto& [name, mesh] : meshes)
  {
    const TriangleMesh converted = coreMesh(mesh);
    for (const Light& light : lights)
    {
      const std::string label = std::string(name) + ", light " + std::to_string(light.position.x) +
        ", w = " + std::to_string(light.w);
      const Kinks kinks = measureKinks(converted, light);
      EXPECT_LT(kinks.largest, tolerance::JointAngle) << label;
      EXPECT_GT(kinks.joints, 50u) << label;
      EXPECT_LE(kinks.leftOut, kinks.joints / 10) << label;
    }
  }
}
