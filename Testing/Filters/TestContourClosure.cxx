// Hidden removal leaves closed what is closed: at a concave corner of a caster no sliver of the
// contour is taken for hidden.

#include "MeshBuilder.h"
#include "PolylineDistance.h"
#include "ShadowPipeline.h"
#include "TestMeshes.h"

#include <vtkCastShadowContour.h>
#include <vtkCellData.h>
#include <vtkMath.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace shadowtest;

namespace
{
/// A plate of an L's shape between z = 2 and z = 3, turned about the z axis, its corners beginning
/// at the given one.
Mesh turnedL(double degrees, int first)
{
  const double corners[6][2] = { { 0.0, 0.0 }, { 2.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 1.0 },
    { 1.0, 2.0 }, { 0.0, 2.0 } };
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  MeshBuilder builder;
  for (const double z : { 2.0, 3.0 })
  {
    for (int i = 0; i < 6; ++i)
    {
      const double* corner = corners[(i + first) % 6];
      builder.addPoint({ std::cos(angle) * corner[0] - std::sin(angle) * corner[1],
        std::sin(angle) * corner[0] + std::cos(angle) * corner[1], z });
    }
  }
  for (vtkIdType i = 0; i < 6; ++i)
  {
    const vtkIdType next = (i + 1) % 6;
    builder.addQuad(i, next, 6 + next, 6 + i);
  }
  // The concave corner sees all others.
  const auto at = [first](vtkIdType i) { return (i - first + 12) % 6; };
  for (const vtkIdType i : { 4, 5, 0, 1 })
  {
    builder.addTriangle(at(3), at((i + 1) % 6), at(i));
    builder.addTriangle(6 + at(3), 6 + at(i), 6 + at((i + 1) % 6));
  }
  return builder.build();
}
}

TEST(ContourClosure, ConcaveCasters)
{
  int placements = 0;
  int whole = 0;
  for (const LightPosition& light :
    { LightPosition{ 0.3, 0.2, 1.0, 0.0 }, LightPosition{ 1.0, 2.0, 20.0, 1.0 } })
  {
    for (int degrees = 0; degrees < 360; degrees += 15)
    {
      for (int first = 0; first < 6; ++first)
      {
        const Mesh plate = turnedL(degrees, first);
        vtkNew<vtkSmoothLightSilhouette> silhouette;
        silhouette->SetInputData(plate);
        silhouette->SetKindToDiscrete();
        silhouette->SetLightPosition(light[0], light[1], light[2], light[3]);
        vtkNew<vtkCastShadowContour> contour;
        contour->AddSilhouetteConnection(silhouette->GetOutputPort());
        contour->AddInputData(1, ground(0.0, 20.0));
        contour->AddInputData(2, plate);
        contour->KeepHiddenOn();
        contour->Update();
        vtkPolyData* lines = contour->GetOutput();
        vtkDataArray* visible = lines->GetCellData()->GetArray("Visible");
        ASSERT_GT(lines->GetNumberOfLines(), 0);
        for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
        {
          EXPECT_GT(lengthOfLine(lines, line), 0.01) << degrees << " degrees, corner " << first;
        }
        // One edge of the notch may lie in the shadow of another, which cuts the line.
        if (visible->GetRange()[0] == 1.0)
        {
          ++whole;
          EXPECT_EQ(lines->GetNumberOfLines(), 1) << degrees << " degrees, corner " << first;
          EXPECT_EQ(lines->GetCellData()->GetArray("Closed")->GetComponent(0, 0), 1.0)
            << degrees << " degrees, corner " << first;
        }
        ++placements;
      }
    }
  }
  EXPECT_GT(whole, 100);
  EXPECT_LT(whole, placements);
}
