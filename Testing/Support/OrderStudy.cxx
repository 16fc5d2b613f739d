#include "OrderStudy.h"

#include "TestMeshes.h"

namespace shadowtest
{
namespace
{
const Plane Receiver{ { 0.0, 0.0, -3.0 }, { 0.0, 0.0, 1.0 } };
const double Ball[3] = { 1.0, 1.0, 1.0 };
constexpr std::uint64_t Seed = 7;

struct Surface
{
  const char* Shape;
  const char* Tessellation;
  std::function<Mesh(int size)> Make;
  std::function<std::unique_ptr<AnalyticShadow>(const LightPoint&)> Shadow;
};

struct NamedLight
{
  const char* Name;
  LightPoint Position;
};

// Near: about a radius above the shapes, so that shadows are magnified several times.
const NamedLight Lights[] = { { "direction", { 0.3, 0.2, 1.0, 0.0 } },
  { "near", { 0.7, 0.5, 1.9, 1.0 } }, { "far", { 3.3, 2.1, 9.3, 1.0 } } };

std::unique_ptr<AnalyticShadow> ballShadow(const LightPoint& light)
{
  return ellipsoidShadow(Ball, light, Receiver);
}

std::unique_ptr<AnalyticShadow> longShadow(const LightPoint& light)
{
  return ellipsoidShadow(EllipsoidAxes, light, Receiver);
}

std::unique_ptr<AnalyticShadow> ringShadow(const LightPoint& light)
{
  return torusShadow(TorusRadius, TorusTube, light, Receiver);
}

const Surface Surfaces[] = {
  { "sphere", "regular", [](int size) { return sphere(18 << size, 36 << size); }, ballShadow },
  { "sphere", "jittered", [](int size) { return icosphere(3 + size, Seed); }, ballShadow },
  { "ellipsoid", "regular", [](int size) { return ellipsoid(18 << size, 36 << size); },
    longShadow },
  { "ellipsoid", "jittered", [](int size) { return icoEllipsoid(3 + size, Seed); }, longShadow },
  { "torus", "regular", [](int size) { return torus(36 << size, 18 << size); }, ringShadow },
  { "torus", "flat", [](int size) { return torus(18 << size, 36 << size); }, ringShadow },
  { "torus", "jittered", [](int size) { return torus(36 << size, 18 << size, Seed); }, ringShadow }
};

double fit(const OrderFigures& figures, double ShadowError::*error)
{
  std::vector<double> h(figures.EdgeLength.begin(), figures.EdgeLength.end());
  std::vector<double> errors;
  for (const ShadowError& e : figures.Error)
  {
    errors.push_back(e.*error);
  }
  return fitOrder(h, errors);
}
}

std::vector<OrderCase> orderCases()
{
  std::vector<OrderCase> cases;
  for (const Surface& surface : Surfaces)
  {
    for (const NamedLight& light : Lights)
    {
      cases.push_back({ surface.Shape, surface.Tessellation, light.Name, light.Position,
        surface.Make, [&surface, &light]() { return surface.Shadow(light.Position); } });
    }
  }
  return cases;
}

double OrderFigures::largestOrder() const
{
  return fit(*this, &ShadowError::Largest);
}

double OrderFigures::rootMeanSquareOrder() const
{
  return fit(*this, &ShadowError::RootMeanSquare);
}

OrderFigures measureOrder(const OrderCase& study, const SilhouetteMaker& make, int samplesPerChord)
{
  OrderFigures figures;
  const auto shadow = study.Shadow();
  for (int size = 0; size < OrderSizes; ++size)
  {
    const auto i = static_cast<std::size_t>(size);
    const Mesh mesh = study.Make(size);
    figures.Triangles[i] = mesh->GetNumberOfCells();
    figures.EdgeLength[i] = meanEdgeLength(mesh);
    figures.Error[i] = shadowError(make(mesh, study.LightPosition), *shadow, samplesPerChord);
  }
  return figures;
}
}
