#include "SilhouetteOracle.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace shadowtest
{
namespace
{
struct Triangle
{
  std::size_t Vertices[3]; // welded
  Vec3 Corners[3];
  Vec3 Normals[3];
};

struct Side
{
  std::size_t Triangle;
  int Corner; // at which it starts
  int Sign;   // +1 from the edge's first vertex to its second
};

using EdgeKey = std::pair<std::size_t, std::size_t>;

double length(const Vec3& v)
{
  return std::sqrt(dot(v, v));
}

class Surface
{
public:
  Surface(vtkPolyData* mesh, const double light[4])
    : Light{ light[0], light[1], light[2] }
    , W(light[3])
  {
    this->load(mesh);
    this->findEdges();
    this->findParts();
  }

  Vec3 ray(const Vec3& point) const { return this->Light - this->W * point; }

  Vec3 areaNormal(std::size_t t) const
  {
    const Vec3* p = this->Triangles[t].Corners;
    return cross(p[1] - p[0], p[2] - p[0]);
  }

  bool closed(std::size_t t) const { return this->Closed[this->Part[t]]; }

  std::vector<Triangle> Triangles;
  std::vector<Vec3> Vertices;
  std::map<EdgeKey, std::vector<Side>> Edges;
  std::vector<std::size_t> Part; // of each triangle: the number of one of its triangles
  std::vector<bool> Closed;      // by part
  bool HasNormals = false;

private:
  void load(vtkPolyData* polydata)
  {
    MeshBuilder mesh;
    mesh.append(polydata);
    this->HasNormals = !mesh.Normals.empty();
    std::map<Vec3, std::size_t> welded;
    std::vector<std::size_t> vertex;
    for (Vec3 p : mesh.Points)
    {
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      {
        vertex.push_back(NotFinite);
        continue;
      }
      for (double& coordinate : p)
      {
        coordinate += 0.0; // -0 is 0
      }
      const auto found = welded.emplace(p, this->Vertices.size());
      if (found.second)
      {
        this->Vertices.push_back(p);
      }
      vertex.push_back(found.first->second);
    }
    for (const auto& cell : mesh.Cells)
    {
      const bool finite = std::all_of(cell.begin(), cell.end(),
        [&](vtkIdType id) { return vertex[static_cast<std::size_t>(id)] != NotFinite; });
      for (std::size_t i = 2; finite && i < cell.size(); ++i)
      {
        const vtkIdType ids[3] = { cell[0], cell[i - 1], cell[i] };
        Triangle triangle{};
        for (std::size_t k = 0; k < 3; ++k)
        {
          const auto id = static_cast<std::size_t>(ids[k]);
          triangle.Vertices[k] = vertex[id];
          triangle.Corners[k] = this->Vertices[vertex[id]];
          triangle.Normals[k] = this->HasNormals ? normalized(mesh.Normals[id]) : Vec3{};
        }
        const std::size_t* v = triangle.Vertices;
        if (v[0] != v[1] && v[1] != v[2] && v[2] != v[0])
        {
          this->Triangles.push_back(triangle);
        }
      }
    }
  }

  void findEdges()
  {
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const std::size_t a = this->Triangles[t].Vertices[k];
        const std::size_t b = this->Triangles[t].Vertices[(k + 1) % 3];
        this->Edges[std::minmax(a, b)].push_back({ t, k, a < b ? 1 : -1 });
      }
    }
  }

  std::size_t root(std::size_t t)
  {
    while (this->Part[t] != t)
    {
      t = this->Part[t] = this->Part[this->Part[t]];
    }
    return t;
  }

  void findParts()
  {
    this->Part.resize(this->Triangles.size());
    std::iota(this->Part.begin(), this->Part.end(), std::size_t{ 0 });
    for (const auto& edge : this->Edges)
    {
      for (const Side& side : edge.second)
      {
        this->Part[this->root(side.Triangle)] = this->root(edge.second[0].Triangle);
      }
    }
    for (std::size_t t = 0; t < this->Part.size(); ++t)
    {
      this->Part[t] = this->root(t);
    }
    this->Closed.assign(this->Triangles.size(), true);
    for (const auto& edge : this->Edges)
    {
      int sum = 0;
      for (const Side& side : edge.second)
      {
        sum += side.Sign;
      }
      if (sum != 0)
      {
        this->Closed[this->Part[edge.second[0].Triangle]] = false;
      }
    }
  }

  static constexpr std::size_t NotFinite = static_cast<std::size_t>(-1);

  Vec3 Light;
  double W;
};

double clearness(double field, const Vec3& normal, const Vec3& ray)
{
  const double size = length(normal) * length(ray);
  return size > 0.0 ? std::abs(field) / size : 0.0;
}

// Field of a triangle's corners, and the weights of its lit and its dark part.
struct CornerField
{
  double Values[3];
  bool Lit[3];
  int LitWeight;
  int DarkWeight;

  bool mixed() const { return this->Lit[0] != this->Lit[1] || this->Lit[1] != this->Lit[2]; }
};

// Place on an edge whose ends have these fields of different signs.
double crossing(double first, double second)
{
  return first / (first - second);
}

std::vector<CornerField> cornerFields(const Surface& surface, SegmentChain& chain)
{
  std::vector<double> agreement(surface.Triangles.size());
  std::vector<double> partAgreement(surface.Triangles.size(), 0.0);
  std::vector<double> partSize(surface.Triangles.size(), 0.0);
  std::vector<CornerField> fields(surface.Triangles.size());
  for (std::size_t t = 0; t < fields.size(); ++t)
  {
    const Triangle& triangle = surface.Triangles[t];
    const Vec3 sum = triangle.Normals[0] + triangle.Normals[1] + triangle.Normals[2];
    const Vec3 area = surface.areaNormal(t);
    agreement[t] = dot(area, sum);
    partAgreement[surface.Part[t]] += agreement[t];
    partSize[surface.Part[t]] += length(area) * length(sum);
    for (int k = 0; k < 3; ++k)
    {
      const Vec3 ray = surface.ray(triangle.Corners[k]);
      fields[t].Values[k] = dot(triangle.Normals[k], ray);
      fields[t].Lit[k] = fields[t].Values[k] >= 0.0;
      chain.Margin =
        std::min(chain.Margin, clearness(fields[t].Values[k], triangle.Normals[k], ray));
    }
  }
  for (std::size_t t = 0; t < fields.size(); ++t)
  {
    const std::size_t part = surface.Part[t];
    const Triangle& triangle = surface.Triangles[t];
    const bool closed = surface.closed(t);
    const double measure = closed ? partAgreement[part] : agreement[t];
    const double size = closed ? partSize[part]
                               : length(surface.areaNormal(t)) *
        length(triangle.Normals[0] + triangle.Normals[1] + triangle.Normals[2]);
    chain.WindingMargin =
      std::min(chain.WindingMargin, size > 0.0 ? std::abs(measure) / size : 0.0);
    const int sign = measure < 0.0 ? -1 : 1;
    fields[t].LitWeight = sign;
    fields[t].DarkWeight = closed ? 0 : -sign;
  }
  return fields;
}

// The pieces of an edge between the crossings of all sides.
void emitEdge(const Surface& surface, const std::vector<CornerField>& fields, const EdgeKey& edge,
  const std::vector<Side>& sides, SegmentChain& chain)
{
  struct Interval
  {
    bool FirstLit;
    bool SecondLit;
    double Crossing;
    int LitWeight;
    int DarkWeight;
  };
  std::vector<Interval> intervals;
  std::vector<double> breaks{ 0.0, 1.0 };
  for (const Side& side : sides)
  {
    const CornerField& field = fields[side.Triangle];
    const int next = (side.Corner + 1) % 3;
    const int first = side.Sign > 0 ? side.Corner : next;
    const int second = side.Sign > 0 ? next : side.Corner;
    Interval interval{ field.Lit[first], field.Lit[second], 0.0, side.Sign * field.LitWeight,
      side.Sign * field.DarkWeight };
    if (interval.FirstLit != interval.SecondLit)
    {
      interval.Crossing = crossing(field.Values[first], field.Values[second]);
      breaks.push_back(interval.Crossing);
    }
    intervals.push_back(interval);
  }
  std::sort(breaks.begin(), breaks.end());
  const Vec3 a = surface.Vertices[edge.first];
  const Vec3 b = surface.Vertices[edge.second];
  for (std::size_t i = 1; i < breaks.size(); ++i)
  {
    if (!(breaks[i - 1] < breaks[i]))
    {
      continue;
    }
    const double middle = 0.5 * (breaks[i - 1] + breaks[i]);
    int multiplicity = 0;
    for (const Interval& interval : intervals)
    {
      const bool lit = interval.FirstLit == interval.SecondLit
        ? interval.FirstLit
        : (middle < interval.Crossing) == interval.FirstLit;
      multiplicity += lit ? interval.LitWeight : interval.DarkWeight;
    }
    auto at = [&](double u) { return (1.0 - u) * a + u * b; };
    addSegment(chain, at(breaks[i - 1]), at(breaks[i]), multiplicity);
  }
}

void emitChord(const Surface& surface, const CornerField& field, std::size_t t, SegmentChain& chain)
{
  Vec3 from{};
  Vec3 to{};
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    if (field.Lit[k] == field.Lit[next])
    {
      continue;
    }
    const Triangle& triangle = surface.Triangles[t];
    const double u = crossing(field.Values[k], field.Values[next]);
    const Vec3 point = (1.0 - u) * triangle.Corners[k] + u * triangle.Corners[next];
    (field.Lit[k] ? from : to) = point;
  }
  addSegment(chain, from, to, field.LitWeight - field.DarkWeight);
}
}

SegmentChain discreteSilhouette(vtkPolyData* mesh, const double light[4])
{
  const Surface surface(mesh, light);
  SegmentChain chain;
  std::vector<bool> lit(surface.Triangles.size());
  for (std::size_t t = 0; t < lit.size(); ++t)
  {
    const Vec3 normal = surface.areaNormal(t);
    const Vec3 ray = surface.ray(surface.Triangles[t].Corners[0]);
    const double field = dot(normal, ray);
    lit[t] = field >= 0.0;
    chain.Margin = std::min(chain.Margin, clearness(field, normal, ray));
  }
  for (const auto& edge : surface.Edges)
  {
    int multiplicity = 0;
    for (const Side& side : edge.second)
    {
      const int dark = surface.closed(side.Triangle) ? 0 : -1;
      multiplicity += side.Sign * (lit[side.Triangle] ? 1 : dark);
    }
    addSegment(
      chain, surface.Vertices[edge.first.first], surface.Vertices[edge.first.second], multiplicity);
  }
  return chain;
}

bool hasUsableNormals(vtkPolyData* mesh)
{
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  bool usable = normals != nullptr;
  for (vtkIdType i = 0; usable && i < normals->GetNumberOfTuples(); ++i)
  {
    Vec3 normal;
    normals->GetTuple(i, normal.data());
    const double size = length(normal);
    usable = std::isfinite(size) && size > 0.0;
  }
  return usable;
}

SegmentChain accurateSilhouette(vtkPolyData* mesh, const double light[4])
{
  const Surface surface(mesh, light);
  if (!surface.HasNormals && !surface.Triangles.empty())
  {
    throw std::runtime_error("accurateSilhouette: the mesh has no point normals");
  }
  SegmentChain chain;
  const std::vector<CornerField> fields = cornerFields(surface, chain);
  for (const auto& edge : surface.Edges)
  {
    emitEdge(surface, fields, edge.first, edge.second, chain);
  }
  for (std::size_t t = 0; t < fields.size(); ++t)
  {
    if (fields[t].mixed())
    {
      emitChord(surface, fields[t], t, chain);
    }
  }
  return chain;
}
}
