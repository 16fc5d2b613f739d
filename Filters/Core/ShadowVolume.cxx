#include "ShadowVolume.h"

#include "VolumeCaps.h"
#include "VolumeDepth.h"
#include "VolumeRims.h"

#include <algorithm>

namespace shadow
{
namespace
{
/// Points from which on a loop is worth a strip of its own.
constexpr std::size_t longLoop = 16;

class VolumeBuilder
{
public:
  VolumeBuilder(const Caster& caster, const SilhouetteChain& chain,
    const SilhouetteInput& silhouette, const VolumeSettings& settings)
    : TheCaster(caster)
    , Chain(chain)
    , Silhouette(silhouette)
    , Settings(settings)
    , VertexCount(caster.mesh().points.size())
  {
  }

  ShadowVolume build()
  {
    const Caps caps = this->Settings.caps;
    this->placeMeshPoints();
    if (caps != Caps::None)
    {
      addCaps(this->TheCaster, this->Chain,
        caps == Caps::Lit ? CapSide::Lit : CapSide::Dark, this->Volume.triangles);
    }
    const std::vector<VolumeRim> rims = buildRims(
      this->TheCaster, this->Chain, this->Silhouette, caps != Caps::None, this->Volume);
    const bool lightIsOutside = this->lightIsOutside();
    this->Volume.greatestDepth = greatestDepth(
      rims, this->Chain.light, this->TheCaster.centre(), lightIsOutside, this->Volume);
    const std::size_t nearEnd = this->Volume.triangles.size();
    this->Volume.firstEnd = this->Volume.points.size();
    this->Extruded.assign(this->Volume.points.size(), None);
    for (const VolumeRim& rim : rims)
    {
      const bool asStrip = this->Settings.wallStrips && rim.points.size() >= longLoop &&
        !this->endsInOnePoint();
      asStrip ? this->addWallStrip(rim) : this->addWalls(rim);
    }
    if (caps != Caps::None && this->Settings.farCap && !this->endsInOnePoint())
    {
      this->isInfinite() && lightIsOutside ? this->addFarFan(rims) : this->projectNearCap(nearEnd);
    }
    return std::move(this->Volume);
  }

private:
  /// Vertices and crossings keep their node numbers.
  void placeMeshPoints()
  {
    std::vector<Vec4>& points = this->Volume.points;
    points.reserve(this->VertexCount + 2 * this->Chain.crossings.size() +
      3 * this->Silhouette.points.size() + 1);
    for (const Vec3& p : this->TheCaster.mesh().points)
    {
      points.emplace_back(p, 1.0);
    }
    for (const Crossing& c : this->Chain.crossings)
    {
      points.emplace_back(meshPoint(this->TheCaster.mesh(), this->TheCaster.edges(), c), 1.0);
    }
  }

  void add(Index p, Index q, Index r, VolumePart part, int multiplicity)
  {
    if (p != q && q != r && r != p)
    {
      this->Volume.triangles.push_back({ { p, q, r }, part, multiplicity });
    }
  }

  bool isInfinite() const { return this->Settings.end.extent == Extent::Infinite; }
  bool endsInOnePoint() const { return this->isInfinite() && this->Chain.light.isDirectional(); }

  Index addEnd(const Vec4& point, Index origin)
  {
    this->Volume.points.push_back(point);
    this->Volume.origin.push_back(origin);
    return static_cast<Index>(this->Volume.points.size() - 1);
  }

  /// Where a point's shadow ends.
  Index extruded(Index point)
  {
    if (this->endsInOnePoint())
    {
      if (this->Apex == None)
      {
        this->Apex = this->addEnd(this->Chain.light.extrude(Vec3(0.0)), None);
      }
      return this->Apex;
    }
    if (this->Extruded[point] == None)
    {
      const Vec3 place(this->Volume.points[point]);
      const ShadowEnd& end = this->Settings.end;
      this->Volume.unreached +=
        end.extent == Extent::Plane && !end.reachesPlane(place, this->Chain.light);
      this->Extruded[point] = this->addEnd(end.of(place, this->Chain.light), point);
    }
    return this->Extruded[point];
  }

  /// Calls visit(p, q) for the points of each segment of a rim.
  template <class Visit>
  static void forEachSegment(const VolumeRim& rim, const Visit& visit)
  {
    for (std::size_t i = 0; i < rim.points.size(); ++i)
    {
      visit(rim.points[i], rim.points[i + 1 < rim.points.size() ? i + 1 : 0]);
    }
  }

  void addWalls(const VolumeRim& rim)
  {
    forEachSegment(rim,
      [&](Index p, Index q)
      {
        const Index farP = this->extruded(p);
        const Index farQ = this->extruded(q);
        this->add(q, p, farP, VolumePart::Wall, rim.multiplicity);
        this->add(q, farP, farQ, VolumePart::Wall, rim.multiplicity);
      });
  }

  void addWallStrip(const VolumeRim& rim)
  {
    WallStrip strip{ {}, rim.multiplicity };
    strip.points.reserve(2 * (rim.points.size() + 1));
    for (std::size_t i = 0; i <= rim.points.size(); ++i)
    {
      const Index p = rim.points[i < rim.points.size() ? i : 0];
      strip.points.push_back(p);
      strip.points.push_back(this->extruded(p));
    }
    this->Volume.strips.push_back(std::move(strip));
  }

  /// From outside a ball all its points are seen within less than a half space, so a fan at
  /// infinity is the same chain as the projected cap. A smooth contour may leave the mesh's ball.
  bool lightIsOutside() const
  {
    const Vec3& centre = this->TheCaster.centre();
    double radius = this->TheCaster.radius();
    for (const Vec3& p : this->Silhouette.points)
    {
      radius = std::max(radius, glm::length(p - centre));
    }
    return glm::length(this->Chain.light.toward(centre)) > 1.001 * this->Chain.light.w * radius;
  }

  void addFarFan(const std::vector<VolumeRim>& rims)
  {
    const Index apex =
      this->addEnd(this->Chain.light.extrude(this->TheCaster.centre()), None);
    for (const VolumeRim& rim : rims)
    {
      forEachSegment(rim,
        [&](Index p, Index q)
        {
          this->add(apex, this->extruded(q), this->extruded(p), VolumePart::FarCap,
            rim.multiplicity);
        });
    }
  }

  void projectNearCap(std::size_t nearEnd)
  {
    for (std::size_t i = 0; i < nearEnd; ++i)
    {
      const VolumeTriangle t = this->Volume.triangles[i];
      this->add(this->extruded(t.points[2]), this->extruded(t.points[1]),
        this->extruded(t.points[0]), VolumePart::FarCap, t.multiplicity);
    }
  }

  const Caster& TheCaster;
  const SilhouetteChain& Chain;
  const SilhouetteInput& Silhouette;
  const VolumeSettings& Settings;
  const std::size_t VertexCount;
  ShadowVolume Volume;
  std::vector<Index> Extruded; ///< where the shadow of each point ends
  Index Apex = None;
};
}

ShadowVolume extrude(const Caster& caster, const SilhouetteChain& chain,
  const SilhouetteInput& silhouette, const VolumeSettings& settings)
{
  return VolumeBuilder(caster, chain, silhouette, settings).build();
}

double enclosedVolume(const ShadowVolume& volume, const Vec3& centre)
{
  double sum = 0.0;
  const auto add = [&](Index p, Index q, Index r, int multiplicity)
  {
    const Vec3 a = Vec3(volume.points[p]) - centre;
    const Vec3 b = Vec3(volume.points[q]) - centre;
    const Vec3 c = Vec3(volume.points[r]) - centre;
    sum += multiplicity * glm::dot(a, glm::cross(b, c));
  };
  for (const VolumeTriangle& t : volume.triangles)
  {
    add(t.points[0], t.points[1], t.points[2], t.multiplicity);
  }
  for (const WallStrip& strip : volume.strips)
  {
    for (std::size_t i = 0; i + 3 < strip.points.size(); i += 2)
    {
      add(strip.points[i], strip.points[i + 1], strip.points[i + 2], strip.multiplicity);
      add(strip.points[i + 2], strip.points[i + 1], strip.points[i + 3], strip.multiplicity);
    }
  }
  return sum / 6.0;
}
}
