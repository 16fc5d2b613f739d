// The plan against brute force, in random scenes: whatever it decides, samples of casters, shadows
// and receivers are where it says that they can be.

#include "PlanScene.h"
#include "Tolerances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{
using namespace shadowtest;

constexpr std::array<double, 6> Room = { -4.0, 4.0, -4.0, 4.0, 0.0, 4.0 };
constexpr std::uint64_t Scenes = 2000;

struct RandomScene
{
  explicit RandomScene(std::uint64_t seed)
    : Numbers(seed)
    , View(viewFrom(this->Place(), this->Place(), 0.1, this->Numbers.chance(0.2)))
    , Caster(randomBox(this->Place(), this->Numbers))
  {
    const Point3 place = this->Place();
    const double w = this->Numbers.chance(0.6) ? 1.0 : 0.0;
    this->Light.Position = { place[0], place[1], w == 0.0 ? place[2] - 2.0 : 1.5 * place[2], w };
    if (this->Numbers.chance(0.05))
    {
      const Point3 inside = inBox(this->Caster, this->Numbers);
      this->Light.Position = { inside[0], inside[1], inside[2], 1.0 };
    }
    this->Numbers.direction(this->Light.Direction.data());
    const int receivers = this->Numbers.integer(1, 3);
    for (int i = 0; i < receivers; ++i)
    {
      this->Receivers.Bounds.push_back(
        boundsAround(this->Place(), this->Numbers.uniform(0.0, 1.0)));
    }
    this->Receivers.AllBounds = Room;
    this->Receivers.Bounded = this->Numbers.chance(0.7);
  }

  Point3 Place()
  {
    return { this->Numbers.uniform(-4.0, 4.0), this->Numbers.uniform(-4.0, 4.0),
      this->Numbers.uniform(0.0, 4.0) };
  }

  /// How the ray of a point goes on.
  Point3 Ray(const Point3& from) const
  {
    const Point4& light = this->Light.Position;
    return { light[3] * from[0] - light[0], light[3] * from[1] - light[1],
      light[3] * from[2] - light[2] };
  }

  Random Numbers;
  ShadowView View;
  BoxCorners Caster;
  PlanLight Light;
  PlanReceivers Receivers;
};

/// All that concerns one caster, without the rules that leave it out.
ShadowRules withoutSkips()
{
  ShadowRules rules;
  rules.SkipUnseen = false;
  rules.SkipOutsideCones = false;
  rules.SkipWithoutReceivers = false;
  return rules;
}

bool isIn(const std::array<double, 6>& bounds, const Point3& point)
{
  return bounds[0] <= point[0] && point[0] <= bounds[1] && bounds[2] <= point[1] &&
    point[1] <= bounds[3] && bounds[4] <= point[2] && point[2] <= bounds[5];
}

struct Seen
{
  bool InView = false;
  double X = 0.0;
  double Y = 0.0;
  double Depth = 0.0;
};

Seen look(const ShadowView& view, const Point3& point)
{
  const double homogeneous[4] = { point[0], point[1], point[2], 1.0 };
  double clip[4];
  vtkMatrix4x4::MultiplyPoint(view.WorldToClip.data(), homogeneous, clip);
  Seen seen;
  seen.InView = clip[3] > 0.0 && std::fabs(clip[0]) < clip[3] && std::fabs(clip[1]) < clip[3] &&
    std::fabs(clip[2]) < clip[3];
  seen.X = 0.5 * view.Width * (1.0 + clip[0] / clip[3]);
  seen.Y = 0.5 * view.Height * (1.0 + clip[1] / clip[3]);
  seen.Depth = 0.5 * (1.0 + clip[2] / clip[3]);
  return seen;
}

/// How far a ray goes on: to the end of the volume, or a good way if that is infinite.
double randomStep(const CasterPlan& plan, const Point3& from, const Point3& ray, Random& random)
{
  double last = random.chance(0.5) ? 2.0 : 20.0;
  if (plan.End != Point4{})
  {
    const Point3 normal = { plan.End[0], plan.End[1], plan.End[2] };
    last = (dot(normal, from) + plan.End[3]) / -dot(normal, ray);
  }
  return random.uniform(0.0, last);
}
}

TEST(ShadowPlanProperties, NoCasterInTheConeIsSkipped)
{
  int skipped = 0;
  int inCone = 0;
  int missed = 0;
  ShadowRules rules = withoutSkips();
  rules.SkipOutsideCones = true;
  for (std::uint64_t seed = 1; seed <= Scenes; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomScene scene(seed);
    scene.Light.Position[3] = 1.0;
    scene.Light.ConeAngle = scene.Numbers.uniform(0.5, 89.5);
    const bool skip =
      ShadowPlan(scene.View, scene.Receivers, rules).Decide(scene.Light, scene.Caster).Skip;
    skipped += skip;
    bool anyIn = false;
    const Point3 lamp = { scene.Light.Position[0], scene.Light.Position[1],
      scene.Light.Position[2] };
    const double cosine = std::cos(scene.Light.ConeAngle * std::acos(-1.0) / 180.0);
    for (int sample = 0; sample < 500; ++sample)
    {
      const Point3 to = inBox(scene.Caster, scene.Numbers) - lamp;
      anyIn = anyIn || dot(to, scene.Light.Direction) > cosine * std::sqrt(dot(to, to));
    }
    EXPECT_FALSE(skip && anyIn);
    inCone += anyIn;
    missed += !anyIn && !skip;
  }
  EXPECT_GT(skipped, 500);
  EXPECT_GT(inCone, 500);
  // Exact: between the two there are only cones that graze a box, or pass between samples.
  EXPECT_LT(missed, 40);
}

TEST(ShadowPlanProperties, NoCasterBeforeAReceiverIsSkipped)
{
  int skipped = 0;
  int received = 0;
  int missed = 0;
  ShadowRules rules = withoutSkips();
  rules.SkipWithoutReceivers = true;
  for (std::uint64_t seed = 1; seed <= Scenes; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomScene scene(seed);
    scene.Receivers.Bounded = true;
    const bool skip =
      ShadowPlan(scene.View, scene.Receivers, rules).Decide(scene.Light, scene.Caster).Skip;
    skipped += skip;
    bool anyReceives = false;
    for (int sample = 0; sample < 1000; ++sample)
    {
      // Towards receivers, as most of a shadow is elsewhere: is the box between them and the light?
      const std::array<double, 6>& b =
        scene.Receivers.Bounds[static_cast<std::size_t>(sample) % scene.Receivers.Bounds.size()];
      const Point3 place = { scene.Numbers.uniform(b[0], b[1]), scene.Numbers.uniform(b[2], b[3]),
        scene.Numbers.uniform(b[4], b[5]) };
      const Point3 ray = scene.Ray(place);
      // place - t ray in the box's own coordinates, by Cramer's rule.
      const Point3 x = scene.Caster[1] - scene.Caster[0];
      const Point3 y = scene.Caster[2] - scene.Caster[0];
      const Point3 z = scene.Caster[4] - scene.Caster[0];
      const double volume = dot(x, cross(y, z));
      const double last = scene.Light.Position[3] != 0.0 ? 1.0 : 20.0;
      double enter = 0.0;
      double leave = last;
      for (const Point3& normal : { cross(y, z), cross(z, x), cross(x, y) })
      {
        const double at = dot(normal, place - scene.Caster[0]) / volume;
        const double toward = -dot(normal, ray) / volume;
        enter = std::max(enter, std::min(-at / toward, (1.0 - at) / toward));
        leave = std::min(leave, std::max(-at / toward, (1.0 - at) / toward));
      }
      // Flat boxes have no volume: points of theirs are sampled below.
      anyReceives = anyReceives || (volume != 0.0 && enter < leave);
      const Point3 from = inBox(scene.Caster, scene.Numbers);
      const Point3 shadow = from + scene.Numbers.uniform(0.0, 3.0) * scene.Ray(from);
      anyReceives = anyReceives || isIn(b, shadow);
    }
    EXPECT_FALSE(skip && anyReceives);
    received += anyReceives;
    missed += !anyReceives && !skip;
  }
  EXPECT_GT(skipped, 300);
  EXPECT_GT(received, 300);
  EXPECT_LT(missed, 200);
}

TEST(ShadowPlanProperties, VolumesAreWhereThePlanSays)
{
  int zPass = 0;
  int finite = 0;
  int unseen = 0;
  int seenPoints = 0;
  int narrow = 0;
  ShadowRules rules = withoutSkips();
  rules.SkipUnseen = true;
  for (std::uint64_t seed = 1; seed <= Scenes; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomScene scene(seed);
    const CasterPlan plan =
      ShadowPlan(scene.View, scene.Receivers, rules).Decide(scene.Light, scene.Caster);
    zPass += !plan.Skip && plan.ZPass;
    finite += plan.End != Point4{};
    unseen += plan.Skip;
    narrow += plan.DepthRange[1] - plan.DepthRange[0] < 0.2;
    for (int sample = 0; sample < 100; ++sample)
    {
      const Point3 from = inBox(scene.Caster, scene.Numbers);
      const Point3 ray = scene.Ray(from);
      const Point3 point = from + randomStep(plan, from, ray, scene.Numbers) * ray;
      const Seen seen = look(scene.View, point);
      if (plan.Skip)
      {
        EXPECT_FALSE(seen.InView && isIn(Room, point));
        continue;
      }
      const Point3 inRoom = from + scene.Numbers.uniform(0.0, 2.0) * ray;
      if (plan.End != Point4{} && isIn(Room, inRoom))
      {
        EXPECT_GT(dot({ plan.End[0], plan.End[1], plan.End[2] }, inRoom) + plan.End[3], 0.0);
      }
      if (!seen.InView)
      {
        continue;
      }
      ++seenPoints;
      EXPECT_GE(seen.X, plan.Scissor[0]);
      EXPECT_LE(seen.X, plan.Scissor[0] + plan.Scissor[2]);
      EXPECT_GE(seen.Y, plan.Scissor[1]);
      EXPECT_LE(seen.Y, plan.Scissor[1] + plan.Scissor[3]);
      EXPECT_GE(seen.Depth, plan.DepthRange[0]);
      EXPECT_LE(seen.Depth, plan.DepthRange[1]);
    }
    // A place on the near rectangle from which the light is hidden by the box: z-pass would miss
    // it.
    for (int sample = 0; sample < 20 && !plan.Skip; ++sample)
    {
      Matrix4 toWorld;
      vtkMatrix4x4::Invert(scene.View.WorldToClip.data(), toWorld.data());
      const double clip[4] = { scene.Numbers.uniform(-1.0, 1.0), scene.Numbers.uniform(-1.0, 1.0),
        -1.0, 1.0 };
      double world[4];
      vtkMatrix4x4::MultiplyPoint(toWorld.data(), clip, world);
      const Point3 place = { world[0] / world[3], world[1] / world[3], world[2] / world[3] };
      const Point3 x = scene.Caster[1] - scene.Caster[0];
      const Point3 y = scene.Caster[2] - scene.Caster[0];
      const Point3 z = scene.Caster[4] - scene.Caster[0];
      const double volume = dot(x, cross(y, z));
      const Point3 towards = place -
        scene.Numbers.uniform(0.0, scene.Light.Position[3] != 0.0 ? 1.0 : 4.0) * scene.Ray(place) -
        scene.Caster[0];
      bool hidden = volume != 0.0;
      for (const Point3& normal : { cross(y, z), cross(z, x), cross(x, y) })
      {
        const double at = dot(normal, towards) / volume;
        hidden = hidden && at > 0.0 && at < 1.0;
      }
      EXPECT_FALSE(hidden && plan.ZPass);
    }
  }
  EXPECT_GT(zPass, 300);
  EXPECT_GT(finite, 300);
  EXPECT_LT(finite, static_cast<int>(Scenes) - 300);
  EXPECT_GT(unseen, 100);
  EXPECT_GT(narrow, 100);
  EXPECT_GT(seenPoints, 5000);
}

TEST(ShadowPlanProperties, AStepOfAPixelMovesTheShadowByAtMostOne)
{
  int samples = 0;
  int scenesSeen = 0;
  int scenesTight = 0;
  for (std::uint64_t seed = 1; seed <= Scenes; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomScene scene(seed);
    const CasterPlan plan =
      ShadowPlan(scene.View, scene.Receivers, withoutSkips()).Decide(scene.Light, scene.Caster);
    // With the light in the box the resolution of volumes is given instead.
    const Point3 diagonal = scene.Caster[7] - scene.Caster[0];
    if (plan.Pixel < 0x1p-20 * std::sqrt(dot(diagonal, diagonal)))
    {
      continue;
    }
    double greatest = 0.0;
    bool anySeen = false;
    for (int sample = 0; sample < 200; ++sample)
    {
      const Point3 from = inBox(scene.Caster, scene.Numbers);
      const Point3 ray = scene.Ray(from);
      const double step = randomStep(plan, from, ray, scene.Numbers);
      const Seen before = look(scene.View, from + step * ray);
      if (!before.InView)
      {
        continue;
      }
      ASSERT_TRUE(std::isfinite(plan.Pixel));
      anySeen = true;
      ++samples;
      Point3 direction;
      scene.Numbers.direction(direction.data());
      const Point3 across = normalized(cross(direction, ray));
      const Point3 moved = from + plan.Pixel * across;
      const Seen after = look(scene.View, moved + step * scene.Ray(moved));
      greatest = std::max(greatest, std::hypot(after.X - before.X, after.Y - before.Y));
    }
    EXPECT_LE(greatest, 1.0 + tolerance::Moved);
    scenesSeen += anySeen;
    scenesTight += greatest > 0.5;
  }
  EXPECT_GT(samples, 10000);
  EXPECT_GT(scenesSeen, 500);
  EXPECT_GT(scenesTight, 300);
}
