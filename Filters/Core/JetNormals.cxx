#include "JetNormals.h"

#include "JetFit.h"

#include <algorithm>

namespace shadow
{
namespace
{
// Where a neighbour's normal turns by more, angle weights are nearer to the truth more often than
// not, on exact samples of curved shapes; just below they are farther from it.
constexpr double mostSpread = 0.5; // 1 - cosine of 60 degrees

// With the bound on the spread, the jets of smooth shapes turn by at most 15 degrees against the
// angle weights (noise in the points of 3% of an edge). On mechanical parts those that turn by more
// are wrong.
constexpr double mostTurn = 0.9397; // cosine of 20 degrees

// Between 1e-6 and 1e-2 all is the same on smooth shapes; from 3e-2 on good fits are refused.
constexpr double leastCertainty = 1e-3;

// The triangles at a vertex of a smooth surface turn about a quarter of what the vertices two rings
// away do. If they turn by less than a twentieth (here squared) they belong to a flat face beside
// a bend, and say its normal exactly. Fewer than three triangles are flat without saying anything,
// and a bend of less than a ten-thousandth is none.
constexpr double flatFan = 0.05 * 0.05;
constexpr Index leastFan = 3;
constexpr double leastBend = 0.5e-8;

// Rings are added while the vertices do not suffice. Even at the corner of a sheet, with one
// triangle, five rings have sixteen.
constexpr int mostRings = 5;

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
    if (this->Mesh.normals[normal] == Vec3(0.0))
    {
      return Vec3(0.0);
    }
    this->Members.assign(1, normal);
    this->LastRing = 0;
    this->Spread = 0.0;
    Vec3 fitted(0.0);
    for (int ring = 1; ring <= mostRings && fitted == Vec3(0.0) && this->addRing(); ++ring)
    {
      if (this->Members.size() >= fewestForCubic)
      {
        if (this->isFlatBesideABend())
        {
          return Vec3(0.0);
        }
        fitted = this->fitMembers();
      }
    }
    const bool few = this->Members.size() < fewestForCubic;
    return few && this->Spread <= mostSpread ? this->fitMembers() : fitted;
  }

private:
  /// Members of the triangles at the last ring's members. False if there are none, or they turn
  /// too much.
  bool addRing()
  {
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
      if (this->Spread > mostSpread)
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
    this->Spread =
      std::fmax(this->Spread, 1.0 - glm::dot(direction, this->Mesh.normals[this->Members[0]]));
    this->Members.push_back(normal);
  }

  bool isFlatBesideABend() const
  {
    const Index first = this->TheFans.first[this->Members[0]];
    const Index last = this->TheFans.first[this->Members[0] + 1];
    if (last - first < leastFan || this->Spread < leastBend)
    {
      return false;
    }
    for (Index c = first; c < last; ++c)
    {
      const Vec3 flat = unitOrZero(this->Mesh.areaNormal(this->TheFans.corners[c] / 3));
      const double turn = 1.0 - glm::dot(flat, this->Mesh.normals[this->Members[0]]);
      if (flat != Vec3(0.0) && turn > flatFan * this->Spread)
      {
        return false;
      }
    }
    return true;
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
  double Spread = 0.0; // 1 - cosine of the most that a member's normal turns
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
