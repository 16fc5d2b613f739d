#include "ShadowVolume.h"

#include "VolumeDepth.h"

namespace shadow
{
namespace
{
/// Points from which on a loop is worth a strip of its own.
constexpr std::size_t longLoop = 16;

class VolumeBuilder
{
public:
  VolumeBuilder(const NearEnd& near, const VolumeSettings& settings)
    : Near(near)
    , TheLight(near.chain.light)
    , Settings(settings)
  {
  }

  ShadowVolume build()
  {
    this->placeNearEnd();
    const std::size_t nearTriangles = this->Volume.triangles.size();
    this->Volume.firstEnd = this->Volume.points.size();
    this->Extruded.assign(this->Volume.points.size(), None);
    for (const VolumeRim& rim : this->Near.rims)
    {
      const bool asStrip = this->Settings.wallStrips && rim.points.size() >= longLoop &&
        !this->endsInOnePoint();
      asStrip ? this->addWallStrip(rim) : this->addWalls(rim);
    }
    if (this->Near.cap && !this->endsInOnePoint())
    {
      this->isInfinite() && this->Near.lightIsOutside ? this->addFarFan()
                                                      : this->projectNearCap(nearTriangles);
    }
    return std::move(this->Volume);
  }

private:
  /// All of its points and the mesh's keep their numbers.
  void placeNearEnd()
  {
    std::vector<Vec4>& points = this->Volume.points;
    const TriangleMesh& mesh = this->Near.caster.mesh();
    const std::size_t nodes = mesh.points.size() + this->Near.chain.crossings.size();
    points.reserve(nodes + this->Near.chain.crossings.size() + 3 * this->Near.points.size() + 1);
    for (const Vec3& p : mesh.points)
    {
      points.emplace_back(p, 1.0);
    }
    for (const Crossing& c : this->Near.chain.crossings)
    {
      points.emplace_back(meshPoint(mesh, this->Near.caster.edges(), c), 1.0);
    }
    for (const Vec3& p : this->Near.points)
    {
      points.emplace_back(p, 1.0);
    }
    std::vector<VolumeTriangle>& triangles = this->Volume.triangles;
    if (this->Near.cap)
    {
      triangles.reserve(mesh.triangles.size());
      this->Near.cap->forEach(
        [&](const Triangle& t) { triangles.push_back({ t, VolumePart::Cap, 1 }); });
    }
    triangles.insert(
      triangles.end(), this->Near.triangles.begin(), this->Near.triangles.end());
    this->Volume.greatestDepth = greatestDepth(this->Near);
  }

  void add(Index p, Index q, Index r, VolumePart part, int multiplicity)
  {
    if (p != q && q != r && r != p)
    {
      this->Volume.triangles.push_back({ { p, q, r }, part, multiplicity });
    }
  }

  bool isInfinite() const { return this->Settings.end.extent == Extent::Infinite; }
  bool endsInOnePoint() const { return this->isInfinite() && this->TheLight.isDirectional(); }

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
        this->Apex = this->addEnd(this->TheLight.extrude(Vec3(0.0)), None);
      }
      return this->Apex;
    }
    if (this->Extruded[point] == None)
    {
      const Vec3 place(this->Volume.points[point]);
      const ShadowEnd& end = this->Settings.end;
      this->Volume.unreached +=
        end.extent == Extent::Plane && !end.reachesPlane(place, this->TheLight);
      this->Extruded[point] = this->addEnd(end.of(place, this->TheLight), point);
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

  /// At infinity, with the light outside, it is the same chain as the projected cap.
  void addFarFan()
  {
    const Index apex =
      this->addEnd(this->TheLight.extrude(this->Near.caster.centre()), None);
    for (const VolumeRim& rim : this->Near.rims)
    {
      forEachSegment(rim,
        [&](Index p, Index q)
        {
          this->add(apex, this->extruded(q), this->extruded(p), VolumePart::FarCap,
            rim.multiplicity);
        });
    }
  }

  void projectNearCap(std::size_t nearTriangles)
  {
    for (std::size_t i = 0; i < nearTriangles; ++i)
    {
      const VolumeTriangle t = this->Volume.triangles[i];
      this->add(this->extruded(t.points[2]), this->extruded(t.points[1]),
        this->extruded(t.points[0]), VolumePart::FarCap, t.multiplicity);
    }
  }

  const NearEnd& Near;
  const Light& TheLight;
  const VolumeSettings& Settings;
  ShadowVolume Volume;
  std::vector<Index> Extruded; ///< where the shadow of each point ends
  Index Apex = None;
};
}

ShadowVolume extrude(const NearEnd& near, const VolumeSettings& settings)
{
  return VolumeBuilder(near, settings).build();
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
