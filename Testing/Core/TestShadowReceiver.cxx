#include "ShadowReceiver.h"

#include <gtest/gtest.h>

#include <random>

using namespace shadow;

namespace
{
struct Bounds
{
  Vec3 low;
  Vec3 high;
};

/// A plane through which a ray leaves the bounds.
struct Exit
{
  bool hit = false;
  int axis = 0;
  double offset = 0.0;
  Vec3 place{ 0.0 };
};

/// By slabs, beyond the point itself.
Exit exitOf(const Light& light, const Bounds& bounds, const Vec3& point)
{
  const Vec3 ray = -light.toward(point);
  double in = 0.0; // of point + t ray
  double out = std::numeric_limits<double>::infinity();
  Exit exit;
  for (int axis = 0; axis < 3; ++axis)
  {
    double first = (bounds.low[axis] - point[axis]) / ray[axis];
    double second = (bounds.high[axis] - point[axis]) / ray[axis];
    const bool upwards = ray[axis] > 0.0;
    if (!upwards)
    {
      std::swap(first, second);
    }
    in = std::max(in, first);
    if (second < out)
    {
      out = second;
      exit.axis = axis;
      exit.offset = upwards ? bounds.high[axis] : bounds.low[axis];
    }
  }
  exit.hit = in <= out;
  exit.place = point + out * ray;
  return exit;
}

Vec3 shadowOf(const Light& light, const Exit& plane, const Vec3& point)
{
  const Vec3 ray = -light.toward(point);
  return point + ((plane.offset - point[plane.axis]) / ray[plane.axis]) * ray;
}

double distanceToChord(const Vec3& q, const Vec3& a, const Vec3& b)
{
  const Vec3 along = b - a;
  const double t = glm::dot(q - a, along) / glm::dot(along, along);
  return glm::length(q - (a + std::fmin(std::fmax(t, 0.0), 1.0) * along));
}

class Draw
{
public:
  /// With halves, many lights are in the planes of the bounds, and at their corners.
  Draw(unsigned seed, bool halves)
    : Engine(seed)
    , Halves(halves)
  {
  }

  double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(this->Engine); }
  Vec3 vector() { return { this->number(), this->number(), this->number() }; }

  CubicCurve curve()
  {
    const double size = std::pow(10.0, -1.0 + this->number());
    const Vec3 start = this->vector();
    const Vec3 along = size * this->vector();
    return { { start, start + along / 3.0 + 0.2 * size * this->vector(),
      start + 2.0 * along / 3.0 + 0.2 * size * this->vector(), start + along } };
  }

  /// Around the curve, or off it; sometimes flat.
  Bounds bounds()
  {
    const Vec3 middle = this->rounded(2.0 * this->vector());
    Vec3 half = this->rounded(glm::abs(3.0 * this->vector()));
    if (this->number() > 0.0)
    {
      half[static_cast<int>(1.49 * (this->number() + 1.0))] = 0.0;
    }
    return { middle - half, middle + half };
  }

  Light light()
  {
    const double kind = this->number();
    const double w = kind > -0.8 ? 1.0 : 4.0;
    return kind > 0.3
      ? Light{ this->vector(), 0.0 }
      : Light{ w * this->rounded((kind > -0.5 ? 5.0 : 1.5) * this->vector()), w };
  }

private:
  Vec3 rounded(const Vec3& v) const { return this->Halves ? glm::round(2.0 * v) / 2.0 : v; }

  std::mt19937_64 Engine;
  bool Halves;
};
}

// Far from where light and curve touch: a bound that is not finite says that the curve is too long.
TEST(ShadowReceiver, NoShadowIsFartherFromItsChordsThanTheBound)
{
  long hits = 0;
  long finite = 0;
  long misses = 0;
  double tightest = 0.0;
  constexpr unsigned scenes = 40000;
  for (unsigned seed = 1; seed <= scenes; ++seed)
  {
    Draw draw(seed, seed % 2 == 0);
    const Light light = draw.light();
    const Bounds bounds = draw.bounds();
    const CubicCurve curve = draw.curve();
    const double bound = ShadowReceiver(light, bounds.low, bounds.high).deviationBound(curve);
    ASSERT_GE(bound, 0.0) << "seed " << seed;
    finite += std::isfinite(bound);
    misses += bound == 0.0;
    for (int i = 1; i < 40; ++i)
    {
      const Vec3 point = curve.point(i / 40.0);
      const Exit exit = exitOf(light, bounds, point);
      if (!exit.hit || !std::isfinite(bound))
      {
        continue;
      }
      ++hits;
      const double deviation = distanceToChord(exit.place, shadowOf(light, exit, curve.b[0]),
        shadowOf(light, exit, curve.b[3]));
      ASSERT_LE(deviation, bound * (1.0 + 1e-9) + 1e-12) << "seed " << seed;
      tightest = std::fmax(tightest, deviation / bound);
    }
  }
  EXPECT_GT(hits, 100000);
  EXPECT_GT(finite, scenes * 9 / 10);
  EXPECT_GT(misses, 1000);
  EXPECT_GT(tightest, 0.95);
}

TEST(ShadowReceiver, MeasuresOnAFlatReceiverWhatIsSeenThere)
{
  // From z = 4 over a curve in z = 2 the ground sees everything twice as large.
  const CubicCurve arch{ { Vec3(0.0, 0.0, 2.0), Vec3(0.1, 0.03, 2.0), Vec3(0.2, 0.03, 2.0),
    Vec3(0.3, 0.0, 2.0) } };
  const ShadowReceiver ground(
    { Vec3(0.1, 0.0, 4.0), 1.0 }, Vec3(-5.0, -5.0, 0.0), Vec3(5.0, 5.0, 0.0));
  EXPECT_NEAR(ground.deviationBound(arch), 2.0 * arch.deviationBound(), 1e-12);
  // At a slant of 45 degrees what stands up is as long as it is high, what lies across as it is.
  const ShadowReceiver slanted(
    { Vec3(0.0, 1.0, 1.0), 0.0 }, Vec3(-5.0, -5.0, 0.0), Vec3(5.0, 5.0, 0.0));
  EXPECT_NEAR(slanted.deviationBound(arch), arch.deviationBound(), 1e-12);
  // Above the light there is no shadow, nor behind the receiver, nor beside it.
  for (const auto& [low, high] : { std::pair{ Vec3(-5.0, -5.0, 6.0), Vec3(5.0, 5.0, 6.0) },
         std::pair{ Vec3(-5.0, -5.0, 3.0), Vec3(5.0, 5.0, 3.0) },
         std::pair{ Vec3(4.0, -5.0, 0.0), Vec3(5.0, 5.0, 1.0) } })
  {
    EXPECT_EQ(
      ShadowReceiver({ Vec3(0.1, 0.0, 4.0), 1.0 }, low, high).deviationBound(arch), 0.0);
  }
}

TEST(ShadowReceiver, ALampOnTheCeilingIsInTheRoom)
{
  const CubicCurve arch{ { Vec3(0.0, 0.0, 2.0), Vec3(0.1, 0.03, 2.0), Vec3(0.2, 0.03, 2.0),
    Vec3(0.3, 0.0, 2.0) } };
  for (const double height : { 8.9, 9.0, 9.1 })
  {
    const ShadowReceiver room(
      { Vec3(0.1, 0.2, height), 1.0 }, Vec3(-5.0, -5.0, 0.0), Vec3(5.0, 5.0, 9.0));
    EXPECT_NEAR(room.deviationBound(arch), height / (height - 2.0) * arch.deviationBound(), 1e-12);
  }
}
