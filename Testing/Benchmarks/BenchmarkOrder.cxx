// How the error of the shadow's boundary falls with the size of the triangles: largest and root
// mean square error on a plane at five sizes, and the order fitted to them, for the three kinds.
//
// BenchmarkOrder [word ...]: only the cases whose names hold all of the words.

#include "OrderPipeline.h"

#include <cstdio>
#include <string>

namespace
{
using namespace shadowtest;

const char* const KindNames[] = { "discrete", "accurate", "smooth" };

void printRow(
  const std::string& label, const OrderFigures& figures, double ShadowError::*error, double order)
{
  std::printf("  %-16s", label.c_str());
  for (const ShadowError& e : figures.Error)
  {
    std::printf(" %9.2e", e.*error);
  }
  std::printf("  %5.2f\n", order);
}

void printTriangles(const OrderCase& study, const OrderFigures& figures)
{
  std::printf("%s\n  %-16s", study.name().c_str(), "triangles");
  for (const vtkIdType n : figures.Triangles)
  {
    std::printf(" %9lld", static_cast<long long>(n));
  }
  std::printf("  order\n");
}

/// What the errors are silent about.
void printUnmeasured(const OrderFigures& figures)
{
  long samples = 0;
  long leftOut = 0;
  long failed = 0;
  for (const ShadowError& e : figures.Error)
  {
    samples += e.Samples + e.LeftOut + e.Failed;
    leftOut += e.LeftOut;
    failed += e.Failed;
  }
  if (leftOut > 0 || failed > 0)
  {
    std::printf("    of %ld samples %ld near cusps left out, %ld without an answer\n", samples,
      leftOut, failed);
  }
}

void report(const OrderCase& study)
{
  for (const int kind : AllKinds)
  {
    const OrderFigures figures = measureOrder(study, kind);
    if (kind == AllKinds[0])
    {
      printTriangles(study, figures);
    }
    const std::string name = KindNames[kind];
    printRow(name + " max", figures, &ShadowError::Largest, figures.largestOrder());
    printRow(name + " RMS", figures, &ShadowError::RootMeanSquare, figures.rootMeanSquareOrder());
    printUnmeasured(figures);
  }
  std::fflush(stdout);
}

bool wanted(const OrderCase& study, int argc, char* argv[])
{
  for (int i = 1; i < argc; ++i)
  {
    if (study.name().find(argv[i]) == std::string::npos)
    {
      return false;
    }
  }
  return true;
}
}

int main(int argc, char* argv[])
{
  std::printf(
    "Error of the shadow's boundary on a plane 3 below the shape's centre; exact normals;\n"
    "sphere of radius 1, ellipsoid (2, 1, 0.5), torus (1, 0.4)\n");
  for (const OrderCase& study : orderCases())
  {
    if (wanted(study, argc, argv))
    {
      report(study);
    }
  }
  return 0;
}
