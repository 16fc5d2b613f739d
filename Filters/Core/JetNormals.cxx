#include "JetNormals.h"

#include "JetFit.h"

#include <algorithm>

namespace shadow
{
namespace
{
// Where a neighbour's normal turns by more, angle weights are nearer to the truth more often than
// not, on exact samples of curved shapes; just below they are farther from it.
constexpr double mostSpread = 0.5; // cosine of 60 degrees

// With the bound on the spread, jets that turn by up to 35 degrees (on points with noise of a tenth
// of an edge) were better still; this is for what is beyond all measure.
constexpr double mostTurn = 0.7071; // cosine of 45 degrees

// Between 1e-6 and 1e-2 all is the same on smooth shapes; from 3e-2 on good fits are refused.
constexpr double leastCertainty = 1e-3;

// Rings are added while the vertices do not suffice. More than four are far away.
constexpr int mostRings = 4;

// Bounds on the work where very many triangles meet, as at the pole of a sphere.
constexpr std::size_t mostVertices = 96;
constexpr Index mostCorners = 32;

/// The corners that have each normal.
struct Fans
{
  std::vector<Index> first;
  std::vector<Index> corners;

  explicit Fans(const TriangleMesh& mesh)
    : first(mesh.normals.size() + 1, 0)
    , corners(3 * mesh.triangles.size())
  {
    for (const Triangle& t : mesh.cornerNormals)
    {
      for (const Index n : t)
      {
        ++this->first[n + 1];
      }
    }
    for (std::size_t n = 1; n < this->first.size(); ++n)
    {
      this->first[n] += this->first[n - 1];
    }
    std::vector<Index> fill(this->first.begin(), this->first.end() - 1);
    for (std::size_t c = 0; c < this->corners.size(); ++c)
    {
      this->corners[fill[mesh.cornerNormals[c / 3][c % 3]]++] = static_cast<Index>(c);
    }
  }
};

/// Fits one normal after the other; its arrays are used again.
class JetFitter
{
public:
  JetFitter(const TriangleMesh& mesh, const Fans& fans)
    : Mesh(mesh)
    , TheFans(fans)
  {
  }

  /// Zero where the jet is of no use.
  Vec3 fit(Index normal)
  {
    const Vec3& rough = this->Mesh.normals[normal];
    if (rough == Vec3(0.0))
    {
      return rough;
    }
    this->Members.assign(1, normal);
    this->LastRing = 0;
    for (int ring = 1; ring <= mostRings && this->addRing(); ++ring)
    {
      if (this->Members.size() >= fewestForCubic)
      {
        const Vec3 fitted = this->fitMembers();
        if (fitted != Vec3(0.0))
        {
          return fitted;
        }
      }
    }
    const bool few = this->Members.size() < fewestForCubic;
    return few && !this->TooBent ? this->fitMembers() : Vec3(0.0);
  }

private:
  /// Members of the triangles at the last ring's members. False if there are none, or they turn
  /// too much.
  bool addRing()
  {
    this->TooBent = false;
    const std::size_t end = this->Members.size();
    for (std::size_t i = this->LastRing; i < end; ++i)
    {
      const Index first = this->TheFans.first[this->Members[i]];
      const Index last = this->TheFans.first[this->Members[i] + 1];
      const Index step = 1 + (last - first) / mostCorners;
      for (Index c = first; c < last; c += step)
      {
        const Index corner = this->TheFans.corners[c];
        const Triangle& t = this->Mesh.cornerNormals[corner / 3];
        this->add(t[next(corner % 3)]);
        this->add(t[next(next(corner % 3))]);
      }
      if (this->TooBent)
      {
        return false;
      }
    }
    this->LastRing = end;
    return this->Members.size() > end;
  }

  void add(Index normal)
  {
    const Vec3& direction = this->Mesh.normals[normal];
    if (direction == Vec3(0.0) || this->Members.size() == mostVertices ||
      std::find(this->Members.begin(), this->Members.end(), normal) != this->Members.end())
    {
      return;
    }
    this->TooBent =
      this->TooBent || !(glm::dot(direction, this->Mesh.normals[this->Members[0]]) >= mostSpread);
    this->Members.push_back(normal);
  }

  const Vec3& place(Index normal) const
  {
    return this->Mesh.points[this->Mesh.normalVertex[normal]];
  }

  /// The frame is that of the old normal: one from the fitted normal made no difference.
  Vec3 fitMembers()
  {
    const Vec3& z = this->Mesh.normals[this->Members[0]];
    const Vec3 x = glm::normalize(
      glm::cross(std::fabs(z.x) < 0.6 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0), z));
    const Vec3 y = glm::cross(z, x);
    const Vec3 origin = this->place(this->Members[0]);
    double radius = 0.0;
    for (const Index n : this->Members)
    {
      radius = std::fmax(radius, glm::length(this->place(n) - origin));
    }
    this->Samples.clear();
    for (const Index n : this->Members)
    {
      const Vec3 p = (this->place(n) - origin) / radius;
      this->Samples.push_back({ glm::dot(p, x), glm::dot(p, y), glm::dot(p, z) });
    }
    const JetSlopes slopes = fitJet(this->Samples);
    if (!(slopes.certainty > leastCertainty))
    {
      return Vec3(0.0);
    }
    const Vec3 fitted = unitOrZero(z - slopes.x * x - slopes.y * y);
    return glm::dot(fitted, z) >= mostTurn ? fitted : Vec3(0.0);
  }

  const TriangleMesh& Mesh;
  const Fans& TheFans;
  std::vector<Index> Members; // by their normals; the first is the one that is fitted
  std::vector<JetSample> Samples;
  std::size_t LastRing = 0; // where it starts in Members
  bool TooBent = false;
};
}

std::size_t fitJetNormals(TriangleMesh& mesh, const RangeLoop& loop)
{
  const Fans fans(mesh);
  std::vector<Vec3> fitted(mesh.normals.size());
  loop(mesh.normals.size(), heavyGrain,
    [&](std::size_t begin, std::size_t end)
    {
      JetFitter fitter(mesh, fans);
      for (std::size_t n = begin; n < end; ++n)
      {
        fitted[n] = fitter.fit(static_cast<Index>(n));
      }
    });
  std::size_t stayed = 0;
  for (std::size_t n = 0; n < fitted.size(); ++n)
  {
    if (fitted[n] == Vec3(0.0))
    {
      ++stayed;
    }
    else
    {
      mesh.normals[n] = fitted[n];
    }
  }
  return stayed;
}
}
