// The plan of a frame, rule by rule, without OpenGL; and that no rule changes what is seen.

#include "PlanScene.h"
#include "ShadowPlan.h"
#include "SilhouetteChoice.h"
#include "Tolerances.h"

#include <vtkMath.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{
using namespace shadowtest;

const std::array<double, 6> Room = { -4.0, 4.0, -4.0, 4.0, 0.0, 4.0 };
const PlanReceivers InRoom = { { Room }, true, Room };

ShadowView ahead()
{
  return viewFrom({ 0.0, -6.0, 1.0 }, { 0.0, 0.0, 1.0 });
}

const PlanLight Above = { { 0.0, 0.0, 1.0, 0.0 } };

PlanLight lampAt(const Point3& place)
{
  return { { place[0], place[1], place[2], 1.0 } };
}

PlanLight spotAt(const Point3& place, double coneAngle)
{
  return { { place[0], place[1], place[2], 1.0 }, { 0.0, 0.0, -1.0 }, coneAngle };
}

void expectSkip(const CasterPlan& plan, const std::string& reason)
{
  EXPECT_TRUE(plan.Skip);
  EXPECT_EQ(plan.Decision, "skip");
  EXPECT_EQ(plan.Reason, reason);
}
}

TEST(ShadowPlan, ShadowsOutOfViewAreSkipped)
{
  const ShadowPlan plan(ahead(), InRoom, {});
  EXPECT_FALSE(plan.Decide(Above, boxAround({ 0.0, 0.0, 1.0 }, 0.5)).Skip);
  // Behind the eye: its shadow comes into view only from a light behind it.
  const BoxCorners behind = boxAround({ 0.0, -9.0, 1.0 }, 0.5);
  ShadowRules rules;
  rules.SkipWithoutReceivers = false;
  const ShadowPlan unseen(ahead(), InRoom, rules);
  expectSkip(unseen.Decide(Above, behind), "its shadow does not come into view");
  EXPECT_FALSE(unseen.Decide({ { 0.0, -1.0, 0.05, 0.0 } }, behind).Skip);
  expectSkip(unseen.Decide({ { 0.0, 1.0, 0.05, 0.0 } }, behind),
    "its shadow does not come into view");
  // Above the view, with the shadow falling into it.
  EXPECT_FALSE(plan.Decide(Above, boxAround({ 0.0, 0.0, 9.0 }, 0.5)).Skip);

  rules.SkipUnseen = false;
  EXPECT_FALSE(ShadowPlan(ahead(), InRoom, rules).Decide(Above, behind).Skip);
}

TEST(ShadowPlan, CastersOutsideOfTheConeAreSkipped)
{
  const ShadowPlan plan(ahead(), InRoom, {});
  const Point3 lamp = { 0.0, 0.0, 4.0 };
  const BoxCorners beside = boxAround({ 2.0, 0.0, 1.0 }, 0.5);
  const char* reason = "it is outside of the light's cone";
  // Its nearest point is (1.5, 0, 0.5): at 23.2 degrees from the axis.
  expectSkip(plan.Decide(spotAt(lamp, 23.0), beside), reason);
  EXPECT_FALSE(plan.Decide(spotAt(lamp, 23.4), beside).Skip);
  // The cone within a face, the light in the box, and behind the light.
  EXPECT_FALSE(plan.Decide(spotAt(lamp, 1.0), boxAround({ 0.0, 0.0, 1.0 }, 0.5)).Skip);
  EXPECT_FALSE(plan.Decide(spotAt(lamp, 1.0), boxAround({ 0.1, 0.2, 4.1 }, 0.5)).Skip);
  expectSkip(plan.Decide(spotAt({ 0.0, 0.0, 0.3 }, 80.0), boxAround({ 0.0, 0.0, 1.0 }, 0.5)),
    reason);
  // No cone.
  EXPECT_FALSE(plan.Decide(spotAt(lamp, 90.0), beside).Skip);
  PlanLight direction = spotAt({ 0.0, 0.0, 1.0 }, 1.0);
  direction.Position[3] = 0.0;
  EXPECT_FALSE(plan.Decide(direction, beside).Skip);

  ShadowRules rules;
  rules.SkipOutsideCones = false;
  EXPECT_FALSE(ShadowPlan(ahead(), InRoom, rules).Decide(spotAt(lamp, 23.0), beside).Skip);
}

TEST(ShadowPlan, CastersBeforeNothingAreSkipped)
{
  const BoxCorners caster = boxAround({ 0.0, 0.0, 1.0 }, 0.5);
  const char* reason = "nothing behind it receives";
  const auto decide = [&](const std::array<double, 6>& receiver, const PlanLight& light)
  { return ShadowPlan(ahead(), { { receiver }, true, Room }, {}).Decide(light, caster); };
  const auto floorAt = [](double x) {
    return std::array<double, 6>{ x - 0.5, x + 0.5, -0.5, 0.5, 0.0, 0.0 };
  };
  EXPECT_FALSE(decide(floorAt(0.0), Above).Skip);
  EXPECT_FALSE(decide(floorAt(1.0), Above).Skip); // they touch
  expectSkip(decide(floorAt(1.1), Above), reason);
  // A shadow that spreads, and is lowest at x = 1 / 1 * 0.5 below the box's upper edges.
  EXPECT_FALSE(decide(floorAt(1.1), lampAt({ 0.0, 0.0, 3.0 })).Skip);
  EXPECT_FALSE(decide(floorAt(1.4), lampAt({ 0.0, 0.0, 3.0 })).Skip);
  expectSkip(decide(floorAt(1.6), lampAt({ 0.0, 0.0, 3.0 })), reason);
  // On the light's side: over the box, and beside it in its own height.
  expectSkip(decide(boundsAround({ 0.0, 0.0, 2.1 }, 0.5), lampAt({ 0.0, 0.0, 5.0 })), reason);
  expectSkip(decide(boundsAround({ 1.1, 0.0, 1.0 }, 0.5), Above), reason);
  // Only an edge of the box shows that a slanting shadow passes it.
  expectSkip(decide(boundsAround({ 1.4, 0.0, 1.1 }, 0.3), { { 1.0, 0.0, 1.0, 0.0 } }), reason);
  // The light in the box, and next to it.
  EXPECT_FALSE(decide(floorAt(30.0), lampAt({ 0.0, 0.0, 1.4 })).Skip);
  EXPECT_FALSE(decide(floorAt(3.0), lampAt({ 0.0, 0.0, 1.51 })).Skip);

  EXPECT_TRUE(ShadowPlan(ahead(), { {}, true, Room }, {}).Decide(Above, caster).Skip);
  EXPECT_FALSE(ShadowPlan(ahead(), { {}, false, Room }, {}).Decide(Above, caster).Skip);
  ShadowRules rules;
  rules.SkipWithoutReceivers = false;
  EXPECT_FALSE(ShadowPlan(ahead(), { {}, true, Room }, rules).Decide(Above, caster).Skip);
}

TEST(ShadowPlan, ZFailWhereTheNearPlaneMayBeInShadow)
{
  const ShadowPlan plan(ahead(), InRoom, {});
  EXPECT_TRUE(plan.Decide(Above, boxAround({ 0.0, 0.0, 1.0 }, 0.5)).ZPass);
  // Over the eye, and around it.
  ShadowRules rules;
  rules.SkipWithoutReceivers = false;
  const ShadowPlan over(ahead(), InRoom, rules);
  EXPECT_FALSE(over.Decide(Above, boxAround({ 0.0, -5.5, 3.0 }, 0.5)).ZPass);
  EXPECT_FALSE(over.Decide(Above, boxAround({ 0.0, -5.5, 1.0 }, 0.5)).ZPass);
  // A lamp before or behind what is over the eye.
  rules.SkipUnseen = false;
  const ShadowPlan all(ahead(), InRoom, rules);
  EXPECT_FALSE(all.Decide(lampAt({ 0.0, -5.5, 5.0 }), boxAround({ 0.0, -5.5, 3.0 }, 0.5)).ZPass);
  EXPECT_TRUE(all.Decide(lampAt({ 0.0, -5.5, 2.0 }), boxAround({ 0.0, -5.5, 3.0 }, 0.5)).ZPass);
}

TEST(ShadowPlan, VolumesEndBehindTheReceiversIfTheirRaysComeThere)
{
  const BoxCorners box = boxAround({ 0.0, 0.0, 1.0 }, 0.5);
  const ShadowPlan plan(ahead(), InRoom, {});
  const CasterPlan down = plan.Decide(Above, box);
  EXPECT_EQ(down.End[0], 0.0);
  EXPECT_EQ(down.End[1], 0.0);
  EXPECT_GT(down.End[2], 0.0);
  EXPECT_GT(down.End[3], 0.0);
  EXPECT_NE(down.Decision.find("behind the receivers"), std::string::npos);
  // From within a caster rays go all ways.
  EXPECT_EQ(plan.Decide(lampAt({ 0.0, 0.0, 1.0 }), box).End, Point4{});

  ShadowRules infinite;
  infinite.FiniteVolumes = false;
  EXPECT_EQ(ShadowPlan(ahead(), InRoom, infinite).Decide(Above, box).End, Point4{});
  const PlanReceivers unbounded = { { Room }, false, Room };
  EXPECT_EQ(ShadowPlan(ahead(), unbounded, {}).Decide(Above, box).End, Point4{});
}

TEST(ShadowPlan, DepthsAreThoseOfTheVolume)
{
  // Distances 5.5 to 6.5 of 0.5 to 40: its shadow goes down, across the view.
  const BoxCorners box = boxAround({ 0.0, 0.0, 1.0 }, 0.5);
  const auto depthAt = [](double distance)
  { return 40.0 / 39.5 * (1.0 - 0.5 / distance); };
  const CasterPlan down = ShadowPlan(ahead(), InRoom, {}).Decide(Above, box);
  EXPECT_NEAR(down.DepthRange[0], depthAt(5.5), tolerance::DepthMargin);
  EXPECT_NEAR(down.DepthRange[1], depthAt(6.5), tolerance::DepthMargin);
  // With room for the steps by which walls and caps are drawn off their places, on top of the
  // roundings of single precision (some 9 steps here, where depth is (1 + z) / 2).
  ShadowView flat{ {}, 200, 200 };
  vtkMatrix4x4::Identity(flat.WorldToClip.data());
  const CasterPlan roomy = ShadowPlan(flat, { {}, false, Room }, {})
                             .Decide({ { 0.0, 1.0, 0.0, 0.0 } }, boxAround({ 0.0, 0.0, 0.0 }, 0.1));
  EXPECT_LT(roomy.DepthRange[0], 0.45 - 16.0 * 0x1p-24);
  EXPECT_GT(roomy.DepthRange[1], 0.55 + 16.0 * 0x1p-24);
  // To the eye, and beyond it: from the near plane on.
  const PlanLight behind = { { 0.0, 1.0, 0.0, 0.0 } };
  const CasterPlan toEye = ShadowPlan(ahead(), { { Room }, false, Room }, {}).Decide(behind, box);
  EXPECT_EQ(toEye.DepthRange[0], 0.0);
  EXPECT_NEAR(toEye.DepthRange[1], depthAt(6.5), tolerance::DepthMargin);
  ShadowRules rules;
  rules.DepthBounds = false;
  const std::array<double, 2> all = { 0.0, 1.0 };
  EXPECT_EQ(ShadowPlan(ahead(), InRoom, rules).Decide(Above, box).DepthRange, all);
}

TEST(ShadowPlan, PixelsGrowWithDistanceAndShrinkWithMagnification)
{
  const BoxCorners box = boxAround({ 0.0, 0.0, 1.0 }, 0.5);
  // A pixel is 2 tan(15 degrees) / 200 of the distance wide, and a little less at the corners.
  const double footprint = 2.0 * std::tan(vtkMath::RadiansFromDegrees(15.0)) / 200.0;
  const ShadowPlan plan(ahead(), InRoom, {});
  const double across = plan.Decide(Above, box).Pixel;
  EXPECT_LT(across, 5.5 * footprint);
  EXPECT_GT(across, 0.9 * 5.5 * footprint);
  // From 0.5 above the box the shadow on the plane 0.06 below the floor is 3.2 times as large.
  const double magnified = plan.Decide(lampAt({ 0.0, 0.0, 2.0 }), box).Pixel;
  EXPECT_LT(magnified, across / 3.0);
  EXPECT_GT(magnified, across / 6.0);
  // Around the eye the near plane limits it, in the box or not.
  const double around = plan.Decide(Above, boxAround({ 0.0, -5.0, 1.0 }, 3.0)).Pixel;
  EXPECT_LT(around, 0.5 * footprint);
  EXPECT_GT(around, 0.9 * 0.5 * footprint);
  // The same everywhere without perspective, 6 in 200 pixels.
  const ShadowView parallel = viewFrom({ 0.0, -6.0, 1.0 }, { 0.0, 0.0, 1.0 }, 0.5, true);
  EXPECT_NEAR(ShadowPlan(parallel, InRoom, {}).Decide(Above, box).Pixel, 0.03,
    tolerance::SamePoint);
  // The light in the box: as fine as volumes are drawn.
  EXPECT_GT(plan.Decide(lampAt({ 0.0, 0.0, 1.0 }), box).Pixel, 0.0);

  ShadowRules all;
  all.SkipUnseen = false;
  all.SkipWithoutReceivers = false;
  EXPECT_TRUE(std::isinf(
    ShadowPlan(ahead(), InRoom, all).Decide(Above, boxAround({ 0.0, -9.0, 1.0 }, 0.5)).Pixel));
}

TEST(ShadowPlan, NumbersThatAreNoneSkipNothing)
{
  const double none = std::nan("");
  const BoxCorners box = boxAround({ 2.0, 0.0, 1.0 }, 0.5);
  const ShadowPlan plan(ahead(), InRoom, {});
  EXPECT_FALSE(plan.Decide(lampAt({ none, 0.0, 1.0 }), box).Skip);
  PlanLight spot = spotAt({ 0.0, 0.0, 4.0 }, none);
  EXPECT_FALSE(plan.Decide(spot, box).Skip);
  spot.ConeAngle = 10.0;
  EXPECT_TRUE(plan.Decide(spot, box).Skip);
  spot.Direction = { none, 0.0, 0.0 };
  EXPECT_FALSE(plan.Decide(spot, box).Skip);
  spot.Direction = {};
  EXPECT_FALSE(plan.Decide(spot, box).Skip);
  const CasterPlan nowhere = plan.Decide(Above, boxAround({ none, none, none }, 0.5));
  EXPECT_FALSE(nowhere.Skip);
  EXPECT_GT(nowhere.Pixel, 0.0);
  const std::array<double, 2> all = { 0.0, 1.0 };
  EXPECT_EQ(nowhere.DepthRange, all);
  const std::array<double, 6> nothing = { none, none, none, none, none, none };
  EXPECT_FALSE(ShadowPlan(ahead(), { { nothing }, true, Room }, {}).Decide(Above, box).Skip);
}

TEST(SilhouetteChoice, IsSmoothIfEdgesAreOffByMoreThanTheTolerance)
{
  EXPECT_FALSE(ChooseSilhouette(0.25, 1.0, 1.0).Smooth);
  EXPECT_TRUE(ChooseSilhouette(std::nextafter(0.25, 1.0), 1.0, 1.0).Smooth);
  EXPECT_FALSE(ChooseSilhouette(0.5, 1.0, 2.0).Smooth);
  EXPECT_TRUE(ChooseSilhouette(0.5, 1.0, 1.0).Smooth);
  EXPECT_NE(
    ChooseSilhouette(0.5, 1.0, 1.0).Reason, ChooseSilhouette(0.1, 1.0, 1.0).Reason);
}

TEST(SilhouetteChoice, ToleranceIsAPowerOfTwo)
{
  EXPECT_EQ(ChooseSilhouette(1e3, 1.0, 1.0).Tolerance, 1.0);
  EXPECT_EQ(ChooseSilhouette(1e3, std::nextafter(1.0, 0.0), 1.0).Tolerance, 0.5);
  EXPECT_EQ(ChooseSilhouette(1e3, 1.999, 1.0).Tolerance, 1.0);
  EXPECT_EQ(ChooseSilhouette(1e3, 3.0, 2.0).Tolerance, 4.0);
  EXPECT_EQ(ChooseSilhouette(1e3, 0x1p-1070, 1.0).Tolerance, 0x1p-1070);
  EXPECT_EQ(ChooseSilhouette(0.1, 1.0, 1.0).Tolerance, 0.0);
}

TEST(SilhouetteChoice, ExtremesAreDecided)
{
  const double none = std::nan("");
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(ChooseSilhouette(0.0, 1e-300, 1.0).Smooth);
  EXPECT_FALSE(ChooseSilhouette(0.0, 1.0, 0.0).Smooth);
  EXPECT_FALSE(ChooseSilhouette(infinite, infinite, 1.0).Smooth);
  EXPECT_FALSE(ChooseSilhouette(none, infinite, 1.0).Smooth);
  EXPECT_FALSE(ChooseSilhouette(1.0, none, 1.0).Smooth);
  EXPECT_FALSE(ChooseSilhouette(1.0, 1.0, none).Smooth);
  EXPECT_FALSE(ChooseSilhouette(1.0, 1.0, 0.0).Smooth);
  EXPECT_TRUE(ChooseSilhouette(none, 1.0, 1.0).Smooth);
  EXPECT_TRUE(ChooseSilhouette(infinite, 1.0, 1.0).Smooth);
}
