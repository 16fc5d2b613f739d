#include "InputDefects.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Marks points that cells use. Ids that do not exist are passed over.
class UsedPoints
{
public:
  explicit UsedPoints(vtkPolyData* input)
    : Used(static_cast<std::size_t>(input->GetNumberOfPoints()))
  {
  }

  bool has(vtkIdType point) const { return this->Used[static_cast<std::size_t>(point)]; }

  // Calls visit(first point that exists, or -1) for each cell that has a point.
  template <class Visit>
  void add(vtkCellArray* cells, const Visit& visit)
  {
    auto cell = vtk::TakeSmartPointer(cells->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
    {
      vtkIdType count;
      const vtkIdType* ids;
      cell->GetCurrentCell(count, ids);
      vtkIdType first = -1;
      for (vtkIdType i = 0; i < count; ++i)
      {
        if (this->exists(ids[i]))
        {
          this->Used[static_cast<std::size_t>(ids[i])] = true;
          first = first < 0 ? ids[i] : first;
        }
      }
      if (count > 0)
      {
        visit(first);
      }
    }
  }

private:
  bool exists(vtkIdType id) const
  {
    return id >= 0 && static_cast<std::size_t>(id) < this->Used.size();
  }

  std::vector<bool> Used;
};

// From a coordinate to the next one, and from the largest one to the one before.
template <class Real>
double stepAt(Real size)
{
  const Real above = std::nextafter(size, std::numeric_limits<Real>::infinity());
  return std::isfinite(above) ? above - size : size - std::nextafter(size, Real(0));
}

// Of the coordinates' type; 0 for types of whole numbers, which are meant to be steps.
double stepAt(double coordinate, int type)
{
  const double size = std::fabs(coordinate);
  if (type == VTK_FLOAT)
  {
    return stepAt(static_cast<float>(size));
  }
  return type == VTK_DOUBLE ? stepAt(size) : 0.0;
}
}

InputDefects findInputDefects(
  vtkPolyData* input, const shadow::TriangleMesh& mesh, double diagonal)
{
  InputDefects defects;
  if (!input->GetPoints())
  {
    return defects;
  }
  const auto place = [&](vtkIdType id)
  {
    shadow::Vec3 point(std::numeric_limits<double>::quiet_NaN());
    if (id >= 0)
    {
      input->GetPoint(id, &point.x);
    }
    return point;
  };
  UsedPoints used(input);
  for (vtkCellArray* cells : { input->GetPolys(), input->GetStrips() })
  {
    used.add(cells, [](vtkIdType) {});
  }
  for (vtkCellArray* cells : { input->GetLines(), input->GetVerts() })
  {
    used.add(cells, [&](vtkIdType first) { defects.linesAndVertices.add(place(first)); });
  }
  for (vtkIdType id = 0; id < input->GetNumberOfPoints(); ++id)
  {
    if (!used.has(id))
    {
      defects.unusedPoints.add(place(id));
    }
  }
  const int type = input->GetPoints()->GetDataType();
  for (const shadow::Vec3& p : mesh.points)
  {
    const double step = std::max(stepAt(p.x, type), std::max(stepAt(p.y, type), stepAt(p.z, type)));
    defects.coarsestStep = std::max(defects.coarsestStep, step);
    if (diagonal > 0.0 && step > coarseShare * diagonal)
    {
      defects.coarsePoints.add(p);
    }
    if ((diagonal > 0.0 && diagonal < leastSize) || shadow::largestComponent(p) > largestSize)
    {
      defects.extremePoints.add(p);
    }
  }
  return defects;
}
